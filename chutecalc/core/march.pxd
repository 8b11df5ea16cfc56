cimport cython
from libc cimport math
from chutecalc.core cimport acceptance, collocation, events, floats, friction, gauss, panel, section, slide, state

cdef int PASSES, PATIENCE
cdef double STOPPING, STARTING, SHY, AWAY, STIFF, CREEP

cdef void run(state.Stream stream, state.Effort effort) noexcept nogil
cdef void begin(state.Stream stream, state.Effort effort) noexcept nogil
cdef double first_limit(slide.Slide way, double place) noexcept nogil
cdef bint stops(state.Stream stream, double change) noexcept nogil
cdef bint crosses(state.Stream stream, state.Effort effort, double change) noexcept nogil
cdef void go_on(state.Stream stream, state.Effort effort, double change, double growth) noexcept nogil
cdef void advance_by_place(state.Stream stream, state.Effort effort, double target, double growth) noexcept nogil
cdef double slowest(state.Stream stream) noexcept nogil
cdef double fastest(state.Stream stream) noexcept nogil
@cython.locals(good=bint)
cdef void advance(state.Stream stream, state.Effort effort, int kind, double target, gauss.Pair pair, double tolerance) noexcept nogil
