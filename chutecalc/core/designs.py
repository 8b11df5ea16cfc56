"""Many designs at once, for threads too."""

from typing import Any

from chutecalc.core import state, unlocked


def solve(stream: "state.Stream", effort: "state.Effort", numbers: Any, results: Any, first: int, last: int) -> int:
    """:func:`chutecalc.core.batch.solve_rows` with the interpreter's lock released."""
    return unlocked.solve_rows(stream, effort, numbers, results, first, last)
