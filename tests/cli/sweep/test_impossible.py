"""Designs that cannot be built keep their rows, and leave the others as they are."""

import numpy as np

from chutecalc.cli import main
from tests.cli.sweep.commands import DRAWN, HOOD, swept, written


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
