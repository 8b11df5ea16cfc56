"""How a stream gets onto a contact segment: along it, by an impact, or by a flight that lands further on."""

from typing import NamedTuple

import numpy as np

from chutecalc.design import Status, Stream
from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.flight import Flight, flight, path_length
from chutecalc.physics.surface import Surface, incidence, landing
from chutecalc.solver.deviation import Deviation, at_landing, deviation, on_surface
from chutecalc.solver.impact import Impact, impact
from chutecalc.solver.slide import Slide

TANGENT = np.radians(1e-6)
"""Directions closer than this are one: the state passes on unchanged."""
NEARBY = 1e-6
"""How far off, relative, a stream is tried to see how an impact on it changes."""


class Arrival(NamedTuple):
    """How n streams meet a segment; arrays of shape (n,)."""

    path: Flight
    time: Array
    """In flight before, s; 0 for those that are on the segment at once."""
    distance: Array
    """Flown, m."""
    place: Array
    """Where they meet the segment, as a share of its length."""
    velocity: Array
    """On arriving, m/s."""
    incidence: Array
    """Between stream and surface, rad, 0 where they are tangent."""
    impact: Impact
    error: Array
    """Relative, of the velocity left at the place that is met; it goes with the sign of ``place_error``."""
    place_error: Array
    """Of the place, as a share of the segment's length."""
    gap: Array
    """By how much a stream that misses passes the segment's end, m, positive on its side; NaN where it never does."""
    status: Index

    def met(self, rows: Index | slice = slice(None)) -> "Met":
        """Where some of the streams meet the segment."""
        return Met(self.place[rows], self.impact.after[rows], self.error[rows], self.place_error[rows])


class Met(NamedTuple):
    """Where streams are on a segment once they have met it, and how well that is known; as in an arrival."""

    place: Array
    velocity: Array
    error: Array
    place_error: Array


def arrive(stream: Stream, surface: Surface, slide: Slide, drawn: Deviation, known: int = 0) -> Arrival:
    """Meets the segment: at its start, or where a flight comes down on it (physics of joints: docs in the README).

    Args:
        stream: n streams, all in motion; airborne, or on the segment's drawn start.
        surface: the segment as drawn.
        slide: the flow on it.
        drawn: by how much that may be off, as one drawn from where a stream falls; its slope is that of a tangent arc.
        known: how many roots at time 0 of an airborne stream's flight lie on this very surface.

    Returns:
        The arrivals; status ``STALL`` where the impact leaves no velocity, ``MISSED`` where a flight finds no surface
        and never passes its end either, ``PASSED`` where it does.
    """
    shape = stream.velocity.shape
    turn = np.broadcast_to(surface.side * (stream.slope - surface.slope), shape)  # > 0: into the surface
    flies = stream.airborne | (turn < -TANGENT)
    path = flight(stream.x, stream.z, stream.velocity, stream.slope, slide.gravity)
    none, gone = np.zeros(shape), np.full(shape, np.nan)
    off = deviation(stream)
    if not (flies.any() or (turn > TANGENT).any()):  # the stream goes on as it comes
        on, strike = np.full(shape, Status.OK), impact(slide, none, stream.velocity, none)
        return Arrival(
            path, none, none, none, stream.velocity, none, strike, *_carried(slide, none, none, off, drawn), gone, on
        )
    time, distance, place, velocity, angle, gap = none, none, none, stream.velocity, np.maximum(turn, 0.0), gone
    shift = none
    if flies.any():
        found = landing(surface, path, np.where(stream.airborne, known, 1))
        flown, _, strike_angle = incidence(surface, path, found)
        time, place = np.where(flies, found.time, 0.0), np.where(flies, found.place, 0.0)
        distance = np.where(flies, path_length(path, time), 0.0)
        velocity, angle = np.where(flies, flown, velocity), np.where(flies, strike_angle, angle)
        gap = np.where(flies, found.gap, np.nan)
        there, moved = at_landing(off, drawn, path, time, surface, np.where(flies, found.slope, surface.slope))
        off = Deviation._make(np.where(flies, *pair) for pair in zip(there, off, strict=True))
        shift = np.where(flies, moved, 0.0)
    angle = np.where(angle <= TANGENT, 0.0, angle)
    strike = impact(slide, place, velocity, angle)
    error, shift = _struck(slide, surface, place, velocity, angle, strike, off, drawn, shift)
    status = np.where(strike.after > 0.0, Status.OK, Status.STALL)
    status = np.where(np.isnan(place), np.where(gap > 0.0, Status.PASSED, Status.MISSED), status)
    return Arrival(path, time, distance, place, velocity, angle, strike, error, shift, gap, status)


def _struck(
    slide: Slide,
    surface: Surface,
    place: Array,
    velocity: Array,
    angle: Array,
    strike: Impact,
    off: Deviation,
    drawn: Deviation,
    shift: Array,
) -> tuple[Array, Array]:
    """Errors of the velocity left and of the place, from those of the stream that arrives.

    Friction changes with depth, pressure and place: the impact of a stream that is off a little tells how.
    """
    error, shift = _carried(slide, place, shift, off, drawn)
    hit = (angle > 0.0) & ((off.velocity != 0.0) | (off.slope != 0.0) | (shift != 0.0))
    if not hit.any():
        return error, shift
    steeper = surface.side * (off.slope - drawn.slope - surface.turn * shift)
    size = np.maximum(np.maximum(np.abs(off.velocity), np.abs(steeper) / np.maximum(angle, NEARBY)), np.abs(shift))
    scale = NEARBY / np.where(hit & (size > 0.0), size, np.inf)
    beside = impact(slide, place + scale * shift, velocity * (1.0 + scale * off.velocity), angle + scale * steeper)
    change = (beside.after - strike.after) / np.where(scale > 0.0, scale, np.inf)
    after = np.where(strike.after > 0.0, strike.after, np.inf)
    return np.where(hit, change / after, error), shift


def _carried(slide: Slide, place: Array, shift: Array, off: Deviation, drawn: Deviation) -> tuple[Array, Array]:
    """The same where there is no impact. A tangent arc that begins at another slope is the same arc begun elsewhere."""
    turn = np.where(slide.turn != 0.0, slide.turn, np.inf)
    return off.velocity + np.zeros(place.shape), shift + drawn.slope / turn


def entry_error(slide: Slide, met: Met) -> Array:
    """Relative error of the velocity at the place where a stream enters; where the impact stops it, of that place.

    With the sign that goes with those of the segment's own place.
    """
    stopped = met.velocity == 0.0
    if not met.place_error.any():
        return np.where(stopped, 0.0, met.error)
    off = on_surface(slide, met.place, np.where(stopped, 1.0, met.velocity), met.error, met.place_error)
    return np.where(stopped, met.place_error, off)
