"""Locate events inside a panel: event functions, known at the panel's knots, that fall below 0."""

from array import array

from chutecalc.core import floats, friction, gauss, guide_surface, longitudinal

CONTACT_LOSS, CHOKE, JUMP, FACET_UP, FACET_DOWN, PIECE_UP, PIECE_DOWN, SEGMENT_END = range(8)
"""Events; where two occur at once the first counts."""

EVENT_TOLERANCE = 1e-13
"""An event function within this of 0 is at its event; its rounding is a few 1e-16."""
DIFFERENCE_STEP = 1e-3
"""Share of a panel over which an event function is differenced near its minimum."""


def event_function(
    guide: "guide_surface.Guide", facet: int, piece: int, event: int, share: float, y: float, next_breakpoint: float
) -> float:
    """Return the value of an event function at a share and a y: 0 at the event, else of order 1."""
    if event == SEGMENT_END:
        return next_breakpoint - share
    if event == CONTACT_LOSS:
        return guide_surface.normal_acceleration(guide, share, y) / guide.gravity
    if event == CHOKE:
        return relative_excess(floats.root(y) * guide_surface.choke_area(guide, share), guide.flow)
    if event == JUMP:
        return longitudinal.bracket(guide, facet, share, y)
    if event == FACET_UP:
        if facet + 1 >= guide.facets.count:
            return 1.0
        guide_surface.set_section(guide, share)
        return relative_excess(floats.root(y) * guide.facets.area[facet + 1], guide.flow)
    if event == FACET_DOWN:
        guide_surface.set_section(guide, share)
        return 1.0 - floats.root(y) * guide.facets.area[facet] / guide.flow
    stress = friction.wall_stress(guide, facet, share, y)
    press = guide_surface.normal_acceleration(guide, share, y) / guide.gravity
    if event == PIECE_UP:
        return above(guide.starts[piece + 1], stress, press) if piece + 1 < guide.pieces else 1.0
    return -above(guide.starts[piece], stress, press) if guide.starts[piece] > 0.0 else 1.0


def above(start: float, stress: float, press: float) -> float:
    """Return how far the start of a piece lies above a stress, as a share of it and of the stress under weight alone.

    Where hardly anything presses the stream on its surface, its stress is a small difference of large numbers. A share
    of the stress itself would be rounding there. ``press`` is what presses it, over gravity.
    """
    if start == floats.INFINITY:
        return 1.0
    if stress == floats.INFINITY:
        return -press
    return (start - stress) / (start + (stress / press if press != 0.0 else 0.0))


def relative_excess(value: float, limit: float) -> float:
    """Return value over limit less 1; 1 where the value is infinite."""
    return value / limit - 1.0 if value < floats.INFINITY else 1.0


def first_crossing(rule: "gauss.Rule", event_values: "array[float]") -> float:
    """Return the first point in (0, 1) where event values fall below 0, or where to cut to find out whether they do.

    Infinite where they stay positive; 0 where they start at 0 and fall at once. Values that dip towards 0 between two
    knots give the bottom of the dip: cut there, both parts are monotone and no root hides between knots.
    """
    for k in range(1, rule.last + 1):
        if event_values[k] < -EVENT_TOLERANCE:
            if k == 1 and event_values[0] <= EVENT_TOLERANCE:
                return 0.0
            return gauss.find_value(rule, event_values, 0, 0.0, rule.knots[k - 1], rule.knots[k])
    return near_minimum(rule, event_values)


def near_minimum(rule: "gauss.Rule", event_values: "array[float]") -> float:
    """Return the bottom of an inner minimum near 0, refined from the parabola through the lowest three knots.

    Where values have been at 0 up to there, as they are at their beginning, they may fall by a rounding: that is none.
    """
    low = 1
    for k in range(2, rule.last):
        if event_values[k] < event_values[low]:
            low = k
    left = (event_values[low] - event_values[low - 1]) / (rule.knots[low] - rule.knots[low - 1])
    right = (event_values[low + 1] - event_values[low]) / (rule.knots[low + 1] - rule.knots[low])
    if not (left < 0.0 and right > 0.0) or event_values[low - 1] <= EVENT_TOLERANCE:
        return floats.INFINITY
    start, end = rule.knots[low - 1], rule.knots[low + 1]
    bend = (right - left) / (end - start)
    vertex = 0.5 * (start + rule.knots[low]) - 0.5 * left / bend
    bottom = event_values[low] - bend * (rule.knots[low] - vertex) * (rule.knots[low] - vertex)
    near = bottom < 0.2 * (max(event_values[low - 1], event_values[low + 1]) - event_values[low])
    if not near or vertex <= rule.knots[1] or vertex >= rule.knots[rule.last - 1]:
        return floats.INFINITY
    for _ in range(3):  # Newton's method with differences
        before = gauss.evaluate(rule, event_values, 0, vertex - DIFFERENCE_STEP)
        here = gauss.evaluate(rule, event_values, 0, vertex)
        after = gauss.evaluate(rule, event_values, 0, vertex + DIFFERENCE_STEP)
        bend = after - 2.0 * here + before
        if bend > 0.0:
            vertex = min(max(vertex + 0.5 * DIFFERENCE_STEP * (before - after) / bend, start), end)
    return vertex
