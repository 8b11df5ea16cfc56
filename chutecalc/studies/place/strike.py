"""Where a flight comes by, and how a surface must stand there: closed forms on the parabola.

A stream that begins its flight at (x0, z0) with velocity v at a slope a0 below horizontal has after a time t

    x = x0 + v cos a0 t,   z = z0 - v sin a0 t - g t²/2,   tan a = (v sin a0 + g t) / (v cos a0).

It strikes a surface of slope b from its side σ at the incidence i = σ (a - b). So a place fixes the time, the time the
slope of the stream, and that and the incidence the slope of the surface; or the other way round.
"""

from math import atan2, cos, degrees, hypot, inf, pi, sin, sqrt, tan
from typing import NamedTuple

from chutecalc.errors import ChutecalcError, UsageError

LEVEL = 1e-12
"""Share of the velocity below which a stream has no horizontal velocity: it falls straight down."""


class NotReachedError(ChutecalcError):
    """What the stream cannot do, with the nearest that it can."""


class Launch(NamedTuple):
    """A stream where its flight begins."""

    x: float
    z: float
    """Place, m."""
    slope: float
    """Slope below horizontal, rad."""
    velocity: float
    """Velocity, m/s."""
    gravity: float
    """Gravity, m/s²."""

    @property
    def forward(self) -> float:
        """Horizontal velocity, m/s; exactly 0 for a stream that falls straight down."""
        forward = self.velocity * cos(self.slope)
        return forward if abs(forward) > LEVEL * max(self.velocity, LEVEL) else 0.0

    @property
    def downward(self) -> float:
        """Downward velocity, m/s."""
        return self.velocity * sin(self.slope)

    def at(self, time: float) -> tuple[float, float]:
        """Return x and z after a time, m.

        Args:
            time: s.
        """
        return self.x + self.forward * time, self.z - (self.downward + 0.5 * self.gravity * time) * time

    def slope_at(self, time: float) -> float:
        """Return the slope after a time, rad below horizontal.

        Args:
            time: s.
        """
        return atan2(self.downward + self.gravity * time, self.forward)

    def velocity_at(self, time: float) -> float:
        """Return the velocity after a time, m/s.

        Args:
            time: s.
        """
        return hypot(self.forward, self.downward + self.gravity * time)

    def time_to_x(self, x: float) -> float:
        """Return when the flight is at x, s.

        Args:
            x: m.

        Raises:
            NotReachedError: it never is.

        >>> Launch(x=0.0, z=0.0, slope=0.0, velocity=2.0, gravity=9.81).time_to_x(3.0)
        1.5
        """
        if self.forward == 0.0:
            if x == self.x:
                raise UsageError(f"the stream falls straight down at x {x:g} m: give z instead")
            raise NotReachedError(f"the stream falls straight down: the nearest is x {self.x:z.6g} m. Give z instead")
        time = (x - self.x) / self.forward
        if time < 0.0:
            raise NotReachedError(f"its flight begins at x {self.x:z.6g} m: that is the nearest")
        return time

    def time_to_z(self, z: float) -> float:
        """Return when the flight comes down to z, s.

        Args:
            z: m.

        Raises:
            NotReachedError: it never does.

        >>> Launch(x=0.0, z=0.0, slope=0.0, velocity=2.0, gravity=9.81).time_to_z(-4.905)
        1.0
        """
        under = self.downward**2 + 2.0 * self.gravity * (self.z - z)
        time = (sqrt(under) - self.downward) / self.gravity if under >= 0.0 else -1.0
        if time < 0.0:
            top = self.z + min(self.downward, 0.0) ** 2 / (2.0 * self.gravity)
            raise NotReachedError(f"its flight begins to fall at z {top:z.6g} m: that is the nearest")
        return time

    def time_to_slope(self, slope: float) -> float:
        """Return when the flight has a slope, s; negative where it had it before, infinite where it never has it.

        Args:
            slope: rad below horizontal.
        """
        if self.forward == 0.0:
            return 0.0 if slope == pi / 2 else inf if slope > pi / 2 else -inf
        if slope >= pi / 2:
            return inf
        return (self.forward * tan(slope) - self.downward) / self.gravity if slope > -pi / 2 else -inf


class Strike(NamedTuple):
    """How the middle of a stream strikes a surface."""

    time: float
    """Time of flight, s."""
    slope: float
    """Slope of the surface there, rad below horizontal."""


def strike_at(launch: Launch, side: float, time: float, incidence: float) -> Strike:
    """Return how a surface must stand to be struck after a time of flight at an incidence.

    Args:
        launch: of the flight.
        side: σ, dimensionless, 1 for a floor and -1 for a roof.
        time: of the flight, s.
        incidence: rad.
    """
    return Strike(time, launch.slope_at(time) - side * incidence)


def strike_on(launch: Launch, side: float, slope: float, incidence: float) -> Strike:
    """Return where a surface of a slope must stand to be struck at an incidence.

    Args:
        launch: of the flight.
        side: σ, dimensionless, 1 for a floor and -1 for a roof.
        slope: of the surface where it is struck, rad below horizontal.
        incidence: rad.

    Raises:
        NotReachedError: the stream never has the slope for it.

    >>> flat = Launch(x=0.0, z=0.0, slope=0.0, velocity=3.0, gravity=10.0)
    >>> from math import pi
    >>> round(strike_on(flat, 1.0, 0.25 * pi - 0.2, 0.2).time, 9)  # where the stream has 45°
    0.3
    """
    time = launch.time_to_slope(slope + side * incidence)
    if 0.0 <= time < inf:
        return Strike(time, slope)
    reached = launch.slope if time < 0.0 else pi / 2
    nearest = degrees(side * (reached - slope))
    where = "as its flight begins" if time < 0.0 else "after a long fall"
    possible = "" if nearest < 0.0 else f"; the nearest is an incidence of {nearest:z.6g}°, {where}"
    raise NotReachedError(
        f"it would need a slope of {degrees(slope + side * incidence):z.6g}° there, and has"
        f" {degrees(launch.slope):z.6g}° to 90° on its way, with the surface at {degrees(slope):z.6g}°{possible}"
    )
