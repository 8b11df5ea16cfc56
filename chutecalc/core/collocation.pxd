cimport cython
from libc cimport math
from chutecalc.core cimport floats, friction, gauss, matrix, panel, section, slide

cdef double ENOUGH

@cython.locals(sound=bint)
cdef void by_place(panel.Panel own, slide.Slide way, double start, double width, double y0, gauss.Pair pair, int kind, double tolerance) noexcept nogil
cdef double stopped(panel.Panel own, gauss.Rule rule) noexcept nogil
cdef void forces(panel.Panel own, slide.Slide way, gauss.Rule rule, panel.Angles angles) noexcept nogil
cdef void freeze(panel.Panel own, slide.Slide way, gauss.Rule rule, double first, double flow, double bend) noexcept nogil
cdef void linearise(panel.Panel own, slide.Slide way, gauss.Rule rule, gauss.Curve iterate, double flow, double bend) noexcept nogil
cdef void insert(panel.Panel own, section.Loads at, gauss.Equation equation, gauss.Curve iterate, int nodes, double bend, double turned) noexcept nogil
cdef void step(panel.Panel own, gauss.Rule rule, double first, int kind, gauss.Curve curve) noexcept nogil
@cython.locals(sound=bint)
cdef void by_root(panel.Panel own, slide.Slide way, double start, double width, double place, gauss.Pair pair) noexcept nogil
cdef void resist_in_r(panel.Panel own, slide.Slide way, gauss.Rule rule) noexcept nogil
cdef double rates(panel.Panel own, slide.Slide way, gauss.Rule rule, gauss.Curve iterate) noexcept nogil
