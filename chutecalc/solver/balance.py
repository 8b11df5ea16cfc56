"""The velocity at which a stream on a straight keeps its speed."""

import numpy as np

from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.roots import root_between
from chutecalc.physics.section import excess_friction, take_facet, wetted_facet
from chutecalc.solver.slide import Slide

SLOWEST, FASTEST = 1e-9, 1e4


def critical_velocity(slide: Slide) -> Array:
    """v_c, where tan a = μ_e(v_c): entered slower, a stream on a straight decelerates to a stall.

    Friction grows with depth, so the balance is unstable: a faster stream accelerates.

    Args:
        slide: a straight and the flow on it, n designs.

    Returns:
        v_c, m/s, shape (n,); 0 where the slope is steeper than any friction of the section, infinite where it is
        flatter than the wall friction angle itself.
    """
    n = max(len(slide.entry_slope), len(slide.flow), len(slide.friction), slide.facets.area.shape[1])
    slope, flow = np.broadcast_to(slide.entry_slope, n), np.broadcast_to(slide.flow, n)
    friction = np.broadcast_to(slide.friction, n)

    def surplus(log_velocity: Array, rows: Index) -> Array:
        chosen = slide.rows(rows)
        area = flow[rows] / np.exp(log_velocity)
        facet = take_facet(chosen.facets, np.broadcast_to(wetted_facet(chosen.facets, area), rows.shape))
        return np.sin(slope[rows]) - friction[rows] * (1.0 + excess_friction(facet, area)[0]) * np.cos(slope[rows])

    everything = np.arange(n)
    low, high = np.full(n, np.log(SLOWEST)), np.full(n, np.log(FASTEST))
    slow, fast = surplus(low, everything), surplus(high, everything)
    found = np.exp(root_between(surplus, low, high, slow, fast))
    return np.where(slow > 0.0, 0.0, np.where(fast < 0.0, np.inf, found))
