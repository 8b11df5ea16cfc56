"""``chutecalc schema``: print the JSON Schema of a spec, or of the JSON that commands write."""

from enum import StrEnum

import typer

EXAMPLES = ("chutecalc schema > chute.schema.json", "chutecalc schema results > results.schema.json")
PAGE = "installing.md"


class What(StrEnum):
    """What there is a schema of."""

    SPEC = "spec"
    RESULTS = "results"


def schema(
    what: What = typer.Argument(What.SPEC, metavar="[WHAT]", help="spec, or results: the JSON that commands write."),
) -> int:
    """Print the JSON Schema of a spec, for editors, or of results.

    With the schema of a spec editors complete keys and check values. That of results says what the JSON of each command
    has, with the unit of each number.
    """
    from chutecalc.spec.schema import json_schema, schema_text

    typer.echo(schema_text(json_schema() if what == What.SPEC else results_schema()), nl=False)
    return 0


def results_schema() -> dict[str, object]:
    """Return the JSON Schema of what commands write with ``--json``."""
    from chutecalc.dem.shape import dem_shape
    from chutecalc.output.run_shape import run_definitions
    from chutecalc.spec.schema import DIALECT
    from chutecalc.studies.shapes import SHAPES

    shapes = {**{name: shape() for name, shape in SHAPES.items()}, "dem": dem_shape()}
    return {
        "$schema": DIALECT,
        "title": "Results of chutecalc",
        "oneOf": [{"$ref": f"#/$defs/{name}"} for name in shapes],
        "$defs": shapes | run_definitions(),
    }
