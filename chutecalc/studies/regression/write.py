"""Baselines as TOML, one number on a line, so that differences are easy to read."""

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from chutecalc.errors import OutputError
from chutecalc.output.files import open_whole
from chutecalc.output.held import hold_folder, is_special, real_file
from chutecalc.printable import printable
from chutecalc.spec.reader import BASELINE_SUFFIX
from chutecalc.studies.regression.record import baseline_path

MOST_HELD = 200
"""Folders that are held at once: a process can open 256 files on some systems."""


def hold_baselines(specs: Iterable[str]) -> None:
    """Keep other processes from updating baselines in the same folders, until the command ends.

    Args:
        specs: paths of their specs.

    Raises:
        OutputError: another process is updating them.
    """
    folders = {os.path.realpath(Path(spec).parent) for spec in specs}
    for folder in sorted(folders)[:MOST_HELD]:
        hold_folder(folder, f"baselines in {folder}")


def write_baseline(spec: str, document: Mapping[str, Any]) -> Path:
    """Write a baseline beside its spec, whole or not at all.

    Args:
        spec: path of the spec.
        document: baseline, from :meth:`~chutecalc.studies.regression.baseline.Baseline.document`.

    Returns:
        The path of the baseline.

    Raises:
        OutputError: the file cannot be opened, or what stands in its place is no baseline.
        WriteError: writing failed.
    """
    import tomli_w

    path = baseline_path(Path(spec))
    there = real_file(str(path))  # where a link leads
    if is_special(path):
        raise OutputError(f"{path} is no file. Remove it, and repeat.")
    if there.exists() and not there.name.endswith(BASELINE_SUFFIX):
        raise OutputError(f"{path} leads to {there}, which is no baseline. Remove it, and repeat.")
    with open_whole(str(path)) as stream:
        name = printable(Path(spec).name)
        stream.write(f"# What came out of {name}, by chutecalc check --update. The tolerance is yours to set.\n")
        stream.write(tomli_w.dumps(document))
    return path
