"""The stream at any place of a solved leg: what its panels and its flight say there.

Places are arrays of shape (places, designs), as the panels' own values are; what is returned has that shape too.
"""

from collections.abc import Iterator
from functools import cached_property

import numpy as np

from chutecalc.design import stretched
from chutecalc.physics.arrays import Array, Mask, product
from chutecalc.physics.flight import motion, path_length, position
from chutecalc.physics.friction import equilibrium_friction, equivalent_friction
from chutecalc.physics.roots import root_between
from chutecalc.physics.section import Facets, take_facet, wetted_facet
from chutecalc.physics.surface import point
from chutecalc.physics.wall import wall_friction
from chutecalc.physics.wear import wall_pressures
from chutecalc.physics.wetting import Wetting, depth_and_width, wetting
from chutecalc.solver.balance import critical_velocity
from chutecalc.solver.collocation import interpolation, rule
from chutecalc.solver.crossing import evaluate
from chutecalc.solver.front import Piece
from chutecalc.solver.leg import ContactLeg, Leg
from chutecalc.solver.slide import Course, Slide, place_rates


class FlightProfile:
    """A leg's flight at distances flown, m, shape (places, designs)."""

    def __init__(self, leg: Leg, flow: Array, distances: Array) -> None:
        self.leg, self.flow, self.flown = leg, flow, distances

    @cached_property
    def time(self) -> Array:
        """Since the leg began, s."""
        return _flight_time(self.leg, self.flown)

    @cached_property
    def distance(self) -> Array:
        """From the inlet along the stream, m."""
        return self.leg.start.distance + self.flown

    @cached_property
    def position(self) -> tuple[Array, Array]:
        """X and z, m."""
        return position(self.leg.path, self.time)

    @cached_property
    def motion(self) -> tuple[Array, Array]:
        """Velocity, m/s, and slope, rad."""
        return motion(self.leg.path, self.time)

    @property
    def velocity(self) -> Array:
        """m/s."""
        return self.motion[0]

    @property
    def slope(self) -> Array:
        """Below horizontal, rad."""
        return self.motion[1]

    @property
    def area(self) -> Array:
        """Q/v, m²."""
        return np.where(self.velocity > 0.0, self.flow / np.where(self.velocity > 0.0, self.velocity, 1.0), np.nan)


class SlideProfile:
    """A leg's contact at places, shares of the segment's length, shape (places, designs).

    NaN where there is no stream, or no such quantity. Each quantity is worked out when it is first asked for.
    """

    def __init__(self, leg: Leg, contact: ContactLeg, places: Array, shares: Array | None = None) -> None:
        """The contact at places.

        Args:
            leg, contact: the solved leg.
            places: NaN where none is wanted; outside the part travelled gives NaN.
            shares: where ``places`` are the same shares of the part travelled in all designs, those, shape (places,).
        """
        self.leg, self.contact, self.place, self.shares = leg, contact, places, shares

    @cached_property
    def velocity_squared(self) -> Array:
        """m²/s²."""
        return _velocities(self.contact, self.place, self.shares)

    @cached_property
    def velocity(self) -> Array:
        """m/s."""
        return np.sqrt(self.velocity_squared)

    @cached_property
    def time(self) -> Array:
        """Since the leg began, s."""
        return self.leg.flight_time + _times(self.contact, self.place)

    @property
    def distance(self) -> Array:
        """From the inlet along the stream, m."""
        return self.leg.entry.distance + self.contact.surface.length * (self.place - self.contact.arrival.place)

    @cached_property
    def _point(self) -> tuple[Array, Array, Array]:
        return point(self.contact.surface, self.place)

    @property
    def position(self) -> tuple[Array, Array]:
        """X and z, m."""
        return self._point[:2]

    @property
    def slope(self) -> Array:
        """Below horizontal, rad."""
        return self._point[2]

    @cached_property
    def table(self) -> Facets:
        """The section's facets."""
        return self.contact.slide.facets_at(self.place)

    @cached_property
    def facet(self) -> Facets:
        """The one in which the surface lies."""
        return take_facet(self.table, wetted_facet(self.table, self.contact.slide.area(self.velocity_squared)))

    @property
    def top(self) -> Array:
        """Height of the section's drawn top above the floor, m; NaN where it has none."""
        if len(self.table.area) == 1:
            return np.full((1, 1), np.nan)
        return np.where(self.table.drawn[-1] > 0.0, np.nan, self.table.height[-1])

    @cached_property
    def balance(self) -> Array:
        """The velocity below which friction wins here, m/s, see :func:`chutecalc.solver.balance.critical_velocity`."""
        shape = self.velocity.shape
        slide = self.contact.slide.rows(np.tile(np.arange(shape[1]), shape[0]))
        place = np.broadcast_to(self.place, shape)
        return critical_velocity(slide, place.ravel(), self.velocity.ravel()).reshape(shape)

    @cached_property
    def area(self) -> Array:
        """Q/v, m²."""
        return self._finite(self.contact.slide.area(self.velocity_squared))

    @cached_property
    def depth(self) -> Array:
        """M."""
        return self._finite(depth_and_width(self.facet, self.area)[0])

    @cached_property
    def wet(self) -> Wetting:
        """How the stream lies in the section."""
        return Wetting(*map(self._finite, wetting(self.facet, self.area, self.contact.slide.equilibrium)))

    @cached_property
    def normal(self) -> Array:
        """Normal acceleration, m/s²."""
        there = np.isnan(self.velocity_squared)
        return np.where(there, np.nan, self.contact.slide.normal(self.place, self.velocity_squared))

    def moving(self, velocity_squared: float) -> "SlideProfile":
        """The same with some velocity at all places, m²/s²."""
        other = SlideProfile(self.leg, self.contact, self.place, self.shares)
        other.__dict__["velocity_squared"] = np.full(self.velocity_squared.shape, velocity_squared)
        return other

    @cached_property
    def stress(self) -> Array:
        """What the wall's friction is read at, f ρ n H, Pa; infinite at rest, where depth is."""
        stress = self.contact.slide.density * np.maximum(self.normal, 0.0) * self.wet.factor * self.depth
        return self._known(np.where(self.velocity_squared == 0.0, np.inf, stress))

    @cached_property
    def wall_friction(self) -> Array:
        """μ."""
        along = wall_friction(self.contact.slide.wall, self.stress)
        return self._known(np.where(self._thrown, self.contact.arrival.impact.wall_friction, along))

    @cached_property
    def friction(self) -> Array:
        """μ_e."""
        along = equivalent_friction(self.wall_friction, self.wet.excess)
        return self._known(np.where(self._thrown, self.contact.arrival.impact.friction, along))

    @property
    def even_friction(self) -> Array:
        """μ_e where all wall pressures carry the weight alike, for the paper's law to compare with."""
        slide, missing = self.contact.slide, self.wet.missing
        stress = slide.density * np.maximum(self.normal, 0.0) * self.depth / (1.0 - missing)
        return self._known(equilibrium_friction(wall_friction(slide.wall, stress), self.wet.excess, missing))

    @cached_property
    def pressures(self) -> tuple[Array, Array, Array]:
        """On floor, chamfers and side walls, Pa; on a plate the impact's."""
        slide = self.contact.slide
        weight = slide.density * np.maximum(self.normal, 0.0)
        floor, chamfer, side = wall_pressures(slide.section_at(self.place), self.table, self.wet, weight)
        thrown = self._thrown
        struck = self._known(np.where(thrown, self.contact.arrival.impact.pressure, floor))
        return struck, np.where(thrown, np.nan, chamfer), np.where(thrown, np.nan, side)

    @cached_property
    def wear(self) -> tuple[Array, Array, Array]:
        """Friction power per area there, μ p v, W/m², where slip is the mean velocity; on a plate the impact's."""
        floor, chamfer, side = (pressure * self.wall_friction * self.velocity for pressure in self.pressures)
        return self._known(np.where(self._thrown, self.contact.arrival.impact.wear, floor)), chamfer, side

    @property
    def _thrown(self) -> Mask:
        """The designs in which this is a plate that is struck: the stream leaves it where it strikes it."""
        return (self.contact.arrival.incidence > 0.0) & (self.leg.segment.kind == "plate")

    def _known(self, values: Array) -> Array:
        """NaN where there is no stream."""
        known: Array = stretched(np.where(np.isnan(self.velocity_squared), np.nan, values), self.velocity_squared.shape)
        return known

    def _finite(self, values: Array) -> Array:
        """NaN where the stream stands still, which leaves it no depth."""
        there = np.isfinite(values) & ~np.isnan(self.velocity_squared)
        finite: Array = stretched(np.where(there, values, np.nan), self.velocity_squared.shape)
        return finite


def _flight_time(leg: Leg, distances: Array) -> Array:
    """Time at which a flight has covered a distance: Newton, from uniform acceleration between the same ends."""
    total = path_length(leg.path, leg.flight_time)
    start, whole = leg.start.velocity, leg.flight_time
    push = np.where(whole > 0.0, 2.0 * (total - start * whole) / np.where(whole > 0.0, whole, 1.0) ** 2, 0.0)
    divisor = start + np.sqrt(np.maximum(start**2 + 2.0 * push * distances, 0.0))
    time = np.where(divisor > 0.0, 2.0 * distances / np.where(divisor > 0.0, divisor, 1.0), 0.0)
    done = np.isnan(time)
    for _ in range(60):  # six do but next to the apex of a steep throw
        velocity, _ = motion(leg.path, time)
        step = (path_length(leg.path, time) - distances) / np.where(velocity > 0.0, velocity, np.inf)
        time = np.where(done, time, np.clip(time - step, 0.0, whole))  # each as if it were alone
        done |= ~(np.abs(step) > 1e-15 * whole)
        if done.all():
            break
    return time


def _velocities(contact: ContactLeg, places: Array, shares: Array | None) -> Array:
    """v² at places, shape (places, designs)."""
    arrival = contact.arrival
    end, last = np.full((2, places.shape[1]), np.nan)
    end[contact.rows], last[contact.rows] = contact.stretch.place, contact.stretch.velocity_squared
    y = np.where(places == end, last, np.nan)
    y = np.where(places == arrival.place, arrival.impact.after**2, y)  # also of streams that get no further
    for piece in contact.stretch.pieces:
        rows = contact.rows[piece.rows]
        whole = np.zeros(len(rows), dtype=bool)
        if shares is not None and not piece.by_root:
            whole = (piece.start == arrival.place[rows]) & (piece.end == end[rows])
        if shares is not None and whole.any():
            matrix = interpolation(len(piece.knots) - 2, shares)
            y[:, rows[whole]] = product(matrix, piece.knots[:, whole])
        if not whole.all():
            part, others = _some(piece, ~whole), rows[~whole]
            share = _share(part, places[:, others])
            root = part.start + share * (part.end - part.start)
            values = root**4 if piece.by_root else evaluate(part.knots, share)
            y[:, others] = np.where(np.isnan(share), y[:, others], values)
    return y


def _times(contact: ContactLeg, places: Array) -> Array:
    """The time since the contact began, at places, s, shape (places, designs)."""
    time = np.where(places == contact.arrival.place, 0.0, np.nan)
    elapsed = np.zeros(places.shape[1])
    for piece in contact.stretch.pieces:
        for part in _timed(piece):
            rows = contact.rows[part.rows]
            clock = elapsed[rows] + _clock(contact.slide.rows(rows), part)
            share = _share(part, places[:, rows])
            time[:, rows] = np.where(np.isnan(share), time[:, rows], evaluate(clock, share))
            elapsed[rows] = clock[-1]
    return time


TIMED = 3.0
"""Across how much growth of v² a panel's nodes resolve 1/v to rounding; more of it is divided."""


def _timed(piece: Piece) -> Iterator[Piece]:
    """The piece, divided in c until each part's own nodes resolve 1/v: a smooth v² does not make that smooth."""
    if piece.by_root:
        yield piece
        return
    steep = piece.knots.max(axis=0) > TIMED * piece.knots.min(axis=0)
    steep &= piece.end - piece.start > 1e-15
    if not steep.all():
        yield _some(piece, ~steep)
    if steep.any():
        part = _some(piece, steep)
        middle = 0.5 * (part.start + part.end)
        knots = rule(len(part.knots) - 2).knots[:, None]
        halves = [evaluate(part.knots, np.broadcast_to(0.5 * knots + at, part.knots.shape)) for at in (0.0, 0.5)]
        yield from _timed(part._replace(end=middle, knots=halves[0]))
        yield from _timed(part._replace(start=middle, knots=halves[1]))


def _some(piece: Piece, chosen: Mask) -> Piece:
    """A piece of some of its designs."""
    return Piece._make(field if isinstance(field, bool) else field[..., chosen] for field in piece)


def _clock(slide: Slide, piece: Piece) -> Array:
    """Time since the piece began at its knots: the integral of ds/v over c, or over r."""
    own = rule(len(piece.knots) - 2)
    width = piece.end - piece.start
    if piece.by_root:
        root = piece.start + width * own.nodes[:, None]
        course = Course(slide, piece.facet, piece.piece)
        change, _ = place_rates(course, root, width, piece.knots[1:-1])
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
