"""All roots of a function of one key between its bounds: a coarse grid, refined where a root may hide."""

from collections.abc import Callable

import numpy as np
from scipy.optimize import brentq

from chutecalc.physics.arrays import Array, Index

COARSE = 257
"""Points of the grid to begin with."""
DEEP = 100.0
"""How many times the difference from its neighbours a least value may be, where a root may hide beside it."""
FINER, LEVELS = 16, 4
"""Parts that a cell is cut into where a root may hide, and how often."""


def bracketed_roots(residual: Callable[[Array], Array]) -> Array:
    """Return where a function of one number crosses zero, or jumps over it: the caller knows which.

    Cells are refined where the sign changes; where one end has no value, since the other may lie on the wrong side of a
    root; and beside a least absolute value, where two roots may lie close together. On a level stretch that is far from
    zero, compared with its differences, there is none.

    Args:
        residual: of numbers from 0 to 1, shape (designs,); NaN where a design fails.

    >>> bracketed_roots(lambda x: np.where(x < 0.9, (x - 0.3) * (x - 0.301), np.nan)).round(9).tolist()
    [0.3, 0.301]
    """
    x = np.linspace(0.0, 1.0, COARSE)
    values = residual(x)
    for _ in range(LEVELS):
        cells = _suspicious(values)
        parts = np.arange(1, FINER) / FINER
        new = (x[cells, None] + parts * (x[cells + 1] - x[cells])[:, None]).ravel()
        if not new.size:
            break
        x, first = np.unique(np.concatenate([x, new]), return_index=True)
        values = np.concatenate([values, residual(new)])[first]
    found = list(x[values == 0.0])
    for cell in np.flatnonzero(values[:-1] * values[1:] < 0.0):
        try:
            found.append(brentq(lambda u: float(residual(np.array([u]))[0]), x[cell], x[cell + 1], xtol=1e-15))
        except ValueError:  # a design in between fails: no crossing
            continue
    return np.sort(found)


def _suspicious(values: Array) -> Index:
    """Return the cells, by the number of their lower end, in which a root may hide."""
    there = np.isfinite(values)
    size = np.where(there, np.abs(values), np.inf)
    with np.errstate(invalid="ignore"):
        cells = (there[:-1] != there[1:]) | (values[:-1] * values[1:] < 0.0)
        rise = np.maximum(size[:-2], size[2:]) - size[1:-1]
        is_least = (size[1:-1] < size[:-2]) & (size[1:-1] < size[2:]) & (size[1:-1] <= DEEP * rise)
        least = np.flatnonzero(is_least) + 1
    cells[least - 1] = True
    cells[least] = True
    return np.flatnonzero(cells)
