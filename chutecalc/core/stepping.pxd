cimport cython
from libc cimport math
from chutecalc.core cimport collocation, events, floats, friction, gauss, guide_surface, longitudinal, motion, panel, section, state, step_control

cdef int MANY, JUMP_PANELS, MAX_PANELS, CREEP_PANELS
cdef double STOP_AHEAD, REST_BEHIND, STEP_DECELERATING, STEP_ACCELERATING, STIFFNESS_LIMIT, CREEP_VELOCITY, NEARLY_FULL, STEP_TO_FULL, BEYOND_JUMP, NEXT_TO_FULL, BEHIND, NEAR_JUMP

cdef void solve_segment(state.Stream stream, state.SolverOptions options) noexcept nogil
cdef void initialise(state.Stream stream, state.SolverOptions options) noexcept nogil
@cython.locals(deep=bint)
cdef void pass_plate(state.Stream stream, state.SolverOptions options) noexcept nogil
cdef double first_breakpoint(guide_surface.Guide guide, double share) noexcept nogil
cdef bint detect_stall(state.Stream stream, double change) noexcept nogil
cdef bint detect_jump(state.Stream stream, state.SolverOptions options, double change) noexcept nogil
cdef bint detect_full(state.Stream stream, state.SolverOptions options, double change) noexcept nogil
cdef bint cross_event(state.Stream stream, state.SolverOptions options, double change) noexcept nogil
cdef void next_panel(state.Stream stream, state.SolverOptions options, double change, double jacobian) noexcept nogil
cdef void step_in_share(state.Stream stream, state.SolverOptions options, double target, double jacobian) noexcept nogil
cdef double approach_rate(state.Stream stream, double change, double jump, double full) noexcept nogil
cdef double slowest_on_branch(state.Stream stream) noexcept nogil
cdef double fastest_on_branch(state.Stream stream) noexcept nogil
@cython.locals(good=bint)
cdef void try_panel(state.Stream stream, state.SolverOptions options, int kind, double target, gauss.RulePair pair, double tolerance) noexcept nogil
