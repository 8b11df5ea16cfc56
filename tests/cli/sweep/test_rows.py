"""A row of a sweep is a run: on grids, over parallel lists, in any unit, and by any name of a key."""

import itertools
import json

import numpy as np

import chutecalc
from chutecalc.cli import main
from chutecalc.fields.ranges import read_values
from chutecalc.studies.sweep import sweep as rows_of
from chutecalc.studies.sweep.checks import DEFAULT
from chutecalc.studies.sweep.grid import Grid
from chutecalc.studies.sweep.parameters import Parameter, read_parameters
from tests.cli.sweep.commands import BOTH, HOOD, SPOON, refused, swept, written


def test_one_value_is_a_run(capsys):
    (row,) = swept(capsys, "radius=3", SPOON)
    assert main(["run", SPOON, "--json", "-"]) == 0
    (run,) = json.loads(capsys.readouterr().out)["chutes"]
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


def test_a_unit_is_its_twin(capsys):
    metres = swept(capsys, "radius_m=1:3:0.5", SPOON)
    for millimetres in (
        swept(capsys, "radius_mm=1000:3000:500", SPOON),
        swept(capsys, "segments.spoon.radius_mm=1000:3000:500", SPOON),
    ):
        for one, other in zip(metres, millimetres, strict=True):
            assert [*one.values()][1:] == [*other.values()][1:]


def test_three_parameters_go_round_as_in_a_product_of_lists():
    lists = [[1.0, 2.0], [3.0, 4.0, 5.0], [6.0, 7.0, 8.0, 9.0, 10.0]]
    grid = Grid([Parameter(name, (), np.array(values)) for name, values in zip("abc", lists, strict=True)])
    assert grid.count == 30
    for first, last in ((0, 30), (4, 11), (13, 14), (15, 30)):
        rows = np.arange(first, last)
        found = np.stack([np.broadcast_to(values, len(rows)) for _, values in grid.at(rows)], axis=1)
        assert found.tolist() == [list(row) for row in itertools.product(*lists)][first:last]


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


def test_the_study_is_the_papers(capsys):
    assert main(["sweep", "beta", "delta=30,55", "--keep", "width"]) == 0
    out = capsys.readouterr().out
    assert "0.49739" in out
    assert "left out: β = 0° to 35°" in out
