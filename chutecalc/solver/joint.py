"""How a stream gets onto a contact segment: along it, by an impact, or by a flight that lands further on."""

from typing import NamedTuple

import numpy as np

from chutecalc.design import Status, Stream
from chutecalc.physics.arrays import Array, Index, Mask
from chutecalc.physics.flight import Flight, flight, impact_velocity, path_length
from chutecalc.physics.friction import equivalent_friction
from chutecalc.physics.section import take_facet, wetted_facet
from chutecalc.physics.surface import Surface, incidence, landing
from chutecalc.physics.wall import wall_friction
from chutecalc.physics.wetting import excess_friction
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
    """By how much a stream that misses passes the segment's end, m, positive on its side; NaN where it never does."""
    pressure: Array
    """Of the impact, ρ v² sin² i, Pa; 0 where there is none."""
    status: Index


def arrive(stream: Stream, surface: Surface, slide: Slide, known: int = 0) -> Arrival:
    """Meets the segment: at its start, or where a flight comes down on it (physics of joints: docs in the README).

    Args:
        stream: n streams, all in motion; airborne, or on the segment's drawn start.
        surface: the segment as drawn.
        slide: the flow on it.
        known: how many roots at time 0 of an airborne stream's flight lie on this very surface.

    Returns:
        The arrivals; status ``STALL`` where the impact leaves no velocity, ``MISSED`` where a flight finds no surface
        and never passes its end either, ``PASSED`` where it does.
    """
    shape = stream.velocity.shape
    turn = np.broadcast_to(surface.side * (stream.slope - surface.slope), shape)  # > 0: into the surface
    flies = stream.airborne | (turn < -TANGENT)
    path = flight(stream.x, stream.z, stream.velocity, stream.slope, slide.gravity)
    none = np.zeros(shape)
    if not (flies.any() or (turn > TANGENT).any()):  # the stream goes on as it comes
        on, gone = np.full(shape, Status.OK), np.full(shape, np.nan)
        return Arrival(path, none, none, none, stream.velocity, none, stream.velocity, stream.error, gone, none, on)
    time, distance, place, velocity, strike, gap = (
        none,
        none,
        none,
        stream.velocity,
        np.maximum(turn, 0.0),
        none * np.nan,
    )
    if flies.any():
        found = landing(surface, path, np.where(stream.airborne, known, 1))
        flown, _, angle = incidence(surface, path, found)
        time, place = np.where(flies, found.time, 0.0), np.where(flies, found.place, 0.0)
        distance = np.where(flies, path_length(path, time), 0.0)
        velocity, strike = np.where(flies, flown, velocity), np.where(flies, angle, strike)
        gap = np.where(flies, found.gap, np.nan)
    strike = np.where(strike <= TANGENT, 0.0, strike)
    pressure = slide.density * (velocity * np.sin(strike)) ** 2
    after, sensitivity = _after_impact(slide, place, velocity, strike, pressure)
    error = stream.error * sensitivity * (stream.velocity / velocity) ** 2
    status = np.where(after > 0.0, Status.OK, Status.STALL)
    status = np.where(np.isnan(place), np.where(gap > 0.0, Status.PASSED, Status.MISSED), status)
    return Arrival(path, time, distance, place, velocity, strike, after, error, gap, pressure, status)


def impact_friction(slide: Slide, place: Array, velocity: Array, pressure: Array) -> tuple[Array, Array]:
    """μ_e of an impact on a segment, at the arriving velocity and the impact's pressure, and A dμ_e/dA."""
    table, area = slide.facets_at(place), slide.flow / velocity
    facet = take_facet(table, np.broadcast_to(wetted_facet(table, area), velocity.shape))
    excess, growth = excess_friction(facet, area, slide.equilibrium)
    friction = wall_friction(slide.wall, pressure)
    return equivalent_friction(friction, excess), friction * growth


def _after_impact(slide: Slide, place: Array, velocity: Array, strike: Array, pressure: Array) -> tuple[Array, Array]:
    """Velocity after the impact, and what a relative error of the arriving one becomes."""
    struck: Mask = strike > 0.0
    if not struck.any():
        return velocity, np.ones(velocity.shape)
    friction, growth = impact_friction(slide, place, velocity, pressure)
    after = np.where(struck, impact_velocity(velocity, strike, friction), velocity)
    # d(ln after)/d(ln v) = 1 + (A dμ_e/dA) sin i v/after, since A = Q/v
    share = growth * np.sin(strike) * velocity / np.where(after > 0.0, after, np.inf)
    return after, np.where(struck, np.abs(1.0 + share), 1.0)
