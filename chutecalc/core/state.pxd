cimport cython
from chutecalc.core cimport events, floats, gauss, guide_surface, matrix, panel

cdef int OK, STALL, CHOKED, CONTACT_LOST, MISSED, NOT_REACHED, PASSED, JUMPED, RUNNING, UNSOLVED, FAULT, PANEL_SIZE
cdef double LEAST_STEP

@cython.final
cdef class SolverOptions:
    cdef public gauss.RulePair first_pair, second_pair, step_pair, r_pair
    cdef public double tolerance, panel_tolerance
    cdef public bint dense_output

@cython.final
cdef class PanelStore:
    cdef public panel.Panel panel
    cdef public double[::1] event_values, work, panels
    cdef public int capacity, count
    cdef public bint full

@cython.final
cdef class Stream:
    cdef public guide_surface.Guide guide
    cdef public PanelStore store
    cdef public panel.Panel panel
    cdef public double[::1] event_values, work
    cdef public int[::1] active_events
    cdef public int status, facet, piece, attempts
    cdef public bint has_events, target_in_r, try_finer, r_rejected
    cdef public double share, y, error, breakpoint, next_step, r_fraction, event_target, last_crossing, choke_share, choke_y, choke_error, shift

cdef double event_function(Stream stream, int event, double share, double y) noexcept nogil
