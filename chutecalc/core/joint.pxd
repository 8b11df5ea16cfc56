cimport cython
from libc cimport math
from chutecalc.core cimport flight, floats, guide_surface, impact, motion, records, state, surface

cdef double TANGENT, START_TOLERANCE, START_ERRORS, PERTURBATION

cdef void meet_segment(records.ChuteState chute, records.Segment segment, guide_surface.Guide guide, int known_roots) noexcept nogil
cdef double through_start(records.ChuteState chute, guide_surface.Guide guide) noexcept nogil
cdef void miss_segment(records.ChuteState chute, guide_surface.Guide guide) noexcept nogil
cdef void clear_arrival(records.ChuteState chute) noexcept nogil
cdef double landing_error(records.ChuteState chute, records.Segment segment, guide_surface.Guide guide, double slope) noexcept nogil
@cython.locals(strikes=bint)
cdef void impact_error(records.ChuteState chute, records.Segment segment, guide_surface.Guide guide) noexcept nogil
cdef double entry_error(records.ChuteState chute, guide_surface.Guide guide) noexcept nogil
cdef double squared(guide_surface.Guide guide, double velocity) noexcept nogil
