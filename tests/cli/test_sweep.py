"""``chutecalc sweep`` through ``main``: rows, files, what is refused, and what a killed sweep leaves."""

import csv
import io
import itertools
import json
import re
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
import tomli_w

import chutecalc
from chutecalc.cli import main
from chutecalc.errors import UsageError
from chutecalc.fields.ranges import read_values
from chutecalc.output.run import run_document
from chutecalc.results.cases import Cases
from chutecalc.results.segment_columns import segment_columns
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.sweep import sweep as rows_of
from chutecalc.studies.sweep.checks import DEFAULT, DEFAULT_ON_BELT
from chutecalc.studies.sweep.grid import Grid
from chutecalc.studies.sweep.parameters import Parameter, read_parameters
from chutecalc.studies.sweep.plot import draw_sweep
from chutecalc.studies.sweep.table import column_of
from chutecalc.studies.sweep.text_parameter import TextParameter
from tests.conftest import ROOT, spec

SPOON = str(ROOT / "specs/paper/r3_d55_chamfered.toml")
VEE = str(ROOT / "specs/vee.toml")
HOOD = str(ROOT / "specs/coal_hood_spoon.toml")
BOTH = {"material": {"density_kg_m3": 800.0, "internal_friction_deg": 50.0, "pressure_ratio": 0.3}}
CURVES = {
    "segments": [
        {"kind": "curve", "radius_m": 2.0, "to_slope_deg": 30.0},
        {"name": "last", "kind": "curve", "radius_m": 3.0, "to_slope_deg": 20.0},
    ]
}
DRAWN = {"body": {"shape": "chamfered", "base_m": 0.3, "chamfer_deg": 45.0, "chamfer_m": 0.2}}


def written(tmp_path, **tables):
    """Write a spec to a file and return its path."""
    path = tmp_path / "chute.toml"
    path.write_text(tomli_w.dumps(spec(**tables)), encoding="utf-8")
    return str(path)


def swept(capsys, *arguments):
    """Run a sweep and return its rows as dictionaries of text."""
    assert main(["sweep", *arguments, "--csv", "-"]) == 0
    return list(csv.DictReader(io.StringIO(capsys.readouterr().out)))


def refused(capsys, *arguments, status=2):
    """Return the message about a wrong sweep."""
    assert main(["sweep", *arguments]) == status
    shown = capsys.readouterr()
    assert shown.out == ""
    assert "Traceback" not in shown.err
    return shown.err


def test_one_value_is_a_run(capsys):
    (row,) = swept(capsys, "radius=3", SPOON)
    assert main(["run", SPOON, "--json", "-"]) == 0
    run = json.loads(capsys.readouterr().out)
    assert list(row) == ["radius_m", "status", *DEFAULT]
    assert row["status"] == run["status"] == "ok"
    for name in ("velocity_m_s", "depth_m", "slope_deg"):
        assert float(row[f"exit_{name}"]) == run["exit"][name]
    spoon = run["segments"][-1]
    assert float(row["max_depth_m"]) == spoon["maximum"]["depth_m"]
    assert float(row["min_velocity_m_s"]) == spoon["minimum"]["velocity_m_s"]


def test_a_grid_is_its_rows_one_by_one(capsys):
    grid = swept(capsys, "radius=1:3:1", "phi=25,35,40", SPOON)
    assert [(float(row["radius_m"]), float(row["friction_deg"])) for row in grid] == [
        (radius, phi) for radius in (1, 2, 3) for phi in (25, 35, 40)
    ]
    for row in grid:
        (alone,) = swept(capsys, f"radius={row['radius_m']}", f"phi={row['friction_deg']}", SPOON)
        assert alone == row
    assert {row["status"] for row in grid} == {"ok", "stall"}
    assert all(row["exit_velocity_m_s"] == row["max_depth_m"] == "" for row in grid if row["status"] != "ok")


def test_extremes_inside_a_segment_are_those_of_a_run(capsys):
    for row in swept(capsys, "segments.hood.radius_m=1,1.3", HOOD, "--columns", "max_depth_m,min_velocity_m_s"):
        chute = chutecalc.load(HOOD).vary({"segments.hood.radius_m": float(row["segments.hood.radius_m"])})
        segments = [segment for segment in chutecalc.solve(chute).segments if segment.kind != "fall"]
        deepest = max(segment.maximum["depth_m"][0] for segment in segments)
        slowest = min(segment.minimum["velocity_m_s"][0] for segment in segments)
        assert float(row["max_depth_m"]) == pytest.approx(deepest, rel=1e-10)  # as extremes promise
        assert float(row["min_velocity_m_s"]) == pytest.approx(slowest, rel=1e-10)


def test_a_unit_is_its_twin(capsys):
    metres = swept(capsys, "radius_m=1:3:0.5", SPOON)
    for millimetres in (
        swept(capsys, "radius_mm=1000:3000:500", SPOON),
        swept(capsys, "segments.spoon.radius_mm=1000:3000:500", SPOON),
    ):
        for one, other in zip(metres, millimetres, strict=True):
            assert [*one.values()][1:] == [*other.values()][1:]


def test_rows_depend_on_neither_blocks_nor_threads(capsys, monkeypatch):
    arguments = ("radius=1:4:#9", "phi=20:40:#7", SPOON)
    whole = swept(capsys, *arguments)
    monkeypatch.setattr(rows_of, "CHUNK", 4)
    assert swept(capsys, *arguments, "--jobs", "3") == whole
    assert swept(capsys, *arguments, "--jobs", "1") == whole


def test_three_parameters_go_round_as_in_a_product_of_lists():
    lists = [[1.0, 2.0], [3.0, 4.0, 5.0], [6.0, 7.0, 8.0, 9.0, 10.0]]
    grid = Grid([Parameter(name, (), np.array(values)) for name, values in zip("abc", lists, strict=True)])
    assert grid.count == 30
    for first, last in ((0, 30), (4, 11), (13, 14), (15, 30)):
        rows = np.arange(first, last)
        found = np.stack([np.broadcast_to(values, len(rows)) for values in grid.at(rows)], axis=1)
        assert found.tolist() == [list(row) for row in itertools.product(*lists)][first:last]


def test_a_tolerance_that_cannot_be_is_refused_at_once():
    chute = chutecalc.load(SPOON)
    with pytest.raises(chutecalc.UsageError, match="rtol must be from"):
        rows_of.Sweep(chute, read_parameters(["phi=20,25"], chute), rtol=0.5)


def test_the_wall_may_vary_where_the_pressure_ratio_is_given(capsys, tmp_path):
    rows = swept(capsys, "phi=20,25", written(tmp_path, **BOTH))
    assert [row["status"] for row in rows] == ["ok", "ok"]


def test_a_short_name_means_every_such_key(capsys):
    both = swept(capsys, "phi=24", HOOD)
    apart = swept(capsys, "liners.steel.friction_deg=24", "liners.ceramic.friction_deg=24", HOOD)
    assert both[0]["exit_velocity_m_s"] == apart[0]["exit_velocity_m_s"]
    assert "segments.hood.radius_m or segments.spoon.radius_m" in refused(capsys, "radius=2", HOOD)


def test_parallel_lists(capsys):
    rows = swept(capsys, "--zip", "radius=1,2,3", "phi=25,26,27", "rate=500", SPOON)
    assert [row["radius_m"] + row["friction_deg"] for row in rows] == ["1.025.0", "2.026.0", "3.027.0"]
    assert {row["rate_t_h"] for row in rows} == {"500.0"}
    message = refused(capsys, "--zip", "radius=1,2,3", "phi=25,26", SPOON)
    assert "equal length, or single values. Given: radius_m 3, friction_deg 2" in message


@pytest.mark.parametrize("keep", ["width", "depth"])
def test_what_is_kept(keep, capsys, tmp_path):
    path = written(tmp_path, sections=DRAWN)
    for row in swept(capsys, "beta=30:90:15", "--keep", keep, path):
        beta, first = np.radians(float(row["chamfer_deg"])), np.radians(45.0)
        width = 0.3 + 2 * 0.2 * np.cos(first)
        length = 0.2 if keep == "width" else 0.2 * np.sin(first) / np.sin(beta)
        left = width - 2 * length * np.cos(beta)
        section = {"body": {**DRAWN["body"], "chamfer_deg": np.degrees(beta), "base_m": left, "chamfer_m": length}}
        alone = chutecalc.solve(chutecalc.parse(spec(sections=section)))
        assert float(row["exit_velocity_m_s"]) == pytest.approx(alone.exit_velocity[0], rel=1e-9)
    (same,) = swept(capsys, "beta=45", "--keep", keep, path)
    (base,) = swept(capsys, "beta=45", path)
    assert same == base


FIRST, SECOND = (
    {"base_m": 0.3, "chamfer_deg": 45.0, "chamfer_m": 0.2},
    {"base_m": 0.1, "chamfer_deg": 60.0, "chamfer_m": 0.3},
)


def gives_way(keep, beta, base_m, chamfer_deg, chamfer_m):
    """Base and length of a chamfer at another angle, from the sketch: a trapezium of the same top, or height too."""
    top = base_m + 2 * chamfer_m * np.cos(np.radians(chamfer_deg))
    height = chamfer_m * np.sin(np.radians(chamfer_deg))
    length = chamfer_m if keep == "width" else height / np.sin(np.radians(beta))
    return {"base_m": top - 2 * length * np.cos(np.radians(beta)), "chamfer_deg": beta, "chamfer_m": length}


@pytest.mark.parametrize("keep", ["width", "depth"])
@pytest.mark.parametrize("sections", [{"one": FIRST, "two": SECOND}, {"one": SECOND, "two": FIRST}])
def test_what_is_kept_of_two_sections(keep, sections, capsys, tmp_path):
    segments = [
        {"kind": "straight", "slope_deg": 40.0, "length_m": 2.0, "section": "one"},
        {"kind": "straight", "slope_deg": 38.0, "length_m": 1.0, "section": "two"},
    ]
    shaped = {name: {"shape": "chamfered", **section} for name, section in sections.items()}
    path = written(tmp_path, sections=shaped, segments=segments)
    rows = swept(capsys, "beta=20:90:10", "--keep", keep, path)
    for row in rows:
        now = {name: gives_way(keep, float(row["chamfer_deg"]), **section) for name, section in sections.items()}
        if min(section["base_m"] for section in now.values()) < 0.0:
            assert row["status"] == "impossible"
            continue
        shaped = {name: {"shape": "chamfered", **section} for name, section in now.items()}
        alone = chutecalc.solve(chutecalc.parse(spec(sections=shaped, segments=segments)))
        assert row["status"] == "ok"
        assert float(row["exit_velocity_m_s"]) == pytest.approx(alone.exit_velocity[0], rel=1e-9)
    assert {row["status"] for row in rows} == {"ok", "impossible"}


def test_a_base_that_is_varied_too_is_the_one_that_gives_way(capsys, tmp_path):
    path = written(tmp_path, sections=DRAWN)
    rows = swept(capsys, "beta=40,60", "sections.body.base_mm=200,400", "--keep", "width", path)
    assert len(rows) == 4
    for row in rows:
        base = float(row["sections.body.base_mm"]) / 1000
        now = gives_way("width", float(row["chamfer_deg"]), base, 45.0, 0.2)
        alone = chutecalc.solve(chutecalc.parse(spec(sections={"body": {"shape": "chamfered", **now}})))
        assert float(row["exit_velocity_m_s"]) == pytest.approx(alone.exit_velocity[0], rel=1e-9)


def test_a_base_that_gives_way_to_nothing_leaves_a_vee(capsys, tmp_path):
    # B = 2 C (cos β - cos 60°), so that W = 2 C cos β: near 60° a small difference, at 60° it is 0 to the last digit
    for beta in (20, 40, 50, 59, 59.2, 59.3, 59.5, 59.6, 59.8, 59.9, 60):
        base = 40.0 * (np.cos(np.radians(beta)) - np.cos(np.radians(60.0)))
        shaped = {"shape": "chamfered", "base_m": base, "chamfer_deg": 60.0, "chamfer_m": 20.0}
        (row,) = swept(capsys, f"beta={beta}", "--keep", "width", written(tmp_path, sections={"body": shaped}))
        flanks = {"shape": "vee", "chamfer_deg": float(beta), "chamfer_m": 20.0}
        alone = chutecalc.solve(chutecalc.parse(spec(sections={"body": flanks})))
        assert row["status"] == "ok"
        assert float(row["exit_velocity_m_s"]) == pytest.approx(alone.exit_velocity[0], rel=1e-9)
        assert float(row["exit_depth_m"]) == pytest.approx(alone.exit["depth_m"][0], rel=1e-9)


def test_impossible_designs_keep_their_rows(capsys, tmp_path):
    path = written(tmp_path, sections=DRAWN)
    rows = swept(capsys, "beta=10:50:5", "rate=500,1000", "--keep", "depth", path)
    cotangent = 0.3 + 2 * 0.2 * np.sqrt(0.5)  # B + 2 C cos β over the height of the chamfer is 2 cot β at the limit
    limit = np.degrees(np.arctan(2 * 0.2 * np.sqrt(0.5) / cotangent))
    for row in rows:
        impossible = float(row["chamfer_deg"]) < limit
        assert (row["status"] == "impossible") == impossible
        assert (row["exit_velocity_m_s"] == "") == impossible
    assert main(["sweep", "beta=10:50:5", "--keep", "depth", path]) == 0
    assert "left out: 4 impossible designs, whose" in capsys.readouterr().out
    assert main(["sweep", "beta=20,40", "--keep", "depth", path]) == 0
    out = capsys.readouterr().out
    assert "2 designs: 1 impossible, 1 ok\n" in out
    assert "left out: 1 impossible design, whose" in out


def test_values_that_only_together_cannot_be(capsys, tmp_path):
    path = written(tmp_path, sections=DRAWN)
    rows = swept(capsys, "base=0,0.3", "beta=45,90", path)
    assert [row["status"] for row in rows] == ["ok", "impossible", "ok", "ok"]
    slopes = swept(capsys, "segments.hood.to_slope_deg=10,15,80", HOOD)
    assert [row["status"] for row in slopes] == ["impossible", "impossible", "ok"]


def test_rows_of_a_locus_that_only_together_fall_are_impossible(capsys, tmp_path):
    path = written(tmp_path, liners={"wall": {"yield_locus_kpa": [[0.2, 0.04], [2.0, 0.14]]}})
    one, other = "liners.wall.yield_locus_kpa.1.2", "liners.wall.yield_locus_kpa.2.2"
    rows = swept(capsys, f"{one}=0.04,0.08,0.12", f"{other}=0.06,0.1,0.14", path)
    assert [row["status"] == "impossible" for row in rows] == [
        first > second for first in (0.04, 0.08, 0.12) for second in (0.06, 0.1, 0.14)
    ]
    for row in rows:
        (alone,) = swept(capsys, f"{one}={row[one]}", path) if row[other] == "0.14" else ({},)
        assert {**row, **{name: value for name, value in alone.items() if name != other}} == row
    assert len({row["exit_velocity_m_s"] for row in rows if row["status"] == "ok"}) == 6


def test_a_hood_that_cannot_be_tangent_to_its_fall_is_impossible_alone(capsys, tmp_path):
    segments = [
        {"kind": "fall", "drop_m": 0.4},
        {"name": "hood", "kind": "hood", "radius_m": 3.0, "to_slope_deg": 60.0},
    ]
    path = written(tmp_path, inlet={"velocity_m_s": 3.0, "slope_deg": 0.0}, segments=segments)
    arrives = np.degrees(np.arctan(np.sqrt(2 * 9.80665 * 0.4) / 3.0))  # 43°: a hood has to steepen from there
    rows = swept(capsys, "segments.hood.to_slope_deg=30:80:5", "phi=15,20", path)
    slopes = [float(row["segments.hood.to_slope_deg"]) for row in rows]
    assert slopes == [slope for slope in range(30, 81, 5) for _ in range(2)]
    assert [row["status"] == "impossible" for row in rows] == [slope <= arrives for slope in slopes]
    for row in rows[-2:]:
        (alone,) = swept(capsys, "segments.hood.to_slope_deg=80", f"phi={row['friction_deg']}", path)
        assert row == alone


def test_all_values_out_of_bounds_are_told_at_once(capsys, monkeypatch):
    monkeypatch.setattr("chutecalc.api.solve.run_chain", lambda *_: 1 / 0)
    message = refused(capsys, "radius=-1:3:1", "phi=20:95:5", "flow.rate_t=1", "segments.spool.radius_m=1", SPOON)
    for words in ("radius_m = -1 to 3", "less than 90", "not end in a unit that fits", "segments has no item 'spool'"):
        assert words in message


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["radius", SPOON], "has no values"),
        (["xyz=1", SPOON], "xyz: it is neither a short name (beta, delta, phi, rate, radius, base) nor a path"),
        (["radius_kg=1", SPOON], "radius_kg: _kg is not a unit of length. Use radius_m or radius_mm or radius_in or"),
        (["drop_m=1,2", SPOON], "drop_m: name the whole path, segments.fall.drop_m."),
        (["rad=1", SPOON], "rad: did you mean radius?"),
        (["base=1", VEE], "base: the spec has no base_m in its sections. Use the path of another number"),
        (
            ["delta=30,40", BOTH],
            "delta: material.pressure_ratio sets K_v, whatever δ is. Vary that, or remove",
        ),
        (["delta_rad=0.5,0.6", BOTH], "material.pressure_ratio sets K_v"),
        (["radius=1,2", CURVES], "the spec has several. Use segments.curve.radius_m or segments.last.radius_m"),
        (["radius=a:b", SPOON], "is not a range"),
        (["radius=1:2:0", SPOON], "radius: the step must not be 0."),
        (["radius=1:2:-1", SPOON], "does not lead from 1 to 2. Use a step of 1."),
        (["radius=2:1:0.5", SPOON], "does not lead from 2 to 1. Use a step of -0.5."),
        (["radius=1:2:#0", SPOON], "is not a count"),
        (["radius=nan", SPOON], "is not a number"),
        (["radius=0:1e9:1e-9", SPOON], "the limit is 100,000,000"),
        (["radius=1", "radius=2", SPOON], "given twice"),
        (["radius=1", "segments.spoon.radius_mm=2", SPOON], "given twice"),
        (["segments.spoon.kind=1,2", SPOON], "segments.2.kind"),
        (["segments.1.onto_next=1,2", SPOON], "segments.1.onto_next"),
        (["title=1,2", SPOON], "neither a short name"),
        (["material.name=1,2", SPOON], "material.name = 1 to 2 cannot be varied"),
        (["model.friction_law=1,2", SPOON], "model.friction_law"),
        ([SPOON], "nothing is varied"),
        (["beta", SPOON, HOOD], "one spec"),
        (["phi=20"], "without a spec"),
        (["beta", "--zip"], "--zip"),
        (["beta", "--stations", "0"], "--stations"),
        (["beta", SPOON, "--area", "0.1"], "--area"),
        (["beta", SPOON, "--phi", "0"], "--phi belongs to the friction study"),
        (["beta", SPOON, "--base", "0"], "--base belongs to the friction study"),
        (["beta", SPOON, "--keep", "width"], "--keep width needs sections.spoon.chamfer_m. Add it to the spec"),
        (["beta", VEE, "--keep", "depth"], "--keep depth cannot be used with sections.flanks: its shape is vee"),
        (["radius=1,2", SPOON, "--keep", "width"], "while a chamfer angle varies. Add one, such as beta=15:90:5"),
        (["base=0.3,0.4", SPOON, "--keep", "width"], "while a chamfer angle varies. Add one, such as beta=15:90:5"),
        (["rate=1,2", VEE, "--keep", "width"], "--keep width needs a section of shape chamfered, and the spec has"),
        (["beta", SPOON, "--columns", "exit_velocity"], "Did you mean exit_velocity_m_s?"),
        (["beta", SPOON, "--columns", "receiver_velocity_ratio"], "no [receiver]"),
        (["beta", SPOON, "--top", "3"], "--top needs --by, such as --by exit_velocity_m_s:max."),
        (["beta", SPOON, "--by", "exit_depth_m:max"], "--by needs --top, such as --top 10."),
        (["beta", SPOON, "--top", "3", "--by", "exit_depth_m"], "--by takes COLUMN:max or COLUMN:min"),
        (["beta", SPOON, "--csv", "a.csv", "--csv=b.csv"], "--csv is given twice. Give it once."),
        (["beta", SPOON, "--top", "3", "--by", "status:max"], "numbers"),
        (["beta", SPOON, "--top", "3", "--by", "depth_m:max", "--points", "3"], "--top selects designs"),
        (["beta", SPOON, "--points", "3", "--columns", "exit_depth_m"], "Use the columns of a station"),
        (["beta", SPOON, "--points", "3", "--stations", "1"], "one of them"),
        (["beta", SPOON, "--resume"], "--resume needs --csv, --json or --parquet"),
        (["beta", SPOON, "--csv", "no/such/folder/a.csv"], "no folder"),
        (
            ["beta", SPOON, "--csv", "o", "--json", "./o"],
            "--csv and --json both write to ./o. Give one of them",
        ),
        (["beta", SPOON, "--csv", "-", "--json", "-"], "standard output"),
        (["beta", SPOON, "--parquet", "-"], "standard output"),
        (["beta", "radius=1,2", "rate=1,2", SPOON, "--plot", "a.svg"], "one or two parameters"),
        (["beta", "nowhere.toml"], "no such file"),
    ],
)
def test_what_is_refused_before_anything_is_solved(arguments, words, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("chutecalc.api.solve.run_chain", lambda *_: 1 / 0)
    with_tables = [written(tmp_path, **word) if isinstance(word, dict) else word for word in arguments]
    before = list(tmp_path.iterdir())
    assert words in refused(capsys, *with_tables)
    assert list(tmp_path.iterdir()) == before


def test_ranges_are_decimal():
    assert read_values("x", "0.1:0.7:0.1").tolist() == [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]
    assert read_values("x", "90:15:-25").tolist() == [90, 65, 40, 15]
    assert read_values("x", "15:90:40").tolist() == [15, 55]
    assert read_values("x", "15:90:#16").tolist() == list(range(15, 91, 5))
    assert read_values("x", "0:1:#3, 7").tolist() == [0, 0.5, 1, 7]


def test_the_best_rows(capsys, monkeypatch):
    rows = [row for row in swept(capsys, "radius=1:4:#9", "phi=20:40:#7", SPOON) if row["status"] == "ok"]
    rows.sort(key=lambda row: -float(row["exit_velocity_m_s"]))
    monkeypatch.setattr(rows_of, "CHUNK", 4)
    best = swept(capsys, "radius=1:4:#9", "phi=20:40:#7", SPOON, "--top", "5", "--by", "exit_velocity_m_s:max")
    assert best == rows[:5]
    few = swept(capsys, "phi=20,44", SPOON, "--top", "5", "--by", "exit_wear_w_m2:min")
    assert len(few) == 1
    assert "exit_wear_w_m2" in few[0]


@pytest.mark.parametrize("how", [("--points", "3"), ("--stations", "0.7")])
def test_profiles_are_those_of_runs(how, capsys, tmp_path, monkeypatch):
    monkeypatch.setattr(rows_of, "STATIONS", 20)
    rows = swept(capsys, "phi=20,35,44", SPOON, *how)
    for phi in ("20", "35", "44"):
        target = tmp_path / "run.csv"
        main(["run", SPOON, "--set", f"liners.wall.friction_deg={phi}", *how, "--csv", str(target)])
        capsys.readouterr()
        alone = list(csv.DictReader(io.StringIO(target.read_bytes().decode())))
        own = [row for row in rows if float(row["friction_deg"]) == float(phi)]
        assert len(own) == len(alone)
        for one, other in zip(own, alone, strict=True):
            assert all(one[name] == other[name] for name in other if name not in ("spec", "case"))
    assert {row["status"] for row in rows} == {"ok", "stall"}


def test_columns_of_profiles_are_those_asked_for_in_their_order(capsys, tmp_path):
    names = ["pressure_kpa", "s_m", "velocity_m_s"]
    rows = swept(capsys, "phi=20,35", SPOON, "--points", "4", "--columns", ",".join(names))
    assert list(rows[0]) == ["friction_deg", "status", *names]
    for phi in (20.0, 35.0):
        run = chutecalc.solve(chutecalc.load(SPOON).put({"liners.wall.friction_deg": phi}))
        stations = run.stations(points=4)
        own = [row for row in rows if float(row["friction_deg"]) == phi]
        assert len(own) == np.isfinite(stations["s_m"]).sum()
        for k, row in enumerate(own):
            assert row["status"] == run.status[0]
            assert [row[name] for name in names] == [
                "" if np.isnan(stations[name][0, k]) else str(stations[name][0, k]) for name in names
            ]


def test_what_stands_at_the_exit_alone_is_not_solved_for_more(capsys, monkeypatch):
    (whole,) = swept(capsys, "radius=3", SPOON, "--columns", "exit_depth_m,error_estimate,max_depth_m")
    (clock,) = swept(capsys, "radius=3", SPOON, "--columns", "exit_time_s")  # needs the whole path
    assert float(clock["exit_time_s"]) == chutecalc.solve(chutecalc.load(SPOON)).exit["time_s"][0]
    monkeypatch.setattr("chutecalc.studies.sweep.design_rows.solve", lambda *_: 1 / 0)
    (row,) = swept(capsys, "radius=3", SPOON, "--columns", "exit_depth_m,error_estimate")
    assert float(row["exit_depth_m"]) == pytest.approx(float(whole["exit_depth_m"]), rel=1e-9)  # rtol is 1e-10


def test_a_few_blocks_are_solved_ahead_of_the_one_that_is_told(monkeypatch):
    chute = chutecalc.load(SPOON)
    sweep = rows_of.Sweep(chute, read_parameters(["radius=1,2"], chute))
    monkeypatch.setattr(sweep, "block", lambda number: {"number": number})
    asked = []
    blocks = sweep.blocks((asked.append(number) or number for number in itertools.count()), jobs=3)
    for number in range(20):
        assert next(blocks) == (number, {"number": number})
        assert len(asked) <= number + 4
    blocks.close()
    numbers = [4, 0, 7, 1, 9]
    assert list(sweep.blocks(numbers, jobs=3)) == [(number, {"number": number}) for number in numbers]


def test_a_block_of_profiles_has_a_quarter_of_a_million_stations():
    chute = chutecalc.load(SPOON)  # a fall and a spoon
    for points, designs in ((2, rows_of.CHUNK), (101, 262_144 // 202), (200_000, 1)):
        sweep = rows_of.Sweep(chute, read_parameters(["radius=1:4:#9"], chute), points=points)
        assert sweep.block_size == designs
        assert sweep.block_count == -(-9 // designs)


def test_nothing_but_the_spec_is_needed_to_sweep_as_run_solves():
    chute = chutecalc.load(SPOON)
    sweep = rows_of.Sweep(chute, read_parameters(["radius=1,2", "phi=20,25"], chute))
    identity = sweep.identity()
    assert (identity["tolerance"], identity["keep"], identity["top"], identity["stations"]) == (
        1e-10,
        "base",
        None,
        [None, None],
    )
    assert sweep.count == 4


def test_findings_and_ends(capsys):
    (row,) = swept(
        capsys, "radius=3", SPOON, "--columns", "findings,exit_froude,exit_time_s,error_estimate,max_wear_w_m2"
    )
    run = chutecalc.solve(chutecalc.load(SPOON))
    assert row["findings"].split() == [finding.code for finding in run.findings()]
    assert float(row["exit_time_s"]) == run.exit["time_s"][0]
    assert float(row["max_wear_w_m2"]) == run.segments[-1].maximum["wear_w_m2"][0]
    (fast,) = swept(capsys, "radius=3", SPOON, "--columns", "exit_froude")
    assert float(fast["exit_froude"]) == pytest.approx(float(row["exit_froude"]), rel=1e-9)  # rtol is 1e-10
    belt = str(ROOT / "specs/belt_hood_spoon.toml")
    (row,) = swept(capsys, "rate=1800", belt, "--columns", "receiver_velocity_ratio")
    assert float(row["receiver_velocity_ratio"]) > 0.5
    names = ["receiver_velocity_ratio", "max_depth_m", "exit_depth_m"]
    (mixed,) = swept(capsys, "rate=1800", belt, "--columns", ",".join(names))
    assert list(mixed) == ["rate_t_h", "status", *names]
    assert float(mixed["receiver_velocity_ratio"]) == pytest.approx(float(row["receiver_velocity_ratio"]), rel=1e-9)


def test_every_format_has_the_same_rows(capsys, tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    files = [str(tmp_path / f"rows.{kind}") for kind in ("csv", "parquet", "json")]
    outputs = [
        word for kind, file in zip(("csv", "parquet", "json"), files, strict=True) for word in (f"--{kind}", file)
    ]
    assert main(["sweep", "phi=20,44", "beta=45,90", SPOON, *outputs]) == 0
    assert "stall" in capsys.readouterr().out
    assert sorted(path.name for path in tmp_path.iterdir()) == ["rows.csv", "rows.json", "rows.parquet"]
    rows = list(csv.DictReader(io.StringIO((tmp_path / "rows.csv").read_bytes().decode())))
    document = json.loads((tmp_path / "rows.json").read_text(encoding="utf-8"))
    assert document["chutecalc"] == chutecalc.__version__
    assert document["rows"] == parquet.read_table(files[1]).to_pylist()
    for one, other in zip(rows, document["rows"], strict=True):
        assert list(one) == list(other)
        assert one == {name: "" if value is None else str(value) for name, value in other.items()}


def test_parquet_needs_its_extra(capsys, monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    message = refused(capsys, "beta", SPOON, "--parquet", str(tmp_path / "a.parquet"), status=3)
    assert "pip install 'chutecalc[parquet]'" in message


@pytest.mark.parametrize(
    "arguments", [["phi=20:40:5"], ["radius=1:4:1", "phi=20:40:5"], ["radius=1:4:#9", "phi=20:40:#9"]]
)
def test_pictures(arguments, tmp_path, capsys):
    files = [tmp_path / name for name in ("one.svg", "two.svg")]
    for file in files:
        assert main(["sweep", *arguments, SPOON, "--plot", str(file), "--units", "us"]) == 0
    assert files[0].read_bytes() == files[1].read_bytes()
    assert len(files[0].read_bytes()) > 10_000
    text = files[0].read_text(encoding="utf-8")  # letters are paths; what they say stands beside them in comments
    assert re.search(r"<!-- exit velocity \S+ fpm -->", text)
    assert "m/s" not in text


def test_a_chart(capsys):
    assert main(["sweep", "beta", SPOON, "--chart"]) == 0
    out = capsys.readouterr().out
    assert "exit velocity v, m/s" in out
    assert "(β, °)" in out


def test_the_study_is_the_papers(capsys):
    assert main(["sweep", "beta", "delta=30,55", "--keep", "width"]) == 0
    out = capsys.readouterr().out
    assert "0.49739" in out
    assert "left out: β = 0° to 35°" in out


LONG = ["radius=2:4:#300", "phi=15:24:#300"]


def started(target, *more):
    """Start a long sweep in a process of its own."""
    command = [sys.executable, "-m", "chutecalc", "sweep", *LONG, SPOON, "--csv", str(target), "--jobs", "1", *more]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def stopped(target, how):
    """Stop a long sweep by a signal once it has blocks; return its status and its output."""
    process = started(target)
    folder = target.with_name(f"{target.name}.part")
    while process.poll() is None and len(list(folder.glob("[0-9]*.npz"))) < 2:
        time.sleep(0.02)
    process.send_signal(how)
    message = process.communicate()[1]
    return process.returncode, message


def test_killed_and_resumed_is_the_same_file(tmp_path, capsys):
    target, whole = tmp_path / "rows.csv", tmp_path / "whole.csv"
    assert main(["sweep", *LONG, SPOON, "--csv", str(whole)]) == 0
    status, _ = stopped(target, signal.SIGKILL)
    assert status == -signal.SIGKILL
    assert sorted(path.name for path in tmp_path.iterdir()) == ["rows.csv.part", "whole.csv"]
    capsys.readouterr()
    assert "--resume" in refused(capsys, *LONG, SPOON, "--csv", str(target))
    other = refused(capsys, LONG[0], "phi=15:25:#300", SPOON, "--csv", str(target), "--resume")
    assert "another sweep, which differs in the parameters" in other
    before = {path.name: path.stat().st_mtime_ns for path in (tmp_path / "rows.csv.part").glob("[0-9]*")}
    assert 0 < len(before) < 6
    assert main(["sweep", *LONG, SPOON, "--csv", str(target), "--resume"]) == 0
    assert target.read_bytes() == whole.read_bytes()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["rows.csv", "whole.csv"]


@pytest.mark.skipif(sys.platform == "win32", reason="signals are others there")
def test_interrupted_it_leaves_what_it_has(tmp_path, capsys):
    target, whole = tmp_path / "rows.csv", tmp_path / "whole.csv"
    assert main(["sweep", *LONG, SPOON, "--csv", str(whole)]) == 0
    status, message = stopped(target, signal.SIGINT)
    assert status == 130
    assert "--resume continues from" in message
    part = target.read_bytes()
    assert part == whole.read_bytes()[: len(part)]
    assert 1 < part.count(b"\r\n") < 90_001
    assert main(["sweep", *LONG, SPOON, "--csv", str(target), "--resume"]) == 0
    assert target.read_bytes() == whole.read_bytes()


def test_without_blocks_there_is_nothing_to_resume(tmp_path, capsys):
    target = tmp_path / "rows.csv"
    arguments = ["phi=20,30", SPOON, "--csv", str(target)]
    assert f"there is no {target}.part to continue. To start the sweep anew" in refused(capsys, *arguments, "--resume")
    assert main(["sweep", *arguments]) == 0
    finished = target.read_bytes()
    capsys.readouterr()
    assert f"there is no {target}.part to continue" in refused(capsys, "phi=20", *arguments[1:], "--resume")
    assert target.read_bytes() == finished
    assert [path.name for path in tmp_path.iterdir()] == ["rows.csv"]


def test_another_spec_or_version_is_not_resumed(tmp_path, capsys, monkeypatch):
    target = tmp_path / "rows.csv"
    monkeypatch.setattr("chutecalc.studies.sweep.block_store.BlockStore.remove", lambda self: None)
    assert main(["sweep", "phi=20,30", SPOON, "--csv", str(target)]) == 0
    capsys.readouterr()
    again = ["phi=20,30", SPOON, "--csv", str(target), "--resume"]
    assert main(["sweep", *again]) == 0
    capsys.readouterr()
    square = [word.replace("chamfered", "square") for word in again]
    assert "differs in the spec" in refused(capsys, *square)
    assert "differs in --columns" in refused(capsys, *again, "--columns", "exit_depth_m")
    monkeypatch.setattr("chutecalc.studies.sweep.sweep.__version__", "0.0.1")
    assert "the version of chutecalc" in refused(capsys, *again)


def test_a_huge_grid_is_asked_for(capsys, monkeypatch):
    asked = []
    monkeypatch.setattr("sys.stdin.isatty", lambda: True, raising=False)
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    monkeypatch.setattr("chutecalc.cli.sweep.CONFIRMED_ABOVE", 3)
    monkeypatch.setattr("typer.confirm", lambda text, **_: asked.append(text))
    assert main(["sweep", "phi=20:30:1", SPOON]) == 2
    assert "11 designs" in asked[0]
    assert main(["sweep", "phi=20:30:1", SPOON, "--yes"]) == 0
    assert len(asked) == 1


BELT = str(ROOT / "specs/belt_hood_spoon.toml")
ALL_OF_SPOON = ",".join(f"segments.spoon.{name}" for name in segment_columns())


def test_columns_of_a_segment_are_its_results(capsys):
    rows = swept(capsys, "rate=1500,1800", BELT, "--columns", ALL_OF_SPOON)
    for row in rows:
        state = chutecalc.solve(chutecalc.load(BELT).vary({"flow.rate_t_h": float(row["rate_t_h"])}))
        spoon = run_document(Cases({DESIGN_POINT: state}), None)["segments"][-1]
        found = {"status": spoon["status"], "duration_s": spoon["duration_s"]}
        for prefix, part in (("entry", "entry"), ("exit", "exit"), ("min", "minimum"), ("max", "maximum")):
            found |= {f"{prefix}_{name}": value for name, value in spoon[part].items()}
        found |= {f"impact_{name}": value for name, value in spoon["impact"].items()} | spoon.get("loads", {})
        shown = {name: "" if value is None else str(value) for name, value in found.items()}
        assert {name.removeprefix("segments.spoon."): value for name, value in row.items() if "spoon" in name} == shown


def test_a_segment_goes_by_name_or_by_number_and_need_not_be_struck(capsys):
    names = "segments.spoon.max_wear_w_m2,segments.4.max_wear_w_m2,segments.throw.impact_incidence_deg"
    (row,) = swept(capsys, "rate=1500", BELT, "--columns", names)
    assert row["segments.spoon.max_wear_w_m2"] == row["segments.4.max_wear_w_m2"] != ""
    assert row["segments.throw.impact_incidence_deg"] == ""


def test_where_a_design_fails_its_segments_say(capsys):
    names = "segments.spoon.status,segments.fall.status,segments.spoon.max_depth_m"
    rows = swept(capsys, "phi=20,40,44", SPOON, "--columns", names)
    assert [row["segments.spoon.status"] for row in rows] == [row["status"] for row in rows] == ["ok", "stall", "stall"]
    assert {row["segments.fall.status"] for row in rows} == {"ok"}
    assert [bool(row["segments.spoon.max_depth_m"]) for row in rows] == [True, False, False]
    best = ["--columns", names, "--top", "2", "--by", "segments.spoon.max_depth_m:min"]
    assert [row["friction_deg"] for row in swept(capsys, "phi=20,25,44", SPOON, *best)] == ["20.0", "25.0"]


def test_columns_of_segments_do_not_depend_on_blocks(capsys, monkeypatch):
    names = "segments.spoon.max_wear_w_m2,segments.spoon.status"
    arguments = ("radius=1:4:#9", "phi=20:40:#5", SPOON, "--columns", names)
    whole = swept(capsys, *arguments)
    monkeypatch.setattr(rows_of, "WITH_FINDINGS", 4)
    assert swept(capsys, *arguments) == whole


@pytest.mark.parametrize(
    ("names", "words"),
    [
        ("segments.spon.max_depth_m", "there is no segment spon. Did you mean spoon? Use 1 (fall), 2 (spoon)."),
        ("segments.3.max_depth_m", "there is no segment 3."),
        ("segments.0.max_depth_m", "there is no segment 0."),
        ("segments.spoon.max_depth", "a segment has no column max_depth. Did you mean max_depth_m? Use entry_"),
        ("segments.spoon", "write segments.SEGMENT.COLUMN, such as segments.spoon.exit_velocity_m_s."),
    ],
)
def test_unknown_columns_of_segments(names, words, capsys):
    assert words in refused(capsys, "radius=1,2", SPOON, "--columns", names)
    assert "--by needs a column of numbers" in refused(
        capsys, "radius=1,2", SPOON, "--top", "1", "--by", "segments.spoon.status:max"
    )
    assert "unknown column segments.spoon.max_depth_m" in refused(
        capsys, "radius=1,2", SPOON, "--points", "3", "--columns", "segments.spoon.max_depth_m"
    )


def test_what_the_belt_gets_is_shown_by_default(capsys):
    (row,) = swept(capsys, "rate=1800", BELT)
    assert list(row) == ["rate_t_h", "status", *DEFAULT, *DEFAULT_ON_BELT]
    run = chutecalc.solve(chutecalc.load(BELT))
    for name in DEFAULT_ON_BELT:
        assert float(row[name]) == run.receiver[name.removeprefix("receiver_")][0]


LINERS = ("segments.spoon.liner=steel,ceramic", "segments.hood.liner=ceramic,steel")


def test_a_grid_of_names_and_numbers_is_its_rows_one_by_one(capsys):
    rows = swept(capsys, LINERS[0], "rate=1000,1500", LINERS[1], HOOD)
    assert [tuple(row.values())[:3] for row in rows] == [
        (spoon, rate, hood)
        for spoon in ("steel", "ceramic")
        for rate in ("1000.0", "1500.0")
        for hood in ("ceramic", "steel")
    ]
    for row in rows:
        changes = {path: float(row[path]) if path == "rate_t_h" else row[path] for path in list(row)[:3]}
        changes["flow.rate_t_h"] = changes.pop("rate_t_h")
        alone = chutecalc.solve(chutecalc.load(HOOD).vary(changes))
        assert float(row["exit_velocity_m_s"]) == alone.exit_velocity[0]
    assert len({row["exit_velocity_m_s"] for row in rows}) == 8


def test_names_side_by_side(capsys):
    grid = {tuple(row.values())[:3]: row for row in swept(capsys, *LINERS, "rate=1000,1500", HOOD)}
    rows = swept(capsys, "--zip", *LINERS, "rate=1500", HOOD)
    assert [tuple(row.values())[:3] for row in rows] == [("steel", "ceramic", "1500.0"), ("ceramic", "steel", "1500.0")]
    assert all(row == grid[tuple(row.values())[:3]] for row in rows)
    assert "equal length" in refused(capsys, "--zip", LINERS[0], "rate=1,2,3", HOOD)


def test_names_of_laws_sections_and_kinds(capsys):
    for argument in ("model.friction_law=paper,equilibrium", "segments.spoon.section=hood,spoon"):
        rows = swept(capsys, argument, HOOD)
        path, names = argument.split("=")
        for row, name in zip(rows, names.split(","), strict=True):
            alone = chutecalc.solve(chutecalc.load(HOOD, {path: name}))
            assert (row[path], float(row["exit_velocity_m_s"])) == (name, alone.exit_velocity[0])
    kinds = swept(capsys, "segments.spoon.kind=curve,hood", HOOD)  # it flattens, which a hood cannot
    assert [row["status"] for row in kinds] == ["ok", "impossible"]


def test_wrong_names_stop_a_sweep_before_it_starts(capsys, monkeypatch):
    monkeypatch.setattr("chutecalc.api.solve.run_chain", lambda *_: 1 / 0)
    message = refused(capsys, "segments.spoon.liner=steel,cermic", "model.friction_law=papr", "rate=-1,2", HOOD)
    assert 'segments.3.liner = "cermic" names cermic, which is not defined' in message
    assert "model.friction_law" in message
    message = refused(capsys, "segments.spoon.liner=steel,cermic", "rate=-1,2", HOOD)
    for words in ("cermic", "flow.rate_t_h = -1 to 2 must be greater than 0"):
        assert words in message
    assert "is not a number" in refused(capsys, "segments.spoon.radius_m=two", HOOD)
    assert "is not a number" in refused(capsys, "segments.spoon.radius_m=1,steel", HOOD)
    assert "has no item" in refused(capsys, "segments.spon.liner=steel", HOOD)
    twice = refused(capsys, "segments.spoon.liner=steel,ceramic", "segments.3.liner=steel", HOOD)
    assert "is given twice, also as segments.spoon.liner" in twice
    assert "width_m = 1.0 is not a key of this table" in refused(capsys, "sections.hood.shape=rectangular,vee", HOOD)


def test_names_with_a_chamfer_that_is_adjusted(capsys):
    arguments = ("beta=30,45", "--keep", "width", HOOD)
    rows = swept(capsys, "segments.hood.liner=steel,ceramic", *arguments)
    for liner in ("steel", "ceramic"):
        own = [row for row in rows if row["segments.hood.liner"] == liner]
        alone = swept(capsys, f"segments.hood.liner={liner}", *arguments)
        assert own == alone
    assert len({row["exit_velocity_m_s"] for row in rows}) == 4


def test_names_in_every_format_and_resumed(capsys, tmp_path, monkeypatch):
    parquet = pytest.importorskip("pyarrow.parquet")
    arguments = [LINERS[0], "rate=1000,1500", HOOD]
    files = {kind: tmp_path / f"rows.{kind}" for kind in ("csv", "parquet", "json")}
    outputs = [word for kind, file in files.items() for word in (f"--{kind}", str(file))]
    monkeypatch.setattr("chutecalc.studies.sweep.block_store.BlockStore.remove", lambda self: None)
    assert main(["sweep", *arguments, *outputs]) == 0
    document = json.loads(files["json"].read_text(encoding="utf-8"))
    assert [row["segments.spoon.liner"] for row in document["rows"]] == ["steel", "steel", "ceramic", "ceramic"]
    assert document["parameters"][0] == {"name": "segments.spoon.liner", "paths": ["segments.spoon.liner"], "values": 2}
    assert document["rows"] == parquet.read_table(files["parquet"]).to_pylist()
    first = files["csv"].read_bytes()
    capsys.readouterr()
    other = ["segments.spoon.liner=ceramic,steel", *arguments[1:]]
    assert "differs in the parameters" in refused(capsys, *other, "--csv", str(files["csv"]), "--resume")
    monkeypatch.setattr("chutecalc.api.solve.run_chain", lambda *_: 1 / 0)  # all blocks are there
    assert main(["sweep", *arguments, "--csv", str(files["csv"]), "--resume"]) == 0
    assert files["csv"].read_bytes() == first


def drawn(*arguments):
    """Return the picture of a sweep."""
    chute = chutecalc.load(HOOD)
    sweep = rows_of.Sweep(chute, read_parameters(list(arguments), chute))
    return draw_sweep(sweep, sweep.block(0)), sweep.block(0)


def test_names_in_pictures_and_charts(capsys):
    figure, block = drawn(LINERS[0])
    axes = figure.axes[0]
    (line,) = (line for line in axes.lines if line.get_gid() == "line")
    assert [label.get_text() for label in axes.get_xticklabels()] == ["steel", "ceramic"]
    assert (line.get_xdata().tolist(), line.get_ydata().tolist()) == ([0, 1], block["exit_velocity_m_s"].tolist())
    figure, block = drawn(LINERS[0], "rate=1000:1500:#3")
    lines = [line for line in figure.axes[0].lines if line.get_gid() == "line"]
    assert [line.get_label() for line in lines] == ["spoon liner = steel", "spoon liner = ceramic"]
    for line, name in zip(lines, ("steel", "ceramic"), strict=True):
        own = block["segments.spoon.liner"] == name
        assert line.get_ydata().tolist() == block["exit_velocity_m_s"][own].tolist()
    assert main(["sweep", LINERS[0], HOOD, "--chart"]) == 0
    assert "(spoon liner: 0 steel, 1 ceramic)" in capsys.readouterr().out


def test_a_key_that_a_chosen_case_sets_is_refused() -> None:
    """A row with the rate of the sweep in its column, and solved at the rate of the case, would state what is not."""
    cases = '[cases.surge]\n"flow.rate_t_h" = 1500\n[cases.slow]\n"inlet.velocity_m_s" = 2'
    chute = chutecalc.parse(chutecalc.STARTER + cases)
    (rate,) = read_parameters(["flow.rate_kg_s=100,200"], chute)
    for names, refused in ("surge,slow", True), ("design,slow", False):
        (case,) = read_parameters([f"case={names}"], chute)
        if refused:
            with pytest.raises(UsageError, match=r"flow\.rate_kg_s: case surge sets it too"):
                rows_of.Sweep(chute, [case, rate])
        else:
            assert rows_of.Sweep(chute, [case, rate]).count == 4


def test_names_may_stand_for_several_keys_at_once():
    states = {"dry": {"flow.rate_t_h": 1000.0}, "wet": {"flow.rate_t_h": 1200.0, "liners.steel.friction_deg": 30.0}}
    case = TextParameter("case", np.array(list(states)), lambda chute, name: chute.put(states[name]))
    (radius,) = read_parameters(["segments.spoon.radius_m=2,3"], chute := chutecalc.load(HOOD))
    sweep = rows_of.Sweep(chute, [radius, case])
    block = sweep.block(0)
    assert block["case"].tolist() == ["dry", "wet", "dry", "wet"]
    for k, name in enumerate(block["case"].tolist()):
        alone = chutecalc.solve(chute.put(states[name] | {"segments.spoon.radius_m": [2.0, 3.0][k // 2]}))
        assert block["exit_velocity_m_s"][k] == alone.exit_velocity[0]
    assert column_of(sweep, "case").heading == "case"
