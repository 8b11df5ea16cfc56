from libc cimport math
from chutecalc.core cimport flight, floats, quartic, records, slide

cdef double ON_IT

cdef (double, double) point(slide.Slide way, double place) noexcept nogil
cdef (double, double, double) land(slide.Slide way, records.Flight path, quartic.Quartic curve, int known) noexcept nogil
cdef void clearance(slide.Slide way, records.Flight path, quartic.Quartic curve) noexcept nogil
cdef (double, double) foot(slide.Slide way, records.Flight path, double time) noexcept nogil
cdef double gap_at_end(slide.Slide way, records.Flight path) noexcept nogil
