cimport cython
from libc cimport math
from chutecalc.core cimport floats, friction, guide_surface, section

cdef int JUMP_ITERATIONS, HALVINGS
cdef double NEAREST

@cython.locals(moment=double, first=int, j=int, top=double, rise=double)
cdef double mean_depth(section.Facets facets, int k, double area, double depth, double width) noexcept nogil
cdef double depth_change(guide_surface.Guide guide, int k, double area, double depth, double width) noexcept nogil
@cython.locals(j=int, change=double, widening=double, lifting=double, turning=double, lengthening=double, rise=double, wetted=double, rising=double, slanted=double)
cdef double area_change(section.Section first, section.Section last, section.Section here, section.Facets facets, int k, double depth) noexcept nogil
cdef (double, double) forces(guide_surface.Guide guide, int facet, int piece, double share, double y) noexcept nogil
cdef double bracket(guide_surface.Guide guide, int facet, double share, double y) noexcept nogil
cdef double jump_above_full(guide_surface.Guide guide, int facet, double share, double y, double full) noexcept nogil
cdef double jump_ahead(guide_surface.Guide guide, int facet, double share, double y) noexcept nogil
