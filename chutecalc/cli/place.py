"""``chutecalc place``: where segments must be drawn so that the stream strikes them as wanted."""

from __future__ import annotations

from typing import TYPE_CHECKING

import typer

from chutecalc.cli.options import LIBRARY
from chutecalc.errors import UsageError
from chutecalc.output.files import open_whole
from chutecalc.output.held import reserve
from chutecalc.output.targets import STANDARD_STREAM, check_targets

if TYPE_CHECKING:
    from chutecalc.studies.place.placement import Placement

EXAMPLES = (
    "chutecalc place chute.toml hood incidence=10 x=1.2 spoon incidence=8 z=-4.5",
    "chutecalc place chute.toml hood incidence=10 x=1.2 share=edges --write",
)
PAGE = "designing.md"


def place(
    spec: str = typer.Argument(..., metavar="SPEC", help="TOML file; - for standard input."),
    arguments: list[str] = typer.Argument(
        ...,
        metavar="SEGMENT WISH...",
        help="A segment and how the stream is to strike it: incidence=DEG, x=M or z=M, and share=SHARE of its length"
        " before the strike, or share=edges, or edges+MARGIN. Then the next segment.",
    ),
    write: bool = typer.Option(False, "--write", help="Write start_m and slope into the spec, comments kept."),
    output: str | None = typer.Option(None, "--output", "-o", metavar="FILE", help="Write the placed spec to a file."),
    json_file: str | None = typer.Option(None, "--json", metavar="FILE", help="Write a JSON document; - for stdout."),
    library: str | None = LIBRARY,
) -> int:
    """Find where segments must be drawn so that the stream strikes them as wanted.

    Incidence and place together give the slope of the surface where the stream strikes it; with one of them alone the
    slope stays as the spec has it. A segment needs a fall before it, and neither a start nor a slope yet. share=edges
    is the least share with which all edges of the stream strike the segment, in all cases.
    """
    from chutecalc.api.load import library_for
    from chutecalc.cli.specs import file_of, read_source
    from chutecalc.output.formats.json import write_document
    from chutecalc.spec.parse import encode, parse_text
    from chutecalc.studies.place.placement import place as placed
    from chutecalc.studies.place.report import placement_dataset
    from chutecalc.studies.place.wish import read_wishes

    if write and (output or spec == STANDARD_STREAM):
        raise UsageError("--write changes the file of the spec: leave out --output, or name a file instead of -")
    check_targets({"--output": output, "--json": json_file}, [spec, library])
    for target in (spec if write else output, json_file):
        reserve(target)
    text, content, source = read_source(spec)
    known = library_for(parse_text(text, source), library, file_of(spec))
    placement = placed(text, read_wishes(arguments), source, known)
    if (target := spec if write else output) is not None:
        with open_whole(target, "wb", read=content if write else None) as stream:
            stream.write(encode(placement.text, like=content))
    if json_file is not None:
        with open_whole(json_file) as stream:
            write_document(stream, placement_dataset(placement))
    if STANDARD_STREAM not in (output, json_file):
        _print(placement, written=target is not None)
    return 0


def _print(placement: Placement, written: bool) -> None:
    """Print how segments are struck, what the spec needs for it, and what a run of the chute has to tell."""
    from chutecalc.output.printer import COLOURS, Printer
    from chutecalc.studies.place.report import drawn_lines, outcome_lines, placement_table, shape_text

    printer = Printer()
    printer.table(placement_table(placement))
    printer.text()
    for each in placement.segments:
        printer.text(f"{each.name}: {shape_text(each)}")
        for line in drawn_lines(each):
            printer.text(f"  {line}")
    if not written:
        printer.text("--write puts this into the spec.")
    printer.text()
    if placement.cases is None:
        printer.text("Other segments have no place yet, so that the whole chute was not solved.")
    else:
        ends = [f"{state} {solution.status[0]}" for state, solution in placement.cases.solutions.items()]
        printer.text(f"status: {', '.join(ends)}")
    for severity, code, where in outcome_lines(placement):
        printer.text(f"{severity} {code}", f"  {where}", COLOURS[severity])
