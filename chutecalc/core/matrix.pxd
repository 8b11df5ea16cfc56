cimport cython

cdef int ROOM

@cython.final
cdef class Matrix:
    cdef public int groups, columns
    cdef public double[::1] values

@cython.locals(a=double, b=double, c=double, d=double, to=Py_ssize_t, at=Py_ssize_t)
cdef void multiply(Matrix matrix, double[::1] x, double[::1] out, int first) noexcept nogil
cdef double entry(Matrix matrix, int i, int j) noexcept nogil
