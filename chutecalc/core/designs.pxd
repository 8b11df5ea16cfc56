from chutecalc.core cimport records, state, unlocked

cpdef int solve(records.Course course, state.Effort effort, double[:, ::1] numbers, int first, int last)
