"""``chutecalc schema``: print the JSON Schema of a spec."""

import typer

EXAMPLES = ("chutecalc schema > chute.schema.json",)


def schema() -> int:
    """Print the JSON Schema of a spec, for editors.

    With it, they complete keys and check values.
    """
    import json

    from chutecalc.spec.schema import json_schema

    typer.echo(json.dumps(json_schema(), indent=2, ensure_ascii=False))
    return 0
