"""The columns of the discrete-element check, a row for each bed."""

from chutecalc.results.column import Column
from chutecalc.results.columns import COLUMNS

DEM_COLUMNS = {
    column.name: column
    for column in (
        Column("case", "case", "", "folder of the case"),
        Column("pour", "pour", "", "how the bed was poured: gentle, rain, freefall"),
        Column("particle_friction", "μ_p", "μ_p", "coefficient of friction between particles", "number", "", 2),
        Column("body_force_g", "force", "", "body force under which the bed was poured, in g", "number", "", 1),
        Column("raised_to_g", "raised", "", "body force raised to before measuring, in g", "number", "", 1),
        Column("base_m", "base", "B", "width of the centre section", "length", "m", 3, source="Paper Eq 2"),
        Column("chamfer_deg", "β", "β", "angles of the drawn walls, from the centre outwards", source="Paper Eq 4"),
        Column("seed", "seed", "", "seed of the particles' positions before the pour", "number", "", 0),
        Column("spread", "spread", "e", "density of the rain over the surface, 1 + e (2 |ξ| - 1)", "number", "", 3),
        Column("status", "status", "", "ok, or failed and the checks that fail"),
        COLUMNS["area_m2"],
        COLUMNS["depth_m"],
        Column("solid_fraction", "solids", "", "solid fraction of the bed's interior", "number", "", 3),
        Column(
            "load_ratio",
            "N_t/N",
            "N_t/N",
            "all normal loads on walls over the weight",
            "number",
            "",
            4,
            source="Paper Eq 10",
        ),
        Column(
            "equivalent_friction",
            "μ_e",
            "μ_e",
            "equivalent friction, tan φ N_t/N",
            "number",
            "",
            4,
            source="Paper Eq 10",
        ),
        Column("balance", "balance", "", "vertical force on the walls over the weight, less 1", "number", "", 6),
        Column("sides", "sides", "", "push of the left less that of the right walls, over their mean", "number", "", 6),
        Column("rest", "rest", "", "kinetic energy of a particle over m g d", "number", "", 12),
        Column("unevenness", "uneven", "", "outer less inner half of the surface, over the depth", "number", "", 3),
        Column("paper_load_ratio", "paper", "", "N_t/N of the paper's law, with the fitted δ", "number", "", 4),
        Column("equilibrium_load_ratio", "equil.", "", "N_t/N of the equilibrium law, with its δ", "number", "", 4),
    )
}
"""The columns by name. ``pressure_ratio_WALL`` and ``load_WALL`` of each wall follow them."""
