"""What stays constant in a section while its chamfer angle varies."""

import numpy as np
import pytest

import chutecalc
from tests.cli.sweep.commands import DRAWN, swept, written
from tests.conftest import spec


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
