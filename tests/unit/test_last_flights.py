"""Rows of a table for what flies past a segment, out of a pipe, and onto a belt."""

import json

import numpy as np
import pytest

import chutecalc
from chutecalc.cli import main
from tests.conftest import ROOT, chute

G = 9.80665
BELT = {"velocity_m_s": 4.0, "friction_deg": 30.0}
HEAD = {"kind": "straight", "name": "head", "slope_deg": 30.0, "length_m": 0.8}
ONTO = {"kind": "fall", "onto_next": True}
LEDGE = {"kind": "straight", "name": "ledge", "slope_deg": 60.0, "length_m": 0.5, "start_m": [0.7, -0.4]}
CATCH = {"kind": "straight", "name": "catch", "slope_deg": 50.0, "length_m": 5.0, "start_m": [1.0, -1.0]}


def rows(solution):
    return {row.name: row for row in solution.trajectory.rows}


def test_a_fall_onto_a_segment_that_is_passed_is_passed(capsys, tmp_path):
    segments = [HEAD, ONTO | {"name": "jump"}, LEDGE | {"may_be_passed": True}, ONTO | {"name": "on"}, CATCH]
    base = chute(inlet={"velocity_m_s": 4.0, "slope_deg": 30.0}, segments=segments)
    solution = chutecalc.solve(base)
    assert [segment.status[0] for segment in solution.segments] == ["ok", "passed", "passed", "ok", "ok"]
    missed = chutecalc.solve(base.put({"segments.ledge.may_be_passed": False}))
    assert [segment.status[0] for segment in missed.segments] == ["ok", "not_reached", "missed", *["not_reached"] * 2]
    many = chutecalc.solve(base.vary({"inlet.velocity_m_s": [0.5, 4.0]}))  # the slow one lands on the ledge
    assert many.segments["jump"].status.tolist() == ["ok", "passed"]


def test_the_flight_onto_a_belt_is_a_row(capsys):
    belt = BELT | {"at_m": [2.0, -3.0]}
    solution = chutecalc.solve(chute(inlet={"velocity_m_s": 4.0, "slope_deg": 30.0}, segments=[HEAD], receiver=belt))
    flight = rows(solution)["receiver:flight"]
    for name, of in (("entry", solution.exit), ("exit", None)):
        there = getattr(flight, name)
        if of is not None:
            for column in ("s_m", "x_m", "z_m", "slope_deg", "velocity_m_s"):
                assert there[column][0] == pytest.approx(of[column][0], rel=1e-14)
    for column, landed in (("x_m", "landing_x_m"), ("z_m", "landing_z_m"), ("slope_deg", "landing_slope_deg")):
        assert flight.exit[column][0] == pytest.approx(solution.receiver[landed][0], rel=1e-13)
    v, a = solution.exit["velocity_m_s"][0], np.radians(solution.exit["slope_deg"][0])
    time = (solution.receiver["landing_x_m"][0] - solution.exit["x_m"][0]) / (v * np.cos(a))
    assert flight.duration[0] == pytest.approx(time, rel=1e-12)
    t = np.linspace(0.0, time, 20001)
    path = np.hypot(np.diff(v * np.cos(a) * t), np.diff(v * np.sin(a) * t + 0.5 * G * t**2)).sum()
    # chords of a parabola are short by about (g h)²/(24 v²) of it in steps of h: 1e-11
    assert flight.exit["s_m"][0] - flight.entry["s_m"][0] == pytest.approx(path, rel=1e-9)
    assert main(["run", str(ROOT / "specs" / "cross_loading.toml")]) == 0
    out = capsys.readouterr().out.splitlines()
    assert any(line.startswith("receiver:flight  flight    in   1.800  1.273  -1.273") for line in out)
    table = out[2 : next(k for k, line in enumerate(out) if line.startswith("status"))]
    assert max(map(len, table)) <= 80


def test_a_belt_without_a_place_has_no_flight():
    solution = chutecalc.solve(chute(inlet={"velocity_m_s": 4.0, "slope_deg": 30.0}, segments=[HEAD], receiver=BELT))
    assert list(rows(solution)) == ["head"]


@pytest.mark.parametrize("received", [False, True])
def test_a_pipe_out_of_which_the_stream_flies_has_a_row_for_that(received):
    pipe = {"pipe": {"shape": "pipe", "radius_m": 0.3}}
    bend = {"kind": "curve", "name": "bend", "radius_m": 2.0, "to_slope_deg": 50.0}
    more = {"receiver": BELT | {"at_m": [1.6, -3.0]}} if received else {}
    inlet = {"velocity_m_s": 5.0, "slope_deg": 20.0}
    solution = chutecalc.solve(chute(flow={"rate_t_h": 100.0}, inlet=inlet, sections=pipe, segments=[bend], **more))
    found = rows(solution)
    assert list(found) == ["bend", "exit:flight", *(["receiver:flight"] if received else [])]
    flight = found["exit:flight"]
    assert flight.entry["velocity_m_s"][0] == pytest.approx(5.0, rel=1e-15)
    for column in ("s_m", "x_m", "z_m", "slope_deg", "velocity_m_s"):
        assert flight.exit[column][0] == pytest.approx(solution.exit[column][0], rel=1e-12)
    if received:
        assert found["receiver:flight"].entry["time_s"][0] == flight.exit["time_s"][0]


def test_a_chute_that_fails_has_no_last_flight():
    belt = BELT | {"at_m": [2.0, 3.0]}  # above the end of the chute
    solution = chutecalc.solve(chute(inlet={"velocity_m_s": 4.0, "slope_deg": 30.0}, segments=[HEAD], receiver=belt))
    assert (solution.status[0], list(rows(solution))) == ("missed", ["head"])


def test_the_document_has_the_segments_alone(capsys):
    assert main(["run", str(ROOT / "specs" / "cross_loading.toml"), "--json", "-"]) == 0
    (document,) = json.loads(capsys.readouterr().out)["chutes"]
    assert [segment["name"] for segment in document["segments"]] == ["chute"]
    assert document["receiver"]["landing_x_m"] == pytest.approx(1.552, abs=5e-4)


def test_landings_belong_to_where_the_stream_left_steel():
    floor = {"name": "first", "kind": "straight", "slope_deg": 45.0, "length_m": 1.0}
    passed = {"name": "deflector", "kind": "straight", "slope_deg": 60.0, "length_m": 1.0, "start_m": [6.0, -0.5]}
    data = {
        "flow": {"rate_t_h": 100.0},
        "material": {"density_kg_m3": 800.0, "internal_friction_deg": 50.0},
        "liners": {"steel": {"friction_deg": 20.0}},
        "sections": {"body": {"shape": "rectangular", "width_m": 1.0}},
        "inlet": {"velocity_m_s": 3.0, "slope_deg": 45.0},
        "segments": [floor, {"kind": "fall", "onto_next": True}, passed | {"may_be_passed": True}],
        "receiver": {"velocity_m_s": 5.0, "friction_deg": 30.0, "at_m": [4.0, -6.0]},
    }
    landings = {"hard_landing", "off_speed"}
    found = [each for each in chutecalc.solve(chutecalc.parse(data)).findings() if each.code in landings]
    assert [each.segment for each in found] == ["first", "first"]
