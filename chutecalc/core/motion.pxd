cimport cython
from libc cimport math
from chutecalc.core cimport floats, friction, guide_surface, longitudinal, section

cdef double TAPER_STEP, FARTHEST_SHARE, DIFFERENCE, NEAR_FULL

cdef (double, double) rhs_at_node(guide_surface.Guide guide, int piece, double share, double y, int number) noexcept nogil
cdef (double, double) rhs(guide_surface.Guide guide, int facet, int piece, double share, double y) noexcept nogil
cdef (double, double) rhs_and_jacobian(guide_surface.Guide guide, int facet, int piece, double share, double y) noexcept nogil
cdef (double, double, double) pressed_rhs(guide_surface.Guide guide, int facet, int piece, double share, double y) noexcept nogil
cdef double rhs_any_branch(guide_surface.Guide guide, double share, double y) noexcept nogil
cdef double force_any_branch(guide_surface.Guide guide, double share, double y) noexcept nogil
cdef (int, int) branch(guide_surface.Guide guide, double share, double y) noexcept nogil
cdef (double, double, double, double) rhs_in_r(guide_surface.Guide guide, int facet, int piece, double r, double width, double share) noexcept nogil
cdef (double, double) rate_in_r(guide_surface.Guide guide, int facet, int piece, double r, double width, double share) noexcept nogil
