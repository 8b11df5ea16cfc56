cimport cython
from libc cimport math
from chutecalc.core cimport batch, floats, gauss, guide_surface, matrix, motion, section, state

cdef double SHARE_TOLERANCE, MAX_GROWTH

@cython.locals(design=int, number=int, at=int, row=int, rule=gauss.Rule, theta=double)
cpdef velocities_squared(double[::1] panels, Py_ssize_t[::1] first, Py_ssize_t[::1] count, dict rules, double[:, :] ends, double[:, :] shares, double[:, :] out)
cdef double end_value(double[:, :] ends, int design, double share) noexcept nogil
cdef double locate(gauss.Rule rule, double[::1] panels, int at, double share) noexcept nogil
cdef double panel_value(gauss.Rule rule, double[::1] panels, int at, double theta) noexcept nogil
@cython.locals(design=int, number=int, at=int, row=int, rule=gauss.Rule, theta=double, elapsed=double, begin=double, width=double)
cpdef times(state.Stream stream, double[:, ::1] numbers, int start, double[:, :] surfaces, double[::1] panels, Py_ssize_t[::1] first, Py_ssize_t[::1] count, dict rules, double[:, :] shares, double[:, :] out)
cdef bint write_part(state.Stream stream, gauss.Rule rule, double[::1] panels, int at, double begin, double width) noexcept nogil
cdef void integrate_time(state.Stream stream, gauss.Rule rule, double[::1] panels, int at, double width, double elapsed) noexcept nogil
@cython.locals(design=int, number=int, at=int, row=int, rule=gauss.Rule)
cpdef knot_shares(double[::1] panels, Py_ssize_t[::1] first, Py_ssize_t[::1] count, dict rules, double[:, :] out)
