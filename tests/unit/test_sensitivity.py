"""Sensitivity: derivatives against closed forms and against another way to take them."""

import numpy as np
import pytest

import chutecalc
from chutecalc.errors import UsageError
from chutecalc.studies.sensitivity.numbers import numbers_of
from tests.conftest import ROOT, chute, vee, vee_friction

RTOL = 1e-10
STEP = RTOL ** (1 / 3)
EXACT = 30 * RTOL / STEP
"""What the solver may have wrong in a slope by five points, whose weights add up to 3, with a margin of ten."""
G = 9.80665


def by_path(found):
    return dict(zip(found.paths, found.derivative.tolist(), strict=True))


def test_a_fall_against_its_closed_form():
    drop, start = 1.5, 3.0
    fall = chute(inlet={"velocity_m_s": start, "slope_deg": 90.0}, segments=[{"kind": "fall", "drop_m": drop}])
    found = chutecalc.sensitivity(fall)
    velocity = np.sqrt(start**2 + 2 * G * drop)
    slopes = by_path(found)
    assert found.value == pytest.approx(velocity, rel=RTOL)
    assert slopes["segments.fall.drop_m"] == pytest.approx(G / velocity, rel=EXACT)
    assert slopes["inlet.velocity_m_s"] == pytest.approx(start / velocity, rel=EXACT)
    assert slopes["flow.rate_t_h"] == slopes["material.density_kg_m3"] == 0.0
    percent = dict(zip(found.paths, found.per_percent, strict=True))
    assert percent["segments.fall.drop_m"] == pytest.approx(G * drop / velocity**2, rel=EXACT)
    assert found.paths[0] == "segments.fall.drop_m"  # 14.7 of v² = 38.4, to 9 of the start
    assert found.smooth.all()


def test_a_vee_against_its_closed_form():
    """v² = v0² + 2 g l (sin a - μ_e cos a), with μ_e of the paper, which a vee has at every depth."""
    slope, length, start, wall = 45.0, 3.0, 2.0, 20.0
    case = chute(
        inlet={"velocity_m_s": start, "slope_deg": slope},
        liners={"wall": {"friction_deg": wall}},
        sections=vee(),
        segments=[{"name": "run", "kind": "straight", "slope_deg": slope, "length_mm": 1000 * length}],
    )

    def squared(slope, length, start, wall):
        friction = vee_friction(wall, 45.0, 50.0)
        return start**2 + 2 * G * length * (np.sin(np.radians(slope)) - friction * np.cos(np.radians(slope)))

    velocity = np.sqrt(squared(slope, length, start, wall))
    slopes = by_path(chutecalc.sensitivity(case))
    per_friction = vee_friction(wall, 45.0, 50.0) / np.tan(np.radians(wall)) / np.cos(np.radians(wall)) ** 2
    by_wall = -G * length * np.cos(np.radians(slope)) * per_friction / velocity * np.pi / 180
    by_length = (velocity**2 - start**2) / length / 2 / velocity / 1000
    assert slopes["segments.run.length_mm"] == pytest.approx(by_length, rel=EXACT)
    assert slopes["liners.wall.friction_deg"] == pytest.approx(by_wall, rel=EXACT * 57.3)


@pytest.mark.parametrize("name", ["paper/r3_d55_chamfered", "vee"])
def test_as_the_function_of_the_chute_by_wider_steps(name):
    """Neville's scheme from steps 40 times as wide, on the replayed recording instead of a batch of variants."""
    case = chutecalc.load(ROOT / f"specs/{name}.toml")
    found = chutecalc.sensitivity(case, "exit_depth_m")
    for path, given, slope, error in zip(found.paths, found.given, found.derivative, found.error, strict=True):
        depth = case.function([path], ["exit_depth_m"])
        if abs(given) < 0.1 or path == "inlet.slope_deg":
            continue
        steps = 0.02 * given / 2.0 ** np.arange(4)
        table = np.array([(depth(given + h) - depth(given - h)) / (2 * h) for h in steps])
        for order in range(1, 4):
            table = (4**order * table[1:] - table[:-1]) / (4**order - 1)
        assert slope == pytest.approx(table[0], abs=max(1e-5 * abs(slope), 3 * error)), path


def test_a_bound_has_points_on_one_side():
    fall = chute(inlet={"velocity_m_s": 0.0, "slope_deg": 90.0}, segments=[{"kind": "fall", "drop_m": 2.0}])
    found = chutecalc.sensitivity(fall)
    velocity = np.sqrt(4 * G)
    slopes, errors = by_path(found), dict(zip(found.paths, found.error, strict=True))
    assert abs(slopes["inlet.velocity_m_s"]) < 1e-6  # v0 / v
    assert errors["segments.fall.drop_m"] < 1e-4 * G / velocity
    assert found.per_percent[found.paths.index("inlet.velocity_m_s")] == 0.0


def test_a_kink_is_marked():
    """The wetted length of a chamfer grows with the rate until it is full: here right at the rate of the spec."""
    section = {"body": {"shape": "chamfered", "base_m": 0.5, "chamfer_deg": 45.0, "chamfer_m": 0.15}}
    smooth = chute(sections=section)
    depth = chutecalc.solve(smooth).exit["depth_m"][0]
    top = 0.15 * np.sin(np.pi / 4)
    area = 0.5 * top + top**2
    rate = 3.6 * area * 800.0 * chutecalc.solve(smooth).exit_velocity[0]
    assert depth < top
    assert chutecalc.sensitivity(smooth, "exit_chamfer_wetted_m").smooth.all()
    for _ in range(30):  # the velocity depends on the rate a little
        full = smooth.put({"flow.rate_t_h": float(rate)})
        rate = 3.6 * area * 800.0 * chutecalc.solve(full).exit_velocity[0]
    found = chutecalc.sensitivity(smooth.put({"flow.rate_t_h": float(rate)}), "exit_chamfer_wetted_m")
    assert not found.smooth[found.paths.index("flow.rate_t_h")]


def test_a_failure_beside_leaves_the_slope_to_the_other_side():
    """A spoon that is placed by the stream begins in its middle: a slower stream misses it."""
    found = chutecalc.sensitivity(chutecalc.load(ROOT / "specs/coal_hood_spoon.toml"))
    k = found.paths.index("inlet.velocity_m_s")
    assert np.isfinite(found.derivative[k])
    assert np.isnan(found.error[k])
    assert not found.smooth[k]


def test_every_number_of_a_spec_is_there_in_its_unit():
    case = chute(inlet={"velocity_m_s": 4.0, "slope_deg": 40.0, "at_mm": [100.0, 200.0]}, limits={"max_fill": 0.5})
    found = {each.path: each.value_in_unit for each in numbers_of(case)}
    assert found["inlet.at_mm.2"] == pytest.approx(200.0)
    assert found["segments.straight.slope_deg"] == 40.0
    assert not any(path.startswith("limits") for path in found)
    assert abs(by_path(chutecalc.sensitivity(case, "exit_x_m"))["inlet.at_mm.1"] - 0.001) < 1e-9


def test_what_has_no_sensitivity_is_refused():
    stalls = chute(liners={"wall": {"friction_deg": 60.0}})
    with pytest.raises(UsageError, match="since it fails"):
        chutecalc.sensitivity(stalls)
    with pytest.raises(UsageError, match="no case wet"):
        chutecalc.sensitivity(chute(), case="wet")
    with pytest.raises(UsageError, match="no number"):
        chutecalc.sensitivity(chute(), "findings")
    with pytest.raises(UsageError, match="one design"):
        chutecalc.sensitivity(chute().vary({"flow.rate_t_h": [1.0, 2.0]}))
