cimport cython
from libc cimport math
from chutecalc.core cimport floats, friction, section, slide

cdef int LYING, PRESSING

cdef void lie(slide.Slide way, double place, double y, int row, int design, double[:, :, ::1] out) noexcept nogil
cdef void press(slide.Slide way, double place, double y, int row, int design, double[:, :, ::1] out) noexcept nogil
@cython.locals(arc=bint, drawn=bint)
cdef double pressure_on(slide.Slide way, double weight, double depth, bint upright) noexcept nogil
