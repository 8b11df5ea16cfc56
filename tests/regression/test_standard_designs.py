"""The library of standard designs: what it covers, and that each is documented and held by its baseline."""

import re
import tomllib

import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.design import Status
from chutecalc.results.findings import CRITERIA
from chutecalc.sections.registry import SHAPES
from chutecalc.segments.registry import KINDS
from tests.conftest import ROOT, STANDARD_DESIGNS

FAILS = [path for path in STANDARD_DESIGNS if path.parent.name == "fails"]
TABLES = {path: tomllib.loads(path.read_text(encoding="utf-8")) for path in STANDARD_DESIGNS}


def test_all_are_as_their_baselines_say(capsys):
    assert main(["check", str(ROOT / "specs")]) == 0
    assert capsys.readouterr().out == f"{len(STANDARD_DESIGNS)} designs: {len(STANDARD_DESIGNS)} ok\n"


@pytest.mark.parametrize("path", STANDARD_DESIGNS, ids=lambda path: path.stem)
def test_each_has_a_title_and_a_comment_on_what_it_shows(path):
    assert path.read_text(encoding="utf-8").startswith("# ")
    assert TABLES[path]["title"]


def test_every_key_of_a_liner_every_segment_section_inlet_and_law_is_in_one():
    tables = TABLES.values()
    segments = [segment for table in tables for segment in table["segments"]]
    assert {segment["kind"] for segment in segments} == KINDS.keys()
    stems = {key.rsplit("_", 1)[0] for segment in segments for key in segment}
    assert {"drop", "run", "length", "onto", "start", "from_slope"} <= stems
    assert any(isinstance(segment.get("section"), list) for segment in segments)
    shapes = {section["shape"] for table in tables for section in table["sections"].values()}
    assert shapes == SHAPES.keys()
    liners = {key.rsplit("_", 1)[0] for table in tables for liner in table["liners"].values() for key in liner}
    assert liners == {"friction", "yield_locus", "own", "slip", "thickness", "wear_mm3_per"}
    assert {"belt" in table["inlet"] for table in tables} == {True, False}
    assert {table.get("model", {}).get("friction_law", "paper") for table in tables} == {"paper", "equilibrium"}
    assert {"pressure_ratio" in table["material"] for table in tables} == {True, False}
    assert any("receiver" in table for table in tables)


def test_every_outcome_and_every_finding_is_shown_by_one():
    solutions = {path: chutecalc.solve(chutecalc.load(path)) for path in STANDARD_DESIGNS}
    ends = {str(segment.status[0]) for solution in solutions.values() for segment in solution.segments}
    assert ends == set(Status.LABELS)
    states = [chutecalc.solve_cases(chutecalc.load(path)).solutions.values() for path in STANDARD_DESIGNS]
    shown = {finding.code for each in states for solution in each for finding in solution.findings()}
    assert shown == {criterion.code for criterion in CRITERIA} - {"implausible"}  # their units are right
    assert [path for path, solution in solutions.items() if solution.status[0] != "ok"] == FAILS


def test_the_library_lists_each_of_them():
    listed = re.findall(r"\]\(([^)]+\.toml)\)", (ROOT / "specs" / "README.md").read_text(encoding="utf-8"))
    own = [path for path in STANDARD_DESIGNS if path.parent.name != "paper"]
    assert sorted(ROOT / "specs" / name for name in listed) == own
