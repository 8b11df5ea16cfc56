cimport cython
from libc cimport math
from chutecalc.core cimport events, floats, gauss, panel, section, slide

cdef int OK, STALL, CHOKED, CONTACT_LOST, RUNNING, UNSOLVED, PASSES, PATIENCE, KEPT
cdef double LEAST_STEP, TIRED, AGAIN, CLEAR, STOPPING, STARTING, SHY, AWAY, STIFF, CREEP
cdef double AT_END, ROUNDING, CLOSE, BEYOND, WELL_WITHIN

@cython.final
cdef class Effort:
    cdef public gauss.Pair first, second, later, near_rest
    cdef public double tolerance, share, inner_tolerance
    cdef public bint complete

@cython.final
cdef class Stream:
    cdef public slide.Slide way
    cdef public panel.Panel panel
    cdef public double[::1] margins, values, kept
    cdef public int[::1] watched
    cdef public int room, panels, status, facet, piece, tried
    cdef public bint full, eventful, aim_by_root, hopeful, tired
    cdef public double place, y, error, limit, reach, stride, aim, crossed, choke_place, choke_y, choke_error

cdef void run(Stream stream, Effort effort) noexcept nogil
cdef void begin(Stream stream, Effort effort) noexcept nogil
cdef double first_limit(slide.Slide way, double place) noexcept nogil
cdef (double, double) pull_here(Stream stream) noexcept nogil
cdef bint stops(Stream stream, double change) noexcept nogil
cdef bint crosses(Stream stream, Effort effort, double change) noexcept nogil
cdef double margin(Stream stream, int event, double place, double y) noexcept nogil
cdef void go_on(Stream stream, Effort effort, double change, double growth) noexcept nogil
cdef void advance_by_place(Stream stream, Effort effort, double target, double growth) noexcept nogil
cdef double slowest(Stream stream) noexcept nogil
cdef double fastest(Stream stream) noexcept nogil
@cython.locals(good=bint)
cdef void advance(Stream stream, Effort effort, int kind, double target, gauss.Pair pair, double tolerance) noexcept nogil
@cython.locals(by_root=bint)
cdef void judge(Stream stream, Effort effort, gauss.Rule rule, double start, double end) noexcept nogil
cdef double margin_at(Stream stream, int event, double at, double unknown) noexcept nogil
cdef bint happens(Stream stream, gauss.Rule rule, int event, double start, double end, double cut) noexcept nogil
cdef void accept_part(Stream stream, Effort effort, gauss.Rule rule, double start, double end, double cut) noexcept nogil
cdef void accept(Stream stream, Effort effort, gauss.Rule rule, double end, double off) noexcept nogil
cdef void keep(Stream stream, gauss.Rule rule, double end) noexcept nogil
cdef void retreat(Stream stream, int kind, double step) noexcept nogil
cdef void chatter(Stream stream, bint by_root, double step) noexcept nogil
cdef void arrive(Stream stream) noexcept nogil
cdef void happen(Stream stream, Effort effort, int event) noexcept nogil
cdef int beyond(int number, int there, int side) noexcept nogil
