cimport cython
from libc cimport math
from chutecalc.core cimport floats, gauss, matrix, slide

cdef double SAFETY, NEWTON_SAFETY, ROOT_SAFETY, ROUNDING, CANCELLED, PLACE_ROUNDING, SETTLED, CHORD
cdef int WHOLE, PLACE, CLINGING, ROOT

@cython.final
cdef class Angles:
    cdef public int count
    cdef public double start, turn
    cdef public double[::1] sine, cosine

@cython.final
cdef class Panel:
    cdef public Angles coarse_angles, angles
    cdef public double start, width, error, inner_error, rounding, left, stop, smooth
    cdef public bint by_root
    cdef public int facet, piece
    cdef public gauss.Equation equation
    cdef public gauss.Curve coarse, guess, fine
    cdef public double[::1] knots, growth, sine, press, values

cdef void estimate(Panel panel, bint sound, double update, double newton, double smooth, double rounding, gauss.Pair pair, int kind) noexcept nogil
@cython.locals(arc=bint)
cdef double smoothness_by_place(Panel panel, slide.Slide way, gauss.Rule rule) noexcept nogil
cdef double smoothness_by_root(Panel panel, slide.Slide way, gauss.Rule rule, double first, double place) noexcept nogil
cdef double smoothness(gauss.Rule rule, double[::1] values, double share, bint to_end) noexcept nogil
@cython.locals(arc=bint)
cdef double taper_smoothness(Panel panel, slide.Slide way, gauss.Rule rule, bint to_end) noexcept nogil
cdef double flank_smoothness(Panel panel, slide.Slide way) noexcept nogil
