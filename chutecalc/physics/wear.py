"""What the walls of a section bear: pressure, and with the slip of the stream along them wear."""

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.physics.intervals import with_axes
from chutecalc.physics.section import Circle, Facets, Section
from chutecalc.physics.wetting import Wetting


def wall_pressures(section: Section, table: Facets, wet: Wetting, weight: Array) -> tuple[Array, Array, Array]:
    """Greatest pressure on the centre section, on the chamfers and on the vertical side walls.

    A wall at inclination ψ, ζ below the free surface, bears f K(ψ) ρ n ζ; each is pressed hardest at its foot, and the
    centre section with f ρ n H. The friction law's one factor f for all walls makes friction on them add up to
    μ_e ρ n A a metre of chute.

    Args:
        section, table: the section and its facets.
        wet: how the stream lies in it, shape (places, designs).
        weight: ρ n, N/m³, likewise.

    Returns:
        Pa. Where there is no centre section its place is taken by the foot of the flanks, in a circle by the invert.
        NaN on walls that the section does not have; 0 on dry ones.

    >>> from chutecalc.physics.section import Polygon, facets, take_facet
    >>> from chutecalc.physics.wetting import wetting
    >>> box = Polygon(np.array([1.0]), (), (), np.array([np.inf]))
    >>> table, area = facets(box, np.array([0.4])), np.array([[0.2]])
    >>> wet = wetting(take_facet(table, np.array([[0]])), area)
    >>> floor, chamfer, side = wall_pressures(box, table, wet, np.full((1, 1), 1e4))
    >>> floor.item(), chamfer.item(), side.item()
    (2000.0, nan, 800.0)
    """
    foot, sine, lack, drawn = (
        with_axes(field, weight.ndim) for field in (table.height, table.sine, table.lack, table.drawn)
    )
    raised = wet.factor * weight
    pressure = (1.0 - lack * sine**2) * raised * np.maximum(wet.depth - foot, 0.0)
    flat = with_axes(table.radius, weight.ndim) == 0.0
    chamfer = np.where((drawn > 0.0) & flat & (sine != 0.0), pressure, -np.inf).max(axis=0)
    side = np.where(drawn == 0.0, pressure, -np.inf).max(axis=0)
    centre = raised * wet.depth
    if not isinstance(section, Circle):
        base = section.base
        for length, inclination in zip(section.lengths, section.inclinations, strict=True):
            base = base + np.where(inclination == 0.0, 2.0 * length, 0.0)
        centre = np.where(base > 0.0, centre, np.maximum(chamfer, side))
    return centre, _existing(chamfer), _existing(side)


def _existing(pressure: Array) -> Array:
    """NaN where no wall has been found."""
    return np.where(np.isneginf(pressure), np.nan, pressure)
