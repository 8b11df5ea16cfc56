"""``chutecalc schema``: print the JSON Schema of a spec."""

import typer

EXAMPLES = ("chutecalc schema > chute.schema.json", "chutecalc schema | less")
PAGE = "installing.md"


def schema() -> int:
    """Print the JSON Schema of a spec, for editors.

    With it, they complete keys and check values.
    """
    from chutecalc.spec.schema import schema_text

    typer.echo(schema_text(), nl=False)
    return 0
