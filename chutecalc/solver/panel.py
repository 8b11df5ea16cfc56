"""One panel solved on two rules, the coarser for the start and for the error.

The error left has two parts. Newton leaves the square of its last update u. Collocation leaves u ρ^-(2M - N) at the
end and u ρ^-(M - N) inside, for rules of N and M nodes, with ρ the size of the largest ellipse around the panel (foci
at its ends, sum of the half axes over half the panel's length) in which the solution is smooth: u shows how far N
nodes are off inside, ρ^-N; M nodes are off by ρ^-M inside and by ρ^-2M at the end. What bounds the ellipse is the
nearest rest, v = 0, seen from each pair of knots along the chord: a stream that starts slowly has a thin layer that
may hide between the nodes of both rules. A stream that decays by e^-λ brings
terms of its own, resolved like ρ = 4 √(N M)/(e λ). ``tests/robustness/test_edges.py`` holds the sum, and what rounding
adds, against a solver that shares nothing with this one.
"""

from functools import cache
from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Mask
from chutecalc.solver.collocation import Rule, newton, rule, stiff_newton, transfer
from chutecalc.solver.slide import Course, field, frozen_rates, place_rates, rates

SAFETY = 30.0
NEWTON_SAFETY = 3.0
ROOT_SAFETY = 1000.0  # next to rest a zero of the pull may lie between the start and the first node, unseen
ROUNDING = 1e-15  # of a panel, relative
PLACE_ROUNDING = 2e-15  # in a place along the segment, of its length: no update in r gets below it

WHOLE, PLACE, CLINGING, ROOT = range(4)
"""Ways to a panel: in c the attempt at a whole stretch, which most need no more than, a panel of several, and one along
which a stream clings to a balance; and in r."""
WAYS = {WHOLE: (newton, 1, 1), PLACE: (newton, 2, 2), CLINGING: (stiff_newton, 4, 1)}
"""The step of each in c, and how often it is taken on the coarse rule and on the fine one."""


class Panel(NamedTuple):
    """A solved panel of m designs."""

    knots: Array
    """The unknown at the rule's start, nodes and end, shape (N + 2, m)."""
    growth: Array
    """∂(end)/∂(start)."""
    error: Array
    """Estimated, of the end: relative in y, in r relative to the way; infinite where the panel is no solution."""
    inner_error: Array
    """The same of the polynomial through the knots."""
    rounding: Array
    """What rounding may add to both."""


def panel_by_place(course: Course, start: Array, width: Array, y0: Array, pair: tuple[int, int], way: int) -> Panel:
    """Solves y = v² over a panel in c, in one of three ways: ``WHOLE``, ``PLACE`` or ``CLINGING``."""
    step, iterations, refinements = WAYS[way]
    coarse, fine = rule(pair[0]), rule(pair[1])
    at = field(course, start + width * coarse.nodes[:, None], width)
    first = y0 / at.unit
    y = np.repeat(first[None], pair[0], axis=0)
    # From a balance that clings, freezing friction leads far astray; towards one the linearised equation leads well.
    ends, _ = step(coarse, *(rates(at, y) if way == CLINGING else frozen_rates(at, first, y)), y, first)
    for _ in range(iterations):
        y = ends[:-1]
        ends, coarse_growth = step(coarse, *rates(at, y), y, first)
    last = ends[-1]
    guess = transfer(*pair) @ np.concatenate([first[None], ends])
    at = field(course, start + width * fine.nodes[:, None], width)
    updates = []
    for _ in range(refinements):
        ends, growth = step(fine, *rates(at, guess), guess, first)
        guess -= ends[:-1]
        guess /= ends[:-1]
        last_gap = np.maximum(ends[-2] / ends[-1], 1.0)  # what is small at the last node may not be so at a slow end
        updates.append(np.maximum.reduce(np.abs(guess, out=guess)) * last_gap)
        guess = ends[:-1].copy()
    knots = np.concatenate([y0[None], ends * at.unit])
    sound = np.minimum.reduce(ends) > 0.0
    lifted = knots - _arc_velocity(course, start) ** 2 if course.arcs else knots
    smoothness = _smoothness(fine, lifted, 0.4)
    panel = _panel(knots, growth[-1], sound, updates, smoothness, ROUNDING / ends[-1], pair, way)
    if way != CLINGING:
        return panel
    # Gauss collocation keeps an offset from the balance that decays too fast to be seen, each rule its own share of it.
    kept = np.abs(last / ends[-1] - 1.0) * np.minimum(np.abs(growth[-1] / coarse_growth[-1]), 1.0)
    return panel._replace(error=panel.error + kept)


def panel_by_root(course: Course, start: Array, width: Array, place: Array, pair: tuple[int, int]) -> Panel:
    """Solves c over a panel in r = √v, from a place. Only where v rises or falls throughout."""
    coarse, fine = rule(pair[0]), rule(pair[1])
    root = start + width * coarse.nodes[:, None]
    first, _ = place_rates(course, start, width, place)
    c = place + first / (4.0 * width * start**3) * (root**4 - start**4)
    for _ in range(4):
        ends, _ = newton(coarse, *place_rates(course, root, width, c), c, place)
        c = ends[:-1]
    guess = transfer(*pair) @ np.concatenate([place[None], ends])
    root = start + width * fine.nodes[:, None]
    change, change_growth = place_rates(course, root, width, guess)
    ends, growth = newton(fine, change, change_growth, guess, place)
    # Where v turns inside, r is no measure of the way; and far beyond the segment there is nothing to solve for.
    within = (np.minimum.reduce(ends) >= place) & (np.maximum.reduce(ends) < 2.0)
    sound = (np.minimum.reduce(change) > 0.0) & within
    noise = np.maximum.reduce(np.abs(ends[:-1] - guess)) - PLACE_ROUNDING
    update = np.maximum(noise, 0.0) / np.maximum(np.abs(ends[-1] - place), PLACE_ROUNDING)
    pull = np.concatenate([start[None], root]) ** 3 / np.concatenate([first[None], change])
    smoothness = np.minimum(_smoothness(fine, pull, 0.2), _flank_smoothness(course, start, width, place))
    return _panel(np.concatenate([place[None], ends]), growth[-1], sound, [update], smoothness, 0.0, pair, ROOT)


def _smoothness(own: Rule, values: Array, share: float) -> Array:
    """ρ of the largest ellipse around the panel that is free of the zeros of what has these values at its knots.

    A chord from one knot to the next points to a zero. Beyond the panel's ends, at x on (-1, 1) stretched to the
    panel, it leaves |x| + √(x² - 1). Within the panel there is none on the real axis; one as far off it, b, leaves 1 +
    η with η √(c (1 - c)) + η²/4 = b at the place c. As values bend, a chord may point too far: only a share of the way
    counts.
    """
    shape = _shape(len(own.nodes))
    gaps, bulge, low = (item[: len(values) - 1] for item in shape)
    beyond = values[:-1] / np.diff(values, axis=0)  # the chord's reach beyond its first knot, in gaps, and less than 0
    beyond *= gaps
    off = np.abs(beyond)
    off *= share
    off += bulge**2
    np.sqrt(off, out=off)
    off -= bulge
    off *= 2.0
    beyond -= low
    np.abs(beyond, out=beyond)
    beyond -= 0.5
    beyond *= 2.0 * share
    np.maximum(beyond, 0.0, out=beyond)
    stretched = beyond + 2.0
    stretched *= beyond
    np.sqrt(stretched, out=stretched)
    stretched += beyond
    np.maximum(stretched, off, out=stretched)
    smallest: Array = np.minimum.reduce(stretched)
    return 1.0 + smallest


@cache
def _shape(count: int) -> tuple[Array, Array, Array]:
    """Of the gaps between a rule's knots: width, √(c (1 - c)) at the end nearer to the panel's, and c - 1/2."""
    knots = rule(count).knots[:, None]
    bulge = np.sqrt(knots * (1.0 - knots))
    return np.diff(knots, axis=0), np.minimum(bulge[1:], bulge[:-1]), knots[:-1] - 0.5


def _arc_velocity(course: Course, place: Array) -> Array:
    """The velocity at which a full circle would flow, where depth on an arc has its branch point; 0 on flat facets."""
    radius = course.at(place).facet.radius
    velocity: Array = course.slide.flow / (np.pi * np.where(radius > 0.0, radius, np.inf) ** 2)
    return velocity


def _flank_smoothness(course: Course, start: Array, width: Array, place: Array) -> Array:
    """ρ that the section leaves to a panel in r: sloping walls bring χ a branch point at r = i √(Q/A_apex).

    A_apex is what the facet's flanks, drawn down to where they meet, would add to the area. Branch points so near rest
    that less than rounding of the way lies between are left out. An arc has its own on the real axis, below the panel.
    """
    slide, facet = course.slide, course.at(place).facet
    apex = facet.width**2 * facet.sine / (4.0 * facet.cosine) - facet.area
    branch = np.sqrt(slide.flow / apex)
    distance: Array = np.hypot(np.minimum(start, start + width), branch) / np.abs(width)
    below = (np.minimum(start, start + width) - np.sqrt(_arc_velocity(course, place))) / np.abs(width)
    distance = np.where(facet.radius > 0.0, 2.0 * np.maximum(below, 0.0), distance)
    return np.where((branch > 1e-4 * np.abs(width)) | (facet.radius > 0.0), 1.0 + np.sqrt(2.0 * distance), np.inf)


def _panel(
    knots: Array,
    growth: Array,
    sound: Mask,
    updates: list[Array],
    smoothness: Array,
    rounding: Array | float,
    pair: tuple[int, int],
    way: int,
) -> Panel:
    """The panel with its errors.

    A solution that changes by e^-λ over the panel has terms that N nodes resolve like an ellipse of ρ = 4 N/(e λ).
    """
    coarse, fine = pair
    decay = np.abs(np.log(np.abs(growth)))
    if way != CLINGING:  # where a stream clings to a balance, such terms have died out before
        resolved = 4.0 / np.e * np.sqrt(coarse * fine) / decay
        smoothness = np.minimum(smoothness, np.maximum(resolved, 1.0))
    inside = updates[0] * smoothness ** (coarse - fine)
    end = inside * smoothness**-fine
    safety, newton_part = (ROOT_SAFETY if way == ROOT else SAFETY), NEWTON_SAFETY * updates[-1] ** 2
    return Panel(
        knots,
        growth,
        np.where(sound, newton_part + safety * end, np.inf),
        np.where(sound, newton_part + 0.1 * safety * inside, np.inf),
        ROUNDING + rounding / np.maximum(decay, 1.0),
    )
