cimport cython
from chutecalc.core cimport chain, floats, guide_surface, receiver, records, section, state, wall_loads

cdef int HEADER

@cython.locals(row=int)
cpdef int solve_rows(records.ChuteState chute, state.SolverOptions options, double[:, ::1] numbers, int first, int last) noexcept nogil
cdef void write_ends(records.ChuteState chute, records.Segment last, state.Stream stream) noexcept nogil
cdef void read_segments(records.ChuteState chute, records.Segment segment, double[:, ::1] numbers, int row, int at) noexcept nogil
cdef int read_guide(guide_surface.Guide guide, double[:, ::1] numbers, int row, int at) noexcept nogil
cdef void restore_guide(guide_surface.Guide guide, double[:, ::1] numbers, int row, int at, double slope, double turn, double length) noexcept nogil
cdef int read_section(section.Section cross_section, double[:, ::1] numbers, int row, int at) noexcept nogil
