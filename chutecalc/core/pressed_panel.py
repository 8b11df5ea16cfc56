"""Linearise the equation of motion with pressure along the stream over a panel in c, and bound its ellipse."""

import math

from chutecalc.core import floats, gauss, guide_surface, longitudinal, motion, panel


def freeze_bracket(trial: "panel.Panel", guide: "guide_surface.Guide", nodes: int, initial: float) -> None:
    """Divide the equation with friction frozen by the bracket at the panel's start, for a first guess."""
    y = 2.0 * trial.width * guide.length * guide.gravity * initial
    bracket = longitudinal.bracket(guide, trial.facet, trial.start, y)
    for j in range(nodes):
        trial.equation.forcing[j] = floats.quotient(trial.equation.forcing[j], bracket)
        trial.equation.jacobian[j] = floats.quotient(trial.equation.jacobian[j], bracket)


def linearise(trial: "panel.Panel", guide: "guide_surface.Guide", rule: "gauss.Rule", iterate: "gauss.Iterate") -> None:
    """Write the equation in Y, v² over 2 g h, linearised at an iterate, and what Newton leaves of an update of 1.

    That is half of Y ∂²f/∂Y² at the nodes. Beyond the jump everything is NaN, and the panel is refused.
    """
    per_change = 2.0 * guide.length * guide.gravity
    unit = per_change * trial.width
    trial.newton_factor = 0.0
    for j in range(rule.count):
        y = iterate.solution[j + 1]
        value, first, second = motion.pressed_rhs(
            guide, trial.facet, trial.piece, trial.start + trial.width * rule.knots[j + 1], unit * y
        )
        trial.equation.forcing[j] = (value - first) / per_change
        trial.equation.jacobian[j] = floats.quotient(first, y) / per_change
        bend = math.fabs(floats.quotient(0.5 * second, y)) / per_change
        if not bend <= trial.newton_factor:
            trial.newton_factor = bend


def ellipse_rho(trial: "panel.Panel", guide: "guide_surface.Guide", rule: "gauss.Rule") -> float:
    """Return ρ of the largest ellipse around a panel in c up to the jump, to which the bracket falls as a root."""
    for j in range(rule.last + 1):
        share = trial.start + trial.width * rule.knots[j]
        bracket = longitudinal.bracket(guide, trial.facet, share, trial.solution[j])
        trial.work[j] = bracket * bracket if bracket > 0.0 else floats.NAN
    return panel.ellipse_rho(rule, trial.work, 1.0, True)
