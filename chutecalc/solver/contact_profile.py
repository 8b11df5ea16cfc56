"""Evaluate a solved segment in contact at any position, from its panels.

Positions are arrays of shape (positions, designs), as are all results.
"""

from functools import cached_property

import numpy as np

from chutecalc.core import critical_velocity, profile, wall_loads
from chutecalc.design import stretched
from chutecalc.physics.arrays import Array, Mask
from chutecalc.physics.surface import point
from chutecalc.solver.segment_solution import ContactSolution, Ends, SegmentSolution


class ContactProfile:
    """The contact of a segment's solution, at shares of the segment's length.

    Results are NaN where there is no stream or no such quantity, and are computed when first read.
    """

    def __init__(self, solved: SegmentSolution, contact: ContactSolution, flow: Array, shares: Array) -> None:
        """Evaluate the contact at shares.

        Args:
            solved: the segment's solution.
            contact: what it has along the guiding surface.
            flow: volume rate Q, m³/s, shape (1,) or (designs,).
            shares: shape (shares, designs); NaN, and shares outside the part travelled, give NaN.
        """
        self.solved, self.contact, self.flow, self.share, self.shape = solved, contact, flow, shares, shares.shape

    @cached_property
    def velocity_squared(self) -> Array:
        """Velocity squared times momentum factor, α_m v², m²/s², as the core has it."""
        y = np.empty(self.share.shape)
        self.contact.panels.velocities_squared(self.contact.bounds, self.share, y)
        return y

    @cached_property
    def velocity(self) -> Array:
        """Velocity, m/s."""
        velocity: Array = np.sqrt(self.velocity_squared) / self.contact.guide_rows.momentum_root
        return velocity

    @cached_property
    def time(self) -> Array:
        """Time since the segment's solution began, s."""
        time = np.full(self.share.shape, np.nan)
        self.contact.panels.times(self.share, time)
        return self.solved.flight_time + np.where(self.share == self.contact.arrival.share, 0.0, time)

    @property
    def distance(self) -> Array:
        """Distance from the inlet along the stream, m."""
        return self.solved.entry.distance + self.contact.surface.length * (self.share - self.contact.arrival.share)

    @cached_property
    def _point(self) -> tuple[Array, Array, Array]:
        return point(self.contact.surface, self.share)

    @property
    def position(self) -> tuple[Array, Array]:
        """Position x and z, m."""
        return self._point[:2]

    @property
    def slope(self) -> Array:
        """Slope below horizontal, rad."""
        return self._point[2]

    @cached_property
    def area(self) -> Array:
        """Flow area Q/v, m²; NaN at rest."""
        moving = self.velocity > 0.0
        return np.where(moving, self.flow / np.where(moving, self.velocity, 1.0), np.nan)

    @cached_property
    def stream_section(self) -> tuple[Array, ...]:
        """Tables of the stream in its section, see :func:`chutecalc.core.wall_loads.write_stream_section`."""
        out = np.empty((wall_loads.STREAM_SECTION_ROWS, *self.share.shape))
        profile.tabulate_stream_section(*self.contact.guide_rows.core_arguments, self.share, self.velocity_squared, out)
        return tuple(out)

    @property
    def depth(self) -> Array:
        """Depth, m."""
        return self.stream_section[0]

    @property
    def width(self) -> Array:
        """Width of the free surface, m."""
        return self.stream_section[1]

    @property
    def chamfer(self) -> Array:
        """Wetted length of the drawn facets on one side, m."""
        return self.stream_section[2]

    @property
    def missing(self) -> Array:
        """Missing load m, the fraction of the weight that hydrostatic wall pressures do not carry."""
        return self.stream_section[3]

    @property
    def top(self) -> Array:
        """Height of the section's drawn top above the floor, m; NaN where it has none."""
        return self.stream_section[4]

    @property
    def fill(self) -> Array:
        """Share of a closed section's area, or of the height of the walls, that is filled; NaN where neither exists."""
        return self.stream_section[5]

    @property
    def greatest_width(self) -> Array:
        """Greatest width of the stream, m."""
        return self.stream_section[6]

    @cached_property
    def wall_loads(self) -> tuple[Array, ...]:
        """Tables of the loads on the walls, on a plate those of the impact.

        See :func:`chutecalc.core.wall_loads.write_wall_loads`.
        """
        out = np.empty((wall_loads.WALL_LOAD_ROWS, *self.share.shape))
        profile.tabulate_wall_loads(*self.contact.guide_rows.core_arguments, self.share, self.velocity_squared, out)
        arrival = self.contact.arrival
        thrown: Mask = (arrival.incidence > 0.0) & self.solved.segment.deflects
        if thrown.any():
            impact = arrival.impact
            struck = (impact.wall_friction, impact.friction, None, impact.pressure, np.nan, np.nan)
            for number, values in enumerate(struck, 2):
                if values is not None:
                    out[number] = np.where(thrown & ~np.isnan(self.velocity_squared), values, out[number])
        return tuple(out)

    @property
    def normal_acceleration(self) -> Array:
        """Normal acceleration, m/s²."""
        return self.wall_loads[0]

    @property
    def stress(self) -> Array:
        """Stress at which wall friction is read, f ρ n H, Pa; infinite at rest, as depth is."""
        return self.wall_loads[1]

    @property
    def wall_friction(self) -> Array:
        """Coefficient of wall friction μ."""
        return self.wall_loads[2]

    @property
    def friction(self) -> Array:
        """Equivalent friction coefficient μ_e."""
        return self.wall_loads[3]

    @property
    def equilibrium_friction(self) -> Array:
        """Equivalent friction coefficient μ_e by the equilibrium law, with wall pressures that carry the weight."""
        return self.wall_loads[4]

    @property
    def pressures(self) -> tuple[Array, ...]:
        """Greatest pressures on floor, chamfers and side walls, Pa; on a plate the impact's on the floor."""
        return self.wall_loads[5:8]

    def wear(self, wall: int) -> Array:
        """Return the friction power per area μ p v, W/m², with the mean velocity as slip.

        On the floor of a plate it is the impact's.

        Args:
            wall: 0 for the floor, 1 for the chamfers, 2 for the side walls.
        """
        wear: Array = self.pressures[wall] * self.wall_friction * self.velocity
        thrown = (self.contact.arrival.incidence > 0.0) & self.solved.segment.deflects
        return np.where(thrown, self.contact.arrival.impact.wear, wear) if wall == 0 else wear

    @cached_property
    def critical_velocity(self) -> Array:
        """Velocity below which friction exceeds gravity's pull, m/s, see :mod:`chutecalc.core.critical_velocity`."""
        out = np.empty(self.share.shape)
        critical_velocity.critical_velocities(*self.contact.guide_rows.core_arguments, self.share, self.velocity, out)
        return out

    def with_velocity_squared(self, velocity_squared: float) -> "ContactProfile":
        """Return a profile at the same shares with one velocity at all of them.

        Args:
            velocity_squared: α_m v², m²/s².
        """
        other = ContactProfile(self.solved, self.contact, self.flow, self.share)
        other.__dict__["velocity_squared"] = np.full(self.share.shape, velocity_squared)
        return other

    def where_flowing(self, values: Array) -> Array:
        """Return values with NaN where there is no stream.

        Args:
            values: shape (shares, designs) or one that broadcasts to it.
        """
        flowing: Array = stretched(
            np.where(np.isnan(self.velocity_squared), np.nan, values), self.velocity_squared.shape
        )
        return flowing


class EndContactProfile(ContactProfile):
    """The end of a chute in contact, shape (1, designs).

    Args:
        ends: ends of the designs.
        flow: volume rate Q, m³/s, shape (1,) or (designs,).
    """

    def __init__(self, ends: Ends, flow: Array) -> None:
        self.ends, self.flow = ends, flow
        self.__dict__.update(
            velocity=ends.velocity[None], stream_section=tuple(ends.stream_section), wall_loads=tuple(ends.wall_loads)
        )

    @property
    def distance(self) -> Array:
        """Distance from the inlet along the stream, m."""
        return self.ends.distance[None]

    @property
    def position(self) -> tuple[Array, Array]:
        """Position x and z, m."""
        return self.ends.x[None], self.ends.z[None]

    @property
    def slope(self) -> Array:
        """Slope below horizontal, rad."""
        return self.ends.slope[None]

    def wear(self, wall: int) -> Array:
        """Return the friction power per area μ p v, W/m².

        Args:
            wall: 0 for the floor, 1 for the chamfers, 2 for the side walls.
        """
        wear: Array = self.pressures[wall] * self.wall_friction * self.velocity
        return wear
