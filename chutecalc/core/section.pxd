cimport cython
from libc cimport math
from chutecalc.core cimport circle, floats, matrix

@cython.final
cdef class Section:
    cdef public bint circle, closed
    cdef public int walls
    cdef public double base, radius, wall_height
    cdef public double[::1] lengths, inclinations

@cython.final
cdef class Loads:
    cdef public double[::1] area, bend, excess, excess_sensitivity, missing, missing_sensitivity, adhesion, adhesion_fall, adhesion_rise

@cython.final
cdef class Facets:
    cdef public int count
    cdef public bint circle
    cdef public double radius, deficit, full
    cdef public double[::1] series
    cdef public double[::1] sine, cosine, area, width, height
    cdef public double[::1] excess, excess_rise, own_excess, shortfall, shortfall_rise, own_shortfall
    cdef public Loads loads
    cdef public double[::1] two_over_sine, four_cot, apex_width_squared, sine_own_excess, sine_own_shortfall

cdef void interpolate_sections(Section first, Section last, double share, Section target) noexcept nogil
cdef double interpolate_number(double first, double last, double share) noexcept nogil
cdef void stack_facets(Section section, double vertical_ratio, Facets facets) noexcept nogil
cdef void stack_circle(Section section, double vertical_ratio, Facets facets) noexcept nogil
cdef void set_derived(Facets facets, int k) noexcept nogil
cdef int facet_of(Facets facets, double area) noexcept nogil
cdef (double, double) depth_and_width(Facets facets, int k, double area) noexcept nogil
cdef double wetted_below(Section section, Facets facets, int k, double area) noexcept nogil
cdef double floor_width(Section section) noexcept nogil
cdef double area_at_depth(Facets facets, double depth) noexcept nogil
cdef double half_angle(double depth, double radius) noexcept nogil
cdef (double, double, double, double, double) arc(Facets facets, double area) noexcept nogil
cdef double widest(Facets facets, double depth, double width) noexcept nogil
