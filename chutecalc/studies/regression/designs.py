"""The standard designs in files and folders."""

import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from chutecalc.api.chute import Chute
from chutecalc.api.load import library_for
from chutecalc.errors import AllSpecsError, Fault, SpecError, UsageError
from chutecalc.spec.parse import parse_text, read_text
from chutecalc.spec.reader import BASELINE_SUFFIX
from chutecalc.studies.regression.record import baseline_path, spec_path

MARKS = {"flow", "segments"}
"""Tables of which a spec has at least one, and the settings of a project none."""


class Designs(NamedTuple):
    """Designs that were found."""

    chutes: list[Chute]
    """Chutes of one design each, whose sources are the paths of their specs."""
    orphaned: list[Path]
    """Baselines without a spec."""


def find_designs(paths: Iterable[str], library: str | None = None) -> Designs:
    """Read and check the designs in files and folders, each once, in the order given.

    In a folder these are all TOML files at any depth that have a baseline beside them, or a table ``flow`` or
    ``segments``. Folders whose names begin with a dot are skipped. A baseline stands for its spec.

    Args:
        paths: Specs, baselines and folders.
        library: File of the materials and liners that specs may use; else the one beside each.

    Raises:
        AllSpecsError: All faults of all specs.
        UsageError: A path does not exist, or there is no spec.

    >>> import chutecalc
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     size = Path(folder, "spoon.toml").write_text(chutecalc.STARTER, encoding="utf-8")
    ...     print([Path(chute.source).name for chute in find_designs([folder]).chutes])
    ['spoon.toml']
    """
    chutes: list[Chute] = []
    errors: list[SpecError] = []
    orphaned: list[Path] = []
    given = list(paths)
    for file, named in _files(given):
        if file.name.endswith(BASELINE_SUFFIX) and os.path.exists(file):
            orphaned.append(file)
            continue
        try:
            chute = _read(file, named or os.path.exists(baseline_path(file)), library)
        except SpecError as error:
            errors.append(error)
        else:
            chutes += [chute] if chute else []
    if errors:
        raise AllSpecsError(errors)
    if not chutes and not orphaned:
        raise UsageError(f"there is no spec in {', '.join(given)}. Name a spec, or a folder that contains one")
    return Designs(chutes, orphaned)


def _files(paths: Iterable[str]) -> Iterator[tuple[Path, bool]]:
    """Yield TOML files, and whether they were named themselves; a baseline only where its spec does not exist."""
    met: set[str] = set()
    for path in map(Path, paths):
        for file in _below(path) if os.path.isdir(path) else [path]:
            if file.name.endswith(BASELINE_SUFFIX):
                spec = spec_path(file)
                file = spec if os.path.exists(spec) else file
            if (real := os.path.realpath(file)) not in met:
                met.add(real)
                yield file, file == path


def _below(folder: Path) -> Iterator[Path]:
    """Yield the TOML files in a folder at any depth, in order."""
    for here, folders, files in os.walk(folder):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        yield from (Path(here, name) for name in sorted(files) if name.endswith(".toml"))


def _read(file: Path, sure: bool, library: str | None) -> Chute | None:
    """Read a design, or None from TOML that need not be a spec and is not."""
    if not os.path.exists(file) and file.suffix != ".toml":
        raise SpecError([Fault("", "there is no such file or folder", "check the name")], str(file))
    text = read_text(file)
    data = parse_text(text, str(file))
    if not (sure or MARKS & data.keys()):
        return None
    return Chute(data, str(file), text, library=library_for(data, library, file))
