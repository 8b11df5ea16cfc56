cimport cython
from libc cimport math
from chutecalc.core cimport events, floats, friction, gauss, guide_surface, motion, panel, section, state

cdef int JUMP_ITERATIONS
cdef double UNRESOLVED, LEAST_R_FRACTION, FIRST_R_FRACTION, BRANCH_CLEARANCE, END_TOLERANCE, ROUNDING, NEAR_END, OVERSHOOT, INNER_ERROR_FACTOR, MIN_FACTOR, MAX_FACTOR

@cython.locals(in_r=bint)
cdef void process_events(state.Stream stream, state.SolverOptions options, gauss.Rule rule, double start, double end) noexcept nogil
cdef double event_value_at(state.Stream stream, int event, double at, double unknown) noexcept nogil
cdef bint event_confirmed(state.Stream stream, gauss.Rule rule, int event, double at, double cut) noexcept nogil
cdef void accept_until(state.Stream stream, state.SolverOptions options, gauss.Rule rule, double start, double end, double cut) noexcept nogil
cdef void accept_step(state.Stream stream, state.SolverOptions options, gauss.Rule rule, double end, double off) noexcept nogil
cdef void store_panel(state.Stream stream, gauss.Rule rule, double end) noexcept nogil
cdef void reject_step(state.Stream stream, state.SolverOptions options, int kind, double step) noexcept nogil
cdef void end_here(state.Stream stream, state.SolverOptions options) noexcept nogil
@cython.locals(informative=bint)
cdef double shrink_factor(panel.Panel trial, state.SolverOptions options) noexcept nogil
cdef void shorten_after_chatter(state.Stream stream, bint in_r, double step) noexcept nogil
cdef void reach_breakpoint(state.Stream stream) noexcept nogil
cdef void apply_event(state.Stream stream, state.SolverOptions options, int event) noexcept nogil
cdef int next_interval(int number, int there, int side) noexcept nogil
cdef void jump(state.Stream stream) noexcept nogil
