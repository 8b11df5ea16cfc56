"""Wall friction that depends on pressure: bounds, kinks, and segments against an independent integration."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import chutecalc
from chutecalc.physics.wall import wall_friction, yield_locus
from tests.conftest import chute

G = 9.80665
ROWS = [[0.5, 0.30], [1.0, 0.52], [2.0, 0.95]]


def friction(stress, rows, internal_deg):
    """μ_w by its definition: linear between the rows, end slopes beyond them, τ not below 0 nor above σ sin δ."""
    sigma, tau = np.array(rows, dtype=float).T
    k = int(np.clip(np.searchsorted(sigma, stress) - 1, 0, len(sigma) - 2))
    shear = tau[k] + (tau[k + 1] - tau[k]) / (sigma[k + 1] - sigma[k]) * (stress - sigma[k])
    return min(max(shear, 0.0), stress * np.sin(np.radians(internal_deg))) / stress


@pytest.mark.parametrize(
    "rows",
    [ROWS, [[0.5, 0.1], [1.0, 0.45]], [[1.0, 0.2], [2.0, 0.2]], [[0.2, 0.3], [0.4, 0.35], [3.0, 0.4], [4.0, 2.0]]],
)
@pytest.mark.parametrize("internal", [25.0, 40.0, 60.0])
def test_the_law_is_its_definition(rows, internal):
    pa = np.array(rows).T[:, :, None] * 1e3
    wall = yield_locus(*pa, np.array([np.sin(np.radians(internal))]))
    for stress in np.geomspace(1e-3, 50.0, 60):
        exact = friction(stress, rows, internal)
        assert wall_friction(wall, np.array([stress * 1e3]))[0] == pytest.approx(exact, rel=1e-12, abs=1e-15)


def test_its_limit_at_no_pressure_is_the_materials_own():
    wall = yield_locus(*(np.array(ROWS).T[:, :, None] * 1e3), np.array([0.6]))
    assert wall_friction(wall, np.zeros(1))[0] == 0.6


def test_a_locus_through_the_origin_is_a_constant_angle():
    mu = np.tan(np.radians(25.0))
    locus = {"wall": {"yield_locus_kpa": [[0.5, 0.5 * mu], [1.0, mu], [2.0, 2 * mu]]}}
    for segment in (
        {"kind": "straight", "slope_deg": 50.0, "length_m": 5.0},
        {"kind": "curve", "radius_m": 3.0, "to_slope_deg": 5.0},
    ):
        inlet = {"velocity_m_s": 4.0, "slope_deg": 50.0}
        one = chutecalc.solve(chute(liners=locus, inlet=inlet, segments=[segment]))
        same = chutecalc.solve(chute(inlet=inlet, segments=[segment]))
        assert one.exit_velocity[0] == pytest.approx(same.exit_velocity[0], rel=1e-13)


def integrated(case):
    """v at the end of a rectangular segment, by DOP853 with the law's definition."""
    flow = case["rate"] / 3.6 / case["density"]
    ratio = (1 - np.sin(np.radians(case["internal"]))) / (1 + np.sin(np.radians(case["internal"])))
    curvature = 0.0 if case["radius"] is None else 1.0 / case["radius"]
    end = case["length"] if case["radius"] is None else np.radians(case["from"] - case["to"]) * case["radius"]

    def state(s, v):
        slope = np.radians(case["from"]) - curvature * s
        depth = flow / v / case["width"]
        n = G * np.cos(slope) + curvature * v * v
        return slope, depth, n, case["density"] * n * depth / 1e3

    def rate(s, y):
        slope, depth, n, stress = state(s, y[0])
        mu = friction(stress, case["rows"], case["internal"])
        return [(G * np.sin(slope) - mu * (1 + ratio * depth / case["width"]) * n) / y[0]]

    run = solve_ivp(rate, (0.0, end), [case["velocity"]], "DOP853", rtol=1e-12, atol=1e-14, max_step=end / 2000)
    return run.y[0, -1]


@pytest.mark.parametrize(
    ("rows", "radius", "velocity", "rate"),
    [
        (ROWS, None, 3.0, 1500.0),
        (ROWS, 3.0, 6.0, 1500.0),
        ([[0.3, 0.25], [0.8, 0.35], [2.5, 1.4]], 2.0, 7.0, 2500.0),  # rises with pressure
        ([[0.4, 0.3], [1.0, 0.42], [3.0, 0.8]], 2.0, 5.0, 4000.0),  # falls
        ([[0.4, 0.0], [1.0, 0.3]], None, 2.0, 800.0),  # none at low pressure
    ],
)
def test_segments_against_an_independent_integration(rows, radius, velocity, rate):
    case = {
        "rate": rate,
        "density": 900.0,
        "internal": 42.0,
        "width": 0.6,
        "from": 55.0,
        "to": 5.0,
        "length": 5.0,
        "radius": radius,
        "rows": rows,
        "velocity": velocity,
    }
    segment = (
        {"kind": "straight", "slope_deg": 55.0, "length_m": 5.0}
        if radius is None
        else {"kind": "curve", "radius_m": radius, "to_slope_deg": 5.0}
    )
    solution = chutecalc.solve(
        chute(
            flow={"rate_t_h": rate},
            material={"density_kg_m3": 900.0, "internal_friction_deg": 42.0},
            liners={"wall": {"yield_locus_kpa": rows}},
            sections={"body": {"shape": "rectangular", "width_m": 0.6}},
            inlet={"velocity_m_s": velocity, "slope_deg": 55.0},
            segments=[segment],
        )
    )
    # over a kink of the slope a step h of DOP853 is off by h² of what the slope jumps: 1e-7 of the way with 2,000 steps
    # times the jump, a hundredth at most
    assert solution.exit_velocity[0] == pytest.approx(integrated(case), rel=2e-9)


def test_an_impact_takes_the_friction_of_its_own_pressure():
    rows = [[1.0, 0.6], [20.0, 6.0]]
    solution = chutecalc.solve(
        chute(
            liners={"wall": {"yield_locus_kpa": rows}},
            inlet={"velocity_m_s": 6.0, "slope_deg": 60.0},
            sections={"body": {"shape": "rectangular", "width_m": 0.5}},
            segments=[{"kind": "straight", "slope_deg": 40.0, "length_m": 0.001}],
        )
    )
    angle = np.radians(20.0)
    stress = 800 * (6 * np.sin(angle)) ** 2 / 1e3
    depth = 1000 / 3.6 / 800 / 6.0 / 0.5
    ratio = (1 - np.sin(np.radians(50.0))) / (1 + np.sin(np.radians(50.0)))
    mu = friction(stress, rows, 50.0) * (1 + ratio * depth / 0.5)
    after = 6.0 * (np.cos(angle) - mu * np.sin(angle))
    assert solution.segments[0].impact["pressure_kpa"][0] == pytest.approx(stress, rel=1e-13)
    assert solution.segments[0].entry["velocity_m_s"][0] == pytest.approx(after, rel=1e-13)


def test_own_material_is_the_sine_of_internal_friction():
    own = chutecalc.solve(chute(liners={"wall": {"own_material": True}}))
    angle = np.degrees(np.arctan(np.sin(np.radians(50.0))))
    same = chutecalc.solve(chute(liners={"wall": {"friction_deg": angle}}))
    assert own.status[0] == same.status[0]
    assert own.exit["s_m"][0] == pytest.approx(same.exit["s_m"][0], rel=1e-12, nan_ok=True)
    assert not [finding for finding in own.findings() if finding.code == "inadmissible_friction"]


def test_slip_ratio_scales_wear_alone():
    whole = chutecalc.solve(chute())
    less = chutecalc.solve(chute(liners={"wall": {"friction_deg": 25.0, "slip_ratio": 0.7}}))
    assert less.exit["wear_w_m2"][0] == pytest.approx(0.7 * whole.exit["wear_w_m2"][0], rel=1e-14)
    assert less.exit_velocity[0] == whole.exit_velocity[0]


def test_roberts_wear_on_a_rectangular_spoon():
    # W_c = Q_m K_c g tan φ N_WR/B, N_WR = v²/(R g) + sin θ
    solution = chutecalc.solve(
        chute(
            liners={"wall": {"friction_deg": 25.0, "slip_ratio": 0.8}},
            sections={"body": {"shape": "rectangular", "width_m": 0.5}},
            inlet={"velocity_m_s": 6.0, "slope_deg": 90.0},
            segments=[{"kind": "curve", "radius_m": 3.0, "to_slope_deg": 0.0}],
        )
    )
    stations = solution.stations(points=9)
    theta = np.radians(90 - stations["slope_deg"][0])
    number = stations["velocity_m_s"][0] ** 2 / (3.0 * G) + np.sin(theta)
    assert np.allclose(stations["wear_number"][0], number, rtol=1e-13)
    exact = 1000 / 3.6 * 0.8 * G * np.tan(np.radians(25.0)) * number / 0.5
    assert np.allclose(stations["wear_w_m2"][0], exact, rtol=1e-12)
