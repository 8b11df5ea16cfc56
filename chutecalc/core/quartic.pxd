cimport cython
from libc cimport math
from chutecalc.core cimport floats

@cython.final
cdef class Quartic:
    cdef public double[::1] value, slope, knots, falls

cpdef int falls_through_zero(Quartic curve, double horizon) noexcept nogil
cdef double value_at(double[::1] coefficients, int degree, double at) noexcept nogil
cdef double root_between(double[::1] coefficients, int degree, double low, double high) noexcept nogil
