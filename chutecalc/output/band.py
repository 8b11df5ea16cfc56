"""The band of a chute's own assumptions: for people, and as part of a document."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from chutecalc.output.dataset import number
from chutecalc.output.grid import Grid
from chutecalc.results.band import COLUMNS, NOTE, Band, Range, Ranges
from chutecalc.results.column import quantity_text
from chutecalc.results.columns import COLUMNS as CATALOGUE
from chutecalc.results.segments import SegmentResult

if TYPE_CHECKING:
    from chutecalc.output.printer import Printer

ROWS = {"in": "entry", "out": "exit", "min": "minimum", "max": "maximum"}
"""Rows of each segment, by their labels."""
MISSED = (
    "the steel stands where the stream of the spec needs it: give the segment a place that catches the others too, or"
    ' see what they would do with steel = "follows_stream"'
)
"""What to do where variants miss a segment."""
BEYOND = 1e-6
"""Relative difference by which an extreme is beyond both ends, so that it has a row."""


def print_band(printer: Printer, band: Band) -> None:
    """Print the band: a table beside that of the stream, and what it is.

    Args:
        printer: where to.
        band: of one chute.
    """
    printer.text()
    printer.table(band_table(band, printer.units))
    printer.text()
    for line in band_lines(band, printer.units):
        printer.text("band", f"  {line}")


def band_table(band: Band, units: str) -> Grid:
    """Return velocity and depth of the chute as written, each with the least and the largest of all variants.

    Args:
        band: of one chute.
        units: ``metric`` or ``us``.
    """
    table = Grid(f"band over {len(band.variants)} variants of the model")
    for label in ("segment", ""):
        table.column(label, left=True, label=True)
    for name in COLUMNS:
        column = CATALOGUE[name]
        for words in (column.heading, "least", "largest"):
            table.column(f"{words}\n{column.unit_text(units)}")
    for segment in band.solution.segments:
        if segment.status[0] == "not_reached":
            continue
        shown = segment.name
        for label, row in ROWS.items():
            own, ranges = getattr(segment, row), band.segments[segment.name][row]
            if row in ("minimum", "maximum") and not _beyond_ends(segment, row):
                continue
            cells: list[str] = []
            for name in COLUMNS:
                cells += (CATALOGUE[name].shown(value, units) for value in (float(own[name][0]), *ranges[name]))
            if any(cells):
                table.row([shown, label, *cells])
                shown = ""
    return table


def _beyond_ends(segment: SegmentResult, row: str) -> bool:
    """Return whether an extreme of the chute as written lies beyond both ends of the segment."""
    sign = 1.0 if row == "maximum" else -1.0
    for name in COLUMNS:
        extreme = sign * getattr(segment, row)[name][0]
        ends = [sign * of[name][0] for of in (segment.entry, segment.exit)]
        if all(extreme - end > BEYOND * abs(extreme) for end in ends):
            return True
    return False


def band_lines(band: Band, units: str) -> Iterator[str]:
    """Yield what the band is, and where it ends for some of the variants.

    Args:
        band: of one chute.
        units: ``metric`` or ``us``.
    """
    factors, ratios = (sorted(set(numbers)) for numbers in zip(*band.variants, strict=True))
    yield (
        f"over momentum factors α_m {_listed(factors)} and longitudinal pressure ratios K_l {_listed(ratios)}: {NOTE}"
    )
    if band.solution.ok[0]:
        yield _exit_text(band, units)
    for stop in band.stops:
        names = "; ".join(str(variant) for variant in stop.variants)
        yield (
            f"ends for {len(stop.variants)} of {len(band.variants)} variants on {stop.segment}, {stop.status} at s ="
            f" {_from_to('s_m', stop.s_m, units)}, and holds without them from there on: {names}"
            + (f"; {MISSED}" if stop.status == "missed" else "")
        )


def exit_line(band: Band, units: str) -> str:
    """Return the band at the exit in a line for a report, of a chute that gets through.

    Args:
        band: of one chute.
        units: ``metric`` or ``us``.
    """
    ends = sum(len(stop.variants) for stop in band.stops)
    fails = f"; {ends} of {len(band.variants)} variants do not get through" if ends else ""
    return f"{_exit_text(band, units)}, by what the model leaves open{fails} (--band)"


def _exit_text(band: Band, units: str) -> str:
    """Return the ranges of velocity and depth at the exit."""
    known = {name: ends for name, ends in band.exit.items() if ends.least == ends.least}
    return (
        f"exit {', '.join(f'{CATALOGUE[name].heading} {_from_to(name, ends, units)}' for name, ends in known.items())}"
    )


def band_document(band: Band) -> dict[str, Any]:
    """Return the band as an object.

    Args:
        band: of one chute.
    """
    return {
        "note": NOTE,
        "variants": [variant._asdict() for variant in band.variants],
        "exit": _ranges(band.exit),
        "segments": [
            {"name": name, **{row: _ranges(ranges) for row, ranges in rows.items()}}
            for name, rows in band.segments.items()
        ],
        "ends": [
            {
                "status": stop.status,
                "segment": stop.segment,
                "s_m": _range(stop.s_m),
                "variants": [variant._asdict() for variant in stop.variants],
            }
            for stop in band.stops
        ],
    }


def _ranges(ranges: Ranges) -> dict[str, Any]:
    return {name: _range(ends) for name, ends in ranges.items()}


def _range(ends: Range) -> dict[str, Any]:
    return {"least": number(ends.least), "largest": number(ends.largest)}


def _listed(numbers: list[float]) -> str:
    return ", ".join(f"{each:.4g}" for each in numbers)


def _from_to(name: str, ends: Range, units: str) -> str:
    """Return a range with its unit; one number where both ends look alike."""
    least, largest = (quantity_text(name, end, units) for end in ends)
    return least if least == largest else f"{least} to {largest}"
