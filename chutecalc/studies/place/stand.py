"""How a segment must stand where a flight is to strike it: the slopes and the start that its spec needs."""

from collections.abc import Mapping
from math import degrees, inf, pi, radians
from typing import Any, NamedTuple

import numpy as np

from chutecalc.design import Contact
from chutecalc.errors import UsageError
from chutecalc.fields.units import convert, same_quantity
from chutecalc.physics.arrays import Array
from chutecalc.physics.surface import Surface, point
from chutecalc.segments.arc import Arc
from chutecalc.segments.hood import Hood
from chutecalc.segments.registry import KINDS
from chutecalc.segments.straight import Straight
from chutecalc.studies.place.strike import Launch, NotReachedError, Strike, strike_at, strike_on
from chutecalc.studies.place.wish import Wish

DECIMALS = 12
"""Decimals of written places and slopes: less than what a stream may be off a start."""
BEGINS, ENDS, SLOPE = "from_slope_deg", "to_slope_deg", "slope_deg"


class Stand(NamedTuple):
    """A segment as it must stand."""

    strike: Strike
    """When the flight strikes it, and its slope there."""
    slopes: dict[str, float]
    """Slope at the start of an arc, or of a flat segment, degrees, by its key."""


def stand_for(launch: Launch, table: Mapping[str, Any], wish: Wish) -> Stand:
    """Return how a segment must stand to be struck as wanted.

    Place and incidence together give its slope. One of them alone leaves the slope as the spec has it.

    Args:
        launch: of the flight that leads to it.
        table: of the segment in the spec.
        wish: how it is to be struck.

    Raises:
        NotReachedError: it cannot be, with the nearest that can.
        UsageError: the spec has no slope, and the wishes do not give it.
    """
    kind: Any = KINDS[table["kind"]]
    side = kind.side
    ends = angle_of(table, ENDS) if issubclass(kind, Arc) else None
    key = SLOPE if ends is None else BEGINS
    begins, share = angle_of(table, key), wish.share if ends is not None else 0.0
    time = _time(launch, wish)
    if time is not None and wish.incidence_deg is not None:
        strike = strike_at(launch, side, time, radians(wish.incidence_deg))
        begins = strike.slope if ends is None else (strike.slope - share * ends) / (1.0 - share)
        _check_start(kind, begins, ends, launch.slope_at(time), side, share)
        return Stand(strike, {key: round(degrees(begins), DECIMALS) + 0.0})
    if begins is None:
        raise UsageError(f"it has no {key}: give it, or both incidence and x or z, which tell the slope")
    there = begins if ends is None else begins + share * (ends - begins)
    if time is not None:
        incidence = side * (launch.slope_at(time) - there)
        if incidence < 0.0:
            raise NotReachedError(
                f"the stream has a slope of {degrees(launch.slope_at(time)):z.6g}° there and the surface"
                f" {degrees(there):z.6g}°, so it would come from behind. Give incidence too, which turns the surface"
            )
        return Stand(Strike(time, there), {key: round(degrees(begins), DECIMALS) + 0.0})
    assert wish.incidence_deg is not None
    strike = strike_on(launch, side, there, radians(wish.incidence_deg))
    return Stand(strike, {key: round(degrees(begins), DECIMALS) + 0.0})


def start_of(segment: Contact, launch: Launch, stand: Stand, share: float) -> tuple[float, float]:
    """Return where a segment must start, x and z, m.

    Args:
        segment: its numbers, with the slopes of ``stand``.
        launch: of the flight that leads to it.
        stand: how it stands.
        share: of its length that lies before the strike.
    """
    assert segment.entry_slope is not None
    turn, length, zero = segment.exit_slope - segment.entry_slope, length_of(segment), np.zeros(1)
    x, z, _ = point(Surface(segment.side, zero, zero, segment.entry_slope, turn, length), np.full(1, share))
    struck = launch.at(stand.strike.time)
    return round(struck[0] - x.item(), DECIMALS) + 0.0, round(struck[1] - z.item(), DECIMALS) + 0.0


def length_of(segment: Contact) -> Array:
    """Return the length of a segment whose slopes are known, m.

    Args:
        segment: its numbers.
    """
    if segment.radius is None:
        assert segment.length is not None
        return segment.length
    assert segment.entry_slope is not None
    return segment.radius * np.abs(segment.exit_slope - segment.entry_slope)


def _time(launch: Launch, wish: Wish) -> float | None:
    """Return when the flight is at the place wanted; None if none is."""
    if wish.x_m is not None:
        return launch.time_to_x(wish.x_m)
    return None if wish.z_m is None else launch.time_to_z(wish.z_m)


def angle_of(table: Mapping[str, Any], key: str) -> float | None:
    """Return an angle of a table in any of its units, rad; None where there is none.

    Args:
        table: of a segment.
        key: of the angle in its first unit.
    """
    for name in same_quantity(key):
        if name in table:
            return float(convert(table[name], "angle", name.rpartition("_")[2], "rad"))
    return None


def _check_start(kind: type, begins: float, ends: float | None, stream: float, side: float, share: float) -> None:
    """Check that a segment may begin at a slope.

    Args:
        kind: class of the segment.
        begins: the slope, rad.
        ends: slope at the end of an arc, rad; None for a flat segment.
        stream: slope of the stream where it strikes, rad.
        side: σ of the surface.
        share: of its length that lies before the strike.

    Raises:
        NotReachedError: it may not, with the nearest incidence for which it may.
    """
    low = 0.0 if issubclass(kind, Straight) else -pi / 2
    high = ends if ends is not None and issubclass(kind, Hood) else pi / 2
    open_below, open_above = low < 0.0, issubclass(kind, Hood)
    if (low < begins if open_below else low <= begins) and (begins < high if open_above else begins <= high):
        if begins == ends:
            raise NotReachedError("its arc would have no length, as it would begin at the slope at which it ends")
        return
    bound = low if begins <= low else high
    there = bound if ends is None else bound + share * (ends - bound)
    nearest = degrees(side * (stream - there))
    why = "a hood must steepen" if open_above and bound == high else "that is not possible"
    is_open = open_below if bound == low else open_above
    limit = ("more than " if side * (begins - bound) >= 0.0 else "less than ") if is_open else ""
    possible = f"; the nearest is an incidence of {limit}{nearest:z.6g}°" if 0.0 <= nearest < inf else ""
    raise NotReachedError(
        f"it would begin at a slope of {degrees(begins):z.6g}° and end at"
        f" {degrees(begins if ends is None else ends):z.6g}°: {why}{possible}"
    )
