"""The shape of the document of the discrete-element check."""

from chutecalc.dem.columns import DEM_COLUMNS
from chutecalc.output.shape import (
    COUNT,
    NUMBER,
    TEXT,
    VALUE,
    Shape,
    by_name,
    column_shape,
    document,
    list_of,
    record,
)

MEASURED = record("", mean=NUMBER, scatter=NUMBER)


def dem_shape() -> Shape:
    """Return the shape of the document: series of beds with what was fitted to them, and each bed."""
    law = record("", load_ratio=NUMBER, missing=NUMBER, loads=by_name(NUMBER, "wall"))
    point = record(
        "beds of one section",
        chamfer_deg=TEXT,
        seeds=COUNT,
        area_m2=MEASURED,
        depth_m=MEASURED,
        solid_fraction=MEASURED,
        load_ratio=MEASURED,
        equivalent_friction=MEASURED,
        walls=by_name(record("", load=MEASURED, pressure_ratio=MEASURED), "wall"),
        laws=by_name(law, "friction law"),
    )
    fit = record("", internal_friction_deg=NUMBER, scatter_deg=NUMBER, residual=NUMBER)
    series = record(
        "sections that were poured alike",
        pour=TEXT,
        particle_friction=NUMBER,
        body_force_g=NUMBER,
        raised_to_g=NUMBER,
        fits=by_name(fit, "friction law"),
        points=list_of(point),
    )
    known = {name: column_shape(column) for name, column in DEM_COLUMNS.items()}
    case = {"type": "object", "properties": known, "additionalProperties": VALUE}
    return document(
        "dem",
        "Beds of particles against the friction law.",
        claim=TEXT,
        series=list_of(series),
        cases=list_of(case, "a bed each, with numbers of its walls"),
        failures=list_of(TEXT),
        waiting=COUNT,
    )
