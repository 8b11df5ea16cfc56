from chutecalc.core cimport march, unlocked

cpdef int solve(march.Stream stream, march.Effort effort, double[:, ::1] numbers, double[:, ::1] results, int first, int last)
