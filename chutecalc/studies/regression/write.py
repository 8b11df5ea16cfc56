"""Baselines as TOML, one number on a line, so that differences are easy to read."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from chutecalc.output.files import open_whole
from chutecalc.printable import printable
from chutecalc.studies.regression.record import baseline_path


def write_baseline(spec: str, document: Mapping[str, Any]) -> Path:
    """Write a baseline beside its spec, whole or not at all.

    Args:
        spec: path of the spec.
        document: baseline, from :meth:`~chutecalc.studies.regression.baseline.Baseline.document`.

    Returns:
        The path of the baseline.

    Raises:
        OutputError: the file cannot be opened.
        WriteError: writing failed.
    """
    import tomli_w

    path = baseline_path(Path(spec))
    with open_whole(str(path)) as stream:
        name = printable(Path(spec).name)
        stream.write(f"# What came out of {name}, by chutecalc check --update. The tolerance is yours to set.\n")
        stream.write(tomli_w.dumps(document))
    return path
