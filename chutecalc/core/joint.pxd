cimport cython
from libc cimport math
from chutecalc.core cimport flight, floats, friction, impact, records, slide, state, surface

cdef double TANGENT, NEARBY

cdef void arrive(records.Course course, records.Segment segment, slide.Slide way, int known) noexcept nogil
cdef void lose(records.Course course, slide.Slide way) noexcept nogil
cdef void nothing(records.Course course) noexcept nogil
cdef double landed_error(records.Course course, records.Segment segment, slide.Slide way, double slope) noexcept nogil
@cython.locals(hit=bint)
cdef void strike_error(records.Course course, records.Segment segment, slide.Slide way) noexcept nogil
cdef double entry_error(records.Course course, slide.Slide way) noexcept nogil
