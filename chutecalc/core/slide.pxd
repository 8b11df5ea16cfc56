cimport cython
from libc cimport math
from chutecalc.core cimport floats, section

@cython.final
cdef class Slide:
    cdef public section.Facets facets
    cdef public section.Section first, last, here
    cdef public bint taper, equilibrium, sticky
    cdef public int pieces
    cdef public double x, z, drawn_at, side, gravity, entry_slope, turn, length, flow, density, vertical_ratio, bend
    cdef public double[::1] starts, intercepts, slopes

cdef void begin(Slide slide) noexcept nogil
cdef void draw(Slide slide, double place) noexcept nogil
cdef double wall_height(Slide slide, double place) noexcept nogil
cdef double choke_area(Slide slide, double place) noexcept nogil
cdef double flow_area(Slide slide, double y) noexcept nogil
cdef double normal(Slide slide, double place, double y) noexcept nogil
cdef int piece_of(Slide slide, double pressure) noexcept nogil
cdef double wall_friction(Slide slide, double pressure) noexcept nogil
