"""One panel solved on two rules, the coarser for the start and for the error.

The error left has two parts. Newton leaves at most the square of its last update u times half the equation's second
derivative where that is largest. Collocation leaves u ρ^-(2M - N) at the end and u ρ^-(M - N) inside, for rules of N
and M nodes, with ρ the size of the largest ellipse around the panel (foci at its ends, sum of the half axes over half
the panel's length) in which the solution is smooth: u shows how far N nodes are off inside, ρ^-N; M nodes are off by
ρ^-M inside and by ρ^-2M at the end. What bounds the ellipse is the nearest rest, v = 0, seen from knots along the
chord: a stream that starts slowly has a thin layer that may hide between the nodes of both rules. A stream that decays
by e^-λ brings terms of its own, resolved like ρ = 4 √(N M)/(e λ). ``tests/robustness/test_edges.py`` holds the sum, and
what rounding adds, against a solver that shares nothing with this one.
"""

from functools import cache
from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Index, Mask, product
from chutecalc.solver.collocation import integrate, integrate_stiff, rule, transfer
from chutecalc.solver.slide import Course, Field, Linear, field, frozen, linearised, place_rates

# Of 20,488 random segments up to the edges and seven pairs of rules one panel is worse than with these it says, by 1.2:
# benchmarks/estimates.py.
SAFETY = 150.0
NEWTON_SAFETY = 1.0
ROOT_SAFETY = 1000.0  # next to rest a zero of the pull may lie between the start and the first node, unseen
ROUNDING = 1e-15  # of a panel, relative
CANCELLED = 4e-15  # of the forces that nearly cancel where a stream clings to a balance
PLACE_ROUNDING = 2e-15  # in a place along the segment, of its length: no update in r gets below it

WHOLE, PLACE, CLINGING, ROOT = range(4)
"""Ways to a panel: in c the attempt at a whole stretch, which most need no more than, a panel of several, and one along
which a stream clings to a balance; and in r."""
WAYS = {WHOLE: (integrate, 1, 1), PLACE: (integrate, 2, 2), CLINGING: (integrate_stiff, 3, 1)}
"""The step of each in c, and how often it is taken on the coarse rule and on the fine one."""


class Panel(NamedTuple):
    """A solved panel of m designs."""

    knots: Array
    """The unknown at the rule's start, nodes and end, shape (N + 2, m)."""
    growth: Array
    """What a small change at the start has become at nodes and end, shape (N + 1, m)."""
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
    # From a balance that clings, freezing friction leads far astray; towards one the linearised equation leads well.
    near = linearised(at, np.repeat(first[None], pair[0], axis=0)) if way == CLINGING else frozen(at, first)
    knots, _ = step(coarse, near.forcing, near.growth, first)
    for _ in range(iterations):
        near = linearised(at, knots[1:-1])
        knots, coarse_growth = step(coarse, near.forcing, near.growth, first)
    last = knots[-1]
    guess = product(transfer(*pair), knots)
    at = field(course, start + width * fine.nodes[:, None], width)
    updates = []
    for _ in range(refinements):
        near = linearised(at, guess)
        knots, growth = step(fine, near.forcing, near.growth, first)
        inner, end = knots[1:-1], knots[-1]
        guess /= inner
        guess -= 1.0
        np.abs(guess, out=guess)
        last_gap = np.maximum(inner[-1] / end, 1.0)  # what is small at the last node may not be so at a slow end
        updates.append(np.maximum.reduce(guess) * last_gap)
        guess = inner
    sound = (updates[-1] < 1.0) & (end > 0.0)  # then it is positive all along, as what it was worked out from
    scaled = knots * at.unit
    scaled[0] = y0
    places = start + width * fine.knots[:, None]
    smoothness = _smoothness(pair[1], scaled - _arc_velocity(course, places) ** 2 if course.arcs else knots, 1.0)
    if course.slide.end_section is not None:
        smoothness = np.minimum(smoothness, _taper_smoothness(pair[1], course, places, scaled))
    newton = NEWTON_SAFETY * updates[-1] ** 2 * _left(course, at, near)
    panel = _panel(scaled, growth, sound, updates[0], newton, smoothness, ROUNDING / end, pair, way)
    if way != CLINGING:
        return panel
    # Gauss collocation keeps an offset from the balance that decays too fast to be seen, each rule its own share of it.
    kept = np.abs(last / end - 1.0) * np.minimum(np.abs(growth[-1] / coarse_growth[-1]), 1.0)
    # Slope and friction nearly cancel: their rounding moves the balance the more, the less friction depends on v.
    noise = CANCELLED / np.abs(near.growth[-1] * inner[-1])
    kept = np.maximum(kept - noise, 0.0)
    return panel._replace(error=panel.error + kept, rounding=panel.rounding + noise)


def _left(course: Course, at: Field, near: Linear) -> Array:
    """What Newton leaves of an update of 1, relative: half of Y ∂²f/∂Y² where that is largest.

    That is at most A χ'/Y times 3/8 of the load from gravity and 1/4 of that from the bend; on a crest and under a hood
    the two may cancel in f, which is why there (1 + χ) b less b, χ b, is added.
    """
    weight = np.abs(near.bending)
    if near.held is not None:
        weight += 2.0 * np.abs(near.held)
    opposed = course.slide.turn > 0.0
    if opposed.any():
        weight += np.where(opposed, 2.0 * (np.abs(near.bending - near.growth) - np.abs(at.bend)), 0.0)
    left: Array = np.maximum.reduce(weight)
    return left


def panel_by_root(course: Course, start: Array, width: Array, place: Array, pair: tuple[int, int]) -> Panel:
    """Solves c over a panel in r = √v, from a place. Only where v rises or falls throughout."""
    coarse, fine = rule(pair[0]), rule(pair[1])
    root = start + width * coarse.nodes[:, None]
    first, _ = place_rates(course, start, width, place)
    c = place + first / (4.0 * width * start**3) * (root**4 - start**4)
    for _ in range(4):
        change, growth = place_rates(course, root, width, c)
        knots, _ = integrate(coarse, change - growth * c, growth, place)
        c = knots[1:-1]
    guess = product(transfer(*pair), knots)
    root = start + width * fine.nodes[:, None]
    change, growth = place_rates(course, root, width, guess)
    knots, growth = integrate(fine, change - growth * guess, growth, place)
    # Where v turns inside, r is no measure of the way; and far beyond the segment there is nothing to solve for.
    within = (np.minimum.reduce(knots) >= place) & (np.maximum.reduce(knots) < 2.0)
    sound = (np.minimum.reduce(change) > 0.0) & within
    noise = np.maximum.reduce(np.abs(knots[1:-1] - guess)) - PLACE_ROUNDING
    update = np.maximum(noise, 0.0) / np.maximum(np.abs(knots[-1] - place), PLACE_ROUNDING)
    pull = np.concatenate([start[None], root]) ** 3 / np.concatenate([first[None], change])
    smoothness = np.minimum(_smoothness(pair[1], pull, 0.2), _flank_smoothness(course, start, width, place))
    if course.slide.end_section is not None:
        y = np.concatenate([start[None], root]) ** 4
        smoothness = np.minimum(smoothness, _taper_smoothness(pair[1], course, knots[:-1], y))
    return _panel(knots, growth, sound, update, NEWTON_SAFETY * update**2, smoothness, 0.0, pair, ROOT)


def _smoothness(count: int, values: Array, share: float) -> Array:
    """ρ of the largest ellipse around the panel that is free of the zeros of what has these values at a rule's knots.

    The end may be left out.

    A chord from one knot to the next points to a zero. With the panel stretched to (-1, 1) an ellipse of half axis a
    has ρ = a + √(a² - 1). A zero beyond the panel's end is on the one with a = |x|; within the panel there is none on
    the real axis, and one as far off it, s, above the knot k has a² - 1 = (√(p² + 4 s²) - p)/2 with p = 1 - k² - s².
    Only a share of the distance counts where values bend so that a chord points too far.
    """
    chosen, places, gaps, room = _chords(count, share, len(values) == count + 2)
    values = values.take(chosen, axis=0)
    reach = values[:-1] / (values[1:] - values[:-1])
    reach *= gaps
    beyond = places - reach
    beyond *= beyond
    beyond -= 1.0
    reach *= reach
    flat = room - reach
    reach *= 4.0
    reach += flat * flat
    np.sqrt(reach, out=reach)
    reach -= flat
    reach *= 0.5
    np.maximum(reach, beyond, out=reach)
    nearest: Array = np.minimum.reduce(reach)
    return np.sqrt(1.0 + nearest) + np.sqrt(nearest)


@cache
def _chords(count: int, share: float, to_end: bool) -> tuple[Index, Array, Array, Array]:
    """Between which of a rule's knots chords are laid; where they start on (-1, 1), k; a share of their width; 1 - k².

    Every second knot will do, and at the ends, where layers hide, each.
    """
    half = [0, 1, *range(3, count // 2 + 1, 2)]
    numbers = sorted({*half, *(count + 1 - number for number in half)})  # np.unique loads numpy.ma, 20 ms
    chosen = np.array(numbers if to_end else numbers[:-1])
    places = 2.0 * rule(count).knots[chosen][:, None] - 1.0
    return chosen, places[:-1], np.diff(places, axis=0) * share, 1.0 - places[:-1] ** 2


def _arc_velocity(course: Course, place: Array) -> Array:
    """The velocity at which a full circle would flow, where depth on an arc has its branch point; 0 on flat facets."""
    radius = course.at(place).facet.radius
    velocity: Array = course.slide.flow / (np.pi * np.where(radius > 0.0, radius, np.inf) ** 2)
    return velocity


def _taper_smoothness(count: int, course: Course, place: Array, y: Array) -> Array:
    """ρ that a taper leaves: where its numbers, drawn on, would leave the stream no width or a facet no rise.

    Args:
        count: of the rule.
        course: the designs.
        place, y: at the rule's knots, with or without the end.
    """
    facet, area = course.at(place).facet, course.slide.area(y)
    # Of the surface's width² over the area: a stream that grows thin is not taken for a section that ends.
    opening = facet.width**2 / area + 4.0 * facet.cosine / facet.sine * (1.0 - facet.area / area)
    arc = facet.radius > 0.0
    full = facet.radius * np.sqrt(np.sqrt(y)) - np.sqrt(course.slide.flow / np.pi)  # 0 where a full circle would flow
    tapering = (np.where(arc, facet.radius, opening), np.where(arc, full, facet.sine))
    return np.minimum(*(_smoothness(count, np.broadcast_to(values, y.shape), 1.0) for values in tapering))


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
    update: Array,
    newton: Array,
    smoothness: Array,
    rounding: Array | float,
    pair: tuple[int, int],
    way: int,
) -> Panel:
    """The panel with its errors.

    A solution that changes by e^-λ over the panel has terms that N nodes resolve like an ellipse of ρ = 4 N/(e λ).
    """
    coarse, fine = pair
    decay = np.abs(np.log(np.abs(growth[-1])))
    if way != CLINGING:  # where a stream clings to a balance, such terms have died out before
        resolved = 4.0 / np.e * np.sqrt(coarse * fine) / decay
        smoothness = np.minimum(smoothness, np.maximum(resolved, 1.0))
    inside = np.where(sound, update, np.inf) * smoothness ** (coarse - fine)
    inside *= ROOT_SAFETY if way == ROOT else SAFETY
    error = newton + inside * smoothness**-fine
    return Panel(knots, growth, error, newton + 0.1 * inside, ROUNDING + rounding / np.maximum(decay, 1.0))
