"""Solve one design from its varied numbers to the stream at the end, in one compiled step."""

import math
from typing import Any

from chutecalc.core import batch, floats, records, replay, state

OUTPUTS = (
    "exit_velocity_m_s",
    "error_estimate",
    "exit_s_m",
    "exit_x_m",
    "exit_z_m",
    "exit_slope_deg",
    "exit_depth_m",
)
"""Results, in this order."""


class SingleDesignSolver:
    """A recipe, the state of a chute, and room for one row."""

    def __init__(
        self,
        recipe: "replay.Recipe",
        chute: "records.ChuteState",
        options: "state.SolverOptions",
        inputs: Any,
        numbers: Any,
    ) -> None:
        """Take ownership of the records; ``inputs`` and ``numbers`` are tables of one row.

        ``inputs`` holds the varied numbers, ``numbers`` what the recipe makes of them.
        """
        self.recipe, self.chute, self.options = recipe, chute, options
        self.inputs, self.numbers = inputs, numbers


def solve_single(solver: SingleDesignSolver, values: tuple[Any, ...]) -> list[float] | None:
    """Return the :data:`OUTPUTS` for a tuple of varied values; NaN where the stream fails.

    The depth is NaN unless it is asked for. Return None where a value is not a Python float, a check of the recipe has
    another result, or a curve is not tangent to its stream; the caller then finds out why. For one thread at a time:
    compiled, the interpreter's lock is held.
    """
    for k in range(solver.recipe.varied):
        value = values[k]
        if not isinstance(value, float):
            return None
        solver.inputs[0, k] = value
    if replay.replay(solver.recipe, solver.inputs, solver.numbers) != 1:
        return None
    if batch.solve_rows(solver.chute, solver.options, solver.numbers, 0, 1) != 1 or solver.chute.status < state.OK:
        return None
    if solver.chute.status > state.OK:
        return [floats.NAN] * len(OUTPUTS)
    current = solver.chute.current
    depth = float(solver.chute.stream_section[0, 0, 0]) if solver.chute.with_stream_section else floats.NAN
    slope = current.slope * (180.0 / math.pi)
    return [current.velocity, solver.chute.error, current.distance, current.x, current.z, slope, depth]
