cimport cython
from libc cimport math
from chutecalc.core cimport batch, flight, floats, records, slide, walls

cdef int TRIES

@cython.locals(design=int, row=int)
cpdef lying(slide.Slide way, double[:, ::1] numbers, int start, double[:, :] surfaces, double[:, :] places, double[:, :] squared, double[:, :, ::1] out)
@cython.locals(design=int, row=int)
cpdef pressing(slide.Slide way, double[:, ::1] numbers, int start, double[:, :] surfaces, double[:, :] places, double[:, :] squared, double[:, :, ::1] out)
@cython.locals(design=int, row=int, path=records.Flight, time=double)
cpdef flying(double[:, :] paths, double[:] times, double[:, :] distances, double[:, :, ::1] out)
cdef void begin(records.Flight path, double[:, :] paths, int design) noexcept nogil
@cython.locals(design=int, row=int, path=records.Flight)
cpdef flown(double[:, :] paths, double[:, :] times, double[:, :] out)
cdef double time_at(records.Flight path, double whole, double distance) noexcept nogil
