cimport cython
from libc cimport math
from chutecalc.core cimport batch, floats, friction, gauss, matrix, section, slide, state

cdef double SLACK, STEEP

@cython.locals(design=int, number=int, here=int, row=int, rule=gauss.Rule, share=double)
cpdef velocities(double[::1] kept, Py_ssize_t[::1] first, Py_ssize_t[::1] count, dict rules, double[:, :] ends, double[:, :] places, double[:, :] out)
cdef double at_ends(double[:, :] ends, int design, double place) noexcept nogil
cdef double locate(gauss.Rule rule, double[::1] kept, int at, double place) noexcept nogil
cdef double squared(gauss.Rule rule, double[::1] kept, int at, double share) noexcept nogil
@cython.locals(design=int, number=int, at=int, row=int, rule=gauss.Rule, share=double, elapsed=double, begin=double, width=double)
cpdef times(state.Stream stream, double[:, ::1] numbers, int start, double[:, :] surfaces, double[::1] kept, Py_ssize_t[::1] first, Py_ssize_t[::1] count, dict rules, double[:, :] places, double[:, :] out)
cdef bint part_is_steep(state.Stream stream, gauss.Rule rule, double[::1] kept, int at, double begin, double width) noexcept nogil
cdef void clock(state.Stream stream, gauss.Rule rule, double[::1] kept, int at, double width, double elapsed) noexcept nogil
@cython.locals(design=int, number=int, at=int, row=int, rule=gauss.Rule)
cpdef knot_places(double[::1] kept, Py_ssize_t[::1] first, Py_ssize_t[::1] count, dict rules, double[:, :] out)
