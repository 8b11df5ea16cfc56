"""Against exact solutions. A vee's friction does not depend on depth, so its μ_e is one number."""

import numpy as np
import pytest

import chutecalc
from chutecalc.physics.motion import FLOOR, ROOF
from tests.conftest import chute, spec, vee, vee_friction
from tests.verification.exact import (
    arc_velocity_squared,
    normal_acceleration,
    rectangular_straight_distance,
    straight_velocity_squared,
)

G = 9.80665
WALL, BETA, DELTA = 20.0, 50.0, 40.0
FRICTION = vee_friction(WALL, BETA, DELTA)


def vee_chute(velocity, slope, *segments):
    return chute(
        material={"internal_friction_deg": DELTA},
        liners={"wall": {"friction_deg": WALL}},
        sections=vee(BETA),
        inlet={"velocity_m_s": velocity, "slope_deg": slope},
        segments=list(segments),
    )


@pytest.mark.parametrize(
    ("kind", "side", "velocity", "start", "end"),
    [
        ("curve", FLOOR, 5.0, 90.0, 10.0),  # spoon
        ("curve", FLOOR, 6.0, 45.0, -10.0),  # spoon that rises at its end
        ("curve", FLOOR, 2.0, 5.0, 40.0),  # crest
        ("curve", FLOOR, 5.0, -20.0, 15.0),  # crest that first rises
        ("hood", ROOF, 8.0, 10.0, 85.0),
        ("hood", ROOF, 9.0, -15.0, 60.0),  # hood that first rises
    ],
)
@pytest.mark.parametrize("rtol", [1e-10, 1e-12])
def test_arc_of_constant_friction(kind, side, velocity, start, end, rtol):
    radius = 3.0
    solution = chutecalc.solve(
        vee_chute(velocity, start, {"kind": kind, "radius_m": radius, "to_slope_deg": end}), rtol
    )
    stations = solution.stations(points=51)
    slope = np.radians(stations["slope_deg"][0])

    exact = np.sqrt(arc_velocity_squared(side, G, radius, FRICTION, np.radians(start), velocity, slope))

    assert solution.status[0] == "ok"
    assert np.abs(stations["velocity_m_s"][0] / exact - 1).max() < rtol


def test_exact_arcs_solve_the_equation_of_motion():
    # central differences of the exact solution against dy/ds = 2 (g sin a - μ n): error h² y'''/6
    for side, turn in ((FLOOR, -1.0), (FLOOR, 1.0), (ROOF, 1.0)):
        a, h, radius, friction = 0.7, 1e-5, 2.0, 0.3
        before, y, after = (
            float(arc_velocity_squared(side, G, radius, friction, a - turn * 0.2, 4.0, at)) for at in (a - h, a, a + h)
        )
        slope = (after - before) / (2 * h) * turn / radius
        normal = float(normal_acceleration(side, G, a, -turn / radius, y))
        assert slope == pytest.approx(2 * (G * np.sin(a) - friction * normal), rel=1e-8)


@pytest.mark.parametrize(("velocity", "slope"), [(2.0, 55.0), (6.0, 12.0)])
def test_straight_of_constant_friction(velocity, slope):
    solution = chutecalc.solve(vee_chute(velocity, slope, {"kind": "straight", "slope_deg": slope, "length_m": 2.0}))
    stations = solution.stations(points=21)

    exact = straight_velocity_squared(G, np.radians(slope), FRICTION, velocity, stations["s_m"][0])

    assert np.abs(stations["velocity_m_s"][0] / np.sqrt(exact) - 1).max() < 1e-10


def test_stall_on_a_straight_of_constant_friction():
    velocity, slope = 3.0, np.radians(5.0)
    solution = chutecalc.solve(vee_chute(velocity, 5.0, {"kind": "straight", "slope_deg": 5.0, "length_m": 20.0}))

    stop = velocity**2 / (2 * G * (FRICTION * np.cos(slope) - np.sin(slope)))

    assert solution.status[0] == "stall"
    assert abs(solution.trajectory.segment_solutions[0].exit.distance[0] - stop) < 1e-8


@pytest.mark.parametrize(("last", "status"), [(0.5e-3, "stall"), (2e-3, "ok")])
def test_a_stream_slower_than_a_millimetre_in_a_second_has_stalled(last, status):
    velocity, slope = 3.0, np.radians(5.0)
    length = (velocity**2 - last**2) / (2 * G * (FRICTION * np.cos(slope) - np.sin(slope)))
    solution = chutecalc.solve(vee_chute(velocity, 5.0, {"kind": "straight", "slope_deg": 5.0, "length_m": length}))
    assert solution.status[0] == status
    assert abs(solution.trajectory.segment_solutions[0].exit.distance[0] - length) < 1e-8


@pytest.mark.parametrize(
    ("velocity", "slope", "length"),
    [(2.0, 50.0, 4.0), (1.0, 35.0, 3.0), (6.0, 20.0, 5.0), (0.8, 30.0, 2.0), (12.0, 5.0, 8.0)],
)
def test_straight_rectangular_chute_with_friction_growing_with_depth(velocity, slope, length):
    width, wall, delta, rate, density = 0.6, 22.0, 45.0, 600.0, 900.0
    solution = chutecalc.solve(
        chute(
            flow={"rate_t_h": rate},
            material={"density_kg_m3": density, "internal_friction_deg": delta},
            liners={"wall": {"friction_deg": wall}},
            sections={"body": {"shape": "rectangular", "width_m": width}},
            inlet={"velocity_m_s": velocity, "slope_deg": slope},
            segments=[{"kind": "straight", "slope_deg": slope, "length_m": length}],
        )
    )
    stations = solution.stations(points=11)
    speed, distance = stations["velocity_m_s"][0], stations["s_m"][0]
    reached = np.isfinite(speed) & (speed > 0)

    a, mu = np.radians(slope), np.tan(np.radians(wall))
    ratio = (1 - np.sin(np.radians(delta))) / (1 + np.sin(np.radians(delta)))
    drive, drag = G * (np.sin(a) - mu * np.cos(a)), G * mu * ratio * np.cos(a) * rate / 3.6 / density / width**2
    exact = rectangular_straight_distance(drive, drag, velocity, speed[reached])

    assert np.abs(exact - distance[reached]).max() < 1e-10 * length
    if solution.status[0] == "stall":  # at v = 0 the same formula gives the distance to the stop
        stop = rectangular_straight_distance(drive, drag, velocity, 0.0)
        assert abs(solution.trajectory.segment_solutions[0].exit.distance[0] - stop) < 1e-8


def test_the_implicit_straight_solution_solves_its_equation():
    # ds/dv = v²/(A v - B), by central differences
    drive, drag, h = 2.0, 0.7, 1e-5
    low, high = rectangular_straight_distance(drive, drag, 1.0, np.array([2.0 - h, 2.0 + h]))
    assert (high - low) / (2 * h) == pytest.approx(2.0**2 / (drive * 2.0 - drag), rel=1e-9)


def test_lift_off_from_a_frictionless_crest():
    # energy: v² = v0² + 2 g R (cos a0 - cos a); it lifts where v² = R g cos a: cos a = (v0²/(g R) + 2 cos a0)/3
    velocity, radius, start = 3.0, 2.0, 10.0
    solution = chutecalc.solve(
        chute(
            liners={"wall": {"friction_deg": 0.0}},
            inlet={"velocity_m_s": velocity, "slope_deg": start},
            segments=[{"kind": "curve", "radius_m": radius, "to_slope_deg": 80.0}],
        )
    )

    lift = np.arccos((velocity**2 / (G * radius) + 2 * np.cos(np.radians(start))) / 3)

    assert solution.status[0] == "contact_lost"
    assert abs(solution.trajectory.segment_solutions[0].exit.distance[0] - radius * (lift - np.radians(start))) < 1e-8


def test_a_slow_stream_drops_off_a_rising_hood():
    # frictionless: v² = v0² - 2 g (z - z0) with z - z0 = R (cos a - cos a0); it drops where v² = R g cos a
    velocity, radius, start = 6.3, 4.0, -35.0
    solution = chutecalc.solve(
        chute(
            liners={"wall": {"friction_deg": 0.0}},
            inlet={"velocity_m_s": velocity, "slope_deg": start},
            segments=[{"kind": "hood", "radius_m": radius, "to_slope_deg": 40.0}],
        )
    )

    drop = -np.arccos((velocity**2 / (G * radius) + 2 * np.cos(np.radians(start))) / 3)

    assert solution.status[0] == "contact_lost"
    assert abs(solution.trajectory.segment_solutions[0].exit.distance[0] - radius * (drop - np.radians(start))) < 1e-8


def test_choke_where_the_depth_passes_the_wall():
    # a vee decelerating at constant friction: depth = wall height at A = H² cot β, v = Q/A
    height, velocity, slope = 0.5, 3.0, np.radians(10.0)
    data = spec(
        material={"internal_friction_deg": DELTA},
        liners={"wall": {"friction_deg": WALL}},
        sections=vee(BETA, wall_height_m=height),
        inlet={"velocity_m_s": velocity, "slope_deg": 10.0},
        segments=[{"kind": "straight", "slope_deg": 10.0, "length_m": 20.0}],
    )
    solution = chutecalc.solve(chutecalc.parse(data))

    brake = 2 * G * (FRICTION * np.cos(slope) - np.sin(slope))
    at_choke = 1000 / 3.6 / 800 / (height**2 / np.tan(np.radians(BETA)))
    choked, stop = (velocity**2 - at_choke**2) / brake, velocity**2 / brake

    assert solution.status[0] == "choke"
    assert abs(solution.trajectory.segment_solutions[0].exit.distance[0] - choked) < 1e-8
    (finding,) = [item for item in solution.findings() if item.code == "choke"]
    assert finding.numbers["further_m"][0] == pytest.approx(stop - choked, abs=1e-8)
