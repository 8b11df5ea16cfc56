cimport cython
from libc cimport math
from chutecalc.core cimport floats, section

@cython.final
cdef class Guide:
    cdef public section.Facets facets
    cdef public section.Section first, last, section_here
    cdef public bint taper, equilibrium, adhesive
    cdef public int pieces
    cdef public double x, z, section_share, side, gravity, entry_slope, turn, length, flow, density, vertical_ratio, signed_curvature, momentum_root, longitudinal
    cdef public double[::1] starts, intercepts, slopes

cdef void set_constants(Guide guide) noexcept nogil
cdef void set_section(Guide guide, double share) noexcept nogil
cdef double wall_height(Guide guide, double share) noexcept nogil
cdef double choke_area(Guide guide, double share) noexcept nogil
cdef double full_velocity(Guide guide) noexcept nogil
cdef double flow_area(Guide guide, double y) noexcept nogil
cdef double normal_acceleration(Guide guide, double share, double y) noexcept nogil
cdef int piece_of(Guide guide, double pressure) noexcept nogil
cdef double wall_friction(Guide guide, double pressure) noexcept nogil
