cimport cython
from libc cimport math
from chutecalc.core cimport flight, floats, friction, joint, march, records, slide, state, surface

cdef int STRIKES
cdef double FARTHEST

cdef void start(records.Course course) noexcept nogil
cdef void save(records.Course course) noexcept nogil
cdef void restore(records.Course course) noexcept nogil
cdef void run(records.Course course, state.Effort effort, records.Segment segment) noexcept nogil
@cython.locals(tangent=bint, placed=bint)
cdef void lay(records.Course course, records.Segment segment, slide.Slide way) noexcept nogil
cdef void along(records.Course course, state.Effort effort, records.Segment segment, state.Stream own, int known) noexcept nogil
cdef void enter(records.Course course, records.Segment segment, slide.Slide way) noexcept nogil
cdef void settle(records.Point point, records.Segment segment, slide.Slide way, double place, double error, double shift) noexcept nogil
@cython.locals(choked=bint)
cdef void leave(records.Course course, records.Segment segment, state.Stream own) noexcept nogil
cdef (double, double) loss_error(slide.Slide way, double place, double y, double error) noexcept nogil
cdef void lose(records.Course course, records.Segment segment) noexcept nogil
cdef void leave_out(records.Course course, records.Segment segment, state.Stream own) noexcept nogil
@cython.locals(airborne=bint)
cdef void strike_again(records.Course course, state.Effort effort, records.Segment segment) noexcept nogil
cdef void fall(records.Course course, records.Segment segment) noexcept nogil
cdef void drop(records.Course course, records.Segment segment) noexcept nogil
cdef void fly(records.Course course, double time) noexcept nogil
cdef void onto_next(records.Course course, records.Segment segment, records.Segment following, slide.Slide way) noexcept nogil
@cython.locals(choked=bint)
cdef void write(records.Course course, records.Segment segment, state.Stream own, int panels) noexcept nogil
