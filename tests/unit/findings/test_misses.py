"""Streams that pass a segment by, or never reach the end of a fall."""

import pytest

from tests.unit.findings.chutes import PASSABLE, all_of, codes, found, solved


def test_passed_by():
    short = {"name": "short", "kind": "straight", "slope_deg": 60.0, "length_m": 0.05}
    long = {"name": "long", "kind": "straight", "slope_deg": 60.0, "length_m": 5.0}
    flying, along = ({"velocity_m_s": 3.0, "slope_deg": slope} for slope in (20.0, 60.0))
    leaves = solved(inlet=flying, segments=[short, long])
    follows = solved(inlet=along, segments=[short, long])
    allowed = solved(inlet=flying, segments=[short | {"may_be_passed": True}, long])
    assert (found(leaves, "passed_by").segment, found(leaves, "passed_by").severity) == ("short", "failure")
    assert (leaves.status[0], [each.status[0] for each in leaves.segments]) == ("missed", ["missed", "not_reached"])
    assert "passed_by" not in codes(follows)
    assert (found(allowed, "passed_by").severity, allowed.status[0]) == ("note", "ok")


def test_a_fall_that_is_never_reached_says_so():
    solution = solved(
        inlet={"velocity_m_s": 0.0, "slope_deg": 90.0},
        segments=[
            {"kind": "fall", "onto_next": True},
            {"kind": "straight", "slope_deg": 30.0, "length_m": 1.0, "start_m": [-0.9, -1.0]} | PASSABLE,
            {"name": "last", "kind": "fall", "run_m": 3.0},
        ],
    )
    assert solution.status[0] == "missed"
    (missed,) = all_of(solution, "missed")
    assert (missed.segment, missed.severity) == ("last", "failure")
    assert missed.message() == (
        "the stream never reaches the end of the fall: it falls straight down; give drop_m instead of run_m"
    )


@pytest.mark.parametrize(
    ("inlet", "passed", "fall", "reason"),
    [
        (
            {"velocity_m_s": 1.0, "slope_deg": 80.0},
            {"kind": "straight", "slope_deg": 30.0, "length_m": 1.0, "start_m": [-2.0, -4.0]},
            {"run_m": 0.5},
            "it is already past that distance; increase run_m",
        ),
        (
            {"velocity_m_s": 5.0, "slope_deg": 0.0},
            {"kind": "hood", "radius_m": 2.0, "from_slope_deg": 20.0, "to_slope_deg": 60.0, "start_m": [1.0, 2.0]},
            {"drop_m": 0.5},
            "it is already below that level; increase drop_m",
        ),
    ],
)
def test_a_fall_that_is_never_reached_says_why(inlet, passed, fall, reason):
    last = {"name": "last", "kind": "fall", **fall}
    passed = passed | PASSABLE
    solution = solved(inlet=inlet, segments=[{"kind": "fall", "onto_next": True}, passed, last])
    (missed,) = all_of(solution, "missed")
    assert missed.message() == f"the stream never reaches the end of the fall: {reason}"
