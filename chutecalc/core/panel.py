"""A panel as two rules have solved it, the coarser for the start and for the error, and that error.

The error left has two parts. Newton leaves at most the square of its last update u times half the equation's second
derivative where that is largest. Collocation leaves u ρ^-(2M - N) at the end and u ρ^-(M - N) inside, for rules of N
and M nodes, with ρ the size of the largest ellipse around the panel (foci at its ends, sum of the half axes over half
the panel's length) in which the solution is smooth: u shows how far N nodes are off inside, ρ^-N; M nodes are off by
ρ^-M inside and by ρ^-2M at the end. What bounds the ellipse is the nearest rest, v = 0, seen from knots along the
chord: a stream that starts slowly has a thin layer that may hide between the nodes of both rules. A stream that decays
by e^-λ brings terms of its own, resolved like ρ = 4 √(N M)/(e λ). ``tests/robustness/test_edges.py`` holds the sum, and
what rounding adds, against a solver that shares nothing with this one.
"""

import math
from array import array

from chutecalc.core import floats, gauss, matrix, slide

# Of 19,270 random segments up to the edges and seven pairs of rules one panel is worse than with these it says, by 1.2:
# benchmarks/estimates.py.
SAFETY = 150.0
NEWTON_SAFETY = 1.0
ROOT_SAFETY = 1000.0  # next to rest a zero of the pull may lie between the start and the first node, unseen
ROUNDING = 1e-15  # of a panel, relative
CANCELLED = 4e-15  # of the forces that nearly cancel where a stream clings to a balance
PLACE_ROUNDING = 2e-15  # in a place along the segment, of its length: no update in r gets below it
SETTLED = 1e-7  # of the way: an update that leaves its square is the last
CHORD = 0.2  # of the distance to a zero of the pull that counts, where chords point too far

WHOLE, PLACE, CLINGING, ROOT = range(4)
"""Ways to a panel: in c the attempt at a whole stretch, which most need no more than, a panel of several, and one along
which a stream clings to a balance; and in r."""


class Angles:
    """Sine and cosine of the slope at a rule's nodes, for the panel that asked last: variants ask for the same."""

    def __init__(self) -> None:
        self.count = 0
        self.start = self.turn = 0.0
        """Slope at the panel's start, and what it turns by."""
        self.sine, self.cosine = floats.zeros(matrix.MOST), floats.zeros(matrix.MOST)


class Panel:
    """A solved panel, and room to work in."""

    def __init__(self) -> None:
        self.start = self.width = 0.0
        """Of the independent variable, c or r."""
        self.by_root = False
        self.facet = self.piece = 0
        """The branch of the friction law."""
        self.equation = gauss.Equation()
        self.coarse, self.guess, self.fine = gauss.Curve(), gauss.Curve(), gauss.Curve()
        """The unknown, y or c: by the coarser rule, that at the finer one's nodes, and by the finer."""
        self.knots, self.growth = self.fine.knots, self.fine.growth
        self.error = self.inner_error = self.rounding = 0.0
        """Estimated, of the end: relative in y, in r relative to the way; infinite where the panel is no solution.
        The same of the polynomial through the knots. What rounding may add to both."""
        self.sine, self.press, self.values = (floats.zeros(matrix.MOST) for _ in range(3))
        self.coarse_angles, self.angles = Angles(), Angles()
        self.left = 0.0
        self.stop = 1.0
        """Where the first iterate would have stopped the stream, with friction as at the panel's start, as a share of
        the width; 1 where it would not."""
        self.smooth = 1.0
        """ρ of the ellipse around the panel in which the solution is smooth."""


def estimate(
    panel: Panel,
    sound: bool,
    update: float,
    newton: float,
    smooth: float,
    rounding: float,
    pair: "gauss.Pair",
    kind: int,
) -> None:
    """The panel's errors.

    A solution that changes by e^-λ over the panel has terms that N nodes resolve like an ellipse of ρ = 4 N/(e λ).
    """
    coarse, fine = pair.coarse.count, pair.fine.count
    panel.smooth = smooth
    grown = math.fabs(panel.growth[fine])
    decay = math.fabs(math.log(grown)) if grown > 0.0 and grown < floats.INFINITY else floats.INFINITY
    if kind != CLINGING:  # where a stream clings to a balance, such terms have died out before
        resolved = floats.quotient(4.0 / math.e * math.sqrt(coarse * fine), decay)
        smooth = min(smooth, max(resolved, 1.0))
    inside = floats.INFINITY
    if sound and smooth >= 1.0:
        inside = update * smooth ** (coarse - fine) * (ROOT_SAFETY if kind == ROOT else SAFETY)
    panel.error = newton + (inside * smooth**-fine if inside < floats.INFINITY else floats.INFINITY)
    panel.inner_error = newton + 0.1 * inside
    panel.rounding = ROUNDING + rounding / max(decay, 1.0)


def smoothness_by_place(panel: Panel, way: "slide.Slide", rule: "gauss.Rule") -> float:
    """ρ of the largest ellipse that a panel in c leaves: up to rest, or to where a full circle would flow."""
    arc = way.facets.circle and panel.facet == 0
    for j in range(rule.last + 1):
        panel.values[j] = panel.knots[j]
        if arc:
            slide.draw(way, panel.start + panel.width * rule.knots[j])
            full = way.flow / (math.pi * way.facets.radius * way.facets.radius)
            panel.values[j] -= full * full
    smooth = smoothness(rule, panel.values, 1.0, True)
    if way.taper:
        smooth = min(smooth, taper_smoothness(panel, way, rule, True))
    return smooth


def smoothness_by_root(panel: Panel, way: "slide.Slide", rule: "gauss.Rule", first: float, place: float) -> float:
    """ρ that a panel in r leaves: up to a zero of the pull, and by what the section does."""
    r = panel.start
    panel.values[0] = floats.quotient(r * r * r, first)
    for j in range(rule.count):
        r = panel.start + panel.width * rule.knots[j + 1]
        panel.values[j + 1] = floats.quotient(r * r * r, panel.sine[j])
    smooth = smoothness(rule, panel.values, CHORD, False)
    slide.draw(way, place)
    smooth = min(smooth, flank_smoothness(panel, way))
    if way.taper:
        smooth = min(smooth, taper_smoothness(panel, way, rule, False))
    return smooth


def smoothness(rule: "gauss.Rule", values: "array[float]", share: float, to_end: bool) -> float:
    """ρ of the largest ellipse around the panel that is free of the zeros of what has these values at the knots.

    A chord from one knot to the next points to a zero. With the panel stretched to (-1, 1) an ellipse of half axis a
    has ρ = a + √(a² - 1). A zero beyond the panel's end is on the one with a = |x|; within the panel there is none on
    the real axis, and one as far off it, s, above the knot k has a² - 1 = (√(p² + 4 s²) - p)/2 with p = 1 - k² - s².
    Only a share of the distance counts where values bend so that a chord points too far.
    """
    nearest = floats.INFINITY
    for i in range(rule.chords - (1 if to_end else 2)):
        this, other = rule.chord[i], rule.chord[i + 1]
        k = 2.0 * rule.knots[this] - 1.0
        gap = (2.0 * rule.knots[other] - 1.0 - k) * share
        reach = floats.quotient(values[this], values[other] - values[this]) * gap
        beyond = (k - reach) * (k - reach) - 1.0
        flat = 1.0 - k * k - reach * reach
        room = 0.5 * (floats.root(4.0 * reach * reach + flat * flat) - flat)
        if beyond > room:
            room = beyond
        if not room >= nearest:
            nearest = room
        if nearest != nearest:
            return floats.NAN
    return floats.root(1.0 + nearest) + floats.root(nearest)


def taper_smoothness(panel: Panel, way: "slide.Slide", rule: "gauss.Rule", to_end: bool) -> float:
    """ρ that a taper leaves: where its numbers, drawn on, would leave the stream no width or a facet no rise.

    In a circle, where a full one would flow: there depth has a branch point.
    """
    facet, arc = panel.facet, way.facets.circle and panel.facet == 0
    count = rule.last + (1 if to_end else 0)
    for j in range(count):
        at, y = panel.start + panel.width * rule.knots[j], panel.knots[j]
        if panel.by_root:
            at, y = panel.knots[j], at * at * at * at
        slide.draw(way, at)
        if arc:
            panel.values[j], panel.press[j] = way.facets.radius, way.facets.radius * floats.root(floats.root(y))
            panel.press[j] -= math.sqrt(way.flow / math.pi)
        else:
            area, sine = slide.flow_area(way, y), way.facets.sine[facet]
            # Of the surface's width² over the area: a stream that grows thin is not taken for a section that ends.
            hollow = 1.0 - floats.quotient(way.facets.area[facet], area)
            slant = floats.quotient(4.0 * way.facets.cosine[facet], sine)
            panel.values[j] = floats.quotient(way.facets.width[facet] * way.facets.width[facet], area) + slant * hollow
            panel.press[j] = sine
    return min(smoothness(rule, panel.values, 1.0, to_end), smoothness(rule, panel.press, 1.0, to_end))


def flank_smoothness(panel: Panel, way: "slide.Slide") -> float:
    """ρ that the section leaves to a panel in r: sloping walls bring χ a branch point at r = i √(Q/A_apex).

    A_apex is what the facet's flanks, drawn down to where they meet, would add to the area. Branch points so near rest
    that less than rounding of the way lies between are left out. An arc has its own on the real axis, below the panel.
    """
    low, width = min(panel.start, panel.start + panel.width), math.fabs(panel.width)
    k = panel.facet
    if way.facets.circle and k == 0:
        below = (low - math.sqrt(way.flow / math.pi) / way.facets.radius) / width
        return 1.0 + math.sqrt(4.0 * max(below, 0.0))
    foot = way.facets.width[k] * way.facets.width[k]
    apex = floats.quotient(foot * way.facets.sine[k], 4.0 * way.facets.cosine[k]) - way.facets.area[k]
    branch = floats.root(floats.quotient(way.flow, apex))
    if branch > 1e-4 * width:
        return 1.0 + math.sqrt(2.0 * math.sqrt(low * low + branch * branch) / width)
    return floats.INFINITY
