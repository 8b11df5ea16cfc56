from libc cimport math
from chutecalc.core cimport closed, contact, fall, floats, placement, records, state, surface

cdef void start_at_inlet(records.ChuteState chute) noexcept nogil
cdef void solve_from(records.ChuteState chute, state.SolverOptions options, records.Segment segment) noexcept nogil
cdef void save_start(records.ChuteState chute) noexcept nogil
cdef void restore_start(records.ChuteState chute) noexcept nogil
