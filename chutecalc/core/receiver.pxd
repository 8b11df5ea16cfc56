from libc cimport math
from chutecalc.core cimport fall, flight, floats, joint, records, state

cdef void land_on_belt(records.ChuteState chute) noexcept nogil
cdef double time_to_line(records.Flight path, double x, double z, double slope) noexcept nogil
