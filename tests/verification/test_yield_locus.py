"""Wall friction that depends on pressure: bounds, kinks, and segments against an independent integration."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import chutecalc
from chutecalc.core import floats, guide_surface, section
from chutecalc.core.impact import added_friction
from chutecalc.design import Status
from chutecalc.physics.wall import wall_friction, yield_locus
from tests import seeds
from tests.conftest import chute
from tests.verification.test_independent_sections import circle

G = 9.80665
LIGHT = [[0.0002, 0.00018], [0.0003, 0.00024], [0.0006, 0.0003], [0.0012, 0.0004]]
ROWS = [[0.5, 0.30], [1.0, 0.52], [2.0, 0.95]]


def friction(stress, rows, internal_deg):
    """μ_w by its definition: linear between the rows, end slopes beyond them, τ(0) not below 0, τ not above σ sin δ."""
    sigma, tau = np.array(rows, dtype=float).T
    first = tau[0] - (tau[1] - tau[0]) / (sigma[1] - sigma[0]) * sigma[0]
    sigma, tau = np.append(0.0, sigma), np.append(max(first, 0.0), tau)
    k = int(np.clip(np.searchsorted(sigma, stress) - 1, 0, len(sigma) - 2))
    shear = tau[k] + (tau[k + 1] - tau[k]) / (sigma[k + 1] - sigma[k]) * (stress - sigma[k])
    return min(shear, stress * np.sin(np.radians(internal_deg))) / stress


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


def test_no_added_stress_adds_friction_at_the_rate_of_its_piece():
    """(τ(σ + p) - τ(σ))/p tends to dτ/dσ as p goes to 0, on every piece of the locus and of the bound."""
    wall = yield_locus(*np.array(ROWS).T[:, :, None] * 1e3, np.array([np.sin(np.radians(40.0))]))
    guide = guide_surface.Guide(
        section.Facets(1, False, floats.zeros(1)), section.Section(0, False), None, len(wall.starts)
    )
    guide.starts, guide.intercepts, guide.slopes = (np.ascontiguousarray(field[:, 0]) for field in wall)
    for stress in (1.0, 700.0, 1500.0, 9000.0):
        none, little = (added_friction(guide, stress, p) for p in (0.0, 1e-3 * stress))
        assert none > 0.0
        assert none == pytest.approx(little, rel=1e-9)


def test_a_locus_that_cuts_the_stress_axis_goes_to_the_origin_below_its_first_row():
    """μ = τ1/σ1 = 0.3 there; on 2°, 20 m, 3 m/s the exact distance to the stall by v dv/ds = A - B/v."""
    solution = chutecalc.solve(
        chute(
            flow={"rate_t_h": 300.0},
            material={"density_kg_m3": 1000.0, "internal_friction_deg": 45.0},
            liners={"wall": {"yield_locus_kpa": [[2.0, 0.6], [4.0, 1.6]]}},
            sections={"body": {"shape": "rectangular", "width_m": 0.6}},
            inlet={"velocity_m_s": 3.0, "slope_deg": 2.0},
            segments=[{"kind": "straight", "slope_deg": 2.0, "length_m": 20.0}],
        )
    )
    ratio = np.tan(np.radians(22.5)) ** 2
    slope, sines = np.radians(2.0), np.sin(np.radians(45.0))
    flow = 300 / 3.6 / 1000.0

    # in the pieces of σ = ρ g cos a Q/(v b): 0.3 up to 2 kPa, then τ = σ/2 - 0.4 kPa, below σ sin δ
    def rate(v, s):
        stress = 9.80665 * np.cos(slope) * flow / v / 0.6
        mu = min(0.3 if stress < 2.0 else 0.5 - 0.4 / stress, sines)
        return v / (9.80665 * (np.sin(slope) - mu * (1 + ratio * flow / v / 0.36) * np.cos(slope)))

    corner = 9.80665 * np.cos(slope) * flow / 2.0 / 0.6
    distances = [
        solve_ivp(rate, ends, [0.0], "DOP853", rtol=1e-12, atol=1e-14).y[0, -1]
        for ends in ((3.0, corner), (corner, 1e-7))
    ]
    assert solution.status[0] == "stall"
    assert solution.segments[0].exit["s_m"][0] == pytest.approx(sum(distances), rel=1e-9)
    assert sum(distances) == pytest.approx(1.669, abs=5e-4)


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
    # over a kink of the slope a step h of DOP853 is off by h² of what the slope jumps: with 2,000 steps 1e-7 of the
    # distance times the jump, a hundredth at most
    assert solution.exit_velocity[0] == pytest.approx(integrated(case), rel=2e-9)


@pytest.mark.parametrize("law", ["paper", "equilibrium"])
@pytest.mark.parametrize("base", [0.4, 0.0])
def test_the_locus_is_read_at_the_pressure_that_the_law_lays_on_the_floor(law, base):
    """f ρ n H, with f so that the walls' normal forces add up to (1 + χ) N; in a vee of 60° f is 1.5 and 2."""
    beta, ratio, mu_rows = np.radians(60.0), np.tan(np.radians(24.0)) ** 2, ROWS
    k = np.cos(beta) ** 2 + ratio * np.sin(beta) ** 2
    flow, density, radius = 900 / 3.6 / 1100.0, 1100.0, 3.0

    def rate(s, v):
        slope = np.radians(60.0) - s / radius
        n = G * np.cos(slope) + v[0] ** 2 / radius
        area = flow / v[0]
        # A = (B + C cos β) C sin β
        wetted = (-base + np.sqrt(base**2 + 4 * area * np.cos(beta) / np.sin(beta))) / (2 * np.cos(beta))
        depth = wetted * np.sin(beta)
        walls = 2 * k * wetted * depth / 2  # their hydrostatic normal force over ρ n
        hydrostatic = base * depth + walls
        missing = 1 - (base * depth + walls * np.cos(beta)) / area
        borne = hydrostatic / (1 - missing) if law == "equilibrium" else hydrostatic + missing * area
        mu = friction(density * n * depth * borne / hydrostatic / 1e3, mu_rows, 42.0)
        return [(G * np.sin(slope) - mu * borne / area * n) / v[0]]

    section = {"shape": "chamfered", "base_m": base, "chamfer_deg": 60.0}
    solution = chutecalc.solve(
        chute(
            model={"friction_law": law},
            flow={"rate_t_h": 900.0},
            material={"density_kg_m3": density, "internal_friction_deg": 42.0},
            liners={"wall": {"yield_locus_kpa": mu_rows}},
            sections={"body": section},
            inlet={"velocity_m_s": 8.0, "slope_deg": 60.0},
            segments=[{"kind": "curve", "radius_m": radius, "to_slope_deg": 10.0}],
        )
    )
    end = np.radians(50.0) * radius
    run = solve_ivp(rate, (0.0, end), [8.0], "DOP853", rtol=1e-12, atol=1e-14, max_step=end / 2000)
    assert solution.exit_velocity[0] == pytest.approx(run.y[0, -1], rel=2e-9)  # as above


def test_a_stream_that_leaves_a_hood_passes_the_rows_of_its_locus_on_the_way():
    """On a panel beyond the loss of contact stress is negative, and no less a measure of the path there."""
    rows = [[0.7294, 0.455], [0.8926, 0.5599], [1.219, 0.7961], [1.449, 0.7961], [3.2, 1.655]]
    radius, start, density, flow = 4.561, np.radians(-50.14), 641.1, 955.1 / 3.6 / 641.1
    of, lack = circle(0.2569), 1.0 - (1.0 - np.sin(np.radians(54.0))) / (1.0 + np.sin(np.radians(54.0)))

    def normal(s, y):
        return y[0] / radius - G * np.cos(start + s / radius)

    def rate(s, y):
        depth = brentq(lambda h: of(h).area - flow / np.sqrt(y[0]), 1e-9, 50.0, xtol=1e-15, rtol=1e-14)
        area, level, lacking = of(depth)
        n = max(normal(s, y), 1e-12)
        drag = friction(density * n * depth / 1e3, rows, 54.0) * (1.0 + (level - lack * lacking) / area)
        return [2.0 * (G * np.sin(start + s / radius) - drag * n)]

    normal.terminal, normal.direction = True, -1.0
    run = solve_ivp(rate, (0.0, 1.0), [6.321**2], "DOP853", rtol=1e-10, atol=1e-12, max_step=2e-3, events=normal)
    spec = {
        "flow": {"rate_t_h": 955.1},
        "material": {"density_kg_m3": density, "internal_friction_deg": 54.0},
        "liners": {"wall": {"yield_locus_kpa": rows}},
        "sections": {"body": {"shape": "circular", "radius_m": 0.2569}},
        "inlet": {"velocity_m_s": 6.321, "slope_deg": -50.14},
        "segments": [{"kind": "hood", "radius_m": radius, "from_slope_deg": -50.14, "to_slope_deg": 5.5}],
    }
    for rtol in (1e-6, 1e-10):
        solved = chutecalc.solve(chutecalc.parse(spec), rtol).trajectory.segment_solutions[0]
        assert solved.status[0] == Status.CONTACT_LOST
        # over a kink a step h is off by h² of what the slope jumps, as above
        assert solved.exit.distance[0] == pytest.approx(run.t_events[0][0], rel=1e-6)
        assert solved.exit.velocity[0] == pytest.approx(np.sqrt(run.y_events[0][0][0]), rel=1e-6)
        assert solved.contact.panels.count[0] < 60


@pytest.mark.parametrize("rtol", [1e-6, 1e-10, 1e-12])
def test_a_stream_that_clings_to_a_balance_next_to_rest_is_solved_at_every_tolerance(rtol):
    """Slope and friction nearly cancel there, and so do digits: no panel however short gets below that."""
    rows = [[0.91, 0.3555], [1.672, 0.8127], [2.966, 1.3887], [3.143, 1.3887], [3.393, 1.3887]]
    spoon = {"kind": "curve", "radius_m": 6.562, "from_slope_deg": 41.52, "to_slope_deg": -16.26}
    solution = chutecalc.solve(
        chute(
            model={"friction_law": "equilibrium"},
            flow={"rate_t_h": 515.5},
            material={"density_kg_m3": 1016.0, "internal_friction_deg": 36.36},
            liners={"wall": {"yield_locus_kpa": rows}},
            sections={"body": {"shape": "chamfered", "chamfer_deg": 38.5, "base_m": 0.5688}},
            inlet={"velocity_m_s": 0.513, "slope_deg": 41.52},
            segments=[spoon],
        ),
        rtol,
    )
    assert solution.status[0] == "stall"
    assert solution.trajectory.segment_solutions[0].contact.panels.count[0] < 60


def test_errors_beside_adhesion_are_within_their_estimates():
    """Adhesion takes off what the section adds to the change of friction with depth, not off Newton's remainder."""
    random, count = seeds.generator(5), seeds.times(400)
    base = chute(
        flow={"rate_t_h": 1000.0},
        material={"density_kg_m3": 900.0, "internal_friction_deg": 50.0},
        liners={"wall": {"yield_locus_kpa": [[1.0, 1.2], [6.0, 3.4]]}},
        sections={"body": {"shape": "facets", "facets": [{"length_m": 0.1, "slope_deg": 45.0}]}},
        inlet={"velocity_m_s": 5.0, "slope_deg": 60.0},
        segments=[{"kind": "curve", "radius_m": 3.0, "from_slope_deg": 60.0, "to_slope_deg": 30.0}],
    ).vary(
        {
            "flow.rate_t_h": random.uniform(300.0, 3000.0, count),
            "inlet.velocity_m_s": random.uniform(2.0, 9.0, count),
            "segments.1.radius_m": random.uniform(1.0, 8.0, count),
            "sections.body.facets.1.slope_deg": random.uniform(10.0, 80.0, count),
            "sections.body.facets.1.length_m": random.uniform(0.05, 0.2, count),
        }
    )
    right = chutecalc.exits(base, 1e-13)
    ran = right.ok
    assert ran.mean() > 0.5
    for rtol in (1e-8, 1e-10):
        found = chutecalc.exits(base, rtol)
        assert (found.status == right.status).all()
        off = np.abs(found.exit["velocity_m_s"] / right.exit["velocity_m_s"] - 1.0)[ran]
        assert (off <= found.error_estimate[ran] + right.error_estimate[ran] + 2e-13).all()


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


def test_light_material_obeys_a_locus_as_heavy_does():
    """Density, rate and locus ten thousand times as great: the same velocities, through rows at a few pascals."""
    stations = [
        chutecalc.solve(
            chute(
                flow={"rate_t_h": 0.1 * factor},
                material={"density_kg_m3": 0.05 * factor, "internal_friction_deg": 60.0},
                liners={"wall": {"yield_locus_kpa": [[factor * row for row in pair] for pair in LIGHT]}},
                sections={"body": {"shape": "rectangular", "width_m": 0.5}},
                inlet={"velocity_m_s": 1.0, "slope_deg": 50.0},
                segments=[
                    {"kind": "straight", "slope_deg": 50.0, "length_m": 2.0},
                    {"kind": "curve", "radius_m": 1.5, "to_slope_deg": 5.0},
                ],
            )
        ).stations(points=51)
        for factor in (40.0, 4e5)
    ]
    light, heavy = ({name: table[name][0] for name in ("velocity_m_s", "equivalent_friction")} for table in stations)
    assert len(set(light["equivalent_friction"].round(3))) > 20  # rows of the locus are crossed
    for name in light:
        assert np.allclose(light[name], heavy[name], rtol=1e-9, atol=0, equal_nan=True), name
