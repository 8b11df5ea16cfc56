"""Equivalent friction: what the walls of a section do to a stream of a given depth."""

from chutecalc.physics.arrays import Array, Values, real


def equivalent_friction(wall_friction: Values, excess: Values) -> Array:
    """Friction force on the stream over its weight, μ_e = μ (1 + χ), Paper Eq 10 and 11.

    Args:
        wall_friction: μ, the tangent of the wall friction angle, 0 or more.
        excess: χ of the section at the flow's depth, 0 or more (:func:`chutecalc.physics.section.excess_friction`).

    Returns:
        μ_e, never below μ, in the broadcast shape. The load that the walls' hydrostatic pressure does not carry is laid
        on the centre section (Paper Eq 6): strained where that share m exceeds about a tenth, and unsafe in a vee.

    >>> float(equivalent_friction(0.4663, 0.05).round(6))
    0.489615
    """
    return real(wall_friction) * (1.0 + real(excess))


def equilibrium_friction(wall_friction: Values, excess: Values, missing_load: Values) -> Array:
    """The same where all wall pressures are scaled until they carry the weight, μ_e = μ (1 + χ/(1 - m)).

    Args:
        wall_friction, excess: as in :func:`equivalent_friction`.
        missing_load: m, the share of the weight not carried by hydrostatic wall pressures, in [0, 1).

    Returns:
        μ_e, at least that of :func:`equivalent_friction`; equal for a rectangle, and exactly μ/cos β for a vee.

    >>> float(equilibrium_friction(0.5, 0.25, 0.5))
    0.75
    """
    return real(wall_friction) * (1.0 + real(excess) / (1.0 - real(missing_load)))
