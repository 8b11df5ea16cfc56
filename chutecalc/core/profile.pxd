cimport cython
from libc cimport math
from chutecalc.core cimport batch, flight, floats, guide_surface, records, wall_loads

cdef int MAX_ITERATIONS

@cython.locals(design=int, row=int)
cpdef tabulate_stream_section(guide_surface.Guide guide, double[:, ::1] numbers, int start, double[:, :] surfaces, double[:, :] shares, double[:, :] velocities_squared, double[:, :, ::1] out)
@cython.locals(design=int, row=int)
cpdef tabulate_wall_loads(guide_surface.Guide guide, double[:, ::1] numbers, int start, double[:, :] surfaces, double[:, :] shares, double[:, :] velocities_squared, double[:, :, ::1] out)
@cython.locals(design=int, row=int, path=records.Flight, time=double)
cpdef tabulate_flight(double[:, :] paths, double[:] times, double[:, :] distances, double[:, :, ::1] out)
cdef void read_flight(records.Flight path, double[:, :] paths, int design) noexcept nogil
@cython.locals(design=int, row=int, path=records.Flight)
cpdef flight_lengths(double[:, :] paths, double[:, :] times, double[:, :] out)
cdef double flight_time_at(records.Flight path, double whole, double distance) noexcept nogil
