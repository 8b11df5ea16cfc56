from libc cimport math
from chutecalc.core cimport floats, friction, records, section, slide

cdef void strike(records.Impact hit, slide.Slide way, double place, double velocity, double incidence) noexcept nogil
cpdef double added_friction(slide.Slide way, double stress, double added) noexcept nogil
