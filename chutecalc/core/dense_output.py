"""Evaluate the solution between the ends of its panels, at any share of the segment.

Panels are stored as by :class:`chutecalc.core.state.PanelStore`, those of a design one after the other.
"""

from typing import Any

from chutecalc.core import batch, floats, gauss, matrix, motion, state

SHARE_TOLERANCE = 1e-12
"""Shares are products of other shares, so their last digits are not the panels'."""
MAX_GROWTH = 3.0
"""Ratio of v² over which a panel's nodes resolve 1/v to rounding; a panel with more is divided."""


def velocities_squared(
    panels: Any, first: Any, count: Any, rules: dict[int, "gauss.Rule"], ends: Any, shares: Any, out: Any
) -> None:
    """Write y at shares; NaN where there is no stream.

    Args:
        panels: the stored panels.
        first, count: number of each design's first panel, and how many it has.
        rules: collocation rules by their number of nodes.
        ends: a row each of the share where each design begins, √y there, the share where it ends, and y there; the
            first counts where a stream gets no further than its start.
        shares: c, shape (shares, designs).
        out: v², likewise.
    """
    for design in range(len(first)):
        for row in range(len(shares)):
            out[row, design] = end_value(ends, design, shares[row, design])
        for number in range(first[design], first[design] + count[design]):
            at = state.PANEL_SIZE * number
            rule = rules[int(panels[at + 1])]
            for row in range(len(shares)):
                if out[row, design] != out[row, design]:
                    theta = locate(rule, panels, at, shares[row, design])
                    if theta == theta:
                        out[row, design] = panel_value(rule, panels, at, theta)


def end_value(ends: Any, design: int, share: float) -> float:
    """Return v² at either end of the travelled part; NaN between them."""
    if share == ends[0, design]:
        return float(ends[1, design] * ends[1, design])
    return float(ends[3, design]) if share == ends[2, design] else floats.NAN


def locate(rule: "gauss.Rule", panels: Any, at: int, share: float) -> float:
    """Return the position of a share in a panel, in the panel's own variable from 0 to 1; NaN outside it."""
    low, high = panels[at + 4], panels[at + 5]
    if panels[at] > 0.0:
        low, high = panels[at + 6], panels[at + 6 + rule.last]
    linear = floats.quotient(share - low, high - low)
    if not (linear >= -SHARE_TOLERANCE and linear <= 1.0 + SHARE_TOLERANCE):
        return floats.NAN
    if panels[at] > 0.0:
        return gauss.find_value(rule, panels, at + 6, min(max(share, low), high), 0.0, 1.0)
    return min(max(linear, 0.0), 1.0)


def panel_value(rule: "gauss.Rule", panels: Any, at: int, theta: float) -> float:
    """Return v² at a position from 0 to 1 in the panel."""
    if panels[at] > 0.0:
        r = panels[at + 4] + theta * (panels[at + 5] - panels[at + 4])
        return float(r * r * r * r)
    return gauss.evaluate(rule, panels, at + 6, theta)


def times(
    stream: "state.Stream",
    numbers: Any,
    start: int,
    surfaces: Any,
    panels: Any,
    first: Any,
    count: Any,
    rules: dict[int, "gauss.Rule"],
    shares: Any,
    out: Any,
) -> None:
    """Write the time since contact began, s.

    Args:
        stream, numbers: as the panels were solved with, see :func:`chutecalc.core.batch.solve_rows`.
        start: offset of the segment's wall in a row.
        surfaces: entry slope, turn, length and side of the surface, a row for each design.
        panels, first, count, rules, shares, out: as in :func:`velocities_squared`.
    """
    for design in range(len(first)):
        batch.restore_guide(stream.guide, numbers, design, start, surfaces[design])
        elapsed = 0.0
        for number in range(first[design], first[design] + count[design]):
            at = state.PANEL_SIZE * number
            rule = rules[int(panels[at + 1])]
            begin, width = 0.0, 1.0
            while begin < 1.0:
                width = min(width, 1.0 - begin)
                if write_part(stream, rule, panels, at, begin, width):
                    width *= 0.5
                    continue
                integrate_time(stream, rule, panels, at, width, elapsed)
                for row in range(len(shares)):
                    theta = locate(rule, panels, at, shares[row, design])
                    if theta >= begin and theta <= begin + width:
                        out[row, design] = gauss.evaluate(rule, stream.event_values, 0, (theta - begin) / width)
                elapsed = stream.event_values[rule.last]
                begin += width
                width *= 2.0


def write_part(stream: "state.Stream", rule: "gauss.Rule", panels: Any, at: int, begin: float, width: float) -> bool:
    """Write v² at the knots of part of a panel to ``work``; return whether it grows too much for one part.

    A panel in r has 1/v as smooth as itself, and gets r and c.
    """
    least, most = floats.INFINITY, 0.0
    for k in range(rule.last + 1):
        theta = begin + width * rule.knots[k]
        y = gauss.evaluate(rule, panels, at + 6, theta)
        stream.work[k] = y
        if panels[at] > 0.0:
            stream.panel.work[k] = panels[at + 4] + theta * (panels[at + 5] - panels[at + 4])
        least, most = min(least, y), max(most, y)
    return not panels[at] > 0.0 and most > MAX_GROWTH * least and width * (panels[at + 5] - panels[at + 4]) > 1e-15


def integrate_time(
    stream: "state.Stream", rule: "gauss.Rule", panels: Any, at: int, width: float, elapsed: float
) -> None:
    """Write the time at the knots of that part to ``event_values``: the integral of ds/v over c, or over r."""
    width *= panels[at + 5] - panels[at + 4]
    length = stream.guide.length * stream.guide.momentum_root  # ds/v is √α_m ds/√y
    for j in range(rule.count):
        if panels[at] > 0.0:
            r = stream.panel.work[j + 1]
            rate, _, _, _ = motion.rhs_in_r(
                stream.guide, int(panels[at + 2]), int(panels[at + 3]), r, width, stream.work[j + 1]
            )
            stream.panel.equation.forcing[j] = length * rate / (r * r)
        else:
            stream.panel.equation.forcing[j] = length * width / floats.root(stream.work[j + 1])
    matrix.multiply(rule.integral, stream.panel.equation.forcing, stream.panel.wall_drag, 0)
    stream.event_values[0] = elapsed
    for k in range(rule.last):
        stream.event_values[k + 1] = elapsed + stream.panel.wall_drag[k]


def knot_shares(panels: Any, first: Any, count: Any, rules: dict[int, "gauss.Rule"], out: Any) -> None:
    """Write the shares of the panels' knots after their starts, design by design; missing entries stay as they are."""
    for design in range(len(first)):
        row = 0
        for number in range(first[design], first[design] + count[design]):
            at = state.PANEL_SIZE * number
            rule = rules[int(panels[at + 1])]
            for k in range(1, rule.last + 1):
                if panels[at] > 0.0:
                    out[row, design] = panels[at + 6 + k]
                else:
                    out[row, design] = panels[at + 4] + rule.knots[k] * (panels[at + 5] - panels[at + 4])
                row += 1
