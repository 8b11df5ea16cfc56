"""Streams that stall, choke, or lose contact."""

import numpy as np
import pytest

import chutecalc
from tests.conftest import ROOT
from tests.unit.findings.chutes import PIPE, G, all_of, along, codes, found, rectangular, solved


def test_stall_inside_a_segment():
    solution = solved(**along(5.0, length=9.0, velocity=2.0))
    finding = found(solution, "stall")
    assert (finding.severity, finding.segment) == ("failure", "straight")
    assert finding.s_m[0] == solution.trajectory.segment_solutions[0].exit.distance[0]
    travelled, slope = (finding.numbers[name][0] for name in ("travelled_m", "slope_deg"))
    assert travelled == pytest.approx(finding.s_m[0], rel=1e-15)
    assert slope == pytest.approx(5.0, rel=1e-15)
    assert f"falls to 0 after {travelled:.4g} m on the segment, at a slope of 5°" in finding.message()


def test_stall_at_an_impact():
    solution = solved(
        inlet={"velocity_m_s": 4.0, "slope_deg": 90.0},
        segments=[{"kind": "straight", "slope_deg": 5.0, "length_m": 1.0}],
    )
    finding = found(solution, "stall")
    assert finding.numbers["incidence_deg"][0] == pytest.approx(85.0)
    assert finding.numbers["steepest_deg"][0] < 85.0
    assert solution.segments[0].entry["velocity_m_s"][0] == 0.0


def test_a_stall_is_not_quoted_with_numbers_that_grow_without_bound():
    """One finding of each code and design, as for streams that do not stall, in words of its own."""
    base = chutecalc.load(ROOT / "specs/fails/stall.toml")
    many = chutecalc.solve(base.vary({"inlet.velocity_m_s": [1.5, 2.4]}))
    stalls = many.status == "stall"
    assert stalls.any()
    found = all_of(many, "decelerating")
    assert sum(finding.mask.astype(int) for finding in found).max() == 1
    (stalled,) = [finding for finding in found if (finding.mask & stalls).any()]
    assert "∞" not in stalled.message(int(np.flatnonzero(stalled.mask)[0]))
    assert "0 m/s" not in stalled.message(int(np.flatnonzero(stalled.mask)[0]))


@pytest.mark.parametrize("above", [True, False])
def test_choke(above):
    # the stream is deepest at its start, Q/(v b)
    deepest = 1000 / 3.6 / 800 / 4.0 / 0.5
    wall = deepest * (0.999999 if above else 1.000001)
    solution = solved(sections=rectangular(wall_height_m=wall), **along(40.0))
    assert ("choke" in codes(solution)) == above
    assert (solution.status[0] == "choke") == above


def test_a_choke_says_where_the_stream_would_stop_or_that_it_would_run_on():
    stops = solved(sections=rectangular(wall_height_m=0.4), **along(5.0, length=9.0, velocity=3.0))
    assert "would stop" in found(stops, "choke").message()
    assert "the wall height of 15.75 in;" in found(stops, "choke").message(units="us")
    runs = solved(sections=rectangular(wall_height_m=0.4), **along(5.0, velocity=3.0))
    assert "run on" in found(runs, "choke").message()


@pytest.mark.parametrize("body", [PIPE["body"], {"shape": "box", "width_m": 0.5, "height_m": 0.4}])
@pytest.mark.parametrize("above", [True, False])
def test_a_closed_section_chokes_where_it_runs_full(body, above):
    area = np.pi * 0.3**2 if body["shape"] == "pipe" else 0.2
    rate = 3.6 * 800.0 * 4.0 * area * (1.000001 if above else 0.999999)  # full at the entry, and faster below
    solution = solved(flow={"rate_t_h": float(rate)}, sections={"body": body}, **along(70.0))
    assert (solution.status[0] == "choke") == ("choke" in codes(solution)) == above
    assert "above_chamfer" not in codes(solution)
    if above:
        assert "fills the closed section up to its roof" in found(solution, "choke").message()


@pytest.mark.parametrize(("factor", "lost"), [(1.0001, True), (0.9999, False)])
def test_contact_lost_at_the_start_of_a_crest(factor, lost):
    radius, slope = 2.0, np.radians(10.0)
    velocity = np.sqrt(radius * G * np.cos(slope)) * factor
    solution = solved(
        liners={"wall": {"friction_deg": 35.0}},
        inlet={"velocity_m_s": float(velocity), "slope_deg": 10.0},
        segments=[{"kind": "curve", "radius_m": radius, "to_slope_deg": 10.001}],
    )
    assert ("contact_lost" in codes(solution)) == lost


def test_contact_lost_is_a_warning_where_a_fall_follows():
    crest = {"kind": "curve", "radius_m": 1.0, "to_slope_deg": 80.0}
    inlet = {"velocity_m_s": 5.0, "slope_deg": 20.0}
    alone = solved(inlet=inlet, segments=[crest])
    caught = solved(inlet=inlet, segments=[crest, {"kind": "fall", "drop_m": 1.0}])
    assert found(alone, "contact_lost").severity == "failure"
    assert found(caught, "contact_lost").severity == "warning"
    assert (alone.status[0], caught.status[0]) == ("contact_lost", "ok")


@pytest.mark.parametrize(("kind", "words"), [("curve", "less"), ("hood", "more")])
def test_a_loss_of_contact_quotes_what_would_keep_it(kind, words):
    """v² = R g cos a at the balance, for this radius as for this velocity."""
    velocity, slopes = (3.0, (10.0, 80.0)) if kind == "curve" else (5.0, (-40.0, 30.0))
    segment = {"kind": kind, "radius_m": 2.5, "from_slope_deg": slopes[0], "to_slope_deg": slopes[1]}
    inlet = {"velocity_m_s": velocity, "slope_deg": slopes[0]}
    solution = solved(inlet=inlet, segments=[segment, {"kind": "fall", "drop_m": 3.0}])
    lost = all_of(solution, "contact_lost")[0]
    numbers = {name: values[0] for name, values in lost.numbers.items()}
    weight = 9.80665 * np.cos(np.radians(numbers["slope_deg"]))
    assert numbers["balance_m_s"] == pytest.approx(np.sqrt(2.5 * weight), rel=1e-12)
    assert numbers["balance_m_s"] == pytest.approx(numbers["velocity_m_s"], rel=1e-9)  # it leaves there
    assert numbers["radius_m"] == pytest.approx(numbers["velocity_m_s"] ** 2 / weight, rel=1e-12)
    assert f"there it would keep contact at {numbers['balance_m_s']:.4g} m/s or {words}, " in lost.message()
    assert f"m or {'more' if kind == 'curve' else 'less'}; it flies on" in lost.message()
    assert f"{numbers['velocity_m_s']:.4g} m/s" in lost.message()
