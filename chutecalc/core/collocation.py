"""Solve the equation of motion over one panel by Gauss collocation: v² over the share c, or c over r = √v."""

import math

from chutecalc.core import floats, friction, gauss, guide_surface, matrix, motion, panel, pressed_panel, section

NEWTON_FRACTION = 0.1
"""Fraction of the tolerance that Newton's method may leave without another iteration."""


def solve_in_share(
    trial: "panel.Panel",
    guide: "guide_surface.Guide",
    start: float,
    width: float,
    y0: float,
    pair: "gauss.RulePair",
    kind: int,
    tolerance: float,
) -> None:
    """Solve y = v² over a panel in c, of the kind ``FULL_SEGMENT``, ``IN_SHARE`` or ``IN_SHARE_STIFF`` of ``panel``."""
    trial.start, trial.width, trial.in_r = start, width, False
    unit = 2.0 * width * guide.length * guide.gravity
    flow = guide.flow / math.sqrt(unit)
    centrifugal = -2.0 * guide.side * width * guide.turn * guide.slopes[trial.piece]
    initial = y0 / unit
    if not solve_coarse(trial, guide, pair, kind, initial, flow, centrifugal):
        trial.error = trial.inner_error = floats.INFINITY
        return
    latest, update, newton = solve_fine(trial, guide, pair, kind, initial, flow, centrifugal, tolerance)
    last, offset, cancellation = pair.fine.last, 0.0, 0.0
    end = trial.solution[last]
    valid = latest < 1.0 and end > 0.0  # then it is positive throughout, as the guess is
    if kind == panel.IN_SHARE_STIFF:
        offset, cancellation = stiff_errors(trial, pair)
    for j in range(last + 1):
        trial.solution[j] *= unit
    trial.solution[0] = y0
    rho = panel.ellipse_rho_in_share(trial, guide, pair.fine)
    if guide.longitudinal > 0.0:
        rho = min(rho, pressed_panel.ellipse_rho(trial, guide, pair.fine))
    panel.estimate(trial, valid, update, newton, rho, floats.quotient(panel.ROUNDING, end), pair, kind)
    if kind == panel.IN_SHARE_STIFF:
        trial.error += max(offset - cancellation, 0.0)
        trial.rounding += cancellation


def solve_coarse(
    trial: "panel.Panel",
    guide: "guide_surface.Guide",
    pair: "gauss.RulePair",
    kind: int,
    initial: float,
    flow: float,
    centrifugal: float,
) -> bool:
    """Solve the panel by the coarse rule as a guess for the fine one; return whether the stream gets to its end."""
    iterations = 2 if kind == panel.IN_SHARE else 1
    set_forces(trial, guide, pair.coarse, trial.coarse_angles)
    if kind == panel.IN_SHARE_STIFF:  # near an equilibrium, frozen friction would lead far astray
        iterations = 3
        for j in range(pair.coarse.count):
            trial.coarse.solution[j + 1] = initial
        linearise(trial, guide, pair.coarse, trial.coarse, flow, centrifugal)
    else:
        freeze_friction(trial, guide, pair.coarse, initial, flow, centrifugal)
    solve_linearised(trial, pair.coarse, initial, kind, trial.coarse)
    trial.stop_share = first_stop(trial, pair.coarse)
    if trial.stop_share < 1.0:  # no iterate recovers from there
        return False
    for _ in range(iterations):
        linearise(trial, guide, pair.coarse, trial.coarse, flow, centrifugal)
        solve_linearised(trial, pair.coarse, initial, kind, trial.coarse)
    matrix.multiply(pair.transfer, trial.coarse.solution, trial.guess.solution, 1)
    return True


def solve_fine(
    trial: "panel.Panel",
    guide: "guide_surface.Guide",
    pair: "gauss.RulePair",
    kind: int,
    initial: float,
    flow: float,
    centrifugal: float,
    tolerance: float,
) -> tuple[float, float, float]:
    """Solve the panel by the fine rule; return the last and the first relative update, and what Newton leaves."""
    set_forces(trial, guide, pair.fine, trial.angles)
    update, latest, newton, last = 0.0, 0.0, 0.0, pair.fine.last
    for number in range(2 if kind == panel.IN_SHARE else 1):
        linearise(trial, guide, pair.fine, trial.guess, flow, centrifugal)
        solve_linearised(trial, pair.fine, initial, kind, trial.fine)
        latest = 0.0
        for j in range(pair.fine.count):
            latest = max(latest, math.fabs(floats.quotient(trial.guess.solution[j + 1], trial.solution[j + 1]) - 1.0))
            trial.guess.solution[j + 1] = trial.solution[j + 1]
        # What is small at the last node may not be small at a slow end.
        latest *= max(floats.quotient(trial.solution[last - 1], trial.solution[last]), 1.0)
        newton = panel.NEWTON_SAFETY * latest * latest * trial.newton_factor
        if number == 0:
            update = latest
        if newton <= NEWTON_FRACTION * tolerance:
            break
    return latest, update, newton


def stiff_errors(trial: "panel.Panel", pair: "gauss.RulePair") -> tuple[float, float]:
    """Return two relative errors of the end that a stiff equation adds: an offset kept, and what rounding does.

    Gauss collocation keeps an offset from the equilibrium that decays too fast to be resolved; the rules differ in it.
    Slope and friction nearly cancel: the less friction varies, the more their rounding moves the equilibrium.
    """
    last = pair.fine.last
    cancellation = floats.quotient(
        panel.CANCELLATION, math.fabs(trial.equation.jacobian[pair.fine.count - 1] * trial.solution[last - 1])
    )
    ratio = floats.quotient(trial.sensitivity[pair.fine.count], trial.coarse.sensitivity[pair.coarse.count])
    change = math.fabs(floats.quotient(trial.coarse.solution[pair.coarse.last], trial.solution[last]) - 1.0)
    return change * min(math.fabs(ratio), 1.0), cancellation


def first_stop(trial: "panel.Panel", rule: "gauss.Rule") -> float:
    """Return the first knot at which the coarse solution is at rest, as a share of the panel; 1 where there is none."""
    for j in range(rule.last):
        if trial.coarse.solution[j + 1] <= 0.0:
            return float(rule.knots[j + 1])
    return 1.0


def set_forces(trial: "panel.Panel", guide: "guide_surface.Guide", rule: "gauss.Rule", angles: "panel.Angles") -> None:
    """Write the driving force and the wall friction of gravity over weight at the nodes: sin a and μ σ cos a."""
    start, turn = guide.entry_slope + guide.turn * trial.start, guide.turn * trial.width
    if angles.count != rule.count or angles.start != start or angles.turn != turn:
        angles.count, angles.start, angles.turn = rule.count, start, turn
        for j in range(rule.count):
            if j > 0 and turn == 0.0:
                angles.sine[j], angles.cosine[j] = angles.sine[0], angles.cosine[0]
            else:
                slope = start + turn * rule.knots[j + 1]
                angles.sine[j], angles.cosine[j] = math.sin(slope), math.cos(slope)
    slope_of_wall = guide.slopes[trial.piece] * guide.side
    for j in range(rule.count):
        trial.sine[j], trial.wall_drag[j] = angles.sine[j], slope_of_wall * angles.cosine[j]


def freeze_friction(
    trial: "panel.Panel",
    guide: "guide_surface.Guide",
    rule: "gauss.Rule",
    initial: float,
    flow: float,
    centrifugal: float,
) -> None:
    """Write the equation with μ_e as at the panel's start: a close first guess, exact where friction is constant."""
    guide.facets.loads.area[0] = floats.quotient(flow, math.sqrt(initial))
    drag, adhesion = 1.0, 0.0
    for j in range(rule.count):
        if j == 0 or guide.taper:
            guide_surface.set_section(guide, trial.start + trial.width * rule.knots[j + 1])
            friction.set_resistance(guide, trial.facet, trial.piece, 0, 1)
            drag, adhesion = 1.0 + guide.facets.loads.excess[0], guide.facets.loads.adhesion[0]
        trial.equation.forcing[j] = trial.sine[j] - drag * trial.wall_drag[j] - adhesion
        trial.equation.jacobian[j] = -drag * centrifugal
    if guide.longitudinal > 0.0:
        pressed_panel.freeze_bracket(trial, guide, rule.count, initial)


def linearise(
    trial: "panel.Panel",
    guide: "guide_surface.Guide",
    rule: "gauss.Rule",
    iterate: "gauss.Iterate",
    flow: float,
    centrifugal: float,
) -> None:
    """Write the equation linearised at an iterate, and what Newton leaves of an update of 1: half of Y ∂²f/∂Y² at most.

    That is at most A χ'/Y times 3/8 of gravity's load and 1/4 of the centrifugal load, and A_full/(A_full - A) times
    that in a pipe. On a crest and under a hood the two may cancel in f, so (1 + χ) b less b, χ b, is added there.
    """
    if guide.longitudinal > 0.0:
        pressed_panel.linearise(trial, guide, rule, iterate)
        return
    for j in range(rule.count):
        guide.facets.loads.area[j] = floats.quotient(flow, floats.root(iterate.solution[j + 1]))
    if guide.taper:
        for j in range(rule.count):
            guide_surface.set_section(guide, trial.start + trial.width * rule.knots[j + 1])
            friction.set_resistance(guide, trial.facet, trial.piece, j, j + 1)
    else:
        friction.set_resistance(guide, trial.facet, trial.piece, 0, rule.count)
    insert_resistance(
        trial, guide.facets.loads, trial.equation, iterate, rule.count, centrifugal, 2.0 if guide.turn > 0.0 else 0.0
    )
    trial.newton_factor = 0.0
    for j in range(rule.count):
        trial.newton_factor = max(trial.newton_factor, trial.work[j])


def insert_resistance(
    trial: "panel.Panel",
    at: "section.Loads",
    equation: "gauss.Equation",
    iterate: "gauss.Iterate",
    nodes: int,
    centrifugal: float,
    centrifugal_weight: float,
) -> None:
    """Insert resistance into the equation in Y, v² over 2 g h; write Newton's weights at the nodes to ``trial.work``.

    With f = sin a - (1 + χ) (p + b Y) the derivative by Y is h/Y - (1 + χ) b, where h = A χ' (p + b Y)/2, and
    linearising leaves sin a - (1 + χ) p - h. Adhesion is subtracted from f too, and changes h by its own change. Arrays
    are passed by their records so that compilers see which they are.

    Args:
        trial, at, equation: sine and wall friction, loads, and the equation to write.
        iterate: Y at the knots.
        nodes: number of nodes.
        centrifugal: b, 2 h μ σ κ.
        centrifugal_weight: 2 where (1 + χ) b less b counts among the weights, else 0.
    """
    for j in range(nodes):
        y, drag, wall_drag = iterate.solution[j + 1], 1.0 + at.excess[j], trial.wall_drag[j]
        load_change = at.excess_sensitivity[j] * (wall_drag + centrifugal * y) + (
            at.adhesion_rise[j] - at.adhesion_fall[j]
        )
        equation.forcing[j] = trial.sine[j] - drag * wall_drag - at.adhesion[j] - load_change
        load_change = floats.quotient(load_change, y)
        adhesion_change = floats.quotient(
            at.adhesion_fall[j] - 0.5 * (at.adhesion_rise[j] - math.fabs(at.adhesion_rise[j])), y
        )
        equation.jacobian[j] = load_change - drag * centrifugal
        trial.work[j] = (
            math.fabs(load_change)
            + 2.0 * math.fabs(adhesion_change)
            + centrifugal_weight * (math.fabs(drag * centrifugal) - math.fabs(centrifugal))
        ) * at.bend[j]


def solve_linearised(
    trial: "panel.Panel", rule: "gauss.Rule", initial: float, kind: int, curve: "gauss.Iterate"
) -> None:
    """Solve the linear equation over the panel."""
    if kind == panel.IN_SHARE_STIFF:
        gauss.integrate_stiff(rule, trial.equation, initial, curve)
    else:
        gauss.integrate(rule, trial.equation, initial, curve)


def solve_in_r(
    trial: "panel.Panel", guide: "guide_surface.Guide", start: float, width: float, share: float, pair: "gauss.RulePair"
) -> None:
    """Solve c over a panel in r = √v from a share; valid only where v rises or falls throughout."""
    trial.start, trial.width, trial.in_r = start, width, True
    facet, piece = trial.facet, trial.piece
    start_rate, _, change, bracket = motion.rhs_in_r(guide, facet, piece, start, width, share)
    for j in range(pair.coarse.count):
        r = start + width * pair.coarse.knots[j + 1]
        trial.coarse.solution[j + 1] = share + floats.quotient(r * r * r * r - start * start * start * start, change)
    set_resistance_in_r(trial, guide, pair.coarse)
    for _iteration in range(4):
        for j in range(pair.coarse.count):
            trial.guess.solution[j + 1] = trial.coarse.solution[j + 1]
        linearise_in_r(trial, guide, pair.coarse, trial.coarse)
        gauss.integrate(pair.coarse, trial.equation, share, trial.coarse)
        correction = 0.0
        for j in range(pair.coarse.count):
            correction = max(correction, math.fabs(trial.coarse.solution[j + 1] - trial.guess.solution[j + 1]))
        if correction <= panel.CONVERGED * math.fabs(trial.coarse.solution[pair.coarse.last] - share):
            break
    matrix.multiply(pair.transfer, trial.coarse.solution, trial.guess.solution, 1)
    set_resistance_in_r(trial, guide, pair.fine)
    least = linearise_in_r(trial, guide, pair.fine, trial.guess)
    gauss.integrate(pair.fine, trial.equation, share, trial.fine)
    # Where v has an extreme inside, r is not monotone; and far beyond the segment there is nothing to solve for.
    valid, noise, last = least > 0.0, 0.0, pair.fine.last
    for j in range(last + 1):
        valid = valid and trial.solution[j] >= share and trial.solution[j] < 2.0
    for j in range(pair.fine.count):
        noise = max(noise, math.fabs(trial.solution[j + 1] - trial.guess.solution[j + 1]))
    update = max(noise - panel.SHARE_ROUNDING, 0.0) / max(math.fabs(trial.solution[last] - share), panel.SHARE_ROUNDING)
    rho = panel.ellipse_rho_in_r(trial, guide, pair.fine, floats.quotient(start_rate, bracket), share)
    panel.estimate(trial, valid, update, panel.NEWTON_SAFETY * update * update, rho, 0.0, pair, panel.IN_R)


def set_resistance_in_r(trial: "panel.Panel", guide: "guide_surface.Guide", rule: "gauss.Rule") -> None:
    """Write v² and the loads at the nodes of a panel in r, which do not depend on the iterate unless it tapers."""
    if guide.taper or guide.longitudinal > 0.0:
        return
    for j in range(rule.count):
        r = trial.start + trial.width * rule.knots[j + 1]
        trial.work[j] = r * r * r * r
        guide.facets.loads.area[j] = floats.quotient(guide.flow, r * r)
    friction.set_resistance(guide, trial.facet, trial.piece, 0, rule.count)


def linearise_in_r(
    trial: "panel.Panel", guide: "guide_surface.Guide", rule: "gauss.Rule", iterate: "gauss.Iterate"
) -> float:
    """Write the equation in r linearised at an iterate; return the least dc/dr over its bracket, also in ``sine``."""
    least, bracket = floats.INFINITY, 1.0
    for j in range(rule.count):
        r, c = trial.start + trial.width * rule.knots[j + 1], iterate.solution[j + 1]
        if guide.taper or guide.longitudinal > 0.0:
            rate, jacobian, _, bracket = motion.rhs_in_r(guide, trial.facet, trial.piece, r, trial.width, c)
        else:
            change, change_in_share = motion.rhs_at_node(guide, trial.piece, c, trial.work[j], j)
            rate = floats.quotient(4.0 * trial.width * r * r * r, change)
            jacobian = floats.quotient(-rate * change_in_share, change)
        trial.equation.forcing[j], trial.equation.jacobian[j] = rate - jacobian * c, jacobian
        trial.sine[j] = floats.quotient(rate, bracket)
        if not trial.sine[j] >= least:
            least = trial.sine[j]
    return least
