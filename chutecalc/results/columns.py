"""The one catalogue of columns: what tables, CSV, JSON and plots call a quantity, and how people read it."""

from chutecalc.results.column import Column

COLUMNS = {
    column.name: column
    for column in (
        Column("spec", "spec", "", "the spec's file"),
        Column("segment", "segment", "", "name of the segment; NAME:flight for a flight that leads to it"),
        Column("kind", "kind", "", "kind of the segment; flight"),
        Column("s_m", "s", "s", "distance from the inlet along the stream", "length", "m", 3, "ft", 2),
        Column(
            "x_m",
            "x",
            "x",
            "horizontal position along the chute; the inlet is at 0 unless at_m places it",
            "length",
            "m",
            3,
            "ft",
            2,
        ),
        Column("z_m", "z", "z", "height, likewise", "length", "m", 3, "ft", 2),
        Column("slope_deg", "slope", "a", "slope of the stream below horizontal", "angle", "deg", 2, "", 2),
        Column("velocity_m_s", "velocity", "v", "mean velocity of the stream", "velocity", "m_s", 3, "fpm", 1),
        Column("depth_m", "depth", "H", "flow depth normal to the centre section", "length", "m", 4, "in", 2),
        Column("chamfer_wetted_m", "chamfer", "C", "wetted length of one chamfer", "length", "m", 4, "in", 2),
        Column("area_m2", "area", "A", "flow area", "area", "m2", 5, "ft2", 4),
        Column("equivalent_friction", "μ_e", "μ_e", "equivalent friction", "number", "", 4),
        Column(
            "normal_acceleration_m_s2",
            "n",
            "n",
            "acceleration that presses the stream on its surface",
            "acceleration",
            "m_s2",
            2,
            "ft_s2",
            1,
        ),
        Column(
            "pressure_kpa",
            "pressure",
            "p",
            "on the centre section; in a vee, on the flanks at their foot; on a plate, of the impact",
            "pressure",
            "kpa",
            3,
            "psf",
            1,
        ),
        Column("wear_w_m2", "wear", "", "friction power per area there", "power", "w_m2", 1),
        Column("froude", "Fr", "Fr", "Froude number v/√(n A/b_s), b_s the free surface's width", "number", "", 2),
        Column("time_s", "time", "t", "since the inlet", "time", "s", 3),
        Column("chamfer_pressure_kpa", "p chamfer", "", "greatest on the chamfers", "pressure", "kpa", 3, "psf", 1),
        Column("chamfer_wear_w_m2", "wear chamfer", "", "friction power per area there", "power", "w_m2", 1),
        Column(
            "side_pressure_kpa", "p side", "", "greatest on the vertical side walls", "pressure", "kpa", 3, "psf", 1
        ),
        Column("side_wear_w_m2", "wear side", "", "friction power per area there", "power", "w_m2", 1),
        Column("wear_number", "N_WR", "N_WR", "n/g on an arc, Roberts' wear number", "number", "", 3),
    )
}
"""Station columns in the order of the CSV."""

RECEIVER_COLUMNS = {
    column.name: column
    for column in (
        Column("velocity_along_m_s", "along belt", "", "velocity along the belt", "velocity", "m_s", 3, "fpm", 1),
        Column("velocity_across_m_s", "onto belt", "", "velocity onto the belt", "velocity", "m_s", 3, "fpm", 1),
        Column("velocity_ratio", "belt ratio", "", "velocity along the belt over the belt's", "number", "", 4),
        Column("impact_pressure_kpa", "belt impact", "", "impact pressure on the belt", "pressure", "kpa", 3, "psf", 1),
        Column("wear_w_m2", "belt wear", "", "friction power per area of the belt", "power", "w_m2", 1),
        Column("acceleration_length_m", "belt slip", "", "length in which it accelerates", "length", "m", 3, "ft", 2),
        Column("acceleration_power_kw", "belt power", "", "power that accelerates it", "power", "kw", 3),
        Column("landed_velocity_m_s", "landed", "", "along it, impact's friction in", "velocity", "m_s", 3, "fpm", 1),
        Column("landed_acceleration_length_m", "landed slip", "", "accelerates from then", "length", "m", 3, "ft", 2),
        Column("matching_slope_deg", "matching slope", "", "exit slope with the belt's velocity", "angle", "deg", 2),
        Column(
            "matching_velocity_m_s", "matching", "", "exit velocity that would match", "velocity", "m_s", 3, "fpm", 1
        ),
    )
}
"""What a stream does to the belt that it goes to; in a sweep's rows behind ``receiver_``."""
