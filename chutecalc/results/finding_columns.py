"""Columns along a stream that findings alone read: they stand in no table and no file."""

from typing import Any

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.physics.wall import wall_friction
from chutecalc.results.columns import COLUMNS
from chutecalc.results.segment_context import SegmentContext, on_surface
from chutecalc.results.stream_column import StreamColumn


def _clearing_margin(part: SegmentContext, at: Any) -> Array:
    """Return a - atan(μ_e) of a bed at rest as deep as the stream, deg: of a locus at the pressure of its weight."""
    friction, wall = at.friction, part.surface.wall
    if wall.changes:
        weight = at.stress * part.design.gravity * np.cos(at.slope) / at.normal_acceleration
        one_and_excess = np.where(at.wall_friction > 0.0, friction / at.wall_friction, 1.0)
        friction = wall_friction(wall, weight) * one_and_excess
    margin: Array = np.degrees(at.slope - np.arctan(friction))
    return margin


# fmt: off
_CATALOGUE = (
    StreamColumn("thickness", "H/b", "H/b", "depth over the stream's greatest width", "number",
                 formula=lambda part, at: at.depth / at.greatest_width, exists=on_surface,
                 equation="H/b", page="motion-on-a-surface"),
    StreamColumn("missing_load", "m", "m", "share of the weight that hydrostatic wall pressures do not carry",
                 "number",
                 formula=lambda part, at: at.missing, exists=on_surface, source="Paper Eq 6",
                 equation="N_m/N", page="friction-law"),
    StreamColumn("wall_friction", "μ", "μ", "wall friction on the centre section", "number",
                 formula=lambda part, at: at.wall_friction, exists=on_surface, source="Paper Eq 2",
                 equation="tan φ; τ/σ of a yield locus", page="equivalent-friction"),
    StreamColumn("wall_stress_kpa", "σ", "σ", "normal stress at which the wall's friction is read",
                 "pressure", "kpa",
                 formula=lambda part, at: at.stress / 1000.0, exists=on_surface,
                 equation="f ρ n H", page="pressure-and-wear"),
    StreamColumn("clearing_margin_deg", "margin", "", "slope above the equivalent friction angle of what stands there",
                 "angle", "deg", formula=_clearing_margin, exists=on_surface,
                 equation="a − atan μ_e, with n = g cos a", page="after-a-stop"),
    StreamColumn("top_m", "top", "", "height of the section's drawn top above its floor", "length", "m",
                 formula=lambda part, at: at.top, exists=on_surface),
    StreamColumn("above_top_m", "above top", "", "depth above the section's drawn top", "length", "m",
                 formula=lambda part, at: at.depth - at.top, exists=on_surface,
                 equation="H − top", page="equivalent-friction"),
    StreamColumn("equilibrium_friction", "μ_e", "μ_e", "equivalent friction of the equilibrium law",
                 "number",
                 formula=lambda part, at: at.equilibrium_friction, exists=on_surface,
                 equation="μ (1 + χ/(1 − m))", page="friction-law"),
    StreamColumn("balance_m_s", "v_c", "v_c", "velocity below which friction slows the stream",
                 "velocity", "m_s",
                 formula=lambda part, at: at.critical_velocity, exists=on_surface,
                 equation="g sin a = μ_e n at v = v_c", page="motion-on-a-surface"),
    StreamColumn("balance_margin", "v/v_c", "v/v_c", "velocity over that below which friction slows the stream",
                 "number",
                 formula=lambda part, at: at.velocity / at.critical_velocity, exists=on_surface,
                 equation="v/v_c", page="motion-on-a-surface"),
)
# fmt: on

FINDING_COLUMNS = {column.name: column for column in _CATALOGUE}
"""These columns by name."""
ALL_COLUMNS = COLUMNS | FINDING_COLUMNS
"""Every column along a stream by name."""
