"""The stream at any place of a solved leg: what its panels and its flight say there.

Places are arrays of shape (places, designs), as the panels' own values are; what is returned has that shape too.
"""

from functools import cached_property

import numpy as np

from chutecalc.design import stretched
from chutecalc.physics.arrays import Array, Mask
from chutecalc.physics.flight import motion, path_length, position
from chutecalc.physics.friction import equilibrium_friction, equivalent_friction
from chutecalc.physics.section import Facets, take_facet, wetted_facet
from chutecalc.physics.surface import point
from chutecalc.physics.wall import wall_friction
from chutecalc.physics.wear import wall_pressures
from chutecalc.physics.wetting import Wetting, depth_and_width, wetting
from chutecalc.solver.balance import critical_velocity
from chutecalc.solver.leg import ContactLeg, Leg


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

    def __init__(self, leg: Leg, contact: ContactLeg, places: Array) -> None:
        """The contact at places: NaN where none is wanted; outside the part travelled gives NaN."""
        self.leg, self.contact, self.place = leg, contact, places

    @cached_property
    def velocity_squared(self) -> Array:
        """m²/s²."""
        return _velocities(self.contact, self.place)

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
        other = SlideProfile(self.leg, self.contact, self.place)
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


def _velocities(contact: ContactLeg, places: Array) -> Array:
    """v² at places, shape (places, designs)."""
    arrival = contact.arrival
    y = np.full(places.shape, np.nan)
    if contact.stretch.panels is not None:
        contact.stretch.panels.velocities(places, y)
    y = np.where(places == contact.stretch.place, contact.stretch.velocity_squared, y)
    return np.where(places == arrival.place, arrival.impact.after**2, y)  # also of streams that get no further


def _times(contact: ContactLeg, places: Array) -> Array:
    """The time since the contact began, at places, s, shape (places, designs)."""
    time = np.full(places.shape, np.nan)
    if contact.stretch.panels is not None:
        contact.stretch.panels.times(places, time)
    return np.where(places == contact.arrival.place, 0.0, time)
