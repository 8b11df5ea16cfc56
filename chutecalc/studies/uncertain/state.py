"""The state of a chute that is sampled, and what is uncertain in it."""

from chutecalc.api.cases import state_of
from chutecalc.api.chute import Chute
from chutecalc.api.uncertain_keys import TABLE, UncertainKey, UncertainKeys
from chutecalc.errors import Fault, SpecError, UsageError


def state_and_keys(chute: Chute, case: str) -> tuple[Chute, UncertainKeys]:
    """Return a chute in one of its operating states, and its uncertain numbers there, about the values of that state.

    Args:
        chute: of one design, with a table of uncertainties.
        case: name of the state.

    Raises:
        UsageError: the chute has no such table, or no such case.
        SpecError: a number would leave what its key takes in that state.
    """
    if chute.count != 1:
        raise UsageError(f"uncertain takes a chute of one design, not {chute.count}: use the chute before vary")
    if not any(key != "correlation" for key in chute.spec.uncertainty):
        remedy = 'add [uncertainty] with keys such as "flow.rate_t_h" = 100, for plus/minus 100'
        raise UsageError(f"{chute.source} does not say what is uncertain: {remedy}")
    state, as_written = state_of(chute, case), chute.uncertain
    if state is chute:
        return chute, as_written
    try:
        found, faults = state.uncertain, []
    except SpecError as error:
        raise SpecError([_of_case(fault, case) for fault in error.faults], chute.source) from None
    keys: list[UncertainKey] = []
    for key, design in zip(found.keys, as_written.keys, strict=True):
        by = key.parameter.value_in_unit - design.parameter.value_in_unit
        try:
            keys.append(UncertainKey(key.parameter, design.scatter.moved(by, key.parameter)))
        except ValueError as error:
            faults.append(_of_case(Fault(f"{TABLE}.{key.path}", *error.args), case))
    if faults:
        raise SpecError(faults, chute.source)
    return state, found._replace(keys=tuple(keys))


def _of_case(fault: Fault, case: str) -> Fault:
    """Return a fault that says in which case it is one."""
    return fault._replace(problem=f"{fault.problem}, about the value of case {case}")
