"""``chutecalc schema``: the spec as JSON Schema."""

import typer


def schema() -> int:
    """Print the JSON Schema of a spec, with which editors complete and check it."""
    import json

    from chutecalc.spec.schema import json_schema

    typer.echo(json.dumps(json_schema(), indent=2, ensure_ascii=False))
    return 0
