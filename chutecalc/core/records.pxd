cimport cython
from chutecalc.core cimport floats, quartic, state

cdef int SOLUTION_SIZE

@cython.final
cdef class Point:
    cdef public double distance, x, z, slope, velocity, error, x_error, z_error, slope_error

@cython.final
cdef class Flight:
    cdef public double x, z, forward, downward, gravity, x_error, z_error, forward_error, downward_error, downward_now, since

@cython.final
cdef class Impact:
    cdef public double footprint, pressure, stress, wall_friction, friction, velocity_after, wear

@cython.final
cdef class Arrival:
    cdef public int status
    cdef public double time, distance, share, velocity, incidence, gap, error, share_error

@cython.final
cdef class Segment:
    cdef public int number
    cdef public bint final, fall, plate, closed, on_roof, may_be_passed
    cdef public int roots
    cdef public state.Stream stream, roof
    cdef public Segment next
    cdef public double drop, run, start_x, start_z, entry_slope, exit_slope, radius, length
    cdef public double start_x_error, start_z_error, slope_error, arc_x_error, arc_z_error, error_sign

@cython.final
cdef class ChuteState:
    cdef public Segment first, last, first_varied
    cdef public Point saved, saved_launch, launch, inlet, current, start, entry, end, landing
    cdef public Flight flight
    cdef public Arrival arrival
    cdef public Impact impact, perturbed
    cdef public quartic.Quartic clearance
    cdef public int saved_status, status, segment_status, strikes, fault_number, faults, row, capacity, count
    cdef public bint saved_airborne, saved_on_roof, airborne, on_roof, already_landed, full
    cdef public double error, saved_error, saved_x, saved_z, saved_x_error, saved_z_error, gravity, drawn_x, drawn_z, drawn_x_error, drawn_z_error, fault_slope, flight_time, belt_x, belt_z, belt_slope, mouth_time, saved_mouth_time
    cdef public double[::1] solutions
    cdef public double[:, ::1] ends
    cdef public double[:, :, ::1] stream_section, wall_loads
    cdef public bint ends_only, with_stream_section, with_wall_loads

cdef void write_point(double[::1] buffer, int at, Point point) noexcept nogil
cdef void clear_point(Point point) noexcept nogil
cdef void copy_point(Point target, Point source) noexcept nogil
