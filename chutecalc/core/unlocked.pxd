from chutecalc.core cimport batch, state

cdef inline int solve_rows(state.Stream stream, state.Effort effort, double[:, ::1] numbers, double[:, ::1] results, int first, int last):
    cdef int row
    with nogil:
        row = batch.solve_rows(stream, effort, numbers, results, first, last)
    return row
