cimport cython
from libc cimport math
from chutecalc.core cimport events, flight, floats, guide_surface, joint, quartic, records, state, surface

cdef double MOUTH_TOLERANCE

@cython.locals(inside=bint)
cdef void choose_surface(records.ChuteState chute, records.Segment segment, int own_roots, int roof_roots) noexcept nogil
cdef void place_roof(records.Segment segment, guide_surface.Guide own, guide_surface.Guide roof) noexcept nogil
cdef bint runs_on(records.ChuteState chute, guide_surface.Guide guide) noexcept nogil
cdef bint meets_roof(records.ChuteState chute, guide_surface.Guide roof) noexcept nogil
@cython.locals(mitred=bint)
cdef bint enters(records.ChuteState chute, records.Segment segment, guide_surface.Guide own, double since) noexcept nogil
cdef bint is_above(records.ChuteState chute, guide_surface.Guide guide, double time) noexcept nogil
cdef void fly_to_mouth(records.ChuteState chute) noexcept nogil
cdef void fly_out(records.ChuteState chute, records.Segment segment, guide_surface.Guide own) noexcept nogil
cdef bint overfills(records.ChuteState chute, guide_surface.Guide own, double share) noexcept nogil
cdef void leave_out(records.ChuteState chute, records.Segment segment, int status) noexcept nogil
