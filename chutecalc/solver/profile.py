"""The stream at any place of a solved leg: what its panels and its flight say there.

Places are arrays of shape (places, designs), as the panels' own values are; what is returned has that shape too.
"""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.physics.flight import motion, path_length, position
from chutecalc.physics.friction import equivalent_friction
from chutecalc.physics.roots import root_between
from chutecalc.physics.section import take_facet, wetted_facet, wetting
from chutecalc.physics.surface import point
from chutecalc.solver.chain import ContactLeg, Leg
from chutecalc.solver.collocation import interpolation, product, rule
from chutecalc.solver.crossing import evaluate
from chutecalc.solver.front import Piece
from chutecalc.solver.slide import Slide, place_rates


class Profile(NamedTuple):
    """The stream at places of a leg; NaN where there is no stream, or no such quantity in free flight."""

    distance: Array
    """From the inlet along the stream, m."""
    x: Array
    z: Array
    slope: Array
    velocity: Array
    time: Array
    """Since the leg began, s."""
    area: Array
    depth: Array
    chamfer: Array
    """Wetted length of the drawn facets on one side, m."""
    width: Array
    """Of the free surface, m."""
    missing: Array
    """Share of the weight that hydrostatic wall pressures do not carry."""
    friction: Array
    """μ_e."""
    normal: Array
    """Normal acceleration, m/s²."""


def flight_profile(leg: Leg, flow: Array, distances: Array) -> Profile:
    """A leg's flight at distances flown, m, shape (places, designs)."""
    time = _flight_time(leg, distances)
    x, z = position(leg.path, time)
    velocity, slope = motion(leg.path, time)
    area = np.where(velocity > 0.0, flow / np.where(velocity > 0.0, velocity, 1.0), np.nan)
    none = np.full(time.shape, np.nan)
    return Profile._make((leg.start.distance + distances, x, z, slope, velocity, time, area, *[none] * 6))


def slide_profile(leg: Leg, contact: ContactLeg, places: Array, shares: Array | None = None) -> Profile:
    """A leg's contact at places, shares of the segment's length, shape (places, designs).

    Args:
        leg, contact: the solved leg.
        places: NaN where none is wanted; outside the part travelled gives NaN.
        shares: where ``places`` are the same shares of the part travelled in all designs, those, shape (places,).
    """
    y, time = _walk(contact, places, shares)
    x, z, slope = point(contact.surface, places)
    velocity = np.sqrt(y)
    along = contact.surface.length * (places - contact.arrival.place)
    columns = np.broadcast_to(np.arange(y.shape[1]), y.shape).ravel()
    slide = contact.slide.rows(columns)
    area = (contact.slide.flow / velocity).ravel()
    facet = take_facet(slide.facets, wetted_facet(slide.facets, area))
    wet = wetting(facet, area)
    normal = contact.slide.normal(places, y)
    friction = equivalent_friction(slide.friction, wet.excess)
    clock = leg.flight_time + time
    rows = (area, wet.depth, wet.chamfer, wet.width, wet.missing, friction)
    shaped = [np.where(np.isfinite(row), row, np.nan).reshape(y.shape) for row in rows]
    normal = np.where(np.isnan(y), np.nan, normal)
    return Profile._make((leg.entry.distance + along, x, z, slope, velocity, clock, *shaped, normal))


def _flight_time(leg: Leg, distances: Array) -> Array:
    """Time at which a flight has covered a distance: Newton, from uniform acceleration between the same ends."""
    total = path_length(leg.path, leg.flight_time)
    start, whole = leg.start.velocity, leg.flight_time
    push = np.where(whole > 0.0, 2.0 * (total - start * whole) / np.where(whole > 0.0, whole, 1.0) ** 2, 0.0)
    divisor = start + np.sqrt(np.maximum(start**2 + 2.0 * push * distances, 0.0))
    time = np.where(divisor > 0.0, 2.0 * distances / np.where(divisor > 0.0, divisor, 1.0), 0.0)
    for _ in range(6):
        velocity, _ = motion(leg.path, time)
        step = (path_length(leg.path, time) - distances) / np.where(velocity > 0.0, velocity, np.inf)
        time = np.clip(time - step, 0.0, whole)
    return time


def _walk(contact: ContactLeg, places: Array, shares: Array | None) -> tuple[Array, Array]:
    """v² and the time since the contact began, at places, shape (places, designs)."""
    arrival = contact.arrival
    here = places == arrival.place  # also of streams that get no further
    y, time = np.where(here, arrival.after**2, np.nan), np.where(here, 0.0, np.nan)
    elapsed = np.zeros(places.shape[1])
    end = np.full(places.shape[1], np.nan)
    end[contact.rows] = contact.stretch.place
    for piece in contact.stretch.pieces:
        rows = contact.rows[piece.rows]
        clock = elapsed[rows] + _clock(contact.slide.rows(rows), piece)
        whole = np.zeros(len(rows), dtype=bool)
        if shares is not None and not piece.by_root:
            whole = (piece.start == arrival.place[rows]) & (piece.end == end[rows])
        if shares is not None and whole.any():
            matrix = interpolation(len(piece.knots) - 2, shares)
            y[:, rows[whole]] = product(matrix, piece.knots[:, whole])
            time[:, rows[whole]] = product(matrix, clock[:, whole])
        if not whole.all():
            part = Piece._make(field if isinstance(field, bool) else field[..., ~whole] for field in piece)
            others = rows[~whole]
            share = _share(part, places[:, others])
            root = part.start + share * (part.end - part.start)
            values = root**4 if piece.by_root else evaluate(part.knots, share)
            met = ~np.isnan(share)
            y[:, others] = np.where(met, values, y[:, others])
            time[:, others] = np.where(met, evaluate(clock[:, ~whole], share), time[:, others])
        elapsed[rows] = clock[-1]
    return y, time


def _clock(slide: Slide, piece: Piece) -> Array:
    """Time since the piece began at its knots: the integral of ds/v over c, or over r."""
    own = rule(len(piece.knots) - 2)
    width = piece.end - piece.start
    if piece.by_root:
        root = piece.start + width * own.nodes[:, None]
        change, _ = place_rates(slide, take_facet(slide.facets, piece.facet), root, width, piece.knots[1:-1])
        rate = slide.length * change / root**2
    else:
        rate = slide.length * width / np.sqrt(piece.knots[1:-1])
    return np.concatenate([np.zeros((1, len(piece.rows))), product(own.integral, rate)])


def _share(piece: Piece, places: Array) -> Array:
    """Where in a piece's own variable places lie, as shares of its width; NaN outside it."""
    first, last = (piece.knots[0], piece.knots[-1]) if piece.by_root else (piece.start, piece.end)
    linear = (places - first) / np.where(last > first, last - first, 1.0)
    slack = 1e-12  # places are products of shares: their last digits are not the panels'
    share = np.where((linear >= -slack) & (linear <= 1.0 + slack), np.clip(linear, 0.0, 1.0), np.nan)
    if not piece.by_root:
        return share
    inside = np.flatnonzero(~np.isnan(share).ravel())
    wanted, columns = places.ravel()[inside], np.broadcast_to(np.arange(share.shape[1]), share.shape).ravel()[inside]
    low, high = np.zeros(len(inside)), np.ones(len(inside))
    below, above = np.minimum(first[columns] - wanted, 0.0), np.maximum(last[columns] - wanted, 0.0)
    roots = root_between(
        lambda at, which: evaluate(piece.knots[:, columns[which]], at) - wanted[which], low, high, below, above
    )
    flat = np.full(share.size, np.nan)
    flat[inside] = roots
    return flat.reshape(share.shape)
