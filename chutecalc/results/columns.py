"""The catalogue of the columns along a stream: all that is known of each stands in its entry, and nowhere else.

To add a column, add an entry. Tables, charts, CSV, JSON, sweeps, ``chutecalc columns`` and docs/nomenclature.md read
the catalogue. A formula takes the part of the trajectory (see :class:`chutecalc.results.part.SegmentContext`) and the
profile of the stream there (see :class:`chutecalc.solver.contact_profile.ContactProfile`), whose arrays are of
shape (stations, designs), SI and radians.
"""

from collections.abc import Callable, Collection, Iterable
from dataclasses import dataclass
from enum import Enum, Flag
from typing import Any

import numpy as np

from chutecalc.errors import UsageError
from chutecalc.physics.arrays import Array
from chutecalc.physics.loads import liner_life
from chutecalc.physics.wall import wall_friction
from chutecalc.results.column import Column

LEAST_NORMAL = 1e-9
"""Ratio to gravity: with less normal acceleration the stream is about to leave its surface, and dividing by it gives
noise."""


HOUR = 3600.0
"""Seconds of an hour."""


class Extremes(Enum):
    """Where the least and largest values of a column are reported."""

    NONE = 0
    ON_REQUEST = 1
    """Reported in sweeps, as ``max_`` and ``min_`` columns."""
    REPORTED = 2
    """There, and for each segment in tables, JSON and baselines."""


class Needs(Flag):
    """What the solver must work out at the end of a chute for the value of a column there."""

    NOTHING = 0
    DEPTH = 1
    """How the stream fills the section: depth, width, wetted lengths."""
    WALLS = 2
    """What the walls carry: pressures and friction."""
    WHOLE_PATH = 4
    """All that comes before, so that there is no such column at an exit alone."""


def everywhere(part: Any) -> bool:
    """Return that a column exists on surfaces and in flight.

    Args:
        part: the part of the trajectory.
    """
    return True


def on_surface(part: Any) -> bool:
    """Return whether the part follows a guiding surface.

    Args:
        part: the part of the trajectory.
    """
    return bool(part.guided)


def on_arc(part: Any) -> bool:
    """Return whether the part follows an arc.

    Args:
        part: the part of the trajectory.
    """
    return bool(part.on_arc)


def on_wearing_liner(part: Any) -> bool:
    """Return whether the part follows a liner whose life can be told: its thickness and wear rate are known.

    Args:
        part: the part of the trajectory.
    """
    return bool(part.guided) and part.segment.thickness is not None and part.segment.wear_rate is not None


def between_facets(part: Any) -> bool:
    """Return whether the part has a section with drawn facets beside its centre.

    Args:
        part: the part of the trajectory.
    """
    return bool(part.between_facets)


@dataclass(frozen=True, eq=False, kw_only=True)
class StreamColumn(Column):
    """A column along the stream, with its formula."""

    formula: Callable[[Any, Any], Array] | None = None
    """Function of the part and the profile that returns the values; None for text."""
    exists: Callable[[Any], bool] = everywhere
    needs: Needs = Needs.DEPTH | Needs.WALLS
    extremes: Extremes = Extremes.ON_REQUEST
    in_tables: bool = False
    """Whether the tables for people show it."""
    internal: bool = False
    """Whether findings alone ask for it: it stands in no table and no file."""
    infinite_at_lift_off: bool = False
    """Whether it grows without bound where a stream leaves its surface."""

    def values(self, part: Any, profile: Any) -> Array:
        """Return the column along a part of the trajectory.

        Args:
            part: the part.
            profile: the stream there.

        Returns:
            Values of the profile's shape or broadcastable to it; one NaN where the column does not exist.
        """
        if self.formula is None or not self.exists(part):
            return np.full((1, 1), np.nan)
        return self.formula(part, profile)


def _froude(part: Any, at: Any) -> Array:
    """Return the Froude number, v/√(n A/b_s)."""
    pressed = at.normal_acceleration > LEAST_NORMAL * part.design.gravity
    froude: Array = np.where(pressed, at.velocity / np.sqrt(at.normal_acceleration * at.area / at.width), np.nan)
    return froude


def _liner_life(part: Any, at: Any) -> Array:
    """Return the time to wear through the liner where it wears most across the section, h."""
    wear = np.fmax.reduce([at.wear(wall) for wall in range(3)]) * part.slip_ratio
    return liner_life(part.segment.thickness, part.segment.wear_rate, wear) / HOUR


def _clearing_margin(part: Any, at: Any) -> Array:
    """Return a - atan(μ_e) of a bed at rest as deep as the stream, deg: of a locus at the pressure of its weight."""
    friction, wall = at.friction, part.segment.wall
    if wall.changes:
        weight = at.stress * part.design.gravity * np.cos(at.slope) / at.normal_acceleration
        one_and_excess = np.where(at.wall_friction > 0.0, friction / at.wall_friction, 1.0)
        friction = wall_friction(wall, weight) * one_and_excess
    margin: Array = np.degrees(at.slope - np.arctan(friction))
    return margin


# fmt: off
_CATALOGUE = (
    StreamColumn("spec", "spec", "", "the spec's file"),
    StreamColumn("case", "case", "", "operating state: design, or the name of a case"),
    StreamColumn("segment", "segment", "", "name of the segment; NAME:flight for a flight that leads to it"),
    StreamColumn("kind", "kind", "", "kind of the segment; flight"),
    StreamColumn("s_m", "s", "s", "distance from the inlet along the stream", "length", "m", 3, "ft", 2,
                 formula=lambda part, at: at.distance, needs=Needs.NOTHING, extremes=Extremes.NONE, in_tables=True),
    StreamColumn("x_m", "x", "x", "horizontal position along the chute; 0 at the inlet unless at_m is given",
                 "length", "m", 3, "ft", 2,
                 formula=lambda part, at: at.position[0], needs=Needs.NOTHING, extremes=Extremes.NONE, in_tables=True),
    StreamColumn("z_m", "z", "z", "height; 0 at the inlet unless at_m is given", "length", "m", 3, "ft", 2,
                 formula=lambda part, at: at.position[1], needs=Needs.NOTHING, extremes=Extremes.NONE, in_tables=True),
    StreamColumn("slope_deg", "slope", "a", "slope of the stream below horizontal", "angle", "deg", 2, "", 2,
                 formula=lambda part, at: np.degrees(at.slope), needs=Needs.NOTHING, in_tables=True),
    StreamColumn("velocity_m_s", "velocity", "v", "mean velocity of the stream", "velocity", "m_s", 3, "fpm", 1,
                 formula=lambda part, at: at.velocity, needs=Needs.NOTHING,
                 extremes=Extremes.REPORTED, in_tables=True, source="Paper Eq 1"),
    StreamColumn("depth_m", "depth", "H", "flow depth normal to the centre section", "length", "m", 4, "in", 2,
                 formula=lambda part, at: at.depth, exists=on_surface, needs=Needs.DEPTH,
                 extremes=Extremes.REPORTED, in_tables=True, source="Paper Eq 2"),
    StreamColumn("chamfer_wetted_m", "chamfer", "C", "wetted length of one chamfer", "length", "m", 4, "in", 2,
                 formula=lambda part, at: at.chamfer, exists=between_facets, needs=Needs.DEPTH,
                 source="Paper Eq 3"),
    StreamColumn("area_m2", "area", "A", "flow area", "area", "m2", 5, "ft2", 4,
                 formula=lambda part, at: at.area, needs=Needs.NOTHING, source="Paper Eq 7"),
    StreamColumn("fill", "fill", "", "flow area over the area of a closed section; depth over wall height in others",
                 "number", "", 3, formula=lambda part, at: at.fill, exists=on_surface, needs=Needs.DEPTH,
                 extremes=Extremes.REPORTED),
    StreamColumn("equivalent_friction", "μ_e", "μ_e", "equivalent friction", "number", "", 4,
                 formula=lambda part, at: at.friction, exists=on_surface, needs=Needs.WALLS,
                 extremes=Extremes.REPORTED, in_tables=True, source="Paper Eq 11"),
    StreamColumn("normal_acceleration_m_s2", "n", "n", "acceleration that presses the stream against its surface",
                 "acceleration", "m_s2", 2, "ft_s2", 1,
                 formula=lambda part, at: at.normal_acceleration, exists=on_surface, needs=Needs.WALLS),
    StreamColumn("pressure_kpa", "pressure", "p",
                 "pressure on the centre section; in a vee, on the flanks at their foot; on a plate, of the impact",
                 "pressure", "kpa", 3, "psf", 1,
                 formula=lambda part, at: at.pressures[0] / 1000.0, exists=on_surface, needs=Needs.WALLS,
                 extremes=Extremes.REPORTED, in_tables=True),
    StreamColumn("wear_w_m2", "wear", "", "friction power per area at that pressure", "power", "w_m2", 1,
                 formula=lambda part, at: at.wear(0) * part.slip_ratio, exists=on_surface, needs=Needs.WALLS,
                 extremes=Extremes.REPORTED, in_tables=True),
    StreamColumn("froude", "Fr", "Fr", "Froude number, v/√(n A/b_s), b_s the free surface's width", "number", "", 2,
                 formula=_froude, exists=on_surface, extremes=Extremes.REPORTED, in_tables=True,
                 infinite_at_lift_off=True),
    StreamColumn("time_s", "time", "t", "time since the inlet", "time", "s", 3,
                 formula=lambda part, at: part.start_time + at.time, needs=Needs.WHOLE_PATH,
                 extremes=Extremes.NONE, in_tables=True),
    StreamColumn("chamfer_pressure_kpa", "p chamfer", "", "greatest pressure on the chamfers",
                 "pressure", "kpa", 3, "psf", 1,
                 formula=lambda part, at: at.pressures[1] / 1000.0, exists=on_surface, needs=Needs.WALLS,
                 extremes=Extremes.REPORTED),
    StreamColumn("chamfer_wear_w_m2", "wear chamfer", "", "friction power per area at that pressure",
                 "power", "w_m2", 1,
                 formula=lambda part, at: at.wear(1) * part.slip_ratio, exists=on_surface, needs=Needs.WALLS,
                 extremes=Extremes.REPORTED),
    StreamColumn("side_pressure_kpa", "p side", "", "greatest pressure on the vertical side walls",
                 "pressure", "kpa", 3, "psf", 1,
                 formula=lambda part, at: at.pressures[2] / 1000.0, exists=on_surface, needs=Needs.WALLS,
                 extremes=Extremes.REPORTED),
    StreamColumn("side_wear_w_m2", "wear side", "", "friction power per area at that pressure", "power", "w_m2", 1,
                 formula=lambda part, at: at.wear(2) * part.slip_ratio, exists=on_surface, needs=Needs.WALLS,
                 extremes=Extremes.REPORTED),
    StreamColumn("wear_number", "N_WR", "N_WR", "Roberts' wear number, n/g on an arc", "number", "", 3,
                 formula=lambda part, at: at.normal_acceleration / part.design.gravity, exists=on_arc,
                 needs=Needs.WALLS, source="Roberts (2003)"),
    StreamColumn("sliding_life_h", "sliding life", "", "time until sliding wears through the liner, at its worst",
                 "time", "h", 0, formula=_liner_life, exists=on_wearing_liner, needs=Needs.WALLS),

    StreamColumn("thickness", "H/b", "H/b", "depth over the stream's greatest width", "number", internal=True,
                 formula=lambda part, at: at.depth / at.greatest_width, exists=on_surface),
    StreamColumn("missing_load", "m", "m", "share of the weight that hydrostatic wall pressures do not carry",
                 "number", internal=True,
                 formula=lambda part, at: at.missing, exists=on_surface, source="Paper Eq 6"),
    StreamColumn("wall_friction", "μ", "μ", "wall friction on the centre section", "number", internal=True,
                 formula=lambda part, at: at.wall_friction, exists=on_surface, source="Paper Eq 2"),
    StreamColumn("wall_stress_kpa", "σ", "σ", "normal stress at which the wall's friction is read",
                 "pressure", "kpa", internal=True,
                 formula=lambda part, at: at.stress / 1000.0, exists=on_surface),
    StreamColumn("clearing_margin_deg", "margin", "", "slope above the equivalent friction angle of what stands there",
                 "angle", "deg", internal=True, formula=_clearing_margin, exists=on_surface),
    StreamColumn("top_m", "top", "", "height of the section's drawn top above its floor", "length", "m", internal=True,
                 formula=lambda part, at: at.top, exists=on_surface),
    StreamColumn("above_top_m", "above top", "", "depth above the section's drawn top", "length", "m", internal=True,
                 formula=lambda part, at: at.depth - at.top, exists=on_surface),
    StreamColumn("equilibrium_friction", "μ_e", "μ_e", "equivalent friction of the equilibrium law",
                 "number", internal=True,
                 formula=lambda part, at: at.equilibrium_friction, exists=on_surface),
    StreamColumn("balance_m_s", "v_c", "v_c", "velocity below which friction slows the stream",
                 "velocity", "m_s", internal=True,
                 formula=lambda part, at: at.critical_velocity, exists=on_surface),
    StreamColumn("balance_margin", "v/v_c", "v/v_c", "velocity over that below which friction slows the stream",
                 "number", internal=True,
                 formula=lambda part, at: at.velocity / at.critical_velocity, exists=on_surface),
)
# fmt: on

ALL_COLUMNS = {column.name: column for column in _CATALOGUE}
"""Every entry by name, those that only findings ask for included."""
COLUMNS = {name: column for name, column in ALL_COLUMNS.items() if not column.internal}
"""Station columns in the order of the CSV."""
NUMERIC = tuple(name for name, column in COLUMNS.items() if column.formula is not None)
"""Names of the columns of numbers."""
REPORTED = tuple(name for name, column in COLUMNS.items() if column.extremes is Extremes.REPORTED)
"""Names of the columns whose least and largest values are reported for each segment."""
IN_TABLES = tuple(name for name, column in COLUMNS.items() if column.in_tables)
"""Names of the columns that tables for people show."""
AT_STATION = tuple(name for name in COLUMNS if name not in ("spec", "case"))
"""Names of the columns of a solution at its stations."""
AT_EXIT = tuple(name for name in NUMERIC if Needs.WHOLE_PATH not in COLUMNS[name].needs)
"""Names of the columns that exist at an exit alone."""
NEEDING_DEPTH = frozenset(name for name, column in ALL_COLUMNS.items() if Needs.DEPTH in column.needs)
NEEDING_WALLS = frozenset(name for name, column in ALL_COLUMNS.items() if Needs.WALLS in column.needs)
"""Names of the columns for which the solver has to work that out at an exit."""


def column_names(names: Iterable[str]) -> list[str]:
    """Return names of columns as a list, also where one name is given alone.

    Args:
        names: of columns, or one name.

    >>> column_names("depth_m"), column_names(("s_m", "depth_m"))
    (['depth_m'], ['s_m', 'depth_m'])
    """
    return [names] if isinstance(names, str) else list(names)


def check_columns(names: Iterable[str], known: Collection[str], where: str = "") -> None:
    """Check that columns exist.

    Args:
        names: of columns.
        known: names of the columns that exist.
        where: where they exist, for the message.

    Raises:
        UsageError: a name is unknown.

    >>> check_columns(["depth"], COLUMNS)
    Traceback (most recent call last):
    chutecalc.errors.UsageError: there is no column depth. Did you mean depth_m? `chutecalc columns` lists all
    """
    unknown = [name for name in names if name not in known]
    if unknown:
        raise UsageError(
            f"there is no column {', '.join(unknown)}{where}. {closest(unknown, known)}`chutecalc columns` lists all"
        )


def closest(unknown: Iterable[str], known: Collection[str]) -> str:
    """Return a question that offers known names in place of unknown ones, with a space behind; empty without any.

    Args:
        unknown: names.
        known: names.

    >>> closest(["depth", "nope"], COLUMNS)
    'Did you mean depth_m? '
    """
    from difflib import get_close_matches

    matches = [match for name in unknown for match in get_close_matches(name, known, n=1)]
    return f"Did you mean {', '.join(matches)}? " if matches else ""
