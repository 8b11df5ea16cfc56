"""The stream between the ends of its panels: what their polynomials say at any place of the segment.

Panels stand as :class:`chutecalc.core.state.Stream` keeps them, those of a design one after the other.
"""

from typing import Any

from chutecalc.core import batch, floats, friction, gauss, matrix, state

SLACK = 1e-12
"""Places are products of shares: their last digits are not the panels'."""
STEEP = 3.0
"""Across how much growth of v² a panel's nodes resolve 1/v to rounding; more of it is divided."""


def velocities(
    kept: Any, first: Any, count: Any, rules: dict[int, "gauss.Rule"], ends: Any, places: Any, out: Any
) -> None:
    """v² at places; not a number where no stream is.

    Args:
        kept: the panels.
        first, count: the number of each design's first panel, and how many it has.
        rules: by their number of nodes.
        ends: rows of where each way begins, the velocity there, where it ends, and v² there; of a stream that gets no
            further than where it begins the first counts.
        places: c, a row each for so many places of all designs.
        out: likewise.
    """
    for design in range(len(first)):
        for row in range(len(places)):
            out[row, design] = at_ends(ends, design, places[row, design])
        for number in range(first[design], first[design] + count[design]):
            here = state.KEPT * number
            rule = rules[int(kept[here + 1])]
            for row in range(len(places)):
                if out[row, design] != out[row, design]:
                    share = locate(rule, kept, here, places[row, design])
                    if share == share:
                        out[row, design] = squared(rule, kept, here, share)


def at_ends(ends: Any, design: int, place: float) -> float:
    """v² at an end of the way; not a number between them."""
    if place == ends[0, design]:
        return float(ends[1, design] * ends[1, design])
    return float(ends[3, design]) if place == ends[2, design] else floats.NAN


def locate(rule: "gauss.Rule", kept: Any, at: int, place: float) -> float:
    """Where in a panel's own variable a place lies, as a share of its width; not a number outside it."""
    low, high = kept[at + 4], kept[at + 5]
    if kept[at] > 0.0:
        low, high = kept[at + 6], kept[at + 6 + rule.last]
    linear = floats.quotient(place - low, high - low)
    if not (linear >= -SLACK and linear <= 1.0 + SLACK):
        return floats.NAN
    if kept[at] > 0.0:
        return gauss.solve(rule, kept, at + 6, min(max(place, low), high), 0.0, 1.0)
    return min(max(linear, 0.0), 1.0)


def squared(rule: "gauss.Rule", kept: Any, at: int, share: float) -> float:
    """v² at a share of a panel's width."""
    if kept[at] > 0.0:
        r = kept[at + 4] + share * (kept[at + 5] - kept[at + 4])
        return float(r * r * r * r)
    return gauss.evaluate(rule, kept, at + 6, share)


def times(
    stream: "state.Stream",
    numbers: Any,
    start: int,
    surfaces: Any,
    kept: Any,
    first: Any,
    count: Any,
    rules: dict[int, "gauss.Rule"],
    places: Any,
    out: Any,
) -> None:
    """Seconds since the contact began, arguments as of :func:`velocities`.

    Args:
        stream, numbers: as the panels were solved with, see :func:`chutecalc.core.batch.solve_rows`.
        start: where in a row the segment's wall begins.
        surfaces: a row each: the segment's entry slope, turn and length.
        kept, first, count, rules, places, out: as there.
    """
    for design in range(len(first)):
        batch.put_back(
            stream.way, numbers, design, start, surfaces[design, 0], surfaces[design, 1], surfaces[design, 2]
        )
        elapsed = 0.0
        for number in range(first[design], first[design] + count[design]):
            at = state.KEPT * number
            rule = rules[int(kept[at + 1])]
            begin, width = 0.0, 1.0
            while begin < 1.0:
                width = min(width, 1.0 - begin)
                if part_is_steep(stream, rule, kept, at, begin, width):
                    width *= 0.5
                    continue
                clock(stream, rule, kept, at, width, elapsed)
                for row in range(len(places)):
                    share = locate(rule, kept, at, places[row, design])
                    if share >= begin and share <= begin + width:
                        out[row, design] = gauss.evaluate(rule, stream.margins, 0, (share - begin) / width)
                elapsed = stream.margins[rule.last]
                begin += width
                width *= 2.0


def part_is_steep(stream: "state.Stream", rule: "gauss.Rule", kept: Any, at: int, begin: float, width: float) -> bool:
    """Writes v² at the knots of a part of a panel into ``values``; whether it grows too much for one part.

    A panel in r has 1/v as smooth as itself, and writes r and c.
    """
    least, most = floats.INFINITY, 0.0
    for k in range(rule.last + 1):
        share = begin + width * rule.knots[k]
        y = gauss.evaluate(rule, kept, at + 6, share)
        stream.values[k] = y
        if kept[at] > 0.0:
            stream.panel.values[k] = kept[at + 4] + share * (kept[at + 5] - kept[at + 4])
        least, most = min(least, y), max(most, y)
    return not kept[at] > 0.0 and most > STEEP * least and width * (kept[at + 5] - kept[at + 4]) > 1e-15


def clock(stream: "state.Stream", rule: "gauss.Rule", kept: Any, at: int, width: float, elapsed: float) -> None:
    """Writes the time at the knots of that part into ``margins``: the integral of ds/v over c, or over r."""
    width *= kept[at + 5] - kept[at + 4]
    for j in range(rule.count):
        if kept[at] > 0.0:
            r = stream.panel.values[j + 1]
            rate, _, _ = friction.place_rate(
                stream.way, int(kept[at + 2]), int(kept[at + 3]), r, width, stream.values[j + 1]
            )
            stream.panel.equation.forcing[j] = stream.way.length * rate / (r * r)
        else:
            stream.panel.equation.forcing[j] = stream.way.length * width / floats.root(stream.values[j + 1])
    matrix.multiply(rule.integral, stream.panel.equation.forcing, stream.panel.press, 0)
    stream.margins[0] = elapsed
    for k in range(rule.last):
        stream.margins[k + 1] = elapsed + stream.panel.press[k]


def knot_places(kept: Any, first: Any, count: Any, rules: dict[int, "gauss.Rule"], out: Any) -> None:
    """The places of the panels' knots after their starts, design by design; what a design has too few of is left."""
    for design in range(len(first)):
        row = 0
        for number in range(first[design], first[design] + count[design]):
            at = state.KEPT * number
            rule = rules[int(kept[at + 1])]
            for k in range(1, rule.last + 1):
                if kept[at] > 0.0:
                    out[row, design] = kept[at + 6 + k]
                else:
                    out[row, design] = kept[at + 4] + rule.knots[k] * (kept[at + 5] - kept[at + 4])
                row += 1
