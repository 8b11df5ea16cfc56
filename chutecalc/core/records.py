"""Hold the stream at a point, and the state of a chute while it is solved."""

from array import array
from typing import Any

from chutecalc.core import floats, quartic, state


class Point:
    """The stream at a point. Errors have the signs of one and the same small change."""

    def __init__(self) -> None:
        self.distance = self.x = self.z = self.slope = self.velocity = 0.0
        """Distance from the inlet along the stream, m; position, m; slope below horizontal, rad; velocity, m/s."""
        self.error = self.x_error = self.z_error = self.slope_error = 0.0
        """Errors: of the velocity, relative; of the position, m; of the slope, rad. After a stall the first is that of
        the share."""


class Flight:
    """A parabola, and its first-order errors at a time on it."""

    def __init__(self) -> None:
        self.x = self.z = self.forward = self.downward = self.gravity = 0.0
        """Start of the flight, m; velocities there, m/s; gravity, m/s²."""
        self.x_error = self.z_error = self.forward_error = self.downward_error = self.downward_now = 0.0
        """Errors at the time in question, and the downward velocity then."""
        self.since = floats.NAN
        """When it comes out of a closed segment into the one in question, s; NaN where it comes from the open."""


class Impact:
    """Effects of an impact; 0 where a stream meets a surface along it."""

    def __init__(self) -> None:
        self.footprint = self.pressure = self.stress = 0.0
        """Length on which the stream presses, m: H/sin i, or the segment's length if shorter; momentum lost over it,
        Pa: ρ v² sin² i except on a very short segment; stress on the floor, f (ρ n H + pressure), Pa."""
        self.wall_friction = self.friction = 0.0
        """μ of the impulse, the shear stress that it adds over its normal stress; and its μ_e."""
        self.velocity_after = self.wear = 0.0
        """Velocity left along the surface, m/s; friction power per area of the floor over the footprint, W/m², with
        the mean velocity as slip."""


class Arrival:
    """How a stream meets a segment."""

    def __init__(self) -> None:
        self.status = 0
        self.time = self.distance = self.share = self.velocity = self.incidence = self.gap = 0.0
        """Time, s, and length, m, of the flight before; share of the segment's length; velocity, m/s; incidence, rad,
        0 where tangent; gap by which a stream that misses passes the segment's end, m."""
        self.error = self.share_error = 0.0
        """Errors with one sign: of the velocity left, relative, and of the share."""


class Segment:
    """A segment of a chute as drawn; ``next`` is the one after it."""

    def __init__(self, number: int, last: bool, stream: "state.Stream", next_segment: "Segment | None") -> None:
        self.number = number
        self.final = last
        self.stream = stream
        """State of the stream on it, with its numbers; a fall has another segment's and does not use it."""
        self.next = self if next_segment is None else next_segment
        self.fall = self.plate = False
        self.closed = False
        """Whether its section is closed: opposite to the surface that is drawn lies another one, its roof."""
        self.roof = stream
        """State of the stream on that surface; ``stream`` itself where there is none."""
        self.on_roof = False
        """Whether the stream is met there, or was last."""
        self.roots = 0
        """Known roots at time 0 of the flight to the surface that is met next."""
        self.may_be_passed = False
        """Whether a stream that passes it without touching it flies on; otherwise the chute fails there."""
        self.drop = self.run = floats.NAN
        """Drop and run of a fall, m. It ends there only if the next segment has no start of its own."""
        self.start_x = self.start_z = floats.NAN
        """Fixed start, m; NaN where it is the end of the segment before, and after a fall where the stream ends it."""
        self.entry_slope = self.exit_slope = self.radius = self.length = floats.NAN
        """NaN: the entry slope of a curve tangent to a falling stream, the radius of a straight, the length of a
        curve."""
        self.start_x_error = self.start_z_error = self.slope_error = 0.0
        """Errors of its start, m, and of the slope there, rad, for an arc tangent to a stream."""
        self.arc_x_error = self.arc_z_error = 0.0
        """Errors of the position of points of equal slope, m."""
        self.error_sign = 1.0
        """Sign that they take so as to go with the error of the stream on it, which is positive."""


class ChuteState:
    """State of a stream on its way through a chute."""

    def __init__(self, first: Segment, last: Segment) -> None:
        self.first, self.last, self.first_varied = first, last, first
        """Its segments, and the first in which the designs of a batch differ: those before it are solved once."""
        self.inlet, self.current, self.start, self.entry, self.end = Point(), Point(), Point(), Point(), Point()
        """The stream at the inlet; now; and on a segment: as it came, on the surface after an impact, and at the
        end."""
        self.launch = Point()
        """The stream where it came into the air, if it has fallen since to a level or a distance; else NaN."""
        self.flight, self.arrival, self.impact, self.perturbed = Flight(), Arrival(), Impact(), Impact()
        """``perturbed`` is an impact changed a little, to see how an error grows."""
        self.landing = Point()
        """The stream where it lands on the receiving belt."""
        self.belt_x = self.belt_z = self.belt_slope = floats.NAN
        """A point of the receiving belt, m, and its slope, rad; NaN for one where the last segment ends."""
        self.clearance = quartic.Quartic()
        self.gravity = 0.0
        self.status = 0
        self.on_roof = False
        """Whether the stream is at the end of the roof of the segment before it."""
        self.mouth_time = self.saved_mouth_time = floats.NAN
        """When its flight comes out of the closed segment before, s; NaN if it does not."""
        self.airborne = False
        """Whether the stream flies, and is not at the drawn end of the segment that it came from."""
        self.already_landed = False
        """Whether the fall before has found how the stream meets the segment."""
        self.drawn_x = self.drawn_z = self.drawn_x_error = self.drawn_z_error = 0.0
        """Drawn end of the segment before, m, and its errors."""
        self.fault_slope, self.fault_number, self.faults = 0.0, 0, 0
        """Slope of a stream that a curve cannot be tangent to, rad; number of that curve; and how many designs have
        one."""
        self.saved, self.saved_launch = Point(), Point()
        self.saved_status, self.saved_airborne, self.saved_on_roof = 0, False, False
        self.error = self.saved_error = 0.0
        """Error on the last segment that the stream touched: of the velocity, relative, or after a stall of the
        share."""
        self.saved_x = self.saved_z = self.saved_x_error = self.saved_z_error = 0.0
        """The drawn end before the segment where designs begin to differ, with its errors."""
        self.flight_time = 0.0
        self.segment_status = self.strikes = 0
        """How the segment ended, and how often it was struck before."""
        self.row = 0
        self.solutions: Any = floats.zeros(SOLUTION_SIZE)
        """Solutions of the segments one after the other, see :data:`FIELDS`."""
        self.capacity = 0
        self.count = 0
        self.full = False
        self.ends: Any = None
        """How each design ends, see :data:`ENDS`: a row for each quantity."""
        self.stream_section: Any = None
        self.wall_loads: Any = None
        """Tables of the stream in the last section and of the loads on its walls, see
        :mod:`chutecalc.core.wall_loads`."""
        self.ends_only, self.with_stream_section, self.with_wall_loads = False, False, False
        """What is not asked for is not computed: solutions of segments, and those tables."""


ENDS = (
    *("status", "velocity", "error", "distance", "x", "z", "slope"),
    *("landing_x", "landing_z", "landing_velocity", "landing_slope", "clearance"),
)
FIELDS = (
    *("row", "segment", "strikes", "status"),
    *(f"{at}_{name}" for at in ("start", "entry", "exit") for name in (
        "distance", "x", "z", "slope", "velocity", "error", "x_error", "z_error", "slope_error")),
    *("path_x", "path_z", "path_forward", "path_downward", "path_gravity", "flight_time"),
    *("surface_x", "surface_z", "surface_slope", "surface_turn", "surface_length", "surface_side"),
    *("distance", "share", "velocity", "incidence", "gap", "arrival_status"),
    *("footprint", "pressure", "stress", "wall_friction", "friction", "velocity_after", "wear"),
    *("end_share", "end_velocity_squared", "beyond_share", "beyond_status", "attempts", "panels"),
)  # fmt: skip
"""Numbers of a segment's solution, in order. ``end_velocity_squared`` is α_m v² where the segment's solution ends."""
SOLUTION_SIZE = 62
SOLUTION_NUMBERS = SOLUTION_SIZE  # for Python; the other is a C constant if compiled


def write_point(buffer: "array[float]", at: int, point: Point) -> None:
    """Write a point to the buffer."""
    buffer[at], buffer[at + 1], buffer[at + 2] = point.distance, point.x, point.z
    buffer[at + 3], buffer[at + 4], buffer[at + 5] = point.slope, point.velocity, point.error
    buffer[at + 6], buffer[at + 7], buffer[at + 8] = point.x_error, point.z_error, point.slope_error


def clear_point(point: Point) -> None:
    """Set a point to NaN: there is no stream."""
    point.distance = point.x = point.z = point.slope = point.velocity = floats.NAN
    point.error = point.x_error = point.z_error = point.slope_error = floats.NAN


def copy_point(target: Point, source: Point) -> None:
    """Copy a point."""
    target.distance, target.x, target.z = source.distance, source.x, source.z
    target.slope, target.velocity = source.slope, source.velocity
    target.error, target.x_error, target.z_error = source.error, source.x_error, source.z_error
    target.slope_error = source.slope_error
