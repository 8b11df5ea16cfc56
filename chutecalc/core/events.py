"""Where something happens to a stream inside a panel: a margin, known at the panel's knots, falls below zero."""

from array import array

from chutecalc.core import floats, friction, gauss, slide

CONTACT, CHOKE, DEEPER, SHALLOWER, FIRMER, LOOSER, END = range(7)
"""What can happen; of two at once the first counts."""

LEVEL = 1e-13
"""A margin within this of 0 is at its event: rounding in it is a few 1e-16."""
ASIDE = 1e-3
"""Of a panel: over which a margin's slope and bend are taken near its lowest place."""


def margin(way: "slide.Slide", facet: int, piece: int, event: int, place: float, y: float, limit: float) -> float:
    """How far an event is, 0 at it and else of order 1, at a place c and a v² there."""
    if event == END:
        return limit - place
    if event == CONTACT:
        return slide.normal(way, place, y) / way.gravity
    if event == CHOKE:
        return closeness(floats.root(y) * slide.choke_area(way, place), way.flow)
    if event == DEEPER:
        if facet + 1 >= way.facets.count:
            return 1.0
        slide.draw(way, place)
        return closeness(floats.root(y) * way.facets.area[facet + 1], way.flow)
    if event == SHALLOWER:
        slide.draw(way, place)
        return 1.0 - floats.root(y) * way.facets.area[facet] / way.flow
    stress = friction.stress(way, facet, place, y)
    press, pull = max(stress, 0.0), min(stress, 0.0)  # pull: beyond a loss of contact
    if event == FIRMER:
        if piece + 1 >= way.pieces:
            return 1.0
        return balance(way.starts[piece + 1], press) - floats.quotient(2.0 * pull, way.starts[piece + 1])
    least = way.starts[piece]
    return balance(press, least) + 2.0 * pull / least if least > 0.0 else 1.0


def balance(more: float, less: float) -> float:
    """(more - less)/(more + less), with its limits where one of the two is infinite."""
    if more == floats.INFINITY:
        return 1.0
    return -1.0 if less == floats.INFINITY else floats.quotient(more - less, more + less)


def closeness(value: float, limit: float) -> float:
    """Value over limit less 1; 1 where there is no limit to come near."""
    return value / limit - 1.0 if value < floats.INFINITY else 1.0


def first_crossing(rule: "gauss.Rule", margins: "array[float]") -> float:
    """The place in (0, 1) where margins first fall below zero, or should be cut to see whether they do.

    Infinite where they stay positive; 0 where they start at zero and go below at once. Margins that dip towards zero
    between two knots give the bottom of the dip: cut there, the two parts are monotone and nothing hides between knots.
    """
    for k in range(1, rule.last + 1):
        if margins[k] < -LEVEL:
            if k == 1 and margins[0] <= LEVEL:
                return 0.0
            return gauss.solve(rule, margins, 0, 0.0, rule.knots[k - 1], rule.knots[k])
    return dip(rule, margins)


def dip(rule: "gauss.Rule", margins: "array[float]") -> float:
    """The bottom of an inner minimum near zero: of the parabola through the lowest knot and its neighbours, refined."""
    low = 1
    for k in range(2, rule.last):
        if margins[k] < margins[low]:
            low = k
    left = (margins[low] - margins[low - 1]) / (rule.knots[low] - rule.knots[low - 1])
    right = (margins[low + 1] - margins[low]) / (rule.knots[low + 1] - rule.knots[low])
    if not (left < 0.0 and right > 0.0):
        return floats.INFINITY
    start, end = rule.knots[low - 1], rule.knots[low + 1]
    bend = (right - left) / (end - start)
    vertex = 0.5 * (start + rule.knots[low]) - 0.5 * left / bend
    bottom = margins[low] - bend * (rule.knots[low] - vertex) * (rule.knots[low] - vertex)
    near = bottom < 0.2 * (max(margins[low - 1], margins[low + 1]) - margins[low])
    if not near or vertex <= rule.knots[1] or vertex >= rule.knots[rule.last - 1]:
        return floats.INFINITY
    for _ in range(3):  # Newton's method with differences
        before = gauss.evaluate(rule, margins, 0, vertex - ASIDE)
        here = gauss.evaluate(rule, margins, 0, vertex)
        after = gauss.evaluate(rule, margins, 0, vertex + ASIDE)
        bend = after - 2.0 * here + before
        if bend > 0.0:
            vertex = min(max(vertex + 0.5 * ASIDE * (before - after) / bend, start), end)
    return vertex
