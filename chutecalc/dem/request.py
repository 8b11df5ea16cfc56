"""The cases that a command asks for: the paper's troughs over β, or the section of a chute."""

import math
from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

from chutecalc.dem.campaign import Group
from chutecalc.dem.case import POURS, Case
from chutecalc.dem.pour import check_room
from chutecalc.dem.trough import Trough
from chutecalc.errors import UsageError
from chutecalc.fields.ranges import read_values
from chutecalc.physics.pressure import vertical_pressure_ratio

MOST = 1000
"""Largest number of values in a range."""
BETA, BASE, AREA = "15:90:15", 0.5, "0.05"
"""Chamfer angles, deg, width, m, and area, m², of the paper's Figure 5."""


class Beds(NamedTuple):
    """The beds to pour, and the values to compare them with."""

    troughs: Sequence[Trough]
    """The troughs."""
    areas: Sequence[float]
    """Target areas, m², each in every trough."""
    wall_friction: float
    """Wall friction angle φ for μ_e, rad. The walls of the beds have no friction."""
    vertical_ratio: float | None
    """Pressure ratio K_v to compare with besides the fitted one; None for none."""


class PourPlan(NamedTuple):
    """How to pour the beds."""

    frictions: Sequence[float]
    """Coefficients of friction between particles."""
    pours: Sequence[str]
    """Names of pours."""
    seeds: int
    """Number of seeds of each bed."""
    body_forces: Sequence[float]
    """Body forces of the pour, in g."""
    raised_to: float
    """Body force to which the resting bed is raised, in g; 0 to leave it."""
    diameter: float
    """Diameter of the particles, m."""
    slice: float
    """Length of the periodic trough along the chute, m."""


def numbers(text: str, name: str, low: float, high: float) -> list[float]:
    """Read the numbers of a list or range, each once.

    Args:
        text: The list or range, as in :func:`chutecalc.fields.ranges.read_values`.
        name: Name of the option, for messages.
        low, high: Bounds, both allowed, in the unit of the option.

    Raises:
        UsageError: The text is not a list of numbers, or one is out of bounds.

    >>> numbers("0.1:0.3:0.1", "--x", 0.0, 1.0), numbers("1,2.5", "--x", 0.0, 9.0)
    ([0.1, 0.2, 0.3], [1.0, 2.5])
    """
    values = read_values(name, text, MOST).tolist()
    for value in values:
        if not low <= value <= high:
            raise UsageError(f"{name} must be from {low:g} to {high:g}, not {value:g}")
    return list(dict.fromkeys(values))


def pours(text: str) -> list[str]:
    """Read a list of pours, or ``all``.

    Args:
        text: Names with commas between them, or ``all``.

    Raises:
        UsageError: There is no pour of that name.

    >>> pours("gentle,rain")
    ['gentle', 'rain']
    """
    names = list(POURS) if text == "all" else list(dict.fromkeys(text.split(",")))
    for name in names:
        if name not in POURS:
            raise UsageError(f"--pour must be {', '.join(POURS)} or all, not {name!r}")
    return names


def paper_beds(
    beta: str | None, base: float | None, chamfer: float | None, area: str | None, delta: float | None, phi: float
) -> Beds:
    """Return beds between two chamfers; by default those of the paper's Figure 5.

    Args:
        beta: Chamfer angles, deg, as in :func:`numbers`; None for 15 to 90 in steps of 15.
        base: Width of the floor, m; None for 0.5.
        chamfer: Length of a chamfer, m; None for chamfers without a top.
        area: Target areas of the beds, m², as in :func:`numbers`; None for 0.05.
        delta: Angle of internal friction to compare with, deg; None for none.
        phi: Wall friction angle, deg.

    Raises:
        UsageError: A list cannot be read, a value is out of bounds, or a trough has no width.

    >>> beds = paper_beds(beta="30,60", base=None, chamfer=None, area=None, delta=None, phi=25.0)
    >>> len(beds.troughs), beds.areas
    (2, [0.05])
    """
    slopes = numbers(beta or BETA, "--beta", 1.0, 90.0)
    if base == 0.0 and 90.0 in slopes:
        raise UsageError("a vee at 90° has no width. Use a --base above 0, or --beta below 90")
    width, length = BASE if base is None else base, math.inf if chamfer is None else chamfer
    return Beds(
        troughs=[Trough(width, (length,), (math.radians(slope),)) for slope in slopes],
        areas=numbers(area or AREA, "--area", 1e-6, 1e3),
        wall_friction=math.radians(phi),
        vertical_ratio=None if delta is None else float(vertical_pressure_ratio(math.radians(delta))),
    )


def groups(beds: Beds, plan: PourPlan) -> list[Group]:
    """Return a group of seeds for every combination of pour, friction, body force, trough and area.

    Args:
        beds: The beds to pour.
        plan: How to pour them.

    Raises:
        UsageError: A bed is too small for its particles.

    >>> beds = paper_beds(beta="30,60", base=None, chamfer=None, area=None, delta=None, phi=25.0)
    >>> plan = PourPlan(
    ...     frictions=[0.75, 0.9], pours=["rain"], seeds=3, body_forces=[1.0], raised_to=0.0, diameter=0.01, slice=0.05
    ... )
    >>> [(group.case.slope_label, group.case.friction) for group in groups(beds, plan)]
    [('30', 0.75), ('60', 0.75), ('30', 0.9), ('60', 0.9)]
    """
    found = []
    for pour, friction, body_force, trough, area in product(
        plan.pours, plan.frictions, plan.body_forces, beds.troughs, beds.areas
    ):
        case = Case(
            base=trough.base,
            lengths=trough.lengths,
            inclinations=trough.inclinations,
            area=area,
            friction=friction,
            pour=pour,
            seed=1,
            body_force=body_force,
            raised_to=plan.raised_to,
            diameter=plan.diameter,
            slice=plan.slice,
        )
        check_room(case)
        found.append(Group(case, plan.seeds))
    return found
