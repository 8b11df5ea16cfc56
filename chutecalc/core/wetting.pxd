cimport cython
from chutecalc.core cimport batch, floats, friction, section

cdef int WETTING_ROWS

@cython.locals(row=int, k=int, area=double)
cpdef tabulate_wetting(section.Section cross_section, section.Facets facets, double[:, ::1] numbers, double[:] areas, bint equilibrium, double[:, ::1] out)
@cython.locals(row=int)
cpdef areas_below(section.Section cross_section, section.Facets facets, double[:, ::1] numbers, double[:] depths, double[:] out)
