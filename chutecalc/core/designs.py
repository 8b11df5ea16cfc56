"""Many designs at once, for threads too."""

from typing import Any

from chutecalc.core import records, state, unlocked


def solve(course: "records.Course", effort: "state.Effort", numbers: Any, first: int, last: int) -> int:
    """:func:`chutecalc.core.batch.solve_rows` with the interpreter's lock released."""
    return unlocked.solve_rows(course, effort, numbers, first, last)
