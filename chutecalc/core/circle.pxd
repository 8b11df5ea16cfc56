cimport cython
from libc cimport math
from chutecalc.core cimport floats

cdef int TERMS
cdef double LARGEST_U, LEAST_DRY

cdef double area_of_angle(double angle) noexcept nogil
cdef (double, double, double, double, double) lower_arc(double[::1] series, double deficit, double area) noexcept nogil
cdef (double, double, double, double, double) upper_arc(double[::1] series, double deficit, double area) noexcept nogil
cdef double dry_angle(double[::1] series, double area) noexcept nogil
