"""Findings and lines of a report: what is said once, what is set against each other, and the band."""

import json
import re

import numpy as np
import pytest

import chutecalc
from chutecalc.cli import main
from tests.conftest import ROOT

SPECS = ROOT / "specs"
TWICE = """\
[flow]
rate_t_h = 300
[material]
density_kg_m3 = 800
internal_friction_deg = 25
[liners.steel]
friction_deg = 28
[sections.body]
shape = "rectangular"
width_m = 0.6
[inlet]
velocity_m_s = 4
slope_deg = 50
[[segments]]
name = "upper"
kind = "straight"
slope_deg = 50
length_m = 1
[[segments]]
name = "lower"
kind = "straight"
slope_deg = 50
length_m = 1
[cases.wet]
"liners.steel.friction_deg" = 30
"""


@pytest.fixture
def report(capsys, tmp_path):
    """Return what a run prints of a spec, as lines."""

    def printed(text, *arguments):
        path = tmp_path / "chute.toml"
        path.write_text(text, encoding="utf-8")
        main(["run", str(path), *arguments])
        return capsys.readouterr().out.splitlines()

    return printed


def starting(lines, begin):
    return [line for line in lines if line.startswith(begin)]


def test_what_segments_share_is_said_once(report):
    design, wet = starting(report(TWICE), "warning inadmissible_friction")
    assert design.startswith("warning inadmissible_friction  upper, lower: the wall friction of 28° exceeds")
    assert wet.startswith("warning inadmissible_friction  wet: upper, lower: the wall friction of 30° exceeds")


def test_a_single_segment_keeps_its_place(report):
    (line,) = starting(
        report(
            TWICE.replace('[[segments]]\nname = "upper"', "", 1)
            .replace('kind = "straight"\nslope_deg = 50\nlength_m = 1\n', "", 1)
            .split("[cases")[0]
        ),
        "warning inadm",
    )
    assert "  lower, s = 0.000 m: " in line


def test_findings_that_ask_for_opposite_changes_are_set_against_each_other(report):
    spoon = (SPECS / "tapered_spoon.toml").read_text(encoding="utf-8")
    assert not starting(report(spoon), "against each other")  # it clears itself, and lands too hard
    flatter = spoon.replace("to_slope_deg = 35", "to_slope_deg = 27").replace("-1.93]", "-2.6]")
    (line,) = starting(report(flatter), "against each other")
    assert "spoon: a steeper end (below_cut_off) and a flatter one (hard_landing) are both asked for" in line


def test_off_speed_names_a_plan_angle_that_no_velocity_can_make_up_for(report):
    across = (SPECS / "cross_loading.toml").read_text(encoding="utf-8")
    (line,) = starting(report(across), "warning off_speed")
    assert "at a plan angle of 90° only cos ψ = 0 of its horizontal velocity goes along the belt" in line
    assert "make the stream faster" not in line
    (line,) = starting(
        report(
            across.replace("plan_angle_deg = 90", "plan_angle_deg = 20\n").replace(
                "velocity_m_s = 2.0", "velocity_m_s = 4.0"
            )
        ),
        "warning off_speed",
    )  # cos 20° is more than 0.9
    assert "make the stream faster" in line


def test_an_impact_on_a_roof_is_named(report):
    lines = report((SPECS / "pipe_two_bends.toml").read_text(encoding="utf-8"))
    solution = chutecalc.solve(chutecalc.load(SPECS / "pipe_two_bends.toml"))
    struck = [one for one in solution.trajectory.results if one.impact and np.isfinite(one.impact["incidence_deg"][0])]
    on_roof = [bool(one.strikes_roof[0]) for one in struck]
    assert True in on_roof
    assert [", on its roof: " in line for line in starting(lines, "impact  ")] == on_roof


def test_the_report_has_the_band_of_the_exit(report):
    lines = report((SPECS / "vee.toml").read_text(encoding="utf-8"))
    (line,) = starting(lines, "band  ")
    band = chutecalc.solve_band(chutecalc.load(SPECS / "vee.toml"))
    least, largest = band.exit["velocity_m_s"]
    assert line.startswith(f"band  exit velocity {least:.4g} m/s to {largest:.4g} m/s, depth ")
    stalls = report((SPECS / "fails" / "stall.toml").read_text(encoding="utf-8"))
    assert not starting(stalls, "band")


def test_variants_that_do_not_get_through_are_counted(report):
    chute = chutecalc.load(SPECS / "belt_hood_spoon.toml")
    ok = chutecalc.solve_band(chute).solution.ok
    (line,) = starting(report((SPECS / "belt_hood_spoon.toml").read_text(encoding="utf-8")), "band  ")
    assert f"; {np.count_nonzero(~ok)} of {len(ok)} variants do not get through" in line


def test_wear_is_relative_to_a_segment_that_is_named(report):
    lines = report((SPECS / "coal_hood_spoon.toml").read_text(encoding="utf-8"))
    (heading,) = [line for line in lines if line.startswith("loads")]
    assert heading.endswith("hood = 1")


def test_the_flight_onto_a_belt_is_in_all_outputs(tmp_path, report):
    csv, document = tmp_path / "stations.csv", tmp_path / "run.json"
    spec = (SPECS / "cross_loading.toml").read_text(encoding="utf-8")
    lines = report(spec, "--csv", str(csv), "--json", str(document), "--points", "5")
    assert starting(lines, "receiver:flight")
    rows = [line for line in csv.read_text(encoding="utf-8").splitlines() if ",receiver:flight," in line]
    (found,) = json.loads(document.read_text(encoding="utf-8"))["chutes"]
    (flight,) = found["last_flights"]
    assert (len(rows), flight["name"], flight["kind"]) == (5, "receiver:flight", "flight")
    assert flight["exit"]["x_m"] == pytest.approx(found["receiver"]["landing_x_m"], rel=1e-13)
    assert len(flight["stations"]) == 5
    table = chutecalc.solve(chutecalc.load(SPECS / "cross_loading.toml")).stations(points=5)
    assert table["z_m"][0, -1] == pytest.approx(-1.6, rel=1e-13)


def test_a_chute_without_a_flight_behind_it_has_none(tmp_path, report):
    document = tmp_path / "run.json"
    report((SPECS / "vee.toml").read_text(encoding="utf-8"), "--json", str(document))
    assert json.loads(document.read_text(encoding="utf-8"))["chutes"][0]["last_flights"] == []


def test_sweeps_have_the_greatest_impacts_beside_sliding(capsys):
    columns = ["max_impact_wear_w_m2", "max_impact_pressure_kpa", "max_impact_incidence_deg", "max_wear_w_m2"]
    spec = str(SPECS / "coal_hood_spoon.toml")
    assert main(["sweep", spec, "rate=1000,1500", "--columns", ",".join(columns), "--csv", "-"]) == 0
    header, *rows = (line.split(",") for line in capsys.readouterr().out.splitlines())
    many = chutecalc.solve(chutecalc.load(spec).vary({"flow.rate_t_h": [1000.0, 1500.0]}))
    struck = [segment.impact for segment in many.segments if segment.impact]
    for name in columns[:3]:
        expected = np.fmax.reduce([impact[name.removeprefix("max_impact_")] for impact in struck])
        assert [float(row[header.index(name)]) for row in rows] == pytest.approx(expected, rel=1e-12)
    assert all(float(row[header.index("max_wear_w_m2")]) > 0.0 for row in rows)


def test_a_chute_that_strikes_nothing_has_no_impact_wear(capsys):
    assert main(["sweep", str(SPECS / "vee.toml"), "rate=300,400", "--columns", "max_impact_wear_w_m2"]) == 0
    assert len(re.findall(r"ok +0\.0$", capsys.readouterr().out, re.MULTILINE)) == 2


def test_a_clearance_needs_a_belt_with_a_place(capsys):
    assert main(["sweep", str(SPECS / "decline_belt.toml"), "rate=300,400", "--columns", "receiver_clearance_m"]) == 2
    assert "receiver_clearance_m: give receiver.at_m" in capsys.readouterr().err
