cimport cython
from libc cimport math
from chutecalc.core cimport floats, section, slide

cdef double TAPER_STEP, BEYOND

cdef void loads(section.Facets facets, int k, section.Loads at, int first, int last) noexcept nogil
cdef void loads_at(section.Facets facets, int k, double area) noexcept nogil
cdef void law(bint equilibrium, section.Loads at, int first, int last) noexcept nogil
cdef (double, double) law_and_factor(slide.Slide way, int facet, double area) noexcept nogil
cdef (double, double) raised(bint equilibrium, section.Loads at) noexcept nogil
cdef double stress(slide.Slide way, int facet, double place, double y) noexcept nogil
cdef void resist(slide.Slide way, int facet, int piece, int first, int last) noexcept nogil
cdef void stick(slide.Slide way, int facet, int piece, section.Loads at, int first, int last) noexcept nogil
cdef (double, double) pull(slide.Slide way, int piece, double place, double y, int number) noexcept nogil
cdef (double, double) pull_there(slide.Slide way, int facet, int piece, double place, double y) noexcept nogil
cdef (double, double) pull_and_growth(slide.Slide way, int facet, int piece, double place, double y) noexcept nogil
cdef double pull_at(slide.Slide way, double place, double y) noexcept nogil
cdef (double, double, double) place_rate(slide.Slide way, int facet, int piece, double r, double width, double place) noexcept nogil
