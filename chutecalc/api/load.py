"""Chutes read from files, text or tables."""

import os
from collections.abc import Mapping
from pathlib import Path
from reprlib import repr as short
from typing import Any

from chutecalc.api.chute import Chute, check_changes
from chutecalc.errors import Fault, SpecError, UsageError
from chutecalc.spec.bounded import excess_of_tables
from chutecalc.spec.library import LIBRARY_NAME, Library, is_used
from chutecalc.spec.parse import parse_text, read_text
from chutecalc.spec.paths import with_values


def load(path: str | Path, changes: Mapping[str, Any] | None = None, library: str | Path | None = None) -> Chute:
    """Read a chute from a TOML file.

    Args:
        path: of the file.
        changes: values or text by spec path, in the unit of the path. They are put in before the spec is checked, so
            they may be what the file lacks.
        library: file of the materials and liners that the spec may use; without it ``chute-library.toml`` beside the
            spec, if there is one.

    Raises:
        SpecError: the file cannot be read, or its spec has faults; the error lists all of them.
        UsageError: ``path`` is no path, or ``changes`` are no values by path.
    """
    check_path(path, "path")
    file = Path(path)
    return read(read_text(file), str(file), changes, library, file)


def parse(
    spec: str | Mapping[str, Any],
    source: str = "spec",
    changes: Mapping[str, Any] | None = None,
    library: str | Path | None = None,
) -> Chute:
    """Read a chute from the text of a spec, or from its nested tables.

    Args:
        spec: TOML text, or the tables that ``tomllib`` reads from it.
        source: name of the spec in messages.
        changes: as for :func:`load`.
        library: file of the materials and liners that the spec may use.

    Raises:
        SpecError: the spec has faults; the error lists all of them.
        UsageError: ``changes`` are no values by path.

    >>> import chutecalc
    >>> chutecalc.parse(chutecalc.STARTER, source="spoon.toml").source
    'spoon.toml'
    """
    return read(spec, source, changes, library)


def check_path(given: Any, what: str) -> None:
    """Check that something can be the path of a file.

    Args:
        given: what is given.
        what: it is, for the message.

    Raises:
        UsageError: it cannot.
    """
    if not isinstance(given, str | os.PathLike):
        raise UsageError(f"{what} must be the path of a TOML file, not {short(given)}")


def read(
    spec: str | Mapping[str, Any],
    source: str,
    changes: Mapping[str, Any] | None = None,
    library: str | Path | None = None,
    file: Path | None = None,
) -> Chute:
    """Read a chute as :func:`parse` does, and know where its spec stands.

    Args:
        spec: as there.
        source: as there.
        changes: as there.
        library: as there.
        file: of the spec, beside which its library may be; None if it is in no file.

    Raises:
        SpecError: the spec or its library has faults.
    """
    if not isinstance(spec, str | Mapping):
        raise SpecError([Fault("", f"is {short(spec)}", "give TOML text or a table")], source)
    text = spec if isinstance(spec, str) else ""
    data = parse_text(spec, source) if isinstance(spec, str) else dict(spec)
    given = check_changes(changes) if changes else {}
    if fault := excess_of_tables([None if text else data, *given.values()]):
        raise SpecError([fault], source)
    changed = with_values(data, dict(given), source) if given else data
    return checked(Chute(changed, source, text, library=library_for(changed, library, file)))


def library_for(
    data: Mapping[str, Any], given: str | Path | Library | None, file: Path | None = None
) -> Library | None:
    """Return the library of a spec; None if there is none, or none is used.

    Args:
        data: tables of the spec.
        given: the library, its file, or None.
        file: of the spec, beside which the library may be, or None.

    Raises:
        SpecError: the library has faults.
    """
    beside = file.with_name(LIBRARY_NAME) if given is None and file and is_used(data) else None
    path = beside if beside and os.path.exists(beside) else given
    if path is None or isinstance(path, Library):
        return path
    check_path(path, "library")
    from chutecalc.spec.library_file import read_library  # what most runs do not need

    return read_library(path)


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
