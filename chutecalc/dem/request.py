"""What a command asks for, as groups of cases: the paper's troughs over β, or the section of a real chute."""

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
"""Numbers of a range."""
BETA, BASE, AREA = "15:90:15", 0.5, "0.05"
"""Of the paper's Figure 5."""


class Beds(NamedTuple):
    """What beds are poured, and what they are compared with."""

    troughs: Sequence[Trough]
    areas: Sequence[float]
    """Target area of each, m²."""
    wall_friction: float
    """φ for μ_e, rad; the beds' walls have none."""
    vertical_ratio: float | None
    """K_v to compare with besides the fitted one."""


class PourPlan(NamedTuple):
    """How they are poured: what is varied, and what is the same in all cases."""

    frictions: Sequence[float]
    pours: Sequence[str]
    seeds: int
    body_forces: Sequence[float]
    raised_to: float
    diameter: float
    slice: float


def numbers(text: str, name: str, low: float, high: float) -> list[float]:
    """The numbers of a list, each once.

    Args:
        text: as :func:`chutecalc.fields.ranges.read_values` takes it.
        name: of the option, for messages.
        low, high: bounds, both allowed.

    Raises:
        UsageError: it is none, or they are out of bounds.

    >>> numbers("0.1:0.3:0.1", "--x", 0.0, 1.0), numbers("1,2.5", "--x", 0.0, 9.0)
    ([0.1, 0.2, 0.3], [1.0, 2.5])
    """
    values = read_values(name, text, MOST).tolist()
    for value in values:
        if not low <= value <= high:
            raise UsageError(f"{name} has to be from {low:g} to {high:g}, not {value:g}")
    return list(dict.fromkeys(values))


def pours(text: str) -> list[str]:
    """The pours of ``gentle,rain``, or of ``all``.

    Raises:
        UsageError: one that there is not.
    """
    names = list(POURS) if text == "all" else list(dict.fromkeys(text.split(",")))
    for name in names:
        if name not in POURS:
            raise UsageError(f"--pour has to be {', '.join(POURS)} or all, not {name!r}")
    return names


def paper_beds(
    beta: str | None, base: float | None, chamfer: float | None, area: str | None, delta: float | None, phi: float
) -> Beds:
    """Beds between two chamfers, those of the paper's Figure 5 where nothing else is said.

    Args:
        beta: slopes of the chamfers, deg, as :func:`numbers` takes them.
        base: width of the floor, m.
        chamfer: length of a chamfer, m; None for none to end it.
        area: target areas of the beds, m², as :func:`numbers` takes them.
        delta: internal friction to compare with, deg.
        phi: wall friction angle, deg.

    Raises:
        UsageError: a list that is none, a value out of bounds, a trough without width.
    """
    slopes = numbers(beta or BETA, "--beta", 1.0, 90.0)
    if base == 0.0 and 90.0 in slopes:
        raise UsageError("a vee at 90° has no width: give a --base, or a --beta below 90")
    width, length = BASE if base is None else base, math.inf if chamfer is None else chamfer
    return Beds(
        [Trough(width, (length,), (math.radians(slope),)) for slope in slopes],
        numbers(area or AREA, "--area", 1e-6, 1e3),
        math.radians(phi),
        None if delta is None else float(vertical_pressure_ratio(math.radians(delta))),
    )


def groups(beds: Beds, plan: PourPlan) -> list[Group]:
    """Every combination, a group of seeds each.

    Raises:
        UsageError: a bed too small for its particles.
    """
    found = []
    for pour, friction, body_force, trough, area in product(
        plan.pours, plan.frictions, plan.body_forces, beds.troughs, beds.areas
    ):
        case = Case(
            trough.base,
            trough.lengths,
            trough.inclinations,
            area,
            friction,
            pour,
            seed=1,
            body_force=body_force,
            raised_to=plan.raised_to,
            diameter=plan.diameter,
            slice=plan.slice,
        )
        check_room(case)
        found.append(Group(case, plan.seeds))
    return found
