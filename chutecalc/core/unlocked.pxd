from chutecalc.core cimport batch, records, state

cdef inline int solve_rows(records.Course course, state.Effort effort, double[:, ::1] numbers, int first, int last):
    cdef int row
    with nogil:
        row = batch.solve_rows(course, effort, numbers, first, last)
    return row
