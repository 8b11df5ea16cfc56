"""The equation of motion along a guiding surface, and which side of it the stream is on.

With s along the flow, a the slope below horizontal, κ = -da/ds the curvature (positive where the surface flattens) and
y = v²:

    dy/ds = 2 (g sin a - μ_e n),    n = σ (g cos a + κ y),    n ≥ 0

This is for a uniform stream without pressure along it. A momentum factor α_m and a longitudinal pressure ratio K_l
make it, with b_s the width of the free surface and T = ∫ b ζ dζ the first moment of the flow area about it,

    v dv/ds [α_m - K_l n A/(b_s v²) + 2 α_m K_l σ κ T/A] = g sin a - μ_e n - K_l (σ κ T/A g sin a + n ∂H/∂s),
    n = σ (g cos a + α_m κ y)

where ∂H/∂s is the change of depth along a taper at the same flow area. docs/physics.md derives it.

n is the normal acceleration that presses the stream on its surface, m/s². σ is 1 on a floor and -1 under a roof.
Where n falls below 0 the stream has left the surface and the equation no longer holds. On a spoon this is the equation
of motion of Roberts (2003), Paper Eq 1. :mod:`chutecalc.core` solves it. Its exact solutions for constant friction
stand in ``tests/verification/exact.py``: the solver is tested against them.
"""

FLOOR, ROOF = 1.0, -1.0
"""σ: the surface lies under the stream, or above it."""
