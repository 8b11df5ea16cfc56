from chutecalc.core cimport records, state, unlocked

cpdef int solve(records.Course course, state.Effort effort, double[:, ::1] numbers, double[:, ::1] ends, int first, int last)
