"""The columns of the friction study."""

from dataclasses import replace

from chutecalc.results.column import Column
from chutecalc.results.columns import COLUMNS

FRICTION_COLUMNS = {
    column.name: column
    for column in (
        Column("chamfer_deg", "β", "β", "chamfer angle", "angle", "deg", 1, source="Paper Eq 4"),
        Column(
            "internal_friction_deg",
            "δ",
            "δ",
            "effective angle of internal friction",
            "angle",
            "deg",
            1,
            source="Paper Eq 4",
        ),
        Column("base_m", "base", "B", "width of the centre section", "length", "m", 4, "in", 2, source="Paper Eq 2"),
        COLUMNS["chamfer_wetted_m"],
        COLUMNS["depth_m"],
        Column(
            "pressure_ratio",
            "K",
            "K",
            "pressure on a chamfer over that on the centre section",
            "number",
            "",
            4,
            source="Paper Eq 4",
        ),
        replace(COLUMNS["equivalent_friction"], digits=5),
        Column("status", "status", "", "ok, or impossible: a section that cannot exist"),
    )
}
"""Columns of the friction study, in the order of the CSV."""
