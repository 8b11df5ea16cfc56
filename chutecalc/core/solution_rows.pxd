cimport cython
from libc cimport math
from chutecalc.core cimport flight, floats, joint, records, state

@cython.locals(choked=bint)
cdef void write_solution(records.ChuteState chute, records.Segment segment, state.Stream stream, int panel_count) noexcept nogil
cdef void skip_segment(records.ChuteState chute, records.Segment segment, state.Stream stream) noexcept nogil
cdef void clear_stream(state.Stream stream) noexcept nogil
