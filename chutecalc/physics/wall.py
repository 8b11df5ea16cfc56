"""Wall friction: the shear stress τ of a wall at a normal stress σ, piecewise linear.

A constant wall friction angle is one piece through the origin. A measured wall yield locus has a piece between each two
rows, and its first and last slopes continue beyond them. Below the first row τ(0) is never negative: a line that would
cut the stress axis runs from that row to the origin instead, because it would otherwise leave no friction at the low
pressures of chutes, 0.5 to 5 kPa. From above, the locus is bounded by the strength of the material, τ = σ sin δ: a wall
cannot resist more than the material does (Paper, section 6).
"""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.intervals import interval_of, take_row


class Wall(NamedTuple):
    """Pieces τ = intercept + slope σ in rising σ; every field has the shape (pieces, designs)."""

    starts: Array
    """Normal stress at which each piece starts, Pa, 0 for the first."""
    intercepts: Array
    """Shear stress of each piece at σ = 0, Pa."""
    slopes: Array
    """dτ/dσ of each piece, a coefficient."""

    @property
    def changes(self) -> bool:
        """Whether the coefficient of friction depends on pressure."""
        return bool(self.intercepts.any()) or len(self.starts) > 1


def constant_wall(friction: Array) -> Wall:
    """Return a wall with one coefficient of friction at every pressure.

    Args:
        friction: Coefficient of wall friction μ = tan φ, shape (1,) or (designs,).

    >>> wall_friction(constant_wall(np.array([0.5])), np.array([1e3]))
    array([0.5])
    """
    shape = (1, len(friction))
    return Wall(starts=np.zeros(shape), intercepts=np.zeros(shape), slopes=friction[None])


def yield_locus(normal: Array, shear: Array, bound: Array) -> Wall:
    """Return a wall with a measured yield locus, bounded by the strength of the material.

    Args:
        normal: Normal stresses σ of the rows, Pa, positive and rising, shape (rows, designs), at least two rows.
        shear: Shear stresses τ of the rows, Pa, not negative and not falling, shape (rows, designs).
        bound: Slope sin δ of the material's own strength, a coefficient, shape (1,) or (designs,).

    Returns:
        The wall. A piece that a design does not have is empty: it starts where the next one does.

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
    """Find the piece that holds at a normal stress.

    Args:
        wall: The wall.
        stress: Normal stress σ, Pa, 0 or more, shape (..., designs).

    Returns:
        Row numbers of pieces, never of an empty one, in the broadcast shape.

    >>> wall_piece(constant_wall(np.array([0.5])), np.array([1e3]))
    array([0])
    """
    return interval_of(wall.starts, stress)


def wall_friction(wall: Wall, stress: Array) -> Array:
    """Compute the coefficient of wall friction at a normal stress, μ_w = τ/σ.

    Args:
        wall: The wall.
        stress: Normal stress σ, Pa, 0 or more, shape (..., designs).

    Returns:
        μ_w, a coefficient, in the broadcast shape; at σ = 0 the slope of the first piece.

    >>> adhesive = Wall(starts=np.zeros((1, 1)), intercepts=np.array([[50.0]]), slopes=np.array([[0.4]]))
    >>> float(wall_friction(adhesive, np.array([1e3]))[0].round(9))
    0.45
    """
    piece = wall_piece(wall, stress)
    slope, intercept = take_row(wall.slopes, piece), take_row(wall.intercepts, piece)
    return slope + intercept / np.where(stress > 0.0, stress, np.inf)


def holding_depth(wall: Wall, slope: Array, specific_weight: Array) -> Array:
    """Compute the depth of a bed at rest that adhesion holds on a wall steeper than its friction, h.

    The bed presses with σ = ρ g h cos a and pulls with σ tan a. On a piece τ = c + σ tan φ of the locus it is held up
    to σ = c/(tan a - tan φ), which is h = c/[ρ g (sin a - tan φ cos a)]; below the end of that piece.

    Args:
        wall: The wall.
        slope: Slope a of the wall, rad below horizontal, above 0, shape (1,) or (designs,).
        specific_weight: ρ g, N/m³, likewise.

    Returns:
        h, m, shape (designs,): 0 where nothing is held, infinite where a bed of any depth is.

    >>> adhesive = Wall(starts=np.zeros((1, 1)), intercepts=np.array([[200.0]]), slopes=np.array([[0.5]]))
    >>> holding_depth(adhesive, np.radians([45.0]), np.array([1e4])).round(6).tolist()
    [0.056569]
    """
    tangent = np.tan(slope)
    ends = np.concatenate([wall.starts[1:], np.full_like(wall.starts[:1], np.inf)])
    with np.errstate(divide="ignore", invalid="ignore"):
        stress = np.where(wall.slopes < tangent, wall.intercepts / (tangent - wall.slopes), np.inf)
        held = np.where(stress > wall.starts, np.minimum(stress, ends), 0.0)
        return np.asarray(held.max(axis=0) / (specific_weight * np.cos(slope)))


def _holding(stress: Array, normal: Array, slopes: Array, intercepts: Array, bound: Array) -> Index:
    """Return the number of the piece, of the locus or the bound, that holds at stresses of shape (pieces, designs)."""
    row = interval_of(np.concatenate([np.zeros_like(normal[:1]), normal[:-1]]), stress)
    measured = np.take_along_axis(intercepts, row, axis=0) + np.take_along_axis(slopes, row, axis=0) * stress
    chosen: Index = np.where(measured > bound * stress, len(slopes), row)
    return chosen
