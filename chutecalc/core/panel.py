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

import math
from array import array

from chutecalc.core import floats, gauss, slide

# Of 20,488 random segments up to the edges and seven pairs of rules one panel is worse than with these it says, by 1.2:
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


class Panel:
    """A solved panel, and room to work in."""

    def __init__(self) -> None:
        self.start = self.width = 0.0
        """Of the independent variable, c or r."""
        self.by_root = False
        self.facet = self.piece = 0
        """The branch of the friction law."""
        self.knots = floats.zeros(gauss.MOST)
        """The unknown, y or c, at the rule's start, nodes and end."""
        self.growth = floats.zeros(gauss.MOST)
        """What a small change at the start has become at nodes and end."""
        self.error = self.inner_error = self.rounding = 0.0
        """Estimated, of the end: relative in y, in r relative to the way; infinite where the panel is no solution.
        The same of the polynomial through the knots. What rounding may add to both."""
        self.coarse, self.coarse_growth = floats.zeros(gauss.MOST), floats.zeros(gauss.MOST)
        self.guess, self.sine, self.press = (floats.zeros(gauss.MOST) for _ in range(3))
        self.forcing, self.rate, self.values = (floats.zeros(gauss.MOST) for _ in range(3))
        self.system = floats.zeros(gauss.MOST * gauss.MOST)
        self.left = 0.0
        self.smooth = 1.0
        """ρ of the ellipse around the panel in which the solution is smooth."""


def by_place(
    panel: Panel, way: "slide.Slide", start: float, width: float, y0: float, pair: "gauss.Pair", kind: int
) -> None:
    """Solves y = v² over a panel in c, in one of three ways: ``WHOLE``, ``PLACE`` or ``CLINGING``."""
    panel.start, panel.width, panel.by_root = start, width, False
    unit = 2.0 * width * way.length * way.gravity
    flow = way.flow / math.sqrt(unit)
    bend = -2.0 * way.side * width * way.turn * way.slopes[panel.piece]
    first = y0 / unit
    iterations, refinements = 1, 1
    forces(panel, way, pair.coarse)
    if kind == CLINGING:  # from a balance that clings, freezing friction leads far astray
        iterations = 3
        for j in range(pair.coarse.count):
            panel.coarse[j + 1] = first
        linearise(panel, way, pair.coarse, panel.coarse, 1, flow, bend)
    else:
        if kind == PLACE:
            iterations, refinements = 2, 2
        freeze(panel, way, pair.coarse, first, flow, bend)
    step(panel, pair.coarse, first, kind, panel.coarse, panel.coarse_growth)
    for _ in range(iterations):
        linearise(panel, way, pair.coarse, panel.coarse, 1, flow, bend)
        step(panel, pair.coarse, first, kind, panel.coarse, panel.coarse_growth)
    gauss.multiply(pair.transfer, pair.fine.count, pair.coarse.last + 1, panel.coarse, panel.guess)
    forces(panel, way, pair.fine)
    update, latest, last = 0.0, 0.0, pair.fine.last
    for number in range(refinements):
        linearise(panel, way, pair.fine, panel.guess, 0, flow, bend)
        step(panel, pair.fine, first, kind, panel.knots, panel.growth)
        latest = 0.0
        for j in range(pair.fine.count):
            latest = max(latest, math.fabs(floats.quotient(panel.guess[j], panel.knots[j + 1]) - 1.0))
            panel.guess[j] = panel.knots[j + 1]
        end = panel.knots[last]
        # What is small at the last node may not be so at a slow end.
        latest *= max(floats.quotient(panel.knots[last - 1], end), 1.0)
        if number == 0:
            update = latest
    end = panel.knots[last]
    sound = latest < 1.0 and end > 0.0  # then it is positive all along, as what it was worked out from
    noise = 0.0
    if kind == CLINGING:  # slope and friction nearly cancel: their rounding moves the balance the more, the less
        noise = floats.quotient(
            CANCELLED, math.fabs(panel.rate[pair.fine.count - 1] * panel.knots[last - 1])
        )  # friction varies
    for j in range(last + 1):
        panel.knots[j] *= unit
    panel.knots[0] = y0
    newton = NEWTON_SAFETY * latest * latest * panel.left
    smooth = smoothness_by_place(panel, way, pair.fine)
    judge(panel, sound, update, newton, smooth, floats.quotient(ROUNDING, end), pair, kind)
    if kind == CLINGING:
        # Gauss collocation keeps an offset from the balance that decays too fast to be seen, each rule its own share.
        share = floats.quotient(panel.growth[pair.fine.count], panel.coarse_growth[pair.coarse.count])
        kept = math.fabs(floats.quotient(panel.coarse[pair.coarse.last], end) - 1.0) * min(math.fabs(share), 1.0)
        panel.error += max(kept - noise, 0.0)
        panel.rounding += noise


def forces(panel: Panel, way: "slide.Slide", rule: "gauss.Rule") -> None:
    """Gravity's shares along the surface and on the wall, sin a and μ σ cos a, at the nodes."""
    friction = way.slopes[panel.piece] * way.side
    for j in range(rule.count):
        if j > 0 and way.turn == 0.0:
            panel.sine[j], panel.press[j] = panel.sine[0], panel.press[0]
        else:
            slope = way.entry_slope + way.turn * (panel.start + panel.width * rule.knots[j + 1])
            panel.sine[j], panel.press[j] = math.sin(slope), friction * math.cos(slope)


def freeze(panel: Panel, way: "slide.Slide", rule: "gauss.Rule", first: float, flow: float, bend: float) -> None:
    """The equation with μ_e as at the panel's start: near enough to start from, right where friction is constant."""
    area = floats.quotient(flow, math.sqrt(first))
    drag, stuck = 1.0, 0.0
    for j in range(rule.count):
        if j == 0 or way.taper:
            slide.draw(way, panel.start + panel.width * rule.knots[j + 1])
            drag, stuck = slide.drag_of(way, panel.facet, panel.piece, area)
        panel.forcing[j] = panel.sine[j] - drag * panel.press[j] - stuck
        panel.rate[j] = -drag * bend


def linearise(
    panel: Panel, way: "slide.Slide", rule: "gauss.Rule", iterate: "array[float]", offset: int, flow: float, bend: float
) -> None:
    """The equation near an iterate at the nodes, and what Newton leaves of an update of 1: half of Y ∂²f/∂Y² at most.

    That is at most A χ'/Y times 3/8 of the load from gravity and 1/4 of that from the bend; on a crest and under a hood
    the two may cancel in f, which is why there (1 + χ) b less b, χ b, is added.
    """
    panel.left = 0.0
    for j in range(rule.count):
        y = iterate[j + offset]
        area = floats.quotient(flow, floats.root(y))
        if way.taper:
            slide.draw(way, panel.start + panel.width * rule.knots[j + 1])
        forcing, rate, bending, held = slide.linearised(
            way, panel.facet, panel.piece, area, y, panel.sine[j], panel.press[j], bend
        )
        panel.forcing[j], panel.rate[j] = forcing, rate
        weight = math.fabs(bending) + 2.0 * math.fabs(held)
        if way.turn > 0.0:
            weight += 2.0 * (math.fabs(bending - rate) - math.fabs(bend))
        panel.left = max(panel.left, weight)


def step(
    panel: Panel, rule: "gauss.Rule", first: float, kind: int, knots: "array[float]", growth: "array[float]"
) -> None:
    """Solves the linear equation over the panel."""
    if kind == CLINGING:
        gauss.integrate_stiff(rule, panel.forcing, panel.rate, first, knots, growth, panel.system, panel.values)
    else:
        gauss.integrate(rule, panel.forcing, panel.rate, first, knots, growth)


def by_root(panel: Panel, way: "slide.Slide", start: float, width: float, place: float, pair: "gauss.Pair") -> None:
    """Solves c over a panel in r = √v, from a place. Only where v rises or falls throughout."""
    panel.start, panel.width, panel.by_root = start, width, True
    facet, piece = panel.facet, panel.piece
    first, _, pulled = slide.place_rate(way, facet, piece, start, width, place)
    for j in range(pair.coarse.count):
        r = start + width * pair.coarse.knots[j + 1]
        panel.coarse[j + 1] = place + floats.quotient(r * r * r * r - start * start * start * start, pulled)
    for _iteration in range(4):
        for j in range(pair.coarse.count):
            panel.guess[j] = panel.coarse[j + 1]
        rates(panel, way, pair.coarse, panel.coarse, 1)
        gauss.integrate(pair.coarse, panel.forcing, panel.rate, place, panel.coarse, panel.coarse_growth)
        moved = 0.0
        for j in range(pair.coarse.count):
            moved = max(moved, math.fabs(panel.coarse[j + 1] - panel.guess[j]))
        if moved <= SETTLED * math.fabs(panel.coarse[pair.coarse.last] - place):
            break
    gauss.multiply(pair.transfer, pair.fine.count, pair.coarse.last + 1, panel.coarse, panel.guess)
    least = rates(panel, way, pair.fine, panel.guess, 0)
    gauss.integrate(pair.fine, panel.forcing, panel.rate, place, panel.knots, panel.growth)
    # Where v turns inside, r is no measure of the way; and far beyond the segment there is nothing to solve for.
    sound, noise, last = least > 0.0, 0.0, pair.fine.last
    for j in range(last + 1):
        sound = sound and panel.knots[j] >= place and panel.knots[j] < 2.0
    for j in range(pair.fine.count):
        noise = max(noise, math.fabs(panel.knots[j + 1] - panel.guess[j]))
    update = max(noise - PLACE_ROUNDING, 0.0) / max(math.fabs(panel.knots[last] - place), PLACE_ROUNDING)
    smooth = smoothness_by_root(panel, way, pair.fine, first, place)
    judge(panel, sound, update, NEWTON_SAFETY * update * update, smooth, 0.0, pair, ROOT)


def rates(panel: Panel, way: "slide.Slide", rule: "gauss.Rule", iterate: "array[float]", offset: int) -> float:
    """The equation in r, linearised at the nodes, with dc/dr in ``sine``; the least of that."""
    least = floats.INFINITY
    for j in range(rule.count):
        r, c = panel.start + panel.width * rule.knots[j + 1], iterate[j + offset]
        rate, growth, _ = slide.place_rate(way, panel.facet, panel.piece, r, panel.width, c)
        panel.sine[j], panel.forcing[j], panel.rate[j] = rate, rate - growth * c, growth
        if not rate >= least:
            least = rate
    return least


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


def judge(
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
