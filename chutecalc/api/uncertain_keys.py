"""The table ``[uncertainty]`` of a spec: which numbers are uncertain, how, and which of them go together."""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from chutecalc.api.correlation import read_correlation
from chutecalc.api.parameter import Parameter, check_distinct, parameter_at
from chutecalc.api.scatter import DISTRIBUTIONS, PLUS_MINUS, Scatter
from chutecalc.errors import Fault, SpecError
from chutecalc.physics.arrays import Array
from chutecalc.spec.chute_spec import ChuteSpec
from chutecalc.spec.faults import table_faults, value_text

TABLE = "uncertainty"
"""Name of the table in a spec."""
CORRELATION = "correlation"
"""Its key for what goes together; all others are paths."""


class UncertainKey(NamedTuple):
    """A number of a spec that is uncertain."""

    parameter: Parameter
    """Where it stands in the spec."""
    scatter: Scatter
    """How it scatters about its value there."""

    @property
    def path(self) -> str:
        """Key path, as given."""
        return self.parameter.path


class UncertainKeys(NamedTuple):
    """All that is uncertain in a spec."""

    keys: tuple[UncertainKey, ...]
    """The numbers, in the order of the spec."""
    correlation: Array
    """Correlation of the normal numbers behind them, shape (keys, keys)."""

    @property
    def paths(self) -> tuple[str, ...]:
        """Key paths, as given."""
        return tuple(key.path for key in self.keys)

    @property
    def are_independent(self) -> bool:
        """Whether none is correlated with another."""
        return bool(np.array_equal(self.correlation, np.eye(len(self.keys))))


def read_uncertainty(spec: ChuteSpec, source: str, text: str) -> UncertainKeys:
    r"""Return what is uncertain in a spec.

    Args:
        spec: the checked spec, of one design.
        source: what messages call it.
        text: TOML text of it, for line numbers; empty if there is none.

    Raises:
        SpecError: all faults of its table of uncertainties.

    >>> import chutecalc
    >>> chute = chutecalc.parse(chutecalc.STARTER + '[uncertainty]\n"flow.rate_t_h" = 100')
    >>> chute.uncertain.paths, chute.uncertain.keys[0].scatter.text
    (('flow.rate_t_h',), '± 100')
    """
    faults: list[Fault] = []
    table = dict(spec.uncertainty)
    pairs = table.pop(CORRELATION, [])
    entries = dict(_entries(table))
    keys: list[UncertainKey] = []
    for path, value in entries.items():
        try:
            parameter = parameter_at(spec, path, None)
            scatter = Scatter.read(value, parameter)
            keys.append(UncertainKey(parameter, scatter))
        except SpecError as error:
            faults += [_misspelt(spec, each) for each in error.faults]
        except ValueError as error:
            problem, remedy = error.args
            faults.append(Fault(path, problem, remedy, value_text(value)))
    try:
        check_distinct([key.parameter for key in keys])
    except SpecError as error:
        faults += error.faults
    correlation, wrong = read_correlation(list(entries), pairs)
    faults += [Fault(CORRELATION, problem, remedy) for problem, remedy in wrong]
    if faults:
        raise SpecError(table_faults(faults, (TABLE,), text), source)
    return UncertainKeys(tuple(keys), correlation)


def _entries(table: Mapping[str, Any], above: str = "") -> Iterator[tuple[str, Any]]:
    """Yield key paths and how their numbers scatter, whether paths stand in quotes or not."""
    for key, value in table.items():
        if (
            value
            and isinstance(value, dict)
            and not any(name in value and _ends(value[name]) for name in DISTRIBUTIONS)
        ):
            yield from _entries(value, f"{above}{key}.")
        else:
            yield f"{above}{key}", value


def _ends(value: Any) -> bool:
    """Return whether a value is what a distribution takes, rather than a table that a path leads through."""
    return not isinstance(value, dict)


def _misspelt(spec: ChuteSpec, fault: Fault) -> Fault:
    """Return the fault of a path to no number; of a number below which there is a word, that this is no distribution.

    ``friction_deg = { gauss = 1 }`` is the path ``friction_deg.gauss`` to a reader of the table.
    """
    path, _, word = fault.path.rpartition(".")
    try:
        parameter_at(spec, path, None)
    except SpecError:
        return fault
    return Fault(path, f"has no distribution {word}", f"use {PLUS_MINUS}, or one of {', '.join(DISTRIBUTIONS)}")
