from chutecalc.core cimport state, unlocked

cpdef int solve(state.Stream stream, state.Effort effort, double[:, ::1] numbers, double[:, ::1] results, int first, int last)
