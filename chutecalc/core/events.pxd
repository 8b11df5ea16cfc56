cimport cython
from libc cimport math
from chutecalc.core cimport floats, friction, gauss, guide_surface, longitudinal, section

cdef int CONTACT_LOSS, CHOKE, JUMP, FACET_UP, FACET_DOWN, PIECE_UP, PIECE_DOWN, SEGMENT_END
cdef double EVENT_TOLERANCE, DIFFERENCE_STEP

cdef double event_function(guide_surface.Guide guide, int facet, int piece, int event, double share, double y, double next_breakpoint) noexcept nogil
cdef double above(double start, double stress, double press) noexcept nogil
cdef double relative_excess(double value, double limit) noexcept nogil
cdef double first_crossing(gauss.Rule rule, double[::1] event_values) noexcept nogil
@cython.locals(near=bint)
cdef double near_minimum(gauss.Rule rule, double[::1] event_values) noexcept nogil
