"""The standard designs as examples to start from: they ship in the package, and in its source are the folder specs."""

import tomllib
from collections.abc import Iterator
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import Path

from chutecalc.errors import UsageError
from chutecalc.spec.reader import BASELINE_SUFFIX

SCHEMA_FILE = "chute.schema.json"
"""Name of the file that a new spec's first line tells editors to read."""
SCHEMA_LINE = f"#:schema ./{SCHEMA_FILE}\n"


@cache
def examples() -> dict[str, Traversable]:
    """Return the files of the standard designs by name, which is their path without its ending.

    >>> "belt_hood_spoon" in examples(), "paper/r1_d30_square" in examples()
    (True, True)
    """
    shipped: Traversable = files("chutecalc") / "examples"
    folder = shipped if shipped.is_dir() else Path(__file__).parents[2] / "specs"
    return dict(_below(folder, "")) if folder.is_dir() else {}


def _below(folder: Traversable, above: str) -> Iterator[tuple[str, Traversable]]:
    """Yield the specs in a folder by name, then those in the folders below."""
    entries = sorted(folder.iterdir(), key=lambda entry: (entry.is_dir(), entry.name))
    for entry in entries:
        if entry.is_dir():
            yield from _below(entry, f"{above}{entry.name}/")
        elif entry.name.endswith(".toml") and not entry.name.endswith(BASELINE_SUFFIX):
            yield f"{above}{entry.name.removesuffix('.toml')}", entry


def example_text(name: str) -> str:
    """Return the text of a standard design.

    Args:
        name: of the design.

    Raises:
        UsageError: there is no such design.

    >>> "[flow]" in example_text("vee")
    True
    """
    if name not in examples():
        from difflib import get_close_matches

        close = get_close_matches(name, examples(), n=1)
        meant = f"Did you mean {close[0]}? " if close else ""
        raise UsageError(f"there is no example {name}. {meant}`chutecalc new --list` lists all.")
    return examples()[name].read_text(encoding="utf-8")


def example_titles() -> dict[str, str]:
    """Return the titles of the standard designs by name."""
    return {name: str(tomllib.loads(example_text(name)).get("title", "")) for name in examples()}
