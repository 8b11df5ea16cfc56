cimport cython
from libc cimport math
from chutecalc.core cimport floats

cdef int ADD, SUBTRACT, MULTIPLY, DIVIDE, LESS, LESS_EQUAL, EQUAL, AND, OR, NOT, CHOOSE, ROOT, SINE, COSINE, TANGENT, ARCCOSINE, EXPONENTIAL, CHECK, STEP

@cython.final
cdef class Recipe:
    cdef public int count, varied, width
    cdef public int[::1] steps, taken
    cdef public double[::1] values

@cython.locals(rows=int, first=int, row=int)
cpdef int replay(Recipe recipe, double[:, ::1] numbers, double[:, ::1] out) noexcept nogil
@cython.locals(code=int, result=int, first_operand=int, second_operand=int, third_operand=int)
cdef bint follow(Recipe recipe, int at, int rows) noexcept nogil
@cython.locals(yes=bint)
cdef double truth(int code, double first_operand, double second_operand) noexcept nogil
cdef double function(int code, double operand) noexcept nogil
