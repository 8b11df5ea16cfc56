"""Chutes read from files, text or tables."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from chutecalc.api.chute import Chute
from chutecalc.errors import Fault, SpecError
from chutecalc.spec.parse import parse_text, read_text
from chutecalc.spec.paths import with_values


def load(path: str | Path, changes: Mapping[str, Any] | None = None) -> Chute:
    """Read a chute from a TOML file.

    Args:
        path: of the file.
        changes: values or text by spec path, in the unit of the path. They are put in before the spec is checked, so
            they may be what the file lacks.

    Raises:
        SpecError: the file cannot be read, or its spec has faults; the error lists all of them.
    """
    file = Path(path)
    return parse(read_text(file), str(file), changes)


def parse(spec: str | Mapping[str, Any], source: str = "spec", changes: Mapping[str, Any] | None = None) -> Chute:
    """Read a chute from the text of a spec, or from its nested tables.

    Args:
        spec: TOML text, or the tables that ``tomllib`` reads from it.
        source: name of the spec in messages.
        changes: as for :func:`load`.

    Raises:
        SpecError: the spec has faults; the error lists all of them.

    >>> import chutecalc
    >>> chutecalc.parse(chutecalc.STARTER, source="spoon.toml").source
    'spoon.toml'
    """
    if not isinstance(spec, str | Mapping):
        raise SpecError([Fault("", f"is a {type(spec).__name__}", "give TOML text or a table")], source)
    text = spec if isinstance(spec, str) else ""
    data = parse_text(spec, source) if isinstance(spec, str) else dict(spec)
    chute = Chute(with_values(data, dict(changes), source) if changes else data, source, text)
    return checked(chute)


def checked(chute: Chute) -> Chute:
    """Return a chute whose cases and uncertainty have no faults either.

    Args:
        chute: the chute.

    Raises:
        SpecError: they have; the error lists all faults.
    """
    faults: list[Fault] = []
    for table, read in (("cases", lambda: chute.cases), ("uncertainty", lambda: chute.uncertain)):
        try:
            if getattr(chute.spec, table):
                read()  # their faults are those of the spec
        except SpecError as error:
            faults += error.faults
    if faults:
        raise SpecError(sorted(faults, key=lambda fault: fault.line or 0), chute.source)
    return chute
