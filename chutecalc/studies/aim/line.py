"""Whether solutions of an aim lie on a line, so that there is no end of them."""

from collections.abc import Sequence

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.studies.aim.refine import Residuals, differences, refined

FLAT = 1e-4
"""Share of the largest singular value of the slopes below which a root is tried for a line through it."""
ASIDE = 0.01
"""Distance at which a line is tried, as a share of the bounds; half of it has to be kept."""
ROOT = 1e-8
"""Size of the residuals, as a share of their spread, that is a root."""


def dead_targets(residuals: Residuals, places: Array) -> list[int] | None:
    """Return None if roots are apart; if a line of roots goes through any, the numbers of residuals that stay level.

    Where the matrix of slopes is singular, there may be a line of roots or a double root. The place is moved along what
    changes nothing, and refined: on a line it stays where it is, and from a double root it comes back.

    Args:
        residuals: functions of as many numbers from 0 to 1 as there are residuals.
        places: roots, dimensionless, shape (roots, keys).

    >>> dead_targets(lambda x: np.stack([x[:, 0] - x[:, 1], 0.0 * x[:, 0]], axis=1), np.array([[0.5, 0.5]]))
    [1]
    >>> dead_targets(lambda x: np.stack([x[:, 0] - x[:, 1], (x[:, 0] - 0.5) ** 2], axis=1), np.array([[0.5, 0.5]]))
    """
    slopes = differences(residuals, places, residuals(places))
    known = np.isfinite(slopes).all(axis=(1, 2))
    places, slopes = places[known], slopes[known]
    _, size, right = np.linalg.svd(slopes)
    flat = size[:, -1] <= FLAT * size[:, 0]
    places, slopes, along = places[flat], slopes[flat], right[flat, -1]
    if not len(places):
        return None
    begin = np.concatenate([places, places])
    end = refined(residuals, np.clip(begin + ASIDE * np.concatenate([along, -along]), 0.0, 1.0))
    stays = np.linalg.norm(residuals(end), axis=1) <= ROOT
    line = (stays & (np.linalg.norm(end - begin, axis=1) > 0.5 * ASIDE)).reshape(2, -1).any(axis=0)
    level = np.linalg.norm(slopes[line], axis=2).max(axis=0, initial=0.0) <= FLAT
    return [int(number) for number in np.flatnonzero(level)] if line.any() else None


def line_text(targets: Sequence[str], dead: Sequence[int]) -> str:
    """Return that there is no end of solutions, why, and what to do.

    Args:
        targets: names of all targets.
        dead: numbers of those that no key moves.
    """
    still = " and ".join(targets[number] for number in dead)
    why = f": no key moves {still} there" if dead else ", along which the targets do not change"
    remedy = f"another target than {still}" if dead else "another target"
    return (
        f"{', '.join(targets)}: the solutions lie on a whole line, without end{why}. Choose {remedy}, or fewer keys"
        " and targets"
    )
