"""Rows that are stations are those of runs."""

import csv
import io

import numpy as np
import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.studies.sweep import sweep as rows_of
from tests.cli.sweep.commands import SPOON, swept


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
