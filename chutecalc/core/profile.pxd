cimport cython
from libc cimport math
from chutecalc.core cimport batch, flight, floats, records, section, slide

cdef int LYING, PRESSING, FLYING, TRIES

@cython.locals(design=int, row=int)
cpdef lying(slide.Slide way, double[:, ::1] numbers, int start, double[:, :] surfaces, double[:, :] places, double[:, :] squared, double[:, :, ::1] out)
cdef void lie(slide.Slide way, double place, double y, int row, int design, double[:, :, ::1] out) noexcept nogil
@cython.locals(design=int, row=int)
cpdef pressing(slide.Slide way, double[:, ::1] numbers, int start, double[:, :] surfaces, double[:, :] places, double[:, :] squared, double[:, :, ::1] out)
cdef void press(slide.Slide way, double place, double y, int row, int design, double[:, :, ::1] out) noexcept nogil
@cython.locals(arc=bint, drawn=bint)
cdef double pressure_on(slide.Slide way, double weight, double depth, bint upright) noexcept nogil
@cython.locals(design=int, row=int, path=records.Flight, time=double)
cpdef flying(double[:, :] paths, double[:] times, double[:, :] distances, double[:, :, ::1] out)
cdef void begin(records.Flight path, double[:, :] paths, int design) noexcept nogil
@cython.locals(design=int, row=int, path=records.Flight)
cpdef flown(double[:, :] paths, double[:, :] times, double[:, :] out)
cdef double time_at(records.Flight path, double whole, double distance) noexcept nogil
