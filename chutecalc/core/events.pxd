cimport cython
from libc cimport math
from chutecalc.core cimport floats, friction, gauss, section, slide

cdef int CONTACT, CHOKE, DEEPER, SHALLOWER, FIRMER, LOOSER, END
cdef double LEVEL, ASIDE

cdef double margin(slide.Slide way, int facet, int piece, int event, double place, double y, double limit) noexcept nogil
cdef double balance(double more, double less) noexcept nogil
cdef double closeness(double value, double limit) noexcept nogil
cdef double first_crossing(gauss.Rule rule, double[::1] margins) noexcept nogil
@cython.locals(near=bint)
cdef double dip(gauss.Rule rule, double[::1] margins) noexcept nogil
