cimport cython
from libc cimport math
from chutecalc.core cimport floats, friction, gauss, guide_surface, matrix, motion, panel, pressed_panel, section

cdef double NEWTON_FRACTION

@cython.locals(valid=bint)
cdef void solve_in_share(panel.Panel trial, guide_surface.Guide guide, double start, double width, double y0, gauss.RulePair pair, int kind, double tolerance) noexcept nogil
cdef bint solve_coarse(panel.Panel trial, guide_surface.Guide guide, gauss.RulePair pair, int kind, double initial, double flow, double centrifugal) noexcept nogil
cdef (double, double, double) solve_fine(panel.Panel trial, guide_surface.Guide guide, gauss.RulePair pair, int kind, double initial, double flow, double centrifugal, double tolerance) noexcept nogil
cdef (double, double) stiff_errors(panel.Panel trial, gauss.RulePair pair) noexcept nogil
cdef double first_stop(panel.Panel trial, gauss.Rule rule) noexcept nogil
cdef void set_forces(panel.Panel trial, guide_surface.Guide guide, gauss.Rule rule, panel.Angles angles) noexcept nogil
cdef void freeze_friction(panel.Panel trial, guide_surface.Guide guide, gauss.Rule rule, double initial, double flow, double centrifugal) noexcept nogil
cdef void linearise(panel.Panel trial, guide_surface.Guide guide, gauss.Rule rule, gauss.Iterate iterate, double flow, double centrifugal) noexcept nogil
cdef void insert_resistance(panel.Panel trial, section.Loads at, gauss.Equation equation, gauss.Iterate iterate, int nodes, double centrifugal, double centrifugal_weight) noexcept nogil
cdef void solve_linearised(panel.Panel trial, gauss.Rule rule, double initial, int kind, gauss.Iterate curve) noexcept nogil
@cython.locals(valid=bint)
cdef void solve_in_r(panel.Panel trial, guide_surface.Guide guide, double start, double width, double share, gauss.RulePair pair) noexcept nogil
cdef void set_resistance_in_r(panel.Panel trial, guide_surface.Guide guide, gauss.Rule rule) noexcept nogil
cdef double linearise_in_r(panel.Panel trial, guide_surface.Guide guide, gauss.Rule rule, gauss.Iterate iterate) noexcept nogil
