"""How a stream gets onto a contact segment: along it, by an impact, or by a flight that lands further on."""

from typing import NamedTuple

import numpy as np

from chutecalc.design import Status, Stream
from chutecalc.physics.arrays import Array, Index, Mask
from chutecalc.physics.flight import Flight, flight, impact_velocity, path_length
from chutecalc.physics.friction import equivalent_friction
from chutecalc.physics.section import excess_friction, take_facet, wetted_facet
from chutecalc.physics.surface import Surface, incidence, landing
from chutecalc.solver.slide import Slide

TANGENT = np.radians(1e-6)
"""Directions closer than this are one: the state passes on unchanged."""


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
    after: Array
    """Velocity along the surface after the impact, m/s."""
    error: Array
    """Of that, relative."""
    gap: Array
    """By how much a stream misses the segment's end, m."""
    status: Index


def arrive(stream: Stream, surface: Surface, slide: Slide) -> Arrival:
    """Meets the segment: at its start, or where a flight comes down on it (physics of joints: docs in the README).

    Args:
        stream: n streams, all in motion; airborne, or on the segment's drawn start.
        surface: the segment as drawn.
        slide: the flow on it.

    Returns:
        The arrivals; status ``STALL`` where the impact leaves no velocity, ``MISSED`` where a flight finds no surface.
    """
    shape = stream.velocity.shape
    turn = np.broadcast_to(surface.side * (stream.slope - surface.slope), shape)  # > 0: into the surface
    flies = stream.airborne | (turn < -TANGENT)
    path = flight(stream.x, stream.z, stream.velocity, stream.slope, slide.gravity)
    none = np.zeros(shape)
    time, distance, place, velocity, strike, gap = (
        none,
        none,
        none,
        stream.velocity,
        np.maximum(turn, 0.0),
        none * np.nan,
    )
    if flies.any():
        found = landing(surface, path, ~stream.airborne)
        flown, _, angle = incidence(surface, path, found)
        time, place = np.where(flies, found.time, 0.0), np.where(flies, found.place, 0.0)
        distance = np.where(flies, path_length(path, time), 0.0)
        velocity, strike = np.where(flies, flown, velocity), np.where(flies, angle, strike)
        gap = np.where(flies, found.gap, np.nan)
    after, sensitivity = _after_impact(slide, velocity, np.where(strike <= TANGENT, 0.0, strike))
    error = stream.error * sensitivity * (stream.velocity / velocity) ** 2
    status = np.where(np.isnan(place), Status.MISSED, np.where(after > 0.0, Status.OK, Status.STALL))
    return Arrival(path, time, distance, place, velocity, strike, after, error, gap, status)


def _after_impact(slide: Slide, velocity: Array, strike: Array) -> tuple[Array, Array]:
    """Velocity after the impact, and what a relative error of the arriving one becomes."""
    struck: Mask = strike > 0.0
    if not struck.any():
        return velocity, np.ones(velocity.shape)
    area = slide.flow / velocity
    facet = take_facet(slide.facets, np.broadcast_to(wetted_facet(slide.facets, area), velocity.shape))
    excess, growth = excess_friction(facet, area)
    friction = equivalent_friction(slide.friction, excess)
    after = np.where(struck, impact_velocity(velocity, strike, friction), velocity)
    # d(ln after)/d(ln v) = 1 + (A dμ_e/dA) sin i v/after, since A = Q/v
    share = slide.friction * growth * np.sin(strike) * velocity / np.where(after > 0.0, after, np.inf)
    return after, np.where(struck, np.abs(1.0 + share), 1.0)
