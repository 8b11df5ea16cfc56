cimport cython
from libc cimport math
from chutecalc.core cimport batch, floats, friction, slide

cdef double SLOWEST, STEP
cdef double LAST

@cython.locals(design=int, row=int)
cpdef balances(slide.Slide way, double[:, ::1] numbers, int start, double[:, :] surfaces, double[:, :] places, double[:, :] velocities, double[:, :] out)
@cython.locals(faster=bint, k=double)
cdef double balance(slide.Slide way, double place, double velocity) noexcept nogil
cdef double surplus(slide.Slide way, double place, double number) noexcept nogil
@cython.locals(last=int, at=double)
cdef double between(slide.Slide way, double place, double number, double f_low, double f_high) noexcept nogil
