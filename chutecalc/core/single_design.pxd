cimport cython
from libc cimport math
from chutecalc.core cimport batch, floats, records, replay, state

@cython.final
cdef class SingleDesignSolver:
    cdef public replay.Recipe recipe
    cdef public records.ChuteState chute
    cdef public state.SolverOptions options
    cdef public double[:, ::1] inputs, numbers

@cython.locals(k=int, depth=double, slope=double, current=records.Point)
cpdef solve_single(SingleDesignSolver solver, tuple values)
