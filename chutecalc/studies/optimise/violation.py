"""Which limits a design violates, in which state, and by how much."""

from typing import Any, NamedTuple

import numpy as np

from chutecalc.output.dataset import number
from chutecalc.physics.arrays import Array
from chutecalc.studies.optimise.objective import NO_FAILURE, NO_WARNINGS
from chutecalc.studies.optimise.problem import FAILURE, OK, WARNING, Problem


class Violation(NamedTuple):
    """A limit that a design violates in a state."""

    limit: str
    """The limit as it is written, ``no failure``, ``no warnings``, or ``a value of`` a column."""
    state: str
    value: float | str
    """Value of the column there, ``none`` where there is no number; or how the design ends, or codes of warnings."""
    by: float
    """How far the value is beyond the limit, in the unit of the column; NaN where it is no number."""

    def document(self) -> dict[str, Any]:
        """Return its entries, None for numbers that are infinite or do not exist."""
        value = self.value if isinstance(self.value, str) else number(self.value)
        return self._asdict() | {"value": value, "by": number(self.by)}


def violations(problem: Problem, place: Array) -> list[Violation]:
    """Return all limits that a design violates, the worst first, as the search weighs them.

    Args:
        problem: what is wanted.
        place: of the design, in the units of the keys, shape (keys,).
    """
    rows = problem.rows(place[None])
    found: list[tuple[float, Violation]] = []
    for row, state in enumerate(problem.variants.states):
        own = {name: values[row, 0] for name, values in rows.block.items()}
        if own["status"] != OK:
            found.append((FAILURE, Violation(NO_FAILURE, state, str(own["status"]), np.nan)))
        else:
            missing = [name for name in problem.needed if not np.isfinite(own[name])]
            found += [(FAILURE, Violation(f"a value of {name}", state, "none", np.nan)) for name in missing]
        if problem.no_warnings and own["warnings"]:
            codes = str(own["warnings"])
            found.append((WARNING * len(codes.split()), Violation(NO_WARNINGS, state, codes, np.nan)))
        for limit, margins in zip(problem.limits, rows.margins, strict=True):
            if margins[row, 0] < 0.0:
                value = float(own[limit.column])
                by = abs(value - limit.value)
                found.append((-float(margins[row, 0]), Violation(limit.text, state, value, by)))
    return [each for _, each in sorted(found, key=lambda pair: -pair[0])]
