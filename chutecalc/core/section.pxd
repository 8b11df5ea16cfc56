cimport cython
from libc cimport math
from chutecalc.core cimport floats, matrix

cdef int TERMS
cdef double LARGEST

@cython.final
cdef class Section:
    cdef public bint circle
    cdef public int walls
    cdef public double base, radius, wall_height
    cdef public double[::1] lengths, inclinations

@cython.final
cdef class Loads:
    cdef public double[::1] area, excess, growth, missing, missing_growth, stuck, fall, climb

@cython.final
cdef class Facets:
    cdef public int count
    cdef public bint circle
    cdef public double radius, lack
    cdef public double[::1] series
    cdef public double[::1] sine, cosine, area, width, height
    cdef public double[::1] excess, excess_rise, own_excess, shortfall, shortfall_rise, own_shortfall
    cdef public Loads loads
    cdef public double[::1] twice, spread, apex, bend_excess, bend_shortfall

cdef void blend(Section first, Section last, double share, Section here) noexcept nogil
cdef double between(double first, double last, double share) noexcept nogil
cdef void stack(Section section, double vertical_ratio, Facets facets) noexcept nogil
cdef void stack_circle(Section section, double vertical_ratio, Facets facets) noexcept nogil
cdef void prepare(Facets facets, int k) noexcept nogil
cdef int facet_of(Facets facets, double area) noexcept nogil
cdef (double, double) depth_and_width(Facets facets, int k, double area) noexcept nogil
cdef double wetted_below(Section section, Facets facets, int k, double area) noexcept nogil
cdef double floor_width(Section section) noexcept nogil
cdef double area_at_depth(Facets facets, double depth) noexcept nogil
cdef double angle_area(double angle) noexcept nogil
cdef (double, double, double, double, double) arc(Facets facets, double area) noexcept nogil
