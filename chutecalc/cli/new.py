"""``chutecalc new``: write a spec to start from."""

from pathlib import Path

import typer

from chutecalc.errors import UsageError
from chutecalc.output.files import open_new
from chutecalc.output.targets import STANDARD_STREAM
from chutecalc.printable import printable

EXAMPLES = (
    "chutecalc new",
    "chutecalc new --list",
    "chutecalc new --example belt_hood_spoon transfer.toml",
)
PAGE = "spec.md"


def _names() -> list[str]:
    """Return the names of the examples, for completion."""
    from chutecalc.spec.examples import examples

    return list(examples())


def new(
    file: str | None = typer.Argument(
        None, metavar="FILE", help="File to write; - for standard output. Default: chute.toml, or NAME.toml."
    ),
    example: str | None = typer.Option(
        None, "--example", metavar="NAME", help="Write this standard design.", autocompletion=_names
    ),
    list_them: bool = typer.Option(False, "--list", help="List the standard designs with their titles."),
) -> int:
    """Write a spec to start from: a commented chute with all shapes of section and kinds of segment, or an example.

    A file is never overwritten. The first line of the spec names chute.schema.json, which is written beside it if it is
    not there: editors that know JSON Schema for TOML complete keys and check values with it.
    """
    from chutecalc.spec.examples import SCHEMA_FILE, SCHEMA_LINE, example_text
    from chutecalc.spec.library import LIBRARY_NAME
    from chutecalc.spec.reader import BASELINE_SUFFIX
    from chutecalc.spec.starter import STARTER

    if list_them:
        if file or example:
            raise UsageError("--list lists the examples and writes nothing: give it alone")
        return _list()
    text = STARTER if example is None else example_text(example)
    if file == "":
        raise UsageError("the name of the file is empty: leave it out for the usual one")
    target = file or f"{(example or 'chute').rpartition('/')[2]}.toml"
    if target == STANDARD_STREAM:
        typer.echo(text, nl=False)  # without the line: nobody knows where the schema would have to be
        return 0
    if target.endswith((SCHEMA_FILE, LIBRARY_NAME, BASELINE_SUFFIX)):
        raise UsageError(f"{target} is not the name of a spec, but of a file beside one: choose another")
    with open_new(target) as stream:
        schema = Path(target).with_name(SCHEMA_FILE)
        beside = "" if schema.exists() else f", and {schema} for editors"
        stream.write(SCHEMA_LINE + text)
        if beside:  # before the spec is there: both or none
            _write_schema(str(schema))
    typer.echo(printable(f"wrote {target}{beside}. To run it: chutecalc run {target}"))
    return 0


def _list() -> int:
    """List the examples."""
    from chutecalc.output.catalogue import catalogue
    from chutecalc.output.printer import Printer
    from chutecalc.spec.examples import example_titles

    Printer().table(catalogue(("example", "title"), example_titles().items()))
    return 0


def _write_schema(target: str) -> None:
    """Write the JSON Schema of a spec."""
    from chutecalc.spec.schema import json_schema, schema_text

    with open_new(target) as stream:
        stream.write(schema_text(json_schema()))
