cimport cython
from libc cimport math
from chutecalc.core cimport floats, friction, guide_surface, section

cdef int SECTION_ROWS, LOAD_ROWS

cdef void write_stream_section(guide_surface.Guide guide, double share, double y, int row, int design, double[:, :, ::1] out) noexcept nogil
cdef void write_wall_loads(guide_surface.Guide guide, double share, double y, int row, int design, double[:, :, ::1] out) noexcept nogil
@cython.locals(arc=bint, drawn=bint)
cdef double pressure_on(guide_surface.Guide guide, double weight, double depth, bint upright) noexcept nogil
