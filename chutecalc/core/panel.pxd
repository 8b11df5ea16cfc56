cimport cython
from libc cimport math
from chutecalc.core cimport floats, gauss, guide_surface, matrix

cdef double SAFETY, NEWTON_SAFETY, R_SAFETY, ROUNDING, CANCELLATION, SHARE_ROUNDING, CONVERGED, CHORD_FRACTION
cdef int FULL_SEGMENT, IN_SHARE, IN_SHARE_STIFF, IN_R

@cython.final
cdef class Angles:
    cdef public int count
    cdef public double start, turn
    cdef public double[::1] sine, cosine

@cython.final
cdef class Panel:
    cdef public Angles coarse_angles, angles
    cdef public double start, width, error, inner_error, rounding, newton_factor, stop_share, ellipse_rho
    cdef public bint in_r
    cdef public int facet, piece
    cdef public gauss.Equation equation
    cdef public gauss.Iterate coarse, guess, fine
    cdef public double[::1] solution, sensitivity, sine, wall_drag, work

cdef void estimate(Panel panel, bint valid, double update, double newton, double rho, double rounding, gauss.RulePair pair, int kind) noexcept nogil
@cython.locals(arc=bint)
cdef double ellipse_rho_in_share(Panel panel, guide_surface.Guide guide, gauss.Rule rule) noexcept nogil
cdef double ellipse_rho_in_r(Panel panel, guide_surface.Guide guide, gauss.Rule rule, double first, double share) noexcept nogil
cdef double ellipse_rho(gauss.Rule rule, double[::1] values, double fraction, bint to_end) noexcept nogil
@cython.locals(arc=bint)
cdef double taper_ellipse_rho(Panel panel, guide_surface.Guide guide, gauss.Rule rule, bint to_end) noexcept nogil
cdef double flank_ellipse_rho(Panel panel, guide_surface.Guide guide) noexcept nogil
