"""The band of a chute's own assumptions: what it spans, where it ends, and how it is shown."""

import json

import numpy as np
import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.results.band import COLUMNS, NOTE, Variant, variants_of
from tests.conftest import ROOT, chute

SPOON = ROOT / "specs" / "paper" / "r3_d55_chamfered.toml"
FLAT = {
    "sections": {"body": {"shape": "rectangular", "width_m": 0.5}},
    "inlet": {"velocity_m_s": 4.0, "slope_deg": 60.0},
    "segments": [
        {"kind": "curve", "radius_m": 2.0, "to_slope_deg": 15.0},
        {"name": "flat", "kind": "straight", "slope_deg": 15.0, "length_m": 1.9},
    ],
}


def test_a_band_begins_with_the_assumptions_of_the_spec_and_has_none_twice():
    variants = variants_of(Variant(1.25, 0.0), 0.2)
    assert variants[0] == (1.25, 0.0)
    assert sorted(variants) == sorted((a, k) for a in (1.0, 1.25, 1.33) for k in (0.0, 0.2, 1.0))
    assert len(variants_of(Variant(1.1, 0.0), 0.2)) == 10
    assert len(variants_of(Variant(1.0, 0.0), 1.0)) == 6


def test_the_band_is_what_the_variants_give_one_by_one():
    base = chutecalc.load(SPOON)
    band = chutecalc.solve_band(base)
    alone = [
        chutecalc.solve(base.vary({"model.momentum_factor": a, "model.longitudinal_pressure_ratio": k}))
        for a, k in band.variants
    ]
    velocities = [one.exit_velocity[0] for one in alone]
    deepest = [one.segments["spoon"].maximum["depth_m"][0] for one in alone]
    assert band.exit["velocity_m_s"] == (min(velocities), max(velocities))
    assert band.segments["spoon"]["maximum"]["depth_m"] == (min(deepest), max(deepest))
    assert not band.stops
    for s, ranges in band.along(np.linspace(0.0, 1.0, 5)):
        assert s.shape == (5,)
        for name in COLUMNS:
            least, largest = ranges[name]
            assert not (least > largest).any()


def test_variants_that_jump_end_the_band_and_are_named():
    band = chutecalc.solve_band(chute(**FLAT))
    assert band.solution.status[0] == "ok"
    (stop,) = band.stops
    assert (stop.status, stop.segment) == ("choke", "flat")
    assert {variant.longitudinal_ratio for variant in stop.variants} == {1.0}
    through = band.solution.ok
    assert 0 < through.sum() < len(band.variants)
    assert band.exit["velocity_m_s"].least == band.solution.exit_velocity[through].min()
    assert "flat" in repr(stop)


def test_variants_that_miss_a_segment_placed_by_the_stream_are_named():
    belt = chutecalc.load(ROOT / "specs" / "belt_hood_spoon.toml")
    band = chutecalc.solve_band(belt)
    (stop,) = band.stops
    assert (stop.status, stop.segment, len(stop.variants)) == ("missed", "spoon", 8)
    assert stop.s_m.least == band.solution.segments["hood"].exit["s_m"][1:].min()
    moving = chutecalc.solve_band(chutecalc.parse(belt.data | {"model": {"steel": "follows_stream"}}))
    assert not moving.stops
    assert moving.exit["velocity_m_s"].least < 0.98 * moving.exit["velocity_m_s"].largest


def test_a_band_is_that_of_one_design():
    with pytest.raises(chutecalc.UsageError, match="2"):
        chutecalc.solve_band(chutecalc.load(SPOON).vary({"flow.rate_t_h": [500.0, 600.0]}))


def run(capsys, *arguments):
    status = main(["run", *map(str, arguments)])
    return status, capsys.readouterr().out


def test_run_shows_the_band_and_says_what_it_is(capsys):
    status, out = run(capsys, SPOON, "--band")
    assert status == 0
    assert NOTE in out
    assert all(len(line) <= 80 for line in out.splitlines() if line.startswith((" ", "spoon ")))
    assert "exit velocity 3.542 m/s to 3.878 m/s" in out
    assert NOTE not in run(capsys, SPOON)[1]


def test_json_has_the_band(capsys):
    _, out = run(capsys, SPOON, "--band", "--json", "-")
    band = json.loads(out)["chutes"][0]["band"]
    assert band["note"] == NOTE
    assert len(band["variants"]) == 9
    assert band["exit"]["velocity_m_s"]["least"] == pytest.approx(3.542, abs=1e-3)
    assert band["segments"][1]["maximum"]["depth_m"]["largest"] > 0.15
    assert json.loads(run(capsys, SPOON, "--json", "-")[1])["chutes"][0]["band"] is None


def test_a_report_says_where_the_band_ends(tmp_path, capsys):
    path = tmp_path / "flat.json"
    spec = tmp_path / "flat.toml"
    spec.write_text(chutecalc_toml(), encoding="utf-8")
    _, out = run(capsys, spec, "--band", "--json", path)
    assert "on flat, choke at s =" in out
    (end,) = json.loads(path.read_text(encoding="utf-8"))["chutes"][0]["band"]["ends"]
    assert end["segment"] == "flat"


def chutecalc_toml():
    return """
[flow]
rate_t_h = 1000
[material]
density_kg_m3 = 800
internal_friction_deg = 50
[liners.wall]
friction_deg = 25
[sections.body]
shape = "rectangular"
width_m = 0.5
[inlet]
velocity_m_s = 4.0
slope_deg = 60
[[segments]]
kind = "curve"
radius_m = 2.0
to_slope_deg = 15
[[segments]]
name = "flat"
kind = "straight"
slope_deg = 15
length_m = 1.9
"""


def test_a_case_has_its_own_band(tmp_path, capsys):
    spec = tmp_path / "cases.toml"
    spec.write_text(SPOON.read_text(encoding="utf-8") + '\n[cases.wet]\n"liners.wall.friction_deg" = 27\n')
    _, out = run(capsys, spec, "--band", "--case", "wet")
    wet = chutecalc.solve_band(chutecalc.load(spec).cases["wet"])
    assert f"to {wet.exit['velocity_m_s'].largest:.4g} m/s" in out


def test_a_picture_has_the_band_in_the_panels_of_velocity_and_depth():
    from chutecalc.output.plots.run import draw_run
    from chutecalc.results.cases import Cases

    base = chutecalc.load(SPOON)
    figure = draw_run([Cases({"design": chutecalc.solve(base)})], band=chutecalc.solve_band(base))
    gids = {each.get_gid() for axes in figure.axes for each in axes.collections}
    assert {"velocity_m_s band", "depth_m band"} <= gids
    plain = draw_run([Cases({"design": chutecalc.solve(base)})])
    assert not any("band" in str(each.get_gid()) for axes in plain.axes for each in axes.collections)
