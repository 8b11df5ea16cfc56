"""A stream in a circular section, up to the half circle: depth and wall load from the flow area.

With the wetted half-angle ψ0 the area is A = r² (ψ0 - sin ψ0 cos ψ0). That is Kepler's equation at eccentricity 1, and
all that follows from it, divided by its leading power, is smooth in u = (12 A/r²)^(2/3), near 0 as well, where the
formulas in ψ0 lose their digits. So each is kept as a Chebyshev series in u; 26 terms are exact to rounding.
"""

from functools import lru_cache

import numpy as np

from chutecalc.physics.arrays import Array

TERMS = 26
LARGEST = (6.0 * np.pi) ** (2.0 / 3.0)
"""u of the half circle."""


def _angle_area(angle: Array) -> Array:
    """A/r² of a wetted half-angle, ψ0 - sin ψ0 cos ψ0 = (E - sin E)/2 with E = 2 ψ0, by its series."""
    square = (2.0 * angle) ** 2
    total = np.zeros(angle.shape)
    for k in range(16, 0, -1):
        total = (1.0 - total) * square / (2 * k * (2 * k + 1))
    return 0.5 * (2.0 * angle) * total


@lru_cache(maxsize=1)
def series() -> Array:
    """Coefficients, shape (7, TERMS): of ψ0/√u, of the three loads, and of the loads' slopes in u."""
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
