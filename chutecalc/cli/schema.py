"""``chutecalc schema``: prints the JSON Schema of a spec."""

import typer

EXAMPLES = ("chutecalc schema > chute.schema.json",)


def schema() -> int:
    """Print the JSON Schema of a spec, with which editors complete keys and check values."""
    import json

    from chutecalc.spec.schema import json_schema

    typer.echo(json.dumps(json_schema(), indent=2, ensure_ascii=False))
    return 0
