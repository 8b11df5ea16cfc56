cimport cython
from chutecalc.core cimport chain, floats, records, section, slide, state, walls

cdef int HEAD

@cython.locals(row=int)
cpdef int solve_rows(records.Course course, state.Effort effort, double[:, ::1] numbers, int first, int last) noexcept nogil
cdef void tell(records.Course course, records.Segment last, state.Stream own) noexcept nogil
cdef void load(records.Course course, records.Segment segment, double[:, ::1] numbers, int row, int at) noexcept nogil
cdef int load_way(slide.Slide way, double[:, ::1] numbers, int row, int at) noexcept nogil
cdef void put_back(slide.Slide way, double[:, ::1] numbers, int row, int at, double slope, double turn, double length) noexcept nogil
cdef int read(section.Section own, double[:, ::1] numbers, int row, int at) noexcept nogil
