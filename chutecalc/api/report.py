"""Reports of chutes, for a client to read, print and sign."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path

from chutecalc.api.band import solve_band
from chutecalc.api.cases import solve_cases
from chutecalc.api.chute import Chute, check_chute
from chutecalc.errors import ChutecalcError, SpecError, UsageError
from chutecalc.results.band import Band
from chutecalc.results.cases import Cases
from chutecalc.results.column import Units
from chutecalc.spec.library import is_used
from chutecalc.spec.parse import decode, parse_text
from chutecalc.spec.reader import read_bytes


def write_report(file: str, *chutes: Chute, units: str = "metric", rtol: float = 1e-10) -> None:
    """Solve a chute and write a report of it, or of several one that compares them.

    Args:
        file: its path; the ending ``.html`` or ``.pdf`` gives the format.
        *chutes: at least one, of one design each.
        units: ``metric`` or ``us``.
        rtol: relative error allowed to the velocity, dimensionless, as for :func:`chutecalc.solve`.

    Raises:
        UsageError: there is no chute, one has several designs, or the ending or the units are others.
        ExtraMissingError: Jinja2, Matplotlib, or for PDF WeasyPrint is not installed.
        SpecError: as for :func:`chutecalc.solve`.
        OutputError: the file cannot be written.

    >>> import chutecalc, tempfile
    >>> chute = chutecalc.parse(chutecalc.STARTER)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     chutecalc.write_report(f"{folder}/spoon.html", chute)
    """
    from chutecalc.output.html_report.write import check_report

    check_report(file)
    if units not in list(Units):
        raise UsageError(f"units must be {' or '.join(Units)}, not {units!r}")
    if not chutes:
        raise UsageError("a report needs at least one chute")
    for chute in chutes:
        check_chute(chute)
    if several := [chute for chute in chutes if chute.count != 1]:
        count = several[0].count
        raise UsageError(f"a report is that of one design, and a chute has {count}: take one with `chute.put`")
    cases = [solve_cases(chute, rtol) for chute in chutes]
    write_solved(file, chutes, cases, lambda number: band_or_none(chutes[number], rtol), units)


def write_solved(
    file: str,
    chutes: Sequence[Chute],
    cases: Sequence[Cases],
    band: Callable[[int], Band | None],
    units: str,
    settings: Sequence[str] = (),
) -> None:
    """Write the report of chutes that are solved.

    Args:
        file: its path; the ending gives the format.
        chutes: of one design each.
        cases: the same, solved in all their states.
        band: returns the band of a chute by its number from 0, None where it cannot be solved. It is asked for those
            that get through: the stream of others ends here and there, so that their shares do not compare.
        units: ``metric`` or ``us``.
        settings: keys that were changed for this run, as ``PATH=VALUE``.
    """
    from hashlib import sha256

    from chutecalc.output.html_report.reported import Reported
    from chutecalc.output.html_report.write import write_report

    reported = [
        Reported(
            states,
            sha256(_content(chute)).hexdigest() if chute.text else "",
            chute.library.source if chute.library and is_used(chute.written) else "",
            tuple(settings) or _changed(chute),
            band(number) if states.main_solution.ok[0] else None,
        )
        for number, (chute, states) in enumerate(zip(chutes, cases, strict=True))
    ]
    write_report(file, reported, units)


def _content(chute: Chute) -> bytes:
    """Return the content of a chute's file, if that still is what was read; else its text as UTF-8."""
    with suppress(ChutecalcError):
        content = read_bytes(Path(chute.source))
        if decode(content, chute.source) == chute.text:
            return content
    return chute.text.encode()


def _changed(chute: Chute) -> tuple[str, ...]:
    """Return what a report says of a chute that is not the one of its text; nothing where it is."""
    same = not chute.text or parse_text(chute.text, chute.source) == chute.written
    return () if same else ("keys that a program has changed: the inputs are as solved, not as in the spec",)


def band_or_none(chute: Chute, rtol: float = 1e-10) -> Band | None:
    """Return the band of a chute; None where steel that follows the stream cannot be drawn for every variant.

    Args:
        chute: of one design.
        rtol: relative error allowed to the velocity, dimensionless.
    """
    try:
        return solve_band(chute, rtol)
    except SpecError:
        return None
