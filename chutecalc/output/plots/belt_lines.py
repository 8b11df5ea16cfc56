"""Belts from the side as lines: the one that the stream comes from, with its load, and the one that it goes to."""

import numpy as np

from chutecalc.design import Belt, Receiver
from chutecalc.output.plots.flights import Line, belt_throws
from chutecalc.results.solved import SolvedChute

BEHIND, AHEAD = 0.12, 0.28
"""Length of the receiving belt drawn before and after the landing, over the greater side of the chute."""
END_ON = np.cos(np.radians(85.0))
"""Share of its length below which a belt is seen end on: within 5° of across the plane of the chute."""
SHOWN = 3.0
"""Length of the feeding belt drawn before its pulley, over the pulley's radius."""
ON_PULLEY = 25
"""Number of stations around the pulley."""


def feed_lines(solution: SolvedChute) -> list[Line]:
    """Return the belt that the stream comes from, its pulley, and the upper edge of its load; empty without one.

    Args:
        solution: solution of one design.
    """
    belt = solution.design.belt
    if belt is None:
        return []
    throws = belt_throws(belt, solution.design.gravity)
    ends = ((belt.edge_radii["lower"], throws[0]), (belt.edge_radii["upper"], throws[-1]))
    edges = [_around(belt, float(radius[0]), (edge.x, edge.z)) for radius, edge in ends]
    around = np.linspace(0.0, 2.0 * np.pi, 4 * ON_PULLEY, endpoint=False)
    pulley = np.stack(
        [belt.centre[0] + belt.lower_radius * np.sin(around), belt.centre[1] + belt.lower_radius * np.cos(around)]
    )
    return [*edges, pulley]


def receiver_lines(solution: SolvedChute, size: float) -> list[Line]:
    """Return the belt that the stream lands on, in its direction; empty without one, or where it has no place.

    Args:
        solution: solution of one design.
        size: greater side of the chute, m.
    """
    receiver = solution.design.receiver
    if receiver is None:
        return []
    place = np.array([solution.receiver[name][0] for name in ("landing_x_m", "landing_z_m")])
    if receiver.at is not None and not np.isfinite(place).all():
        place = np.array([receiver.at[0][0], receiver.at[1][0]])
    slope, forward = receiver.slope_of_trace[0], np.sign(np.cos(receiver.plan_angle[0]))
    along = forward * np.array([np.cos(slope), -np.sin(slope)])
    ends = np.array([-BEHIND, BEHIND if is_end_on(receiver) else AHEAD])
    line: Line = place[:, None] + size * ends * along[:, None]
    return [line] if np.isfinite(line).all() else []


def is_end_on(receiver: Receiver) -> bool:
    """Return whether the receiving belt runs across the plane of the chute.

    Args:
        receiver: the belt, of one design.
    """
    return bool(abs(np.cos(receiver.plan_angle[0])) < END_ON)


def _around(belt: Belt, radius: float, leaves: tuple[float, float]) -> Line:
    """Return a line along the belt at a radius and around its pulley, to where it leaves."""
    incline, centre = float(belt.incline[0]), np.array([belt.centre[0][0], belt.centre[1][0]])
    x, z = leaves - centre
    angle = np.linspace(-incline, np.arctan2(x, z), ON_PULLEY)
    on_pulley = centre[:, None] + radius * np.stack([np.sin(angle), np.cos(angle)])
    back = on_pulley[:, 0] - SHOWN * float(belt.lower_radius[0]) * np.array([np.cos(incline), np.sin(incline)])
    return np.concatenate([back[:, None], on_pulley], axis=1)
