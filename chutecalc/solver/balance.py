"""The velocity at which a stream on a straight keeps its speed."""

import numpy as np

from chutecalc.design import length
from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.roots import root_between
from chutecalc.solver.slide import Slide, net_pull

SLOWEST, FASTEST = 1e-9, 1e12
GRID = 320
"""Velocities, evenly in their logarithm, between which balances are looked for."""
BLOCK = 100_000


def critical_velocity(slide: Slide, place: Array, velocity: Array) -> Array:
    """v_c, where tan a = μ_e(v_c) and friction grows as the stream slows: the next such balance below a velocity.

    With constant wall friction, which grows with depth, there is one at most: entered slower, the stream decelerates to
    a stall. With a yield locus there may be several.

    Args:
        slide: a straight and the flow on it, n designs.
        place: where along it, shape (n,).
        velocity: of the stream there, m/s, shape (n,).

    Returns:
        v_c, m/s, shape (n,): 0 where the stream accelerates at every smaller velocity, the next balance above where it
        decelerates, infinite where it does so at any.
    """
    n = max(length(slide), len(velocity), len(place))
    place, velocity = np.broadcast_to(place, n), np.broadcast_to(velocity, n)

    def surplus(log_velocity: Array, rows: Index) -> Array:
        return net_pull(slide.rows(rows), place[rows], np.exp(2.0 * log_velocity))

    grid = np.repeat(np.linspace(np.log(SLOWEST), np.log(FASTEST), GRID)[:, None], n, axis=1)
    blocks = np.array_split(grid, max(1, GRID * n // BLOCK))
    values = np.concatenate(
        [net_pull(slide, np.broadcast_to(place, rows.shape), np.exp(2.0 * rows)) for rows in blocks]
    )
    rising = (values[:-1] <= 0.0) & (values[1:] > 0.0)
    below = rising & (grid[:-1] <= np.log(velocity))
    faster = net_pull(slide, place, velocity**2) > 0.0
    last = len(grid) - 2 - below[::-1].argmax(axis=0)  # the highest balance below the stream
    first = (rising & (grid[1:] >= np.log(velocity))).argmax(axis=0)  # the lowest above it
    chosen, columns = np.where(faster, last, first), np.arange(n)
    ends = (grid[chosen, columns], grid[chosen + 1, columns], values[chosen, columns], values[chosen + 1, columns])
    found = np.exp(root_between(surplus, *ends))
    exists = rising[chosen, columns] & np.where(faster, below.any(axis=0), True)
    return np.where(exists, found, np.where(faster, 0.0, np.inf))
