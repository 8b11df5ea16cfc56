"""Gauss collocation of the equation of motion over one panel, in v² over the place or in the place over √v."""

import math

from chutecalc.core import floats, friction, gauss, matrix, panel, section, slide

ENOUGH = 0.1
"""Of the tolerance: what Newton may leave without being asked again."""


def by_place(
    own: "panel.Panel",
    way: "slide.Slide",
    start: float,
    width: float,
    y0: float,
    pair: "gauss.Pair",
    kind: int,
    tolerance: float,
) -> None:
    """Solves y = v² over a panel in c, in one of three ways: ``panel.WHOLE``, ``panel.PLACE`` or ``panel.CLINGING``."""
    own.start, own.width, own.by_root = start, width, False
    unit = 2.0 * width * way.length * way.gravity
    flow = way.flow / math.sqrt(unit)
    bend = -2.0 * way.side * width * way.turn * way.slopes[own.piece]
    first = y0 / unit
    iterations, refinements = 1, 1
    forces(own, way, pair.coarse, own.coarse_angles)
    if kind == panel.CLINGING:  # from a balance that clings, freezing friction leads far astray
        iterations = 3
        for j in range(pair.coarse.count):
            own.coarse.knots[j + 1] = first
        linearise(own, way, pair.coarse, own.coarse, flow, bend)
    else:
        if kind == panel.PLACE:
            iterations, refinements = 2, 2
        freeze(own, way, pair.coarse, first, flow, bend)
    step(own, pair.coarse, first, kind, own.coarse)
    own.stop = stopped(own, pair.coarse)
    if own.stop < 1.0:  # no iterate comes back from there
        own.error = own.inner_error = floats.INFINITY
        return
    for _ in range(iterations):
        linearise(own, way, pair.coarse, own.coarse, flow, bend)
        step(own, pair.coarse, first, kind, own.coarse)
    matrix.multiply(pair.transfer, own.coarse.knots, own.guess.knots, 1)
    forces(own, way, pair.fine, own.angles)
    update, latest, newton, last = 0.0, 0.0, 0.0, pair.fine.last
    for number in range(refinements):
        linearise(own, way, pair.fine, own.guess, flow, bend)
        step(own, pair.fine, first, kind, own.fine)
        latest = 0.0
        for j in range(pair.fine.count):
            latest = max(latest, math.fabs(floats.quotient(own.guess.knots[j + 1], own.knots[j + 1]) - 1.0))
            own.guess.knots[j + 1] = own.knots[j + 1]
        end = own.knots[last]
        # What is small at the last node may not be so at a slow end.
        latest *= max(floats.quotient(own.knots[last - 1], end), 1.0)
        newton = panel.NEWTON_SAFETY * latest * latest * own.left
        if number == 0:
            update = latest
        if newton <= ENOUGH * tolerance:
            break
    end = own.knots[last]
    sound = latest < 1.0 and end > 0.0  # then it is positive all along, as what it was worked out from
    noise = 0.0
    if kind == panel.CLINGING:  # slope and friction nearly cancel: their rounding moves the balance the more, the less
        noise = floats.quotient(
            panel.CANCELLED, math.fabs(own.equation.rate[pair.fine.count - 1] * own.knots[last - 1])
        )  # friction varies
    for j in range(last + 1):
        own.knots[j] *= unit
    own.knots[0] = y0
    smooth = panel.smoothness_by_place(own, way, pair.fine)
    panel.estimate(own, sound, update, newton, smooth, floats.quotient(panel.ROUNDING, end), pair, kind)
    if kind == panel.CLINGING:
        # Gauss collocation keeps an offset from the balance that decays too fast to be seen, each rule its own share.
        share = floats.quotient(own.growth[pair.fine.count], own.coarse.growth[pair.coarse.count])
        kept = math.fabs(floats.quotient(own.coarse.knots[pair.coarse.last], end) - 1.0) * min(math.fabs(share), 1.0)
        own.error += max(kept - noise, 0.0)
        own.rounding += noise


def stopped(own: "panel.Panel", rule: "gauss.Rule") -> float:
    """The first knot at which the stream would have stopped by now, as a share of the panel; 1 where there is none."""
    for j in range(rule.last):
        if own.coarse.knots[j + 1] <= 0.0:
            return float(rule.knots[j + 1])
    return 1.0


def forces(own: "panel.Panel", way: "slide.Slide", rule: "gauss.Rule", angles: "panel.Angles") -> None:
    """Gravity's shares along the surface and on the wall, sin a and μ σ cos a, at the nodes."""
    start, turn = way.entry_slope + way.turn * own.start, way.turn * own.width
    if angles.count != rule.count or angles.start != start or angles.turn != turn:
        angles.count, angles.start, angles.turn = rule.count, start, turn
        for j in range(rule.count):
            if j > 0 and turn == 0.0:
                angles.sine[j], angles.cosine[j] = angles.sine[0], angles.cosine[0]
            else:
                slope = start + turn * rule.knots[j + 1]
                angles.sine[j], angles.cosine[j] = math.sin(slope), math.cos(slope)
    slope_of_wall = way.slopes[own.piece] * way.side
    for j in range(rule.count):
        own.sine[j], own.press[j] = angles.sine[j], slope_of_wall * angles.cosine[j]


def freeze(own: "panel.Panel", way: "slide.Slide", rule: "gauss.Rule", first: float, flow: float, bend: float) -> None:
    """The equation with μ_e as at the panel's start: near enough to start from, right where friction is constant."""
    way.facets.loads.area[0] = floats.quotient(flow, math.sqrt(first))
    drag, stuck = 1.0, 0.0
    for j in range(rule.count):
        if j == 0 or way.taper:
            slide.draw(way, own.start + own.width * rule.knots[j + 1])
            friction.resist(way, own.facet, own.piece, 0, 1)
            drag, stuck = 1.0 + way.facets.loads.excess[0], way.facets.loads.stuck[0]
        own.equation.forcing[j] = own.sine[j] - drag * own.press[j] - stuck
        own.equation.rate[j] = -drag * bend


def linearise(
    own: "panel.Panel",
    way: "slide.Slide",
    rule: "gauss.Rule",
    iterate: "gauss.Curve",
    flow: float,
    bend: float,
) -> None:
    """The equation near an iterate at the nodes, and what Newton leaves of an update of 1: half of Y ∂²f/∂Y² at most.

    That is at most A χ'/Y times 3/8 of the load from gravity and 1/4 of that from the bend; on a crest and under a hood
    the two may cancel in f, which is why there (1 + χ) b less b, χ b, is added.
    """
    for j in range(rule.count):
        way.facets.loads.area[j] = floats.quotient(flow, floats.root(iterate.knots[j + 1]))
    if way.taper:
        for j in range(rule.count):
            slide.draw(way, own.start + own.width * rule.knots[j + 1])
            friction.resist(way, own.facet, own.piece, j, j + 1)
    else:
        friction.resist(way, own.facet, own.piece, 0, rule.count)
    insert(own, way.facets.loads, own.equation, iterate, rule.count, bend, 2.0 if way.turn > 0.0 else 0.0)
    own.left = 0.0
    for j in range(rule.count):
        own.left = max(own.left, own.values[j])


def insert(
    own: "panel.Panel",
    at: "section.Loads",
    equation: "gauss.Equation",
    iterate: "gauss.Curve",
    nodes: int,
    bend: float,
    turned: float,
) -> None:
    """Puts resistance into the equation in Y, the unit 2 g h of v²; Newton's weights at the nodes go to ``own.values``.

    With f = sin a - (1 + χ) (p + b Y) the derivative to Y is h/Y - (1 + χ) b, where h = A χ' (p + b Y)/2, and what it
    leaves of f is sin a - (1 + χ) p - h. What adhesion holds back is taken off f too, and changes h by its own change.
    Arrays are named by their records here, so that compilers see which they are.

    Args:
        own, at, equation: sine and pressing force, resistance, and where the equation stands.
        iterate: Y at the knots.
        nodes: how many.
        bend: b, 2 h μ σ κ.
        turned: 2 where (1 + χ) b less b counts among the weights, else 0.
    """
    for j in range(nodes):
        y, drag, press = iterate.knots[j + 1], 1.0 + at.excess[j], own.press[j]
        bending = at.growth[j] * (press + bend * y) + (at.climb[j] - at.fall[j])
        equation.forcing[j] = own.sine[j] - drag * press - at.stuck[j] - bending
        bending = floats.quotient(bending, y)
        held = floats.quotient(at.fall[j] - 0.5 * (at.climb[j] - math.fabs(at.climb[j])), y)
        equation.rate[j] = bending - drag * bend
        own.values[j] = math.fabs(bending) + 2.0 * math.fabs(held) + turned * (math.fabs(drag * bend) - math.fabs(bend))


def step(own: "panel.Panel", rule: "gauss.Rule", first: float, kind: int, curve: "gauss.Curve") -> None:
    """Solves the linear equation over the panel."""
    if kind == panel.CLINGING:
        gauss.integrate_stiff(rule, own.equation, first, curve)
    else:
        gauss.integrate(rule, own.equation, first, curve)


def by_root(
    own: "panel.Panel", way: "slide.Slide", start: float, width: float, place: float, pair: "gauss.Pair"
) -> None:
    """Solves c over a panel in r = √v, from a place. Only where v rises or falls throughout."""
    own.start, own.width, own.by_root = start, width, True
    facet, piece = own.facet, own.piece
    first, _, pulled = friction.place_rate(way, facet, piece, start, width, place)
    for j in range(pair.coarse.count):
        r = start + width * pair.coarse.knots[j + 1]
        own.coarse.knots[j + 1] = place + floats.quotient(r * r * r * r - start * start * start * start, pulled)
    resist_in_r(own, way, pair.coarse)
    for _iteration in range(4):
        for j in range(pair.coarse.count):
            own.guess.knots[j + 1] = own.coarse.knots[j + 1]
        rates(own, way, pair.coarse, own.coarse)
        gauss.integrate(pair.coarse, own.equation, place, own.coarse)
        moved = 0.0
        for j in range(pair.coarse.count):
            moved = max(moved, math.fabs(own.coarse.knots[j + 1] - own.guess.knots[j + 1]))
        if moved <= panel.SETTLED * math.fabs(own.coarse.knots[pair.coarse.last] - place):
            break
    matrix.multiply(pair.transfer, own.coarse.knots, own.guess.knots, 1)
    resist_in_r(own, way, pair.fine)
    least = rates(own, way, pair.fine, own.guess)
    gauss.integrate(pair.fine, own.equation, place, own.fine)
    # Where v turns inside, r is no measure of the way; and far beyond the segment there is nothing to solve for.
    sound, noise, last = least > 0.0, 0.0, pair.fine.last
    for j in range(last + 1):
        sound = sound and own.knots[j] >= place and own.knots[j] < 2.0
    for j in range(pair.fine.count):
        noise = max(noise, math.fabs(own.knots[j + 1] - own.guess.knots[j + 1]))
    update = max(noise - panel.PLACE_ROUNDING, 0.0) / max(math.fabs(own.knots[last] - place), panel.PLACE_ROUNDING)
    smooth = panel.smoothness_by_root(own, way, pair.fine, first, place)
    panel.estimate(own, sound, update, panel.NEWTON_SAFETY * update * update, smooth, 0.0, pair, panel.ROOT)


def resist_in_r(own: "panel.Panel", way: "slide.Slide", rule: "gauss.Rule") -> None:
    """What resists the streams at the nodes of a panel in r, and v² there; not of a taper, where place counts too."""
    if way.taper:
        return
    for j in range(rule.count):
        r = own.start + own.width * rule.knots[j + 1]
        own.values[j] = r * r * r * r
        way.facets.loads.area[j] = floats.quotient(way.flow, r * r)
    friction.resist(way, own.facet, own.piece, 0, rule.count)


def rates(own: "panel.Panel", way: "slide.Slide", rule: "gauss.Rule", iterate: "gauss.Curve") -> float:
    """The equation in r, linearised at the nodes, with dc/dr in ``sine``; the least of that."""
    least = floats.INFINITY
    for j in range(rule.count):
        r, c = own.start + own.width * rule.knots[j + 1], iterate.knots[j + 1]
        if way.taper:
            rate, growth, _ = friction.place_rate(way, own.facet, own.piece, r, own.width, c)
        else:
            change, bent = friction.pull(way, own.piece, c, own.values[j], j)
            rate = floats.quotient(4.0 * own.width * r * r * r, change)
            growth = floats.quotient(-rate * bent, change)
        own.sine[j], own.equation.forcing[j], own.equation.rate[j] = rate, rate - growth * c, growth
        if not rate >= least:
            least = rate
    return least
