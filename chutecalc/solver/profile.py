"""The stream at any place of a solved leg: what its panels and its flight say there.

Places are arrays of shape (places, designs), as the panels' own values are; what is returned has that shape too.
"""

from functools import cached_property

import numpy as np

from chutecalc.core import balance, profile, walls
from chutecalc.design import stretched
from chutecalc.physics.arrays import Array, Mask
from chutecalc.physics.surface import point
from chutecalc.solver.leg import ContactLeg, Ends, Leg


class FlightProfile:
    """A leg's flight at distances flown, m, shape (places, designs)."""

    def __init__(self, leg: Leg, flow: Array, distances: Array) -> None:
        self.leg, self.flow, self.flown, self.shape = leg, flow, distances, distances.shape

    @cached_property
    def _told(self) -> tuple[Array, ...]:
        """Time since the leg began, x, z, velocity and slope."""
        out = np.empty((5, *self.flown.shape))
        profile.flying(self.leg.path, self.leg.flight_time, self.flown, out)
        return tuple(out)

    @property
    def time(self) -> Array:
        """Since the leg began, s."""
        return self._told[0]

    @cached_property
    def distance(self) -> Array:
        """From the inlet along the stream, m."""
        return self.leg.start.distance + self.flown

    @property
    def position(self) -> tuple[Array, Array]:
        """X and z, m."""
        return self._told[1], self._told[2]

    @property
    def velocity(self) -> Array:
        """m/s."""
        return self._told[3]

    @property
    def slope(self) -> Array:
        """Below horizontal, rad."""
        return self._told[4]

    @property
    def area(self) -> Array:
        """Q/v, m²."""
        return np.where(self.velocity > 0.0, self.flow / np.where(self.velocity > 0.0, self.velocity, 1.0), np.nan)


class SlideProfile:
    """A leg's contact at places, shares of the segment's length, shape (places, designs).

    NaN where there is no stream, or no such quantity. Quantities are worked out when they are first asked for.
    """

    def __init__(self, leg: Leg, contact: ContactLeg, flow: Array, places: Array) -> None:
        """The contact at places: NaN where none is wanted; outside the part travelled gives NaN."""
        self.leg, self.contact, self.flow, self.place, self.shape = leg, contact, flow, places, places.shape

    @cached_property
    def velocity_squared(self) -> Array:
        """m²/s²."""
        y = np.empty(self.place.shape)
        self.contact.panels.velocities(self.contact.ends, self.place, y)
        return y

    @cached_property
    def velocity(self) -> Array:
        """m/s."""
        return np.sqrt(self.velocity_squared)

    @cached_property
    def time(self) -> Array:
        """Since the leg began, s."""
        time = np.full(self.place.shape, np.nan)
        self.contact.panels.times(self.place, time)
        return self.leg.flight_time + np.where(self.place == self.contact.arrival.place, 0.0, time)

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
    def area(self) -> Array:
        """Q/v, m²; NaN where the stream stands still."""
        moving = self.velocity > 0.0
        return np.where(moving, self.flow / np.where(moving, self.velocity, 1.0), np.nan)

    @cached_property
    def lying(self) -> tuple[Array, ...]:
        """How the stream lies in the section, see :func:`chutecalc.core.profile.lying`: a table each."""
        out = np.empty((walls.LIE, *self.place.shape))
        profile.lying(*self.contact.way.read, self.place, self.velocity_squared, out)
        return tuple(out)

    @property
    def depth(self) -> Array:
        """M."""
        return self.lying[0]

    @property
    def width(self) -> Array:
        """Of the free surface, m."""
        return self.lying[1]

    @property
    def chamfer(self) -> Array:
        """Wetted length of the drawn facets on one side, m."""
        return self.lying[2]

    @property
    def missing(self) -> Array:
        """m, the share of the weight that hydrostatic wall pressures do not carry."""
        return self.lying[3]

    @property
    def top(self) -> Array:
        """Height of the section's drawn top above the floor, m; NaN where it has none."""
        return self.lying[4]

    @cached_property
    def pressing(self) -> tuple[Array, ...]:
        """What the walls bear, see :func:`chutecalc.core.profile.pressing`; on a plate what the impact does."""
        out = np.empty((walls.PRESS, *self.place.shape))
        profile.pressing(*self.contact.way.read, self.place, self.velocity_squared, out)
        arrival = self.contact.arrival
        thrown: Mask = (arrival.incidence > 0.0) & self.leg.segment.deflects
        if thrown.any():
            impact = arrival.impact
            struck = (impact.wall_friction, impact.friction, None, impact.pressure, np.nan, np.nan)
            for number, values in enumerate(struck, 2):
                if values is not None:
                    out[number] = np.where(thrown & ~np.isnan(self.velocity_squared), values, out[number])
        return tuple(out)

    @property
    def normal(self) -> Array:
        """Normal acceleration, m/s²."""
        return self.pressing[0]

    @property
    def stress(self) -> Array:
        """What the wall's friction is read at, f ρ n H, Pa; infinite at rest, where depth is."""
        return self.pressing[1]

    @property
    def wall_friction(self) -> Array:
        """μ."""
        return self.pressing[2]

    @property
    def friction(self) -> Array:
        """μ_e."""
        return self.pressing[3]

    @property
    def even_friction(self) -> Array:
        """μ_e where all wall pressures carry the weight alike, for the paper's law to compare with."""
        return self.pressing[4]

    @property
    def pressures(self) -> tuple[Array, ...]:
        """On floor, chamfers and side walls, Pa; on a plate the impact's."""
        return self.pressing[5:8]

    def wear(self, wall: int) -> Array:
        """Friction power per area there, μ p v, W/m², where slip is the mean velocity; on a plate the impact's."""
        wear: Array = self.pressures[wall] * self.wall_friction * self.velocity
        thrown = (self.contact.arrival.incidence > 0.0) & self.leg.segment.deflects
        return np.where(thrown, self.contact.arrival.impact.wear, wear) if wall == 0 else wear

    @cached_property
    def balance(self) -> Array:
        """The velocity below which friction wins here, m/s, see :func:`chutecalc.core.balance.balances`."""
        out = np.empty(self.place.shape)
        balance.balances(*self.contact.way.read, self.place, self.velocity, out)
        return out

    def moving(self, velocity_squared: float) -> "SlideProfile":
        """The same with some velocity at all places, m²/s²."""
        other = SlideProfile(self.leg, self.contact, self.flow, self.place)
        other.__dict__["velocity_squared"] = np.full(self.place.shape, velocity_squared)
        return other

    def known(self, values: Array) -> Array:
        """NaN where there is no stream."""
        known: Array = stretched(np.where(np.isnan(self.velocity_squared), np.nan, values), self.velocity_squared.shape)
        return known


class EndProfile(SlideProfile):
    """The end of a chute in contact, shape (1, designs)."""

    def __init__(self, ends: Ends, flow: Array) -> None:
        self.ends, self.flow = ends, flow
        self.__dict__.update(velocity=ends.velocity[None], lying=tuple(ends.lying), pressing=tuple(ends.pressing))

    @property
    def distance(self) -> Array:
        """From the inlet along the stream, m."""
        return self.ends.distance[None]

    @property
    def position(self) -> tuple[Array, Array]:
        """X and z, m."""
        return self.ends.x[None], self.ends.z[None]

    @property
    def slope(self) -> Array:
        """Below horizontal, rad."""
        return self.ends.slope[None]

    def wear(self, wall: int) -> Array:
        """Friction power per area there, W/m²."""
        wear: Array = self.pressures[wall] * self.wall_friction * self.velocity
        return wear


class EndFlight(FlightProfile):
    """The end of a chute in flight, shape (1, designs)."""

    def __init__(self, ends: Ends, flow: Array) -> None:
        self.flow = flow
        self.__dict__["distance"] = ends.distance[None]
        there = (np.nan, ends.x, ends.z, ends.velocity, ends.slope)
        self.__dict__["_told"] = tuple(np.atleast_2d(values) for values in there)
