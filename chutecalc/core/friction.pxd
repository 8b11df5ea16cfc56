cimport cython
from libc cimport math
from chutecalc.core cimport floats, guide_surface, section

cdef void hydrostatic_loads(section.Facets facets, int k, section.Loads at, int first, int last) noexcept nogil
cdef void hydrostatic_loads_at(section.Facets facets, int k, double area) noexcept nogil
cdef void apply_friction_law(bint equilibrium, section.Loads at, int first, int last) noexcept nogil
cdef (double, double) friction_law_at(guide_surface.Guide guide, int facet, double area) noexcept nogil
cdef (double, double) friction_law(bint equilibrium, section.Loads at) noexcept nogil
cdef double wall_stress(guide_surface.Guide guide, int facet, double share, double y) noexcept nogil
cdef void set_resistance(guide_surface.Guide guide, int facet, int piece, int first, int last) noexcept nogil
cdef void set_adhesion(guide_surface.Guide guide, int facet, int piece, section.Loads at, int first, int last) noexcept nogil
