"""What objects say of themselves in an interpreter and a notebook."""

import numpy as np
import pytest

import chutecalc
from tests.conftest import chute


@pytest.fixture(scope="module")
def spoon():
    return chutecalc.parse(chutecalc.STARTER)


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
    with pytest.raises(IndexError):
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
    assert repr(many.segments["chute"]) == "<SegmentResult chute (straight): 1 ok, 2 stall>"
    stall = next(finding for finding in many.findings() if finding.code == "stall")
    assert repr(stall).startswith("<failure stall (2 of 3 designs): chute, s = ")
    assert f": {stall.message(1)}>" in repr(stall)  # of the first design that it concerns
    table = many._repr_html_()
    assert "<caption>Solution of 3 designs: 1 ok, 2 stall</caption>" in table
    assert "<td>chute</td><td>straight</td><td>1 ok, 2 stall</td><td>3</td>" in table
    assert table.count("<tr>") == 2
