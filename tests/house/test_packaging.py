"""What pyproject.toml and CITATION.cff say of the package agrees with the package."""

import re
import tomllib
from pathlib import Path

import pytest

from chutecalc import extras
from chutecalc.extras import Extra

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
OWN = {"bench", "docs", "test"}
"""Extras for those who work on the package, which no message advises."""
CATALOGUE = [extra for extra in vars(extras).values() if isinstance(extra, Extra)]


def packages(name):
    """Return what an extra installs, without versions."""
    return [re.split(r"[>=;<~! ]", item)[0] for item in PROJECT["optional-dependencies"][name]]


@pytest.mark.parametrize("extra", CATALOGUE, ids=lambda extra: extra.name)
def test_messages_advise_what_the_extra_installs(extra):
    if extra.name != "polars":  # only tests install it
        assert extra.package in packages(extra.name)
    assert extra.package in packages("test") or extra.name == "dem"


def test_every_extra_is_in_the_catalogue():
    assert {extra.name for extra in CATALOGUE} - {"polars"} == set(PROJECT["optional-dependencies"]) - OWN


def test_no_message_advises_what_no_index_has():
    for path in Path(ROOT, "chutecalc").rglob("*.py"):
        assert not re.search(r"pip install '?chutecalc", path.read_text(encoding="utf-8")), path
