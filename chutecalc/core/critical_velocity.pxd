cimport cython
from libc cimport math
from chutecalc.core cimport batch, floats, guide_surface, motion

cdef double SLOWEST, STEP
cdef double STEPS

@cython.locals(design=int, row=int, uniform=double)
cpdef critical_velocities(guide_surface.Guide guide, double[:, ::1] numbers, int start, double[:, :] surfaces, double[:, :] shares, double[:, :] velocities, double[:, :] out)
@cython.locals(accelerates=bint, k=double)
cdef double critical_velocity(guide_surface.Guide guide, double share, double velocity) noexcept nogil
cdef double net_acceleration(guide_surface.Guide guide, double share, double number) noexcept nogil
@cython.locals(last=int, at=double)
cdef double find_root(guide_surface.Guide guide, double share, double number, double f_low, double f_high) noexcept nogil
