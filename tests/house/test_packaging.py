"""What pyproject.toml and CITATION.cff say of the package agrees with the package."""

import re
import tomllib
from pathlib import Path

import pytest

import chutecalc
from chutecalc import extras
from chutecalc.extras import Extra

ROOT = Path(__file__).parents[2]
TOML = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
PROJECT, TOOLS = TOML["project"], TOML["tool"]
CITATION = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
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


def test_licence_and_versions_of_python_are_what_is_built_and_tested():
    assert PROJECT["license"] == "MIT"  # an expression of SPDX, as setuptools from 77 on writes it
    assert not [each for each in PROJECT["classifiers"] if each.startswith("License ::")]  # PyPI refuses both
    built = TOOLS["cibuildwheel"]["build"].replace("cp3", "3.").replace("-*", "").split()
    prefix = "Programming Language :: Python :: 3."
    assert [f"3.{each.removeprefix(prefix)}" for each in PROJECT["classifiers"] if each.startswith(prefix)] == built
    assert PROJECT["requires-python"] == f">={built[0]}"
    matrix = re.search(r"python: \[(.*)\]", (ROOT / ".github/workflows/tests.yml").read_text(encoding="utf-8"))
    assert matrix
    assert [each.strip(' "') for each in matrix[1].split(",")] == built


def test_addresses_are_left_to_be_filled_in():
    assert "urls" not in PROJECT
    lines = (ROOT / "pyproject.toml").read_text(encoding="utf-8").splitlines()
    ready = [line.removeprefix("# ") for line in lines[lines.index("# [project.urls]") :]]
    urls = tomllib.loads("\n".join(ready[: ready.index("")]))["project"]["urls"]
    assert {*urls} <= {"Homepage", "Documentation", "Source", "Issues", "Changelog"}  # well-known labels of PyPI
    assert {*urls.values()} == {"https://"}  # no invented host


def test_citation():
    cited = CITATION.splitlines()
    entries = dict(line.split(": ", 1) for line in cited if line[:1].isalpha() and ": " in line)
    assert entries["version"] == chutecalc.__version__
    assert entries["license"] == PROJECT["license"]
    assert entries["cff-version"] == "1.2.0"
    assert entries["title"] == PROJECT["name"]
    assert {line.removesuffix(":") for line in cited if re.fullmatch(r"[a-z-]+:", line)} == {"authors", "references"}
    assert f"  - name: {PROJECT['authors'][0]['name']}" in cited
    assert {"message", "type", "abstract"} <= {*entries}
    assert not re.search("[\\t]", CITATION)


def test_no_message_advises_what_no_index_has():
    for path in Path(ROOT, "chutecalc").rglob("*.py"):
        assert not re.search(r"pip install '?chutecalc", path.read_text(encoding="utf-8")), path
