"""Scrambled Sobol points: the same for the same seed, in independent replicates that tell the error of a mean."""

from collections.abc import Iterator

import numpy as np
from scipy.stats import qmc

from chutecalc.errors import UsageError
from chutecalc.physics.arrays import Array

REPLICATES = 16
"""Independent scramblings of the points. The scatter of their means is what the standard error is taken from."""
FEWEST, MOST = 256, 1 << 24
"""Samples of a study."""
BITS = 32
"""Binary digits of a point."""


def sample_count(asked: int) -> int:
    """Return the number of samples: the next power of two, of which Sobol points fill the cube most evenly.

    Args:
        asked: at least this many.

    Raises:
        UsageError: that is too few or too many.

    >>> sample_count(1_000_000)
    1048576
    """
    if not FEWEST <= asked <= MOST:
        raise UsageError(f"samples must be {FEWEST} to {MOST:,}, not {asked:,}")
    return 1 << (asked - 1).bit_length()


def cubes(dimension: int, count: int, seed: int) -> Iterator[Array]:
    """Yield points of the unit cube, one replicate after the other.

    Points lie in the middle of their cells of 2**-32, so that none is at an end, where a normal number is infinite.

    Args:
        dimension: of the cube.
        count: points of a replicate, a power of two.
        seed: of the scramblings.

    Yields:
        Points of shape (count, dimension).

    >>> first, *others = cubes(2, 4, seed=1)
    >>> np.sort(np.floor(4 * first[:, 0])).tolist(), len(others)
    ([0.0, 1.0, 2.0, 3.0], 15)
    """
    for own in np.random.SeedSequence(seed).spawn(REPLICATES):
        engine = qmc.Sobol(dimension, scramble=True, bits=BITS, seed=np.random.default_rng(own))
        yield engine.random(count) + 0.5 ** (BITS + 1)


def error_of(replicates: Array) -> Array:
    """Return the standard error of the mean of replicates, s / √R.

    Args:
        replicates: an estimate from each, in any unit, shape (replicates, ...); NaN for one that has none.
    """
    there = np.isfinite(replicates)
    count = np.maximum(there.sum(axis=0), 1)
    mean = np.where(there, replicates, 0.0).sum(axis=0) / count
    squares = np.where(there, (replicates - mean) ** 2, 0.0).sum(axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        error: Array = np.sqrt(np.where(count > 1, squares / (count - 1), np.nan) / count)
    return error
