"""Call the batch solver from Python with the interpreter's lock released."""

from typing import Any

from chutecalc.core import records, state, without_gil


def solve(chute: "records.ChuteState", options: "state.SolverOptions", numbers: Any, first: int, last: int) -> int:
    """Solve rows, see :func:`chutecalc.core.batch.solve_rows`, with the interpreter's lock released."""
    return without_gil.solve_rows(chute, options, numbers, first, last)
