from chutecalc.core cimport batch, march

cdef inline int solve_rows(march.Stream stream, march.Effort effort, double[:, ::1] numbers, double[:, ::1] results, int first, int last):
    cdef int row
    with nogil:
        row = batch.solve_rows(stream, effort, numbers, results, first, last)
    return row
