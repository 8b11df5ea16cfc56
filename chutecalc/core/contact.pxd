cimport cython
from libc cimport math
from chutecalc.core cimport closed, flight, floats, guide_surface, joint, motion, placement, records, solution_rows, state, stepping, surface

cdef int MAX_STRIKES

cdef void solve_contact(records.ChuteState chute, state.SolverOptions options, records.Segment segment, int known_roots) noexcept nogil
cdef void solve_surface(records.ChuteState chute, state.SolverOptions options, records.Segment segment, state.Stream stream, int known_roots) noexcept nogil
cdef bint may_be_caught(records.ChuteState chute, records.Segment segment) noexcept nogil
cdef bint slips_off(records.ChuteState chute, records.Segment segment, state.Stream stream) noexcept nogil
cdef void enter_surface(records.ChuteState chute, records.Segment segment, guide_surface.Guide guide) noexcept nogil
@cython.locals(choked=bint)
cdef void leave_surface(records.ChuteState chute, records.Segment segment, state.Stream stream) noexcept nogil
cdef (double, double) contact_loss_error(guide_surface.Guide guide, double share, double y, double error) noexcept nogil
cdef void miss_segment(records.ChuteState chute, records.Segment segment) noexcept nogil
@cython.locals(airborne=bint, on_roof=bint)
cdef void solve_restrikes(records.ChuteState chute, state.SolverOptions options, records.Segment segment) noexcept nogil
