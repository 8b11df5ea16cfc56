"""The catalogue of the columns along a stream: all that is known of each stands in its entry, and nowhere else.

To add a column, add an entry. Tables, charts, CSV, JSON, sweeps, ``chutecalc columns`` and docs/nomenclature.md read
the catalogue. A formula takes the part of the trajectory (see
:class:`chutecalc.results.segment_context.SegmentContext`) and the profile of the stream there (see
:class:`chutecalc.solver.contact_profile.ContactProfile`), whose arrays are of shape (stations, designs), SI and
radians.
"""

from typing import Any

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.physics.loads import liner_life
from chutecalc.results.segment_context import SegmentContext, between_facets, on_arc, on_surface, on_wearing_liner
from chutecalc.results.stream_column import Extremes, Needs, StreamColumn

LEAST_NORMAL = 1e-9
"""Ratio to gravity: with less normal acceleration the stream is about to leave its surface, and dividing by it gives
noise."""
HOUR = 3600.0
"""Seconds of an hour."""


def _froude(part: SegmentContext, at: Any) -> Array:
    """Return the Froude number, v/√(n A/b_s)."""
    pressed = at.normal_acceleration > LEAST_NORMAL * part.design.gravity
    froude: Array = np.where(pressed, at.velocity / np.sqrt(at.normal_acceleration * at.area / at.width), np.nan)
    return froude


def _liner_life(part: SegmentContext, at: Any) -> Array:
    """Return the time to wear through the liner where it wears most across the section, h."""
    thickness, rate = part.surface.thickness, part.surface.wear_rate
    assert thickness is not None
    assert rate is not None
    return liner_life(thickness, rate, np.fmax.reduce([at.wear(wall) for wall in range(3)]) * part.slip_ratio) / HOUR


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
                 extremes=Extremes.REPORTED, in_tables=True, source="Paper Eq 1",
                 equation="d(v²)/ds = 2 (g sin a − μ_e n)", page="motion-on-a-surface"),
    StreamColumn("depth_m", "depth", "H", "flow depth normal to the centre section", "length", "m", 4, "in", 2,
                 formula=lambda part, at: at.depth, exists=on_surface, needs=Needs.DEPTH,
                 extremes=Extremes.REPORTED, in_tables=True, source="Paper Eq 2",
                 equation="H of the section that holds A = Q/v", page="equivalent-friction"),
    StreamColumn("chamfer_wetted_m", "chamfer", "C", "wetted length of one chamfer", "length", "m", 4, "in", 2,
                 formula=lambda part, at: at.chamfer, exists=between_facets, needs=Needs.DEPTH,
                 source="Paper Eq 3",
                 equation="H/sin β, at most L", page="equivalent-friction"),
    StreamColumn("area_m2", "area", "A", "flow area", "area", "m2", 5, "ft2", 4,
                 formula=lambda part, at: at.area, needs=Needs.NOTHING, source="Paper Eq 7",
                 equation="Q/v = ṁ/(ρ v)", page="motion-on-a-surface"),
    StreamColumn("fill", "fill", "", "flow area over the area of a closed section; depth over wall height in others",
                 "number", "", 3, formula=lambda part, at: at.fill, exists=on_surface, needs=Needs.DEPTH,
                 extremes=Extremes.REPORTED,
                 equation="A/A_full of a pipe or box, else H/wall_height", page="equivalent-friction"),
    StreamColumn("equivalent_friction", "μ_e", "μ_e", "equivalent friction", "number", "", 4,
                 formula=lambda part, at: at.friction, exists=on_surface, needs=Needs.WALLS,
                 extremes=Extremes.REPORTED, in_tables=True, source="Paper Eq 11",
                 equation="μ_e = tan φ (1 + χ)", page="equivalent-friction"),
    StreamColumn("normal_acceleration_m_s2", "n", "n", "acceleration that presses the stream against its surface",
                 "acceleration", "m_s2", 2, "ft_s2", 1,
                 formula=lambda part, at: at.normal_acceleration, exists=on_surface, needs=Needs.WALLS,
                 equation="n = ±(g cos a + α_m κ v²)", page="motion-on-a-surface"),
    StreamColumn("pressure_kpa", "pressure", "p",
                 "pressure on the centre section; in a vee, on the flanks at their foot; on a plate, of the impact",
                 "pressure", "kpa", 3, "psf", 1,
                 formula=lambda part, at: at.pressures[0] / 1000.0, exists=on_surface, needs=Needs.WALLS,
                 extremes=Extremes.REPORTED, in_tables=True,
                 equation="f ρ n H; of an impact ρ v² sin² i", page="pressure-and-wear"),
    StreamColumn("wear_w_m2", "wear", "", "friction power per area at that pressure", "power", "w_m2", 1,
                 formula=lambda part, at: at.wear(0) * part.slip_ratio, exists=on_surface, needs=Needs.WALLS,
                 extremes=Extremes.REPORTED, in_tables=True,
                 equation="μ p v times slip_ratio", page="pressure-and-wear"),
    StreamColumn("froude", "Fr", "Fr", "Froude number, v/√(n A/b_s), b_s the free surface's width", "number", "", 2,
                 formula=_froude, exists=on_surface, extremes=Extremes.REPORTED, in_tables=True,
                 infinite_at_lift_off=True,
                 equation="v/√(n A/b_s)", page="momentum-and-pressure-along-the-stream"),
    StreamColumn("time_s", "time", "t", "time since the inlet", "time", "s", 3,
                 formula=lambda part, at: part.start_time + at.time, needs=Needs.WHOLE_PATH,
                 extremes=Extremes.NONE, in_tables=True,
                 equation="∫ ds/v", page="motion-on-a-surface"),
    StreamColumn("chamfer_pressure_kpa", "p chamfer", "", "greatest pressure on the chamfers",
                 "pressure", "kpa", 3, "psf", 1,
                 formula=lambda part, at: at.pressures[1] / 1000.0, exists=on_surface, needs=Needs.WALLS,
                 extremes=Extremes.REPORTED,
                 equation="f K ρ n ζ, ζ deep below the free surface", page="pressure-and-wear"),
    StreamColumn("chamfer_wear_w_m2", "wear chamfer", "", "friction power per area at that pressure",
                 "power", "w_m2", 1,
                 formula=lambda part, at: at.wear(1) * part.slip_ratio, exists=on_surface, needs=Needs.WALLS,
                 extremes=Extremes.REPORTED,
                 equation="μ p v times slip_ratio, p of the chamfers", page="pressure-and-wear"),
    StreamColumn("side_pressure_kpa", "p side", "", "greatest pressure on the vertical side walls",
                 "pressure", "kpa", 3, "psf", 1,
                 formula=lambda part, at: at.pressures[2] / 1000.0, exists=on_surface, needs=Needs.WALLS,
                 extremes=Extremes.REPORTED,
                 equation="f K_v ρ n ζ, ζ deep below the free surface", page="pressure-and-wear"),
    StreamColumn("side_wear_w_m2", "wear side", "", "friction power per area at that pressure", "power", "w_m2", 1,
                 formula=lambda part, at: at.wear(2) * part.slip_ratio, exists=on_surface, needs=Needs.WALLS,
                 extremes=Extremes.REPORTED,
                 equation="μ p v times slip_ratio, p of the side walls", page="pressure-and-wear"),
    StreamColumn("wear_number", "N_WR", "N_WR", "Roberts' wear number, n/g on an arc", "number", "", 3,
                 formula=lambda part, at: at.normal_acceleration / part.design.gravity, exists=on_arc,
                 needs=Needs.WALLS, source="Roberts (2003)",
                 equation="n/g", page="pressure-and-wear"),
    StreamColumn("sliding_life_h", "sliding life", "", "time until sliding wears through the liner, at its worst",
                 "time", "h", 0, formula=_liner_life, exists=on_wearing_liner, needs=Needs.WALLS,
                 equation="thickness/(k w), k the wear of the liner, w the greatest friction power",
                 page="liner-life"),
)
# fmt: on

COLUMNS = {column.name: column for column in _CATALOGUE}
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
