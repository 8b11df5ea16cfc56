"""Baselines as TOML, a number a line, so that a difference reads well."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from chutecalc.output.files import open_whole
from chutecalc.studies.regression.baseline import baseline_path


def write_baseline(spec: str, document: Mapping[str, Any]) -> Path:
    """Writes a :meth:`~chutecalc.studies.regression.baseline.Baseline.document` beside its spec, whole or not at all.

    Returns:
        Its path.

    Raises:
        OutputError: it cannot be opened.
        WriteError: it was opened, and then could not be written.
    """
    import tomli_w

    path = baseline_path(Path(spec))
    with open_whole(str(path)) as stream:
        stream.write(
            f"# What came out of {Path(spec).name}, by chutecalc check --update. The tolerance is yours to set.\n"
        )
        stream.write(tomli_w.dumps(document))
    return path
