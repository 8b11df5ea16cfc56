"""Hold a panel solved by two collocation rules, and estimate its error.

The error left has two parts. Newton leaves at most the square of its last update u times half the equation's largest
second derivative. Collocation leaves u ρ^-(2M - N) at the end and u ρ^-(M - N) inside, for rules of N and M nodes,
where ρ is the size of the largest ellipse around the panel (foci at its ends, sum of the half axes over half the
panel's length) in which the solution is smooth, the Bernstein ellipse: u shows how far N nodes are off inside, ρ^-N; M
nodes are off by ρ^-M inside and by ρ^-2M at the end. The nearest rest, v = 0, bounds the ellipse; chords between knots
point to it, as a stream that starts slowly has a thin layer that may hide between the nodes of both rules. A stream
that decays by e^-λ brings terms of its own, resolved like ρ = 4 √(N M)/(e λ). ``tests/robustness/test_edges.py`` checks
the sum, and what rounding adds, against an independent solver.
"""

import math
from array import array

from chutecalc.core import floats, gauss, guide_surface, matrix

# Of 19,270 random segments up to the edges and seven pairs of rules one panel is worse than with these it says, by 1.2:
# benchmarks/estimates.py.
SAFETY = 150.0
NEWTON_SAFETY = 1.0
R_SAFETY = 1000.0  # next to rest a zero of dy/dc may hide between the start and the first node
ROUNDING = 1e-15  # of a panel, relative
CANCELLATION = 4e-15  # of the forces that nearly cancel at an equilibrium
SHARE_ROUNDING = 2e-15  # of a share: no update in r gets below it
CONVERGED = 1e-7  # relative: an update that leaves its square is the last
CHORD_FRACTION = 0.2  # of the distance to a zero of dy/dc, where chords point too far

FULL_SEGMENT, IN_SHARE, IN_SHARE_STIFF, IN_R = range(4)
"""Kinds of panel: in c over a whole segment, which suffices for most; in c as one of several; in c where the equation
is stiff near an equilibrium; in r."""


class Angles:
    """Cache of the sine and cosine of the slope at a rule's nodes for the last panel; variants often reuse it."""

    def __init__(self) -> None:
        self.count = 0
        self.start = self.turn = 0.0
        """Slope at the panel's start, and the angle that it turns by."""
        self.sine, self.cosine = floats.zeros(matrix.ROOM), floats.zeros(matrix.ROOM)


class Panel:
    """A solved panel, and work arrays."""

    def __init__(self) -> None:
        self.start = self.width = 0.0
        """Start and width in the independent variable, c or r."""
        self.in_r = False
        self.facet = self.piece = 0
        """Branch of the friction law."""
        self.equation = gauss.Equation()
        self.coarse, self.guess, self.fine = gauss.Iterate(), gauss.Iterate(), gauss.Iterate()
        """The unknown, y or c: by the coarse rule, interpolated to the fine rule's nodes, and by the fine rule."""
        self.solution, self.sensitivity = self.fine.solution, self.fine.sensitivity
        self.error = self.inner_error = self.rounding = 0.0
        """Estimated error of the end: relative in y, in r relative to the panel's length; infinite where there is no
        solution. Likewise of the polynomial through the knots; and what rounding may add to both."""
        self.sine, self.wall_drag, self.work = (floats.zeros(matrix.ROOM) for _ in range(3))
        self.coarse_angles, self.angles = Angles(), Angles()
        self.newton_factor = 0.0
        self.stop_share = 1.0
        """Share of the width at which the first iterate, with friction frozen at the start, stops the stream; 1 where
        it does not."""
        self.ellipse_rho = 1.0
        """ρ of the largest ellipse around the panel in which the solution is smooth."""


def estimate(
    panel: Panel,
    valid: bool,
    update: float,
    newton: float,
    rho: float,
    rounding: float,
    pair: "gauss.RulePair",
    kind: int,
) -> None:
    """Write the panel's error estimates.

    A solution that changes by e^-λ over the panel has terms that N nodes resolve like an ellipse of ρ = 4 N/(e λ).
    """
    coarse, fine = pair.coarse.count, pair.fine.count
    panel.ellipse_rho = rho
    end_sensitivity = math.fabs(panel.sensitivity[fine])
    decay = (
        math.fabs(math.log(end_sensitivity))
        if end_sensitivity > 0.0 and end_sensitivity < floats.INFINITY
        else floats.INFINITY
    )
    if kind != IN_SHARE_STIFF:  # near an equilibrium such terms have decayed before
        resolved = floats.quotient(4.0 / math.e * math.sqrt(coarse * fine), decay)
        rho = min(rho, max(resolved, 1.0))
    inside = floats.INFINITY
    if valid and rho >= 1.0:
        inside = update * rho ** (coarse - fine) * (R_SAFETY if kind == IN_R else SAFETY)
    panel.error = newton + (inside * rho**-fine if inside < floats.INFINITY else floats.INFINITY)
    panel.inner_error = newton + 0.1 * inside
    panel.rounding = ROUNDING + rounding / max(decay, 1.0)


def ellipse_rho_in_share(panel: Panel, guide: "guide_surface.Guide", rule: "gauss.Rule") -> float:
    """Return ρ of the largest ellipse around a panel in c: up to rest, or to where a full circle would flow."""
    arc = guide.facets.circle and panel.facet == 0
    for j in range(rule.last + 1):
        panel.work[j] = panel.solution[j]
        if arc:
            guide_surface.set_section(guide, panel.start + panel.width * rule.knots[j])
            full = guide.flow / (math.pi * guide.facets.radius * guide.facets.radius)
            panel.work[j] -= full * full
    rho = ellipse_rho(rule, panel.work, 1.0, True)
    if guide.taper:
        rho = min(rho, taper_ellipse_rho(panel, guide, rule, True))
    return rho


def ellipse_rho_in_r(
    panel: Panel, guide: "guide_surface.Guide", rule: "gauss.Rule", first: float, share: float
) -> float:
    """Return ρ of the largest ellipse around a panel in r: up to a zero of dy/dc, or as the section allows."""
    r = panel.start
    panel.work[0] = floats.quotient(r * r * r, first)
    for j in range(rule.count):
        r = panel.start + panel.width * rule.knots[j + 1]
        panel.work[j + 1] = floats.quotient(r * r * r, panel.sine[j])
    rho = ellipse_rho(rule, panel.work, CHORD_FRACTION, False)
    guide_surface.set_section(guide, share)
    rho = min(rho, flank_ellipse_rho(panel, guide))
    if guide.taper:
        rho = min(rho, taper_ellipse_rho(panel, guide, rule, False))
    return rho


def ellipse_rho(rule: "gauss.Rule", values: "array[float]", fraction: float, to_end: bool) -> float:
    """Return ρ of the largest ellipse around the panel free of zeros of a function known at the knots.

    A chord from one knot to the next points to a zero. With the panel stretched to (-1, 1) an ellipse of half axis a
    has ρ = a + √(a² - 1). A zero beyond the panel's end lies on the ellipse with a = |x|. Within the panel there is
    none on the real axis, and one at a distance s off it, above the knot k, has a² - 1 = (√(p² + 4 s²) - p)/2 with p =
    1 - k² - s². Only a fraction of the distance counts where the function bends so that a chord points too far.
    """
    nearest = floats.INFINITY
    for i in range(rule.chords - (1 if to_end else 2)):
        knot, next_knot = rule.chord[i], rule.chord[i + 1]
        k = 2.0 * rule.knots[knot] - 1.0
        gap = (2.0 * rule.knots[next_knot] - 1.0 - k) * fraction
        reach = floats.quotient(values[knot], values[next_knot] - values[knot]) * gap
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


def taper_ellipse_rho(panel: Panel, guide: "guide_surface.Guide", rule: "gauss.Rule", to_end: bool) -> float:
    """Return ρ that a taper allows: up to where, drawn on, it would leave the stream no width or a facet no rise.

    In a circle, up to where a full one would flow: depth has a branch point there.
    """
    facet, arc = panel.facet, guide.facets.circle and panel.facet == 0
    count = rule.last + (1 if to_end else 0)
    for j in range(count):
        at, y = panel.start + panel.width * rule.knots[j], panel.solution[j]
        if panel.in_r:
            at, y = panel.solution[j], at * at * at * at
        guide_surface.set_section(guide, at)
        if arc:
            panel.work[j], panel.wall_drag[j] = guide.facets.radius, guide.facets.radius * floats.root(floats.root(y))
            panel.wall_drag[j] -= math.sqrt(guide.flow / math.pi)
        else:
            area, sine = guide_surface.flow_area(guide, y), guide.facets.sine[facet]
            # Width² over area: a stream that grows thin is then not taken for a section that ends.
            foot_ratio = 1.0 - floats.quotient(guide.facets.area[facet], area)
            slant = floats.quotient(4.0 * guide.facets.cosine[facet], sine)
            panel.work[j] = (
                floats.quotient(guide.facets.width[facet] * guide.facets.width[facet], area) + slant * foot_ratio
            )
            panel.wall_drag[j] = sine
    return min(ellipse_rho(rule, panel.work, 1.0, to_end), ellipse_rho(rule, panel.wall_drag, 1.0, to_end))


def flank_ellipse_rho(panel: Panel, guide: "guide_surface.Guide") -> float:
    """Return ρ that the section allows a panel in r: sloping walls give χ a branch point at r = i √(Q/A_apex).

    A_apex is the area that the facet's flanks would add, drawn down to where they meet. Branch points closer to rest
    than rounding are left out. An arc has its branch point on the real axis, below the panel.
    """
    low, width = min(panel.start, panel.start + panel.width), math.fabs(panel.width)
    k = panel.facet
    if guide.facets.circle and k == 0:
        below = (low - math.sqrt(guide.flow / math.pi) / guide.facets.radius) / width
        return 1.0 + math.sqrt(4.0 * max(below, 0.0))
    foot = guide.facets.width[k] * guide.facets.width[k]
    apex = floats.quotient(foot * guide.facets.sine[k], 4.0 * guide.facets.cosine[k]) - guide.facets.area[k]
    branch = floats.root(floats.quotient(guide.flow, apex))
    if branch > 1e-4 * width:
        return 1.0 + math.sqrt(2.0 * math.sqrt(low * low + branch * branch) / width)
    return floats.INFINITY
