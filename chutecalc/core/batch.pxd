cimport cython
from chutecalc.core cimport floats, march, section, slide, state

cdef int HEAD

@cython.locals(row=int, before=int)
cpdef int solve_rows(state.Stream stream, state.Effort effort, double[:, ::1] numbers, double[:, ::1] results, int first, int last) noexcept nogil
cdef void load(slide.Slide way, double[:, ::1] numbers, int row) noexcept nogil
cdef int read(section.Section own, double[:, ::1] numbers, int row, int at) noexcept nogil
