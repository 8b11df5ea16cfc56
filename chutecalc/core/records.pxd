cimport cython
from chutecalc.core cimport floats, quartic, state

cdef int LEG

@cython.final
cdef class Point:
    cdef public double distance, x, z, slope, velocity, error, x_error, z_error, slope_error

@cython.final
cdef class Flight:
    cdef public double x, z, forward, downward, gravity, off_x, off_z, off_forward, off_downward, down

@cython.final
cdef class Impact:
    cdef public double footprint, pressure, stress, wall_friction, friction, after, wear

@cython.final
cdef class Arrival:
    cdef public int status
    cdef public double time, distance, place, velocity, incidence, gap, error, place_error

@cython.final
cdef class Segment:
    cdef public int number
    cdef public bint final, fall, plate
    cdef public state.Stream own
    cdef public Segment next
    cdef public double drop, run, start_x, start_z, entry_slope, exit_slope, radius, length
    cdef public double off_x, off_z, off_slope, aside_x, aside_z, sign

@cython.final
cdef class Course:
    cdef public Segment first, last, again
    cdef public Point saved, inlet, here, start, entry, end
    cdef public Flight flight
    cdef public Arrival arrival
    cdef public Impact impact, beside
    cdef public quartic.Quartic curve
    cdef public int saved_status, status, leg_status, strikes, fault_number, faults, row, room, count
    cdef public bint saved_airborne, airborne, arrived, full
    cdef public double error, saved_error, saved_x, saved_z, saved_off_x, saved_off_z, gravity, drawn_x, drawn_z, drawn_off_x, drawn_off_z, fault_slope, flight_time
    cdef public double[::1] legs
    cdef public double[:, ::1] ends
    cdef public double[:, :, ::1] lying, pressing
    cdef public bint ends_only, tells_lying, tells_pressing

cdef void put(double[::1] legs, int at, Point point) noexcept nogil
cdef void nowhere(Point point) noexcept nogil
cdef void copy(Point there, Point here) noexcept nogil
