cimport cython
from libc cimport math
from chutecalc.core cimport guide_surface, records, state, surface

@cython.locals(tangent=bint, has_start=bint)
cdef void place_segment(records.ChuteState chute, records.Segment segment, guide_surface.Guide guide) noexcept nogil
cdef void set_point(records.Point point, records.Segment segment, guide_surface.Guide guide, double share, double error, double shift) noexcept nogil
