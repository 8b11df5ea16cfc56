cimport cython
from libc cimport math
from chutecalc.core cimport events, floats, friction, gauss, panel, section, slide, state

cdef double TIRED, AGAIN, CLEAR, AT_END, ROUNDING, CLOSE, BEYOND, WELL_WITHIN, LEAST_SHARE, MOST_SHARE

@cython.locals(by_root=bint)
cdef void judge(state.Stream stream, state.Effort effort, gauss.Rule rule, double start, double end) noexcept nogil
cdef double margin_at(state.Stream stream, int event, double at, double unknown) noexcept nogil
cdef bint happens(state.Stream stream, gauss.Rule rule, int event, double start, double end, double cut) noexcept nogil
cdef void accept_part(state.Stream stream, state.Effort effort, gauss.Rule rule, double start, double end, double cut) noexcept nogil
cdef void accept(state.Stream stream, state.Effort effort, gauss.Rule rule, double end, double off) noexcept nogil
cdef void keep(state.Stream stream, gauss.Rule rule, double end) noexcept nogil
cdef void retreat(state.Stream stream, state.Effort effort, int kind, double step) noexcept nogil
@cython.locals(told=bint)
cdef double likely(panel.Panel own, state.Effort effort) noexcept nogil
cdef void chatter(state.Stream stream, bint by_root, double step) noexcept nogil
cdef void arrive(state.Stream stream) noexcept nogil
cdef void happen(state.Stream stream, state.Effort effort, int event) noexcept nogil
cdef int beyond(int number, int there, int side) noexcept nogil
