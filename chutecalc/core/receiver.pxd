from libc cimport math
from chutecalc.core cimport fall, flight, floats, joint, records, state, surface

cdef void land_on_belt(records.ChuteState chute) noexcept nogil
cdef double belt_clearance(records.ChuteState chute) noexcept nogil
cdef double least_from(records.ChuteState chute, records.Segment segment, double least) noexcept nogil
cdef double time_to_line(records.Flight path, double x, double z, double slope) noexcept nogil
