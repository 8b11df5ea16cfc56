"""Wall friction: the shear stress that a wall shows at a normal stress, as one law of linear pieces.

A constant angle is one piece through the origin. A measured wall yield locus has a piece between each two of its rows,
its first and last slope going on beyond them. Below the first row it never comes to less than 0 at σ = 0: a line that
would cut the stress axis goes from that row to the origin instead, for else there would be no friction at all at the
low pressures that chutes have. From above the locus is bounded by the material's own strength, τ = σ sin δ: a wall
cannot resist more than the material does.
"""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.intervals import interval_of, take_row


class Wall(NamedTuple):
    """Pieces τ = intercept + slope σ, in rising σ; every field has the shape (pieces, designs), stresses in Pa."""

    starts: Array
    """σ from which on a piece holds, 0 for the first."""
    intercepts: Array
    slopes: Array

    @property
    def changes(self) -> bool:
        """Whether friction depends on pressure at all."""
        return bool(self.intercepts.any()) or len(self.starts) > 1


def constant_wall(friction: Array) -> Wall:
    """A wall of one friction coefficient μ = tan φ, shape (1,) or (designs,)."""
    return Wall(np.zeros((1, len(friction))), np.zeros((1, len(friction))), friction[None])


def yield_locus(normal: Array, shear: Array, bound: Array) -> Wall:
    """A measured locus, bounded by the material's own strength.

    Args:
        normal: σ of the rows, Pa, positive and rising, shape (rows, designs), two rows at least.
        shear: τ of the rows, Pa, not negative and not falling, likewise.
        bound: sin δ, shape (1,) or (designs,).

    Returns:
        The wall. Pieces that some designs do not have are empty there: they start where the next one does.

    >>> kpa = np.array([[1e3], [2e3]])
    >>> wall = yield_locus(kpa, np.array([[0.6e3], [1.0e3]]), np.array([0.5]))
    >>> [round(float(wall_friction(wall, np.array([sigma]))[0]), 6) for sigma in (100.0, 2e3, 4e3)]
    [0.5, 0.5, 0.45]
    """
    shape = np.broadcast_shapes(normal.shape[1:], shear.shape[1:], bound.shape)
    normal, shear = (np.broadcast_to(rows, (len(rows), *shape)) for rows in (normal, shear))
    bound = np.broadcast_to(bound, shape)
    zero = np.zeros((1, *shape))
    slopes = np.diff(shear, axis=0) / np.diff(normal, axis=0)
    intercepts = shear[:-1] - slopes * normal[:-1]
    bent = intercepts[:1] < 0.0
    slopes = np.concatenate([np.where(bent, shear[:1] / normal[:1], slopes[:1]), slopes])
    intercepts = np.concatenate([np.where(bent, 0.0, intercepts[:1]), intercepts])
    candidates = np.concatenate([intercepts, zero]), np.concatenate([slopes, bound[None]])
    with np.errstate(all="ignore"):
        crossings = intercepts / (bound - slopes)
    corners = np.concatenate([np.where(bent, normal[:1], np.inf), normal[1:-1], crossings])
    starts = np.concatenate([zero, np.sort(np.where(corners > 0.0, corners, np.inf), axis=0)])
    ends = np.concatenate([starts[1:], np.full((1, *shape), np.inf)])
    inside = np.where(np.isfinite(ends), 0.5 * (starts + ends), 2.0 * starts + 1.0)  # no corner lies within a piece
    holds = _holding(np.where(np.isfinite(inside), inside, 1.0), normal, slopes, intercepts, bound)
    return Wall(starts, *(np.take_along_axis(field, holds, axis=0) for field in candidates))


def wall_piece(wall: Wall, stress: Array) -> Index:
    """The piece that holds at a normal stress, Pa, shape (..., designs); empty pieces are never told."""
    return interval_of(wall.starts, stress)


def wall_friction(wall: Wall, stress: Array) -> Array:
    """μ_w = τ/σ at a normal stress, Pa, shape (..., designs); its limit where σ is 0."""
    piece = wall_piece(wall, stress)
    slope, intercept = take_row(wall.slopes, piece), take_row(wall.intercepts, piece)
    return slope + intercept / np.where(stress > 0.0, stress, np.inf)


def _holding(stress: Array, normal: Array, slopes: Array, intercepts: Array, bound: Array) -> Index:
    """Which of the pieces of the locus and the bound holds at stresses, shape (pieces, designs)."""
    row = interval_of(np.concatenate([np.zeros_like(normal[:1]), normal[:-1]]), stress)
    measured = np.take_along_axis(intercepts, row, axis=0) + np.take_along_axis(slopes, row, axis=0) * stress
    chosen: Index = np.where(measured > bound * stress, len(slopes), row)
    return chosen
