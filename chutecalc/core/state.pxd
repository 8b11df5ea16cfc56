cimport cython
from chutecalc.core cimport events, floats, gauss, matrix, panel, slide

cdef int OK, STALL, CHOKED, CONTACT_LOST, MISSED, NOT_REACHED, PASSED, RUNNING, UNSOLVED, FAULT, KEPT
cdef double LEAST_STEP

@cython.final
cdef class Effort:
    cdef public gauss.Pair first, second, later, near_rest
    cdef public double tolerance, share
    cdef public bint complete

@cython.final
cdef class Log:
    cdef public panel.Panel panel
    cdef public double[::1] margins, values, kept
    cdef public int room, count
    cdef public bint full

@cython.final
cdef class Stream:
    cdef public slide.Slide way
    cdef public Log log
    cdef public panel.Panel panel
    cdef public double[::1] margins, values
    cdef public int[::1] watched
    cdef public int status, facet, piece, tried
    cdef public bint eventful, aim_by_root, promising, tired
    cdef public double place, y, error, limit, reach, stride, aim, crossed, choke_place, choke_y, choke_error

cdef double margin(Stream stream, int event, double place, double y) noexcept nogil
