cimport cython
from libc cimport math
from chutecalc.core cimport batch, floats, records, replay, state

@cython.final
cdef class Answer:
    cdef public replay.Recipe recipe
    cdef public records.Course course
    cdef public state.Effort effort
    cdef public double[:, ::1] given, numbers

@cython.locals(k=int, depth=double, slope=double, here=records.Point)
cpdef ask(Answer own, tuple values)
