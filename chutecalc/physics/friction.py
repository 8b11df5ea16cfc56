"""Equivalent friction: the drag of all walls of a section on a stream, as one coefficient."""

from chutecalc.physics.arrays import Array, Values, real


def equivalent_friction(wall_friction: Values, excess: Values) -> Array:
    """Compute the equivalent friction of the paper's law, μ_e = F/N = μ (1 + χ).

    Paper Eq 10 and 11. The weight that hydrostatic wall pressures do not carry is laid on the centre section (Paper Eq
    6). The paper takes that share m to be below about 10 %; beyond it the law is strained, and in a vee, which has no
    centre section, it is unsafe: see :func:`equilibrium_friction`.

    Args:
        wall_friction: Coefficient of wall friction μ, the tangent of the wall friction angle, 0 or more.
        excess: Excess friction χ of the section at the flow's depth, a ratio, 0 or more: see
            :attr:`chutecalc.physics.wetting.Wetting.excess`.

    Returns:
        μ_e, a coefficient, never below μ, in the broadcast shape.

    >>> float(equivalent_friction(0.4663, 0.05).round(6))
    0.489615
    """
    return real(wall_friction) * (1.0 + real(excess))


def equilibrium_friction(wall_friction: Values, excess: Values, missing_load: Values) -> Array:
    """Compute the equivalent friction of the equilibrium law, μ_e = μ (1 + χ/(1 - m)).

    All hydrostatic wall pressures are scaled by one factor until they carry the weight. For a rectangle the result is
    that of the paper's law, for a vee exactly μ/cos β.

    Args:
        wall_friction: Coefficient of wall friction μ, as in :func:`equivalent_friction`.
        excess: Excess friction χ of the paper's law, a ratio, 0 or more.
        missing_load: Share m of the weight that hydrostatic wall pressures do not carry, in [0, 1).

    Returns:
        μ_e, a coefficient, at least that of :func:`equivalent_friction`, in the broadcast shape.

    >>> float(equilibrium_friction(0.5, 0.25, 0.5))
    0.75
    """
    return real(wall_friction) * (1.0 + real(excess) / (1.0 - real(missing_load)))
