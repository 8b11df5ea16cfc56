"""``chutecalc place``: where segments must be drawn so that the stream strikes them as wanted."""

from __future__ import annotations

import typer

from chutecalc.errors import UsageError
from chutecalc.output.files import STANDARD_STREAM, check_openable, check_targets, open_whole

EXAMPLES = (
    "chutecalc place chute.toml hood incidence=10 x=1.2 spoon incidence=8 z=-4.5",
    "chutecalc place chute.toml hood incidence=10 x=1.2 share=0.2 --write",
)


def place(
    spec: str = typer.Argument(..., metavar="SPEC", help="TOML file; - for standard input."),
    arguments: list[str] = typer.Argument(
        ...,
        metavar="SEGMENT WISH...",
        help="A segment and how the stream is to strike it: incidence=DEG, x=M or z=M, and share=SHARE of its length"
        " before the strike. Then the next segment.",
    ),
    write: bool = typer.Option(False, "--write", help="Write start_m and slope into the spec, comments kept."),
    output: str | None = typer.Option(None, "--output", "-o", metavar="FILE", help="Write the placed spec to a file."),
    json_file: str | None = typer.Option(None, "--json", metavar="FILE", help="Write a JSON document; - for stdout."),
) -> int:
    """Find where segments must be drawn so that the stream strikes them as wanted.

    Incidence and place together give the slope of the surface where the stream strikes it; with one of them alone the
    slope stays as the spec has it. A segment needs a fall before it, and neither a start nor a slope yet.
    """
    from chutecalc.cli.specs import read_source
    from chutecalc.output.formats.json import write_document
    from chutecalc.output.printer import Printer
    from chutecalc.spec.parse import encode
    from chutecalc.studies.place.placement import place as placed
    from chutecalc.studies.place.report import placement_document, placement_table
    from chutecalc.studies.place.wish import read_wishes

    if write and (output or spec == STANDARD_STREAM):
        raise UsageError("--write changes the file of the spec: leave out --output, or name a file instead of -")
    check_targets({"--output": output, "--json": json_file}, [spec])
    for target in (spec if write else output, json_file):
        check_openable(target)
    text, content, source = read_source(spec)
    placement = placed(text, read_wishes(arguments), source)
    if (target := spec if write else output) is not None:
        with open_whole(target, "wb") as stream:
            stream.write(encode(placement.text, like=content))
    if json_file is not None:
        with open_whole(json_file) as stream:
            write_document(stream, placement_document(placement))
    if STANDARD_STREAM not in (output, json_file):
        printer = Printer()
        printer.table(placement_table(placement))
        if target is None:
            printer.text()
            for each in placement.segments:
                slopes = (f"{key} = {value!r}" for key, value in each.slopes.items())
                printer.text(f"{each.name}: start_m = {list(each.start_m)}, {', '.join(slopes)}")
            printer.text("--write puts this into the spec.")
    return 0
