"""A stream in a circular section, up to the half circle: depth and wall load from the flow area.

With the wetted half-angle ψ0 the area is A = r² (ψ0 - sin ψ0 cos ψ0). That is Kepler's equation at eccentricity 1, and
all that follows from it, divided by its leading power, is smooth in u = (12 A/r²)^(2/3), near 0 as well, where the
formulas in ψ0 lose their digits. So each is kept as a Chebyshev series in u; 26 terms are exact to rounding.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array

TERMS = 26
LARGEST = (6.0 * np.pi) ** (2.0 / 3.0)
"""u of the half circle."""


class Arc(NamedTuple):
    """A stream on an arc, in the shape of its area."""

    angle: Array
    """Wetted half-angle ψ0, rad."""
    excess: Array
    """χ = (1/A) ∫ K (1 - cos ψ) ζ dl, hydrostatic."""
    excess_growth: Array
    """A dχ/dA."""
    missing: Array
    """m = (1/A) ∫ (1 - K) cos ψ ζ dl, the share of the weight that hydrostatic pressures do not carry."""
    missing_growth: Array
    """A dm/dA."""


def arc(area: Array, lack: Array) -> Arc:
    """The stream of an area in a circle.

    Args:
        area: A/r², 0 to π/2, any shape; above that the half circle's continuation, without meaning.
        lack: 1 - K_v, broadcast against it.

    Returns:
        Angle and loads; χ = 2 ∫ K (1 - cos ψ)(cos ψ - cos ψ0) dψ r²/A with K = 1 - lack sin²ψ.

    >>> half = arc(np.array([np.pi / 2]), np.zeros(1))  # of a liquid: 4/π - 1 more friction than weight
    >>> float(half.angle[0] - np.pi / 2).__abs__() < 1e-15, float(half.excess[0] - (4 / np.pi - 1)).__abs__() < 1e-15
    (True, True)
    """
    root = np.cbrt(12.0 * area)
    u = root**2
    t = 2.0 * u / LARGEST - 1.0
    sums = np.zeros((len(series()), t.size))
    for coefficients, polynomial in zip(series().T, _chebyshev(t.ravel()), strict=True):
        sums += coefficients[:, None] * polynomial  # term after term, whatever the width
    sums = sums.reshape(-1, *t.shape)
    angle, level, bent, lacking, level_slope, bent_slope, lacking_slope = sums
    third = 2.0 / 3.0  # A d/dA = (2/3) u d/du
    excess = u * (level - lack * u * bent)
    growth = third * u * (level + u * level_slope - lack * u * (2.0 * bent + u * bent_slope))
    missing = lack * u * lacking
    return Arc(root * angle, excess, growth, missing, third * lack * u * (lacking + u * lacking_slope))


def angle_area(angle: Array) -> Array:
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
        angle = angle - (angle_area(angle) - u**1.5 / 12.0) / (2.0 * np.sin(angle) ** 2)
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


def _chebyshev(t: Array) -> Array:
    """The polynomials T_0 to T_(TERMS - 1) at places, shape (TERMS, places): T_(k+j) = 2 T_k T_j - T_(k-j)."""
    table = np.empty((TERMS, len(t)))
    table[0], table[1] = 1.0, t
    known = 1
    while known < TERMS - 1:
        count = min(known, TERMS - 1 - known)
        new = np.multiply(table[1 : count + 1], table[known], out=table[known + 1 : known + 1 + count])
        new *= 2.0
        new -= table[known - count : known][::-1]
        known += count
    return table
