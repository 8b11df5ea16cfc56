cimport cython
from libc cimport math
from chutecalc.core cimport floats, section

cdef int MOST

@cython.final
cdef class Matrix:
    cdef public int rows, columns
    cdef public double[::1] values

@cython.final
cdef class Rule:
    cdef public int count, last, chords
    cdef public double[::1] knots, weights
    cdef public Matrix integral
    cdef public int[::1] chord

@cython.final
cdef class Pair:
    cdef public Rule coarse, fine
    cdef public Matrix transfer

@cython.final
cdef class Equation:
    cdef public double[::1] forcing, rate, rises, system

@cython.final
cdef class Curve:
    cdef public double[::1] knots, growth

cdef void multiply(Matrix matrix, double[::1] x, double[::1] out, int first) noexcept nogil
cdef void add(double[::1] values, int rows, int at, double one, double two, double[::1] out, int first) noexcept nogil
cdef double entry(Matrix matrix, int i, int j) noexcept nogil
cpdef void integrate(Rule rule, Equation equation, double start, Curve curve) noexcept nogil
cdef void integrate_stiff(Rule rule, Equation equation, double start, Curve curve) noexcept nogil
cdef void eliminate(double[::1] system, int nodes) noexcept nogil
cdef double evaluate(Rule rule, double[::1] values, int offset, double at) noexcept nogil
cdef double solve(Rule rule, double[::1] values, int offset, double target, double low, double high) noexcept nogil
cdef double slope_at(Rule rule, double[::1] values, int knot) noexcept nogil
