from libc cimport math
from chutecalc.core cimport floats, records

cdef double LEAST_COSINE

cdef void launch(records.Flight flight, records.Point point, double gravity) noexcept nogil
cdef double velocity_at(records.Flight flight, double time) noexcept nogil
cdef double slope_at(records.Flight flight, double time) noexcept nogil
cdef double x_at(records.Flight flight, double time) noexcept nogil
cdef double z_at(records.Flight flight, double time) noexcept nogil
cpdef double time_to_drop(records.Flight flight, double drop) noexcept nogil
cdef double time_to_run(records.Flight flight, double run) noexcept nogil
cdef void set_point(records.Flight flight, double time, records.Point point) noexcept nogil
cdef (double, double) passage(records.Flight flight, double x, double z) noexcept nogil
cdef double delay(records.Flight flight) noexcept nogil
cdef double path_length(records.Flight flight, double time) noexcept nogil
cdef void propagate_error(records.Flight flight, records.Point point, double time) noexcept nogil
cdef void shift_error(records.Flight flight, double later, records.Point point) noexcept nogil
cdef double safe_quotient(double over, double under) noexcept nogil
