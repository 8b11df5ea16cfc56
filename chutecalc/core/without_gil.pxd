from chutecalc.core cimport batch, records, state

cdef inline int solve_rows(records.ChuteState chute, state.SolverOptions options, double[:, ::1] numbers, int first, int last):
    cdef int row
    with nogil:
        row = batch.solve_rows(chute, options, numbers, first, last)
    return row
