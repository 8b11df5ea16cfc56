from libc cimport math
from chutecalc.core cimport floats, friction, guide_surface, records, section

cdef void compute_impact(records.Impact result, guide_surface.Guide guide, double share, double velocity, double incidence) noexcept nogil
cpdef double added_friction(guide_surface.Guide guide, double stress, double added) noexcept nogil
