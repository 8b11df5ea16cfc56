cimport cython

cdef extern from "<math.h>" nogil:
    const double NAN
    const double INFINITY
    double sqrt(double x)
    double exp(double x)

@cython.cdivision(True)
cdef inline double quotient(double over, double under) noexcept nogil:
    return over / under

cdef inline double root(double x) noexcept nogil:
    return sqrt(x)

cdef inline double power(double x) noexcept nogil:
    return exp(x) if x < 709.0 else (INFINITY if x >= 709.0 else NAN)
