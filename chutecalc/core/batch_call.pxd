from chutecalc.core cimport records, state, without_gil

cpdef int solve(records.ChuteState chute, state.SolverOptions options, double[:, ::1] numbers, int first, int last)
