"""Which designs a folder holds."""

import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from chutecalc.api.chute import Chute
from chutecalc.errors import AllSpecsError, SpecError, UsageError
from chutecalc.spec.parse import BASELINE_SUFFIX, parse_text, read_text
from chutecalc.studies.regression.baseline import baseline_path, spec_path

MARKS = {"flow", "segments"}
"""Tables of which a chute's spec has one at least, and the settings of a project none."""


class Designs(NamedTuple):
    """What was found."""

    chutes: list[Chute]
    orphaned: list[Path]
    """Baselines whose spec is gone."""


def find_designs(paths: Iterable[str]) -> Designs:
    """The designs that files and folders hold, read and checked, in the order given; each once.

    Of a folder these are all TOML files below it that have a baseline beside them, or a flow or segments in them;
    folders whose name begins with a dot are passed over. A baseline stands for its spec.

    Raises:
        SpecError: all faults of all of them.
        UsageError: a path that leads nowhere, or nothing found.
    """
    chutes: list[Chute] = []
    errors: list[SpecError] = []
    orphaned: list[Path] = []
    given = list(paths)
    for file, named in _files(given):
        if file.name.endswith(BASELINE_SUFFIX) and file.exists():
            orphaned.append(file)
            continue
        try:
            chute = _read(file, named or baseline_path(file).exists())
        except SpecError as error:
            errors.append(error)
        else:
            chutes += [chute] if chute else []
    if errors:
        raise AllSpecsError(errors)
    if not chutes and not orphaned:
        raise UsageError(f"there is no spec in {', '.join(given)}: name one, or the folder that it is in")
    return Designs(chutes, orphaned)


def _files(paths: Iterable[str]) -> Iterator[tuple[Path, bool]]:
    """TOML files, and whether they were named themselves; a baseline only where its spec is gone."""
    met: set[str] = set()
    for path in map(Path, paths):
        for file in _below(path) if path.is_dir() else [path]:
            if file.name.endswith(BASELINE_SUFFIX):
                spec = spec_path(file)
                file = spec if spec.exists() else file
            if (real := os.path.realpath(file)) not in met:
                met.add(real)
                yield file, file == path


def _below(folder: Path) -> Iterator[Path]:
    """The TOML files of a folder and of those in it, in order."""
    for here, folders, files in os.walk(folder):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        yield from (Path(here, name) for name in sorted(files) if name.endswith(".toml"))


def _read(file: Path, sure: bool) -> Chute | None:
    """A design, or None for TOML that is no spec and need not be one."""
    text = read_text(file)
    data = parse_text(text, str(file))
    return Chute(data, str(file), text) if sure or MARKS & data.keys() else None
