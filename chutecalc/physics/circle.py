"""A stream in a circular section, up to the half circle: depth and wall load from the flow area.

With the wetted half-angle ψ0 the area is A = r² (ψ0 - sin ψ0 cos ψ0), Kepler's equation at eccentricity 1. Everything
that follows from ψ0, divided by its leading power, is smooth in u = (12 A/r²)^(2/3), near 0 as well, where the formulas
in ψ0 lose their digits. Each quantity is therefore a Chebyshev series in u; 26 terms are exact to rounding.
"""

from functools import lru_cache

import numpy as np

from chutecalc.physics.arrays import Array

TERMS = 26
"""Terms of each series."""
LARGEST = (6.0 * np.pi) ** (2.0 / 3.0)
"""u of the half circle, dimensionless."""


def _angle_area(angle: Array) -> Array:
    """Compute A/r² = ψ0 - sin ψ0 cos ψ0 = (E - sin E)/2 with E = 2 ψ0 by its power series."""
    square = (2.0 * angle) ** 2
    total = np.zeros(angle.shape)
    for k in range(16, 0, -1):
        total = (1.0 - total) * square / (2 * k * (2 * k + 1))
    return 0.5 * (2.0 * angle) * total


@lru_cache(maxsize=1)
def series() -> Array:
    """Return the Chebyshev coefficients of ψ0, of the three wall loads and of the loads' derivatives.

    The loads are (2 r²/A) ∫₀^ψ0 w (cos ψ - cos ψ0) dψ with the weights w = 1 - cos ψ, sin²ψ (1 - cos ψ) and
    sin²ψ cos ψ: from them χ and the missing load m follow at any K_v, for K(ψ) = 1 - (1 - K_v) sin²ψ.

    Returns:
        Dimensionless coefficients over 2 u/LARGEST - 1, shape (7, TERMS): ψ0/√u; the loads over u, u² and u; the
        derivatives of these three by u. They hold for 0 ≤ u ≤ LARGEST.

    >>> from numpy.polynomial import chebyshev
    >>> angle = np.sqrt(LARGEST) * chebyshev.chebval(1.0, series()[0])  # of the half circle
    >>> bool(abs(angle / (np.pi / 2) - 1) < 1e-14)
    True
    """
    from numpy.polynomial import chebyshev, legendre  # not loaded by NumPy itself, nor needed without a circle

    nodes = chebyshev.chebpts1(TERMS)
    u = LARGEST * (1.0 + nodes) / 2.0
    angle = np.sqrt(u) / 2.0
    for _ in range(8):
        angle = angle - (_angle_area(angle) - u**1.5 / 12.0) / (2.0 * np.sin(angle) ** 2)
    gauss, weights = legendre.leggauss(24)
    psi = angle * (1.0 + gauss[:, None]) / 2.0
    # cos ψ - cos ψ0 and 1 - cos ψ as products of sines
    head = 2.0 * np.sin((angle + psi) / 2.0) * np.sin((angle - psi) / 2.0)
    tilt = 2.0 * np.sin(psi / 2.0) ** 2
    square = np.sin(psi) ** 2
    area = u**1.5 / 12.0
    loads = [(weights @ (load * head)) * angle / area for load in (tilt, square * tilt, square * np.cos(psi))]
    functions = np.stack([angle / np.sqrt(u), loads[0] / u, loads[1] / u**2, loads[2] / u])
    values = np.linalg.solve(chebyshev.chebvander(nodes, TERMS - 1), functions.T)
    slopes = np.zeros((TERMS, 3))
    slopes[:-1] = chebyshev.chebder(values[:, 1:]) * (2.0 / LARGEST)
    return np.ascontiguousarray(np.concatenate([values, slopes], axis=1).T)
