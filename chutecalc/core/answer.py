"""From varied numbers to the stream at the end, for one design, without a table in between."""

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
"""What is told, in this order."""


class Answer:
    """What it takes to answer: a recipe, records of the chute, and room for one row."""

    def __init__(
        self, recipe: "replay.Recipe", course: "records.Course", effort: "state.Effort", given: Any, numbers: Any
    ) -> None:
        """``given`` and ``numbers`` are tables of a row each: of what is varied, and of what the recipe makes of it.

        The records are this answer's own from now on; they tell the ends and, where that is asked for, how the stream
        lies there.
        """
        self.recipe, self.course, self.effort = recipe, course, effort
        self.given, self.numbers = given, numbers


def ask(own: Answer, values: tuple[Any, ...]) -> list[float] | None:
    """The :data:`OUTPUTS` for as many values as are varied, a depth where it is asked for; NaN where the stream fails.

    None where a value is no Python float, a check of the recipe has another answer, or a curve is not tangent to its
    stream: others find out what to say of that. One thread at a time: compiled, the interpreter's lock is held.
    """
    for k in range(own.recipe.varied):
        value = values[k]
        if not isinstance(value, float):
            return None
        own.given[0, k] = value
    if replay.replay(own.recipe, own.given, own.numbers) != 1:
        return None
    if batch.solve_rows(own.course, own.effort, own.numbers, 0, 1) != 1 or own.course.status < state.OK:
        return None
    if own.course.status > state.OK:
        return [floats.NAN] * len(OUTPUTS)
    here = own.course.here
    depth = float(own.course.lying[0, 0, 0]) if own.course.tells_lying else floats.NAN
    slope = here.slope * (180.0 / math.pi)
    return [here.velocity, own.course.error, here.distance, here.x, here.z, slope, depth]
