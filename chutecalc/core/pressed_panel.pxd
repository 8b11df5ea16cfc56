cimport cython
from libc cimport math
from chutecalc.core cimport floats, gauss, guide_surface, longitudinal, motion, panel

@cython.locals(j=int)
cdef void freeze_bracket(panel.Panel trial, guide_surface.Guide guide, int nodes, double initial) noexcept nogil
@cython.locals(j=int)
cdef void linearise(panel.Panel trial, guide_surface.Guide guide, gauss.Rule rule, gauss.Iterate iterate) noexcept nogil
@cython.locals(j=int)
cdef double ellipse_rho(panel.Panel trial, guide_surface.Guide guide, gauss.Rule rule) noexcept nogil
