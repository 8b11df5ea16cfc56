"""The study of a campaign: beds in series, and the friction law that fits each."""

from functools import cached_property
from typing import NamedTuple

from chutecalc.dem.campaign import Campaign
from chutecalc.dem.fit import Fit, fit
from chutecalc.dem.point import Point

LAWS = ("paper", "equilibrium")
"""The friction laws."""
CLAIM = (
    "This check is about shape: does K(β) with one fitted δ follow the beds of one pour? The fitted δ depends on the"
    " pour and is not the measured angle of internal friction."
)
"""What the check shows, and what it does not."""


class Series(NamedTuple):
    """Points with one pour, one kind of particles and one body force."""

    pour: str
    """Name of the pour."""
    friction: float
    """Coefficient of friction between particles."""
    body_force: float
    """Body force of the pour, in g."""
    raised_to: float
    """Body force to which the resting beds are raised, in g; 0 where they are not."""
    points: tuple[Point, ...]
    """The points with at least one bed that passes all checks."""
    fits: dict[str, Fit]
    """Fits by law; empty where there is no point."""


def series_key(point: Point) -> tuple[str, float, float, float]:
    """Return what the points of a series have in common, the first four fields of its :class:`Series`.

    Args:
        point: The beds of a group, also of one without a usable bed.
    """
    case = point.case
    return case.pour, case.friction, case.body_force, case.raised_to


class Study:
    """The results of a campaign so far.

    Args:
        campaign: The campaign with its folder.
        wall_friction: Wall friction angle φ for μ_e, rad.
        vertical_ratio: Pressure ratio K_v to compare with besides the fitted one; None for none.

    >>> from chutecalc.dem.campaign import Group
    >>> from chutecalc.dem.case import Case
    >>> from chutecalc.dem.store import Store
    >>> case = Case(base=0.5, lengths=(), inclinations=(), area=0.05, friction=0.75, pour="rain", seed=1)
    >>> study = Study(Campaign([Group(case, seeds=3)], Store("no-such-folder")), wall_friction=0.44)
    >>> study.sound, study.points[0].waiting
    (False, 1)
    """

    def __init__(self, campaign: Campaign, wall_friction: float, vertical_ratio: float | None = None) -> None:
        self.wall_friction, self.vertical_ratio = wall_friction, vertical_ratio
        self.store = campaign.store
        outcomes = [(group, campaign.outcome(group)) for group in campaign.groups]
        self.points = tuple(
            Point(group, outcome.beds, outcome.errors, len(outcome.needed)) for group, outcome in outcomes
        )

    @cached_property
    def series(self) -> tuple[Series, ...]:
        """All points as series, with their fits."""
        series: dict[tuple[str, float, float, float], list[Point]] = {}
        for point in self.points:
            series.setdefault(series_key(point), []).append(point)
        fitted = []
        for key, points in series.items():
            usable = tuple(point for point in points if point.beds)
            fitted.append(Series(*key, usable, {law: fit(usable, law) for law in LAWS} if usable else {}))
        return tuple(fitted)

    @property
    def sound(self) -> bool:
        """Whether all cases have been run and pass their checks."""
        return not any(point.failed or point.errors or point.waiting for point in self.points)
