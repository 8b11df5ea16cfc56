"""Compiled by Numba, one design at a time: DOP853 with SciPy's coefficients, error estimate and step control.

If numbalsoda is installed, which takes a Fortran compiler, its solvers run on the same right-hand side.
"""

from functools import cache
from typing import Any

import numpy as np
from numba import carray, cfunc, njit
from scipy.integrate._ivp import dop853_coefficients as table

STAGES = table.N_STAGES
A, B, C = (np.ascontiguousarray(item) for item in (table.A[:STAGES, :STAGES], table.B, table.C[:STAGES]))
E3, E5 = np.ascontiguousarray(table.E3), np.ascontiguousarray(table.E5)


@njit(cache=False)
def rate(theta: float, y: float, p: np.ndarray) -> float:
    """Compute dy/dθ of y = v²; parameters as for heyoka."""
    thin = p[2] / np.sqrt(y)
    wide = p[1] + np.sqrt(p[1] * p[1] + p[4] * thin)
    friction = p[5] * (1.0 + p[3] * thin / (wide * wide))
    return 2.0 * (p[0] * np.cos(theta) - friction * (p[0] * np.sin(theta) + y))


@njit(cache=False)
def dop853(parameters: np.ndarray, start: np.ndarray, end: float, rtol: float) -> np.ndarray:
    """Compute the exit velocities of all designs."""
    out = np.empty(len(start))
    k = np.empty(STAGES + 1)
    for design in range(len(start)):
        p, y, theta, h = parameters[design], start[design] ** 2, 0.0, 0.05
        k[0] = rate(theta, y, p)
        while theta < end:
            h = min(h, end - theta)
            for s in range(1, STAGES):
                rise = 0.0
                for j in range(s):
                    rise += A[s, j] * k[j]
                k[s] = rate(theta + C[s] * h, y + h * rise, p)
            rise = 0.0
            for j in range(STAGES):
                rise += B[j] * k[j]
            new = y + h * rise
            k[STAGES] = rate(theta + h, new, p)
            scale = 1e-3 * rtol + rtol * max(abs(y), abs(new))
            e5, e3 = 0.0, 0.0
            for j in range(STAGES + 1):
                e5 += E5[j] * k[j] / scale
                e3 += E3[j] * k[j] / scale
            norm = 0.0
            if e5 != 0.0 or e3 != 0.0:
                norm = abs(h) * e5 * e5 / np.sqrt(e5 * e5 + 0.01 * e3 * e3)
            if norm < 1.0:
                theta, y = theta + h, new
                k[0] = k[STAGES]
                h *= min(10.0, 0.9 * max(norm, 1e-10) ** -0.125)
            else:
                h *= max(0.2, 0.9 * norm**-0.125)
        out[design] = np.sqrt(y)
    return out


@cache
def _numbalsoda_equation() -> Any:
    """Return the address of the compiled right-hand side; the time of compiling does not count."""
    from numbalsoda import lsoda_sig

    @cfunc(lsoda_sig)
    def equation(theta: float, y: Any, dy: Any, p: Any) -> None:
        dy[0] = rate(theta, y[0], carray(p, (6,)))

    return equation


def with_numbalsoda(method: str, rtol: float, grid: np.ndarray, start: float, parameters: np.ndarray) -> np.ndarray:
    """Solve with ``lsoda`` or ``dop853``; parameters as for heyoka."""
    import numbalsoda

    found, _ = getattr(numbalsoda, method)(
        _numbalsoda_equation().address, np.array([start**2]), grid, parameters, rtol=rtol, atol=1e-3 * rtol
    )
    return np.sqrt(found[:, 0])
