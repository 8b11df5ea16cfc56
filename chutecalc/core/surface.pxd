from libc cimport math
from chutecalc.core cimport flight, floats, guide_surface, quartic, records

cdef double END_TOLERANCE, REFINEMENT

cdef (double, double) point(guide_surface.Guide guide, double share) noexcept nogil
cdef double least_height(guide_surface.Guide guide, double x, double z, double slope) noexcept nogil
cdef (double, double, double) land(guide_surface.Guide guide, records.Flight path, quartic.Quartic curve, int known_roots) noexcept nogil
cdef double refined(guide_surface.Guide guide, records.Flight path, double time) noexcept nogil
cdef void clearance(guide_surface.Guide guide, records.Flight path, quartic.Quartic curve) noexcept nogil
cdef (double, double) foot(guide_surface.Guide guide, records.Flight path, double time) noexcept nogil
cdef double crossing_time(guide_surface.Guide guide, records.Flight path, double share) noexcept nogil
cdef double gap_at(guide_surface.Guide guide, records.Flight path, double share) noexcept nogil
