"""What objects say of themselves in an interpreter and a notebook."""

import numpy as np
import pytest

import chutecalc
from tests.conftest import LEVEL, ROOT, chute


@pytest.fixture(scope="module")
def spoon():
    return chutecalc.parse(LEVEL)


def test_public_names_are_listed():
    assert {"load", "parse", "solve", "exits", "Chute", "Solution"} <= set(dir(chutecalc))


def test_segments_go_by_name_and_by_number(spoon):
    segments = chutecalc.solve(spoon).segments
    assert segments["spoon"].name == segments[1].name == segments[-1].name == "spoon"
    assert [segment.name for segment in segments] == segments.names == ["fall", "spoon"]
    assert [segment.name for segment in segments[:1]] == ["fall"]
    assert len(segments) == 2
    assert repr(segments) == "<Segments fall (fall), spoon (curve)>"
    with pytest.raises(KeyError, match="no segment is called 'hood': the chute has fall, spoon"):
        segments["hood"]
    with pytest.raises(IndexError, match=r"^the chute has 2 segments: fall, spoon$"):
        segments[2]


def test_a_chute_says_where_it_is_from_and_what_it_is_made_of(spoon):
    titled = chutecalc.parse(spoon.data | {"title": "Coal"}, source="coal.toml")
    assert repr(titled) == "<Chute 'coal.toml': Coal; fall, spoon>"
    many = titled.vary({"segments.spoon.radius_m": [2.0, 3.0]})
    assert repr(many) == "<Chute 'coal.toml': Coal; fall, spoon; 2 designs>"


def test_a_solution_says_how_designs_end():
    base = chute(
        segments=[{"name": "chute", "kind": "straight", "slope_deg": 30.0, "length_m": 5.0}],
        inlet={"velocity_m_s": 3.0, "slope_deg": 30.0},
    )
    many = chutecalc.solve(base.vary({"liners.wall.friction_deg": np.array([15.0, 50.0, 55.0])}))
    assert repr(many) == "<Solution of 3 designs: 1 ok, 2 stall>"
    stalls = chutecalc.solve(base.vary({"liners.wall.friction_deg": 50.0}))
    assert repr(stalls).startswith("<Solution: stall in chute at s = ")
    assert repr(chutecalc.exits(base.vary({"liners.wall.friction_deg": [15.0, 50.0]}))) == (
        "<Exits of 2 designs: 1 ok, 1 stall>"
    )
    assert repr(many.segments["chute"]) == (
        "<SegmentResult chute of 3 designs: 1 ok, 2 stall, 3 m/s in, 0 to 5.849 m/s out, depth 0.1722 m in,"
        " 0.09909 m out>"
    )
    assert repr(stalls.segments["chute"]) == "<SegmentResult chute: stall, 3 to 0 m/s, depth 0.1722 m>"
    stall = next(finding for finding in many.findings() if finding.code == "stall")
    assert repr(stall).startswith("<failure stall (2 of 3 designs): chute, s = ")
    assert f": {stall.message(1)}>" in repr(stall)  # of the first design that it concerns
    table = many._repr_html_()
    assert "<caption>Solution of 3 designs: 1 ok, 2 stall</caption>" in table
    assert "<td>chute</td><td>straight</td><td>1 ok, 2 stall</td><td>3</td>" in table
    assert table.count("<tr>") == 2
    assert many.segments._repr_html_() == table.replace("Solution of 3 designs: 1 ok, 2 stall", "Segments")


def test_parts_of_a_solution_say_what_they_are_in_a_line():
    solution = chutecalc.solve(chutecalc.load(ROOT / "specs/belt_hood_spoon.toml"))
    assert repr(solution.trajectory) == "<Trajectory: throw, hood, drop, spoon>"
    assert repr(solution.design) == "<Design of 1: throw, hood, drop, spoon>"
    assert repr(solution.trajectory.parts[1]) == "<Part hood (hood)>"
    assert repr(solution.trajectory.sampled[2]) == "<SampledPart drop (fall): 65 samples>"
    assert repr(solution.segments["drop"]) == "<SegmentResult drop: ok, 4.682 to 7.165 m/s>"
    assert repr(solution.segments["hood"]) == ("<SegmentResult hood: ok, 3.512 to 4.682 m/s, depth 0.1523 to 0.1142 m>")


def test_exits_are_a_table_in_a_notebook(spoon):
    exits = chutecalc.exits(spoon.vary({"segments.spoon.radius_m": [2.0, 3.0]}), columns="velocity_m_s")
    assert exits._repr_html_() == (
        "<table><caption>Exits of 2 designs: 2 ok</caption><tr><th></th><th>column</th><th>range</th></tr>"
        "<tr><td>exit</td><td>velocity_m_s</td><td>3.578 to 3.878</td></tr></table>"
    )
