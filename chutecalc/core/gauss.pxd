cimport cython
from libc cimport math
from chutecalc.core cimport floats, matrix

@cython.final
cdef class Rule:
    cdef public int count, last, chords
    cdef public double[::1] knots, weights
    cdef public matrix.Matrix integral
    cdef public int[::1] chord

@cython.final
cdef class RulePair:
    cdef public Rule coarse, fine
    cdef public matrix.Matrix transfer

@cython.final
cdef class Equation:
    cdef public double[::1] forcing, jacobian, derivative, system

@cython.final
cdef class Iterate:
    cdef public double[::1] solution, sensitivity

cpdef void integrate(Rule rule, Equation equation, double start, Iterate curve) noexcept nogil
cdef void integrate_stiff(Rule rule, Equation equation, double start, Iterate curve) noexcept nogil
cdef void eliminate(double[::1] system, int nodes) noexcept nogil
cdef double evaluate(Rule rule, double[::1] values, int offset, double at) noexcept nogil
cdef double find_value(Rule rule, double[::1] values, int offset, double target, double low, double high) noexcept nogil
cdef double derivative_at(Rule rule, double[::1] values, int knot) noexcept nogil
