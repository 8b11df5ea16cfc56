"""Verdicts on standard designs: for people, as a dataset for files, and as JUnit XML."""

import math
from collections import Counter
from collections.abc import Sequence
from typing import IO, Any
from xml.etree import ElementTree

from chutecalc.output.dataset import Dataset, block_of
from chutecalc.output.grid import GAP, Grid
from chutecalc.output.printer import Printer
from chutecalc.printable import printable
from chutecalc.results.columns import COLUMNS
from chutecalc.results.described import status_words
from chutecalc.studies.regression.verdict import NO_BASELINE, OK, Drift, Verdict, first_and_largest

ROW_COLUMNS: dict[str, type] = {
    "spec": str,
    "outcome": str,
    "tolerance": float,
    "segment": str,
    "visit": int,
    "row": str,
    "column": str,
    "s_m": float,
    "was": float,
    "is": float,
    "off_by": float,
}
"""Columns of the rows, in order."""


def print_verdicts(printer: Printer, verdicts: Sequence[Verdict], written: Sequence[str]) -> None:
    """Print the verdicts.

    Args:
        printer: where to print.
        verdicts: one for each design. Those that do not pass are printed with a table of what drifted.
        written: baselines that were written.
    """
    for verdict in verdicts:
        if verdict.outcome != OK and not (verdict.outcome == NO_BASELINE and verdict.document):
            _print_failing(printer, verdict)
    notes = Counter(note for verdict in verdicts if verdict.outcome == OK for note in verdict.notes)
    for note, count in notes.items():
        printer.text(f"{note}: {_designs(count)} unchanged")
    for path in written:
        printer.text(f"wrote {path}")
    counts = Counter("written" if verdict.document else status_words(verdict.outcome) for verdict in verdicts)
    parts = [
        f"{counts[word]} {word}" for word in sorted(counts, key=lambda word: (word != OK, word == "written", word))
    ]
    printer.text(f"{_designs(len(verdicts))}: {', '.join(parts)}")


def _print_failing(printer: Printer, verdict: Verdict) -> None:
    """Print a design that does not pass."""
    heading = f"{verdict.spec}: {status_words(verdict.outcome)}"
    lines = verdict.lines
    if len(lines) == 1 and not verdict.drifts:
        printer.text(heading, f": {lines[0]}", "bold red")
        return
    printer.text(heading, f" (tolerance {verdict.tolerance:g})" if verdict.drifts else "", "bold red")
    for line in lines:
        printer.text(f"  {line}")
    if verdict.drifts:
        printer.table(_drifts(verdict))


def _drifts(verdict: Verdict) -> Grid:
    """Return a row for each column that drifted: its first drift along the chute, and its largest."""
    table = Grid(indent=GAP)
    for heading in ("column", "was", "is", "drift", "largest at", "first at"):
        table.column(heading, left=heading in ("column", "first at", "largest at"), label=heading == "column")
    for first, most in first_and_largest(verdict.drifts):
        table.row([most.column, *_values(most), f"{most.off:.1e}", _where(most), _where(first)])
    return table


def _where(drift: Drift) -> str:
    """Return the segment of a drift, with the row unless that is a station, and its distance s."""
    row = "" if drift.key.row.startswith("station") else drift.key.row
    s = "" if drift.s_m is None else f", s = {COLUMNS['s_m'].shown(drift.s_m, 'metric')} m"
    return f"{drift.key.segment} {row}".rstrip() + s


def _values(drift: Drift) -> tuple[str, str]:
    """Return both values, with enough digits to show the difference."""
    digits = min(max(2 - math.floor(math.log10(drift.off)), 4), 16)
    was, now = ("none" if value is None else f"{value:z.{digits}g}" for value in (drift.was, drift.now))
    return was, now


def _designs(count: int) -> str:
    return f"{count} design{'s' if count != 1 else ''}"


def _document(verdict: Verdict) -> dict[str, Any]:
    """Return a verdict as an object, with each number that drifted."""
    return {
        "spec": verdict.spec,
        "outcome": verdict.outcome,
        "tolerance": verdict.tolerance,
        "notes": list(verdict.notes),
        "changes": [change._asdict() for change in verdict.changes],
        "drifts": [_drift(drift) for drift in verdict.drifts],
    }


def _drift(drift: Drift) -> dict[str, Any]:
    """Return a drift as an object."""
    return drift.key._asdict() | {
        "column": drift.column,
        "s_m": drift.s_m,
        "was": drift.was,
        "is": drift.now,
        "off_by": drift.off,
    }


def check_dataset(verdicts: Sequence[Verdict], rtol: float) -> Dataset:
    """Return a row for each number that drifted, and one for each design without drift.

    Args:
        verdicts: one for each design.
        rtol: relative tolerance that the designs were solved to, for the document.
    """
    rows = [
        {"spec": verdict.spec, "outcome": verdict.outcome, "tolerance": verdict.tolerance} | drift
        for verdict in verdicts
        for drift in (map(_drift, verdict.drifts) if verdict.drifts else [{}])
    ]
    asked = {"tolerance": rtol}
    blocks = [block_of(rows, ROW_COLUMNS)]
    return Dataset("check", ROW_COLUMNS, blocks, asked, lambda: asked | {"designs": [*map(_document, verdicts)]})


def write_junit(stream: IO[str], verdicts: Sequence[Verdict]) -> None:
    """Write the verdicts as CI systems read tests: a case for each design, with a failure if it does not pass.

    Args:
        stream: where to write.
        verdicts: one for each design.
    """
    fails = sum(verdict.outcome != OK for verdict in verdicts)
    total = {"tests": str(len(verdicts)), "failures": str(fails), "errors": "0", "skipped": "0"}
    total["time"] = f"{sum(verdict.seconds for verdict in verdicts):.3f}"
    root = ElementTree.Element("testsuites", total)
    suite = ElementTree.SubElement(root, "testsuite", {"name": "chutecalc check"} | total)
    for verdict in verdicts:
        name = printable(verdict.spec)  # XML allows all of this
        case = {"classname": "chutecalc.check", "name": name, "file": name}
        element = ElementTree.SubElement(suite, "testcase", case | {"time": f"{verdict.seconds:.3f}"})
        if verdict.outcome != OK:
            lines = [*verdict.lines, *(_line(*pair) for pair in first_and_largest(verdict.drifts))]
            lines = [printable(line) for line in lines]
            failure = {"type": verdict.outcome, "message": f"{status_words(verdict.outcome)}: {lines[0]}"}
            ElementTree.SubElement(element, "failure", failure).text = "\n".join(lines)
    ElementTree.indent(root)
    stream.write('<?xml version="1.0" encoding="utf-8"?>\n')
    stream.write(ElementTree.tostring(root, encoding="unicode"))
    stream.write("\n")


def _line(first: Drift, most: Drift) -> str:
    """Return the first and the largest drift of a column, in a line."""
    begin, end = _where(first), _where(most)
    was, now = _values(most)
    return f"{most.column}: first drift at {begin}; largest at {end}: {now}, was {was} (drift {most.off:.1e})"
