"""What a stream is at one place, and what it takes to solve one chute: the records of the chain."""

from array import array
from typing import Any

from chutecalc.core import floats, quartic, state


class Point:
    """The stream at one place. Errors go with each other's signs: those of one and the same small change."""

    def __init__(self) -> None:
        self.distance = self.x = self.z = self.slope = self.velocity = 0.0
        """From the inlet along the stream; place, m; rad below horizontal; m/s."""
        self.error = self.x_error = self.z_error = self.slope_error = 0.0
        """Of the velocity, relative; m; m; rad. After a stall the first is that of the place."""


class Flight:
    """A parabola, and how it differs from the one meant, to first order, at a time on it."""

    def __init__(self) -> None:
        self.x = self.z = self.forward = self.downward = self.gravity = 0.0
        """Where it begins; velocities there, m/s; m/s²."""
        self.off_x = self.off_z = self.off_forward = self.off_downward = self.down = 0.0
        """Errors at the time looked at, and the velocity downward then."""


class Impact:
    """What an impact does; 0 where a stream meets a surface along it."""

    def __init__(self) -> None:
        self.footprint = self.pressure = self.stress = 0.0
        """Length on which the stream presses, m: H/sin i, or the segment's where that is shorter; momentum lost over
        that, Pa: ρ v² sin² i but on a very short segment; what the floor bears there, f (ρ n H + that), Pa."""
        self.wall_friction = self.friction = 0.0
        """μ of the impulse, what the wall's shear stress grows by over what its normal stress does; μ_e there."""
        self.after = self.wear = 0.0
        """Velocity along the surface that is left, m/s; friction power per area of the floor over the footprint, W/m²,
        where slip is the mean velocity."""


class Arrival:
    """How a stream meets a segment."""

    def __init__(self) -> None:
        self.status = 0
        self.time = self.distance = self.place = self.velocity = self.incidence = self.gap = 0.0
        """In flight before, s and m; where, as a share of the segment's length; m/s; angle between stream and surface,
        0 where they are tangent; by how much a stream that misses passes the segment's end."""
        self.error = self.place_error = 0.0
        """Relative, of the velocity left, and of the place met, with one sign."""


class Segment:
    """A segment of a chute, as it is drawn; ``next`` is the one after it."""

    def __init__(self, number: int, last: bool, own: "state.Stream", following: "Segment | None") -> None:
        self.number = number
        self.final = last
        self.own = own
        """The stream on it, and its numbers; a fall has another's, and does not look at it."""
        self.next = self if following is None else following
        self.fall = self.plate = False
        self.drop = self.run = floats.NAN
        """Of a fall; neither where it ends on the next segment."""
        self.start_x = self.start_z = floats.NAN
        """Where it is drawn from; not a number where that is the end of the one before it."""
        self.entry_slope = self.exit_slope = self.radius = self.length = floats.NAN
        """Not a number: the entry slope of what is tangent to a falling stream, a straight's radius, a curve's
        length."""
        self.off_x = self.off_z = self.off_slope = 0.0
        """By how much it may be drawn wrongly: where it begins; and the slope there, of an arc tangent to a stream."""
        self.aside_x = self.aside_z = 0.0
        """By how much points of it that have the same slope may be off."""
        self.sign = 1.0
        """Of that, so that it goes with the error of the stream on it, which is positive."""


class Course:
    """A stream on its way through a chute."""

    def __init__(self, first: Segment, last: Segment) -> None:
        self.first, self.last, self.again = first, last, first
        """Its segments; and that from which on the designs of a batch differ: what comes before is solved once."""
        self.inlet, self.here, self.start, self.entry, self.end = Point(), Point(), Point(), Point(), Point()
        """At the inlet; now; and of the leg: as it came, on the surface after an impact, and where the leg ends."""
        self.flight, self.arrival, self.impact, self.beside = Flight(), Arrival(), Impact(), Impact()
        """``beside`` is an impact that differs a little, to see what an error becomes."""
        self.curve = quartic.Quartic()
        self.gravity = 0.0
        self.status = 0
        self.airborne = False
        """In free flight: not on the drawn end of the segment it came from."""
        self.arrived = False
        """The fall before has found how the stream meets the segment."""
        self.drawn_x = self.drawn_z = self.drawn_off_x = self.drawn_off_z = 0.0
        """The drawn end of the segment before."""
        self.fault_slope, self.fault_number, self.faults = 0.0, 0, 0
        """Of a stream that a curve cannot be tangent to, and the curve; and how many designs have such a one."""
        self.saved = Point()
        self.saved_status, self.saved_airborne = 0, False
        self.error = self.saved_error = 0.0
        """Of the last segment that the stream has touched: of the velocity there, or after a stall of the place."""
        self.saved_x = self.saved_z = self.saved_off_x = self.saved_off_z = 0.0
        """The stream, and the drawn end before it, where designs begin to differ."""
        self.flight_time = 0.0
        self.leg_status = self.strikes = 0
        """How the leg ended, and how often the segment was struck before."""
        self.row = 0
        self.legs: Any = floats.zeros(LEG)
        """What became of the stream on each segment, one leg after the other; see :data:`FIELDS`."""
        self.room = 0
        self.count = 0
        self.full = False
        self.ends: Any = None
        """How each design ends, see :data:`ENDS`: a table of a row for each quantity."""
        self.lying: Any = None
        self.pressing: Any = None
        """How its stream lies there, and what the walls bear, as of :mod:`chutecalc.core.walls`."""
        self.ends_only, self.tells_lying, self.tells_pressing = False, False, False
        """What is not asked for is not worked out: legs, and those."""


ENDS = ("status", "velocity", "error", "distance", "x", "z", "slope")
FIELDS = (
    *("row", "segment", "strikes", "status"),
    *(f"{at}_{name}" for at in ("start", "entry", "exit") for name in (
        "distance", "x", "z", "slope", "velocity", "error", "x_error", "z_error", "slope_error")),
    *("path_x", "path_z", "path_forward", "path_downward", "path_gravity", "flight_time"),
    *("surface_x", "surface_z", "surface_slope", "surface_turn", "surface_length"),
    *("distance", "place", "velocity", "incidence", "gap", "met"),
    *("footprint", "pressure", "stress", "wall_friction", "friction", "after", "wear"),
    *("end_place", "end_squared", "beyond", "beyond_status", "tried", "panels"),
)  # fmt: skip
"""The numbers of a leg, in their order. ``met`` is the arrival's status; ``end_squared`` is v² where the leg ends."""
LEG = 61
NUMBERS = LEG  # as Python sees it


def put(legs: "array[float]", at: int, point: Point) -> None:
    """Writes down a point."""
    legs[at], legs[at + 1], legs[at + 2] = point.distance, point.x, point.z
    legs[at + 3], legs[at + 4], legs[at + 5] = point.slope, point.velocity, point.error
    legs[at + 6], legs[at + 7], legs[at + 8] = point.x_error, point.z_error, point.slope_error


def nowhere(point: Point) -> None:
    """Of a stream that is not there."""
    point.distance = point.x = point.z = point.slope = point.velocity = floats.NAN
    point.error = point.x_error = point.z_error = point.slope_error = floats.NAN


def copy(there: Point, here: Point) -> None:
    """Makes the one what the other is."""
    there.distance, there.x, there.z = here.distance, here.x, here.z
    there.slope, there.velocity = here.slope, here.velocity
    there.error, there.x_error, there.z_error = here.error, here.x_error, here.z_error
    there.slope_error = here.slope_error
