"""Where columns tend at the end of a part of the trajectory: towards a stall, or a loss of contact."""

from collections.abc import Iterable

import numpy as np

from chutecalc.physics.arrays import Array, Mask, Numbers
from chutecalc.results.finding_columns import ALL_COLUMNS
from chutecalc.results.segment_context import SegmentContext
from chutecalc.solver.contact_profile import ContactProfile
from chutecalc.solver.flight_profile import FlightProfile

AT_REST = (1e-40, 1e-44)
"""Two values of v², m²/s², so near rest that a quantity with a limit there has reached it to the last digit."""
LIFT_OFF = 1e-6
"""Ratio to gravity of the normal acceleration below which contact was lost by it falling to 0."""


def limits_at_end(
    part: SegmentContext, at: FlightProfile | ContactProfile, lost: Mask, names: Iterable[str]
) -> Numbers:
    """Return the limits of columns at the end of a part.

    Args:
        part: of a trajectory.
        at: the stream at its end.
        lost: whether each design loses contact there.
        names: of the columns.

    Returns:
        Arrays of shape (designs,) by name.
    """
    with np.errstate(all="ignore"):
        values = {name: ALL_COLUMNS[name].values(part, at)[0] for name in names}
        if not isinstance(at, ContactProfile):
            return values
        rest = at.velocity_squared[0] == 0.0
        if rest.any():
            slow, slower = (at.with_velocity_squared(tiny) for tiny in AT_REST)
            for name, there in values.items():
                near, nearer = (ALL_COLUMNS[name].values(part, one)[0] for one in (slow, slower))
                values[name] = np.where(rest, _limit(near, nearer), there)
        unpressed = lost & (np.abs(at.normal_acceleration[0]) < LIFT_OFF * part.design.gravity)
        for name in values:
            if ALL_COLUMNS[name].infinite_at_lift_off:
                values[name] = np.where(unpressed, np.inf, values[name])
    return values


def _limit(near: Array, nearer: Array) -> Array:
    """Return where values tend that are known close to rest and closer: to 0, without bound, or to themselves."""
    tends = np.where(np.abs(nearer) > 2.0 * np.abs(near), np.copysign(np.inf, near), near)
    return np.where(np.abs(nearer) < 0.5 * np.abs(near), 0.0, tends)
