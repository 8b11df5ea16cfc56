"""Falls, impacts and landings against the parabola's own equations (README, The model)."""

import numpy as np
import pytest
from scipy.integrate import quad

import chutecalc
from chutecalc.core.flight import time_to_drop
from chutecalc.core.quartic import Quartic, falls_through_zero
from chutecalc.core.records import Flight
from tests.conftest import chute, vee, vee_friction

G = 9.80665


def test_fall_keeps_the_horizontal_velocity():
    velocity, slope, drop = 3.0, np.radians(20.0), 1.7
    solution = chutecalc.solve(
        chute(inlet={"velocity_m_s": velocity, "slope_deg": 20.0}, segments=[{"kind": "fall", "drop_m": drop}])
    )

    down = np.sqrt((velocity * np.sin(slope)) ** 2 + 2 * G * drop)
    time = (down - velocity * np.sin(slope)) / G
    length, _ = quad(
        lambda t: np.hypot(velocity * np.cos(slope), velocity * np.sin(slope) + G * t), 0, time, epsabs=1e-13
    )

    end = solution.exit
    assert end["velocity_m_s"][0] == pytest.approx(np.hypot(velocity * np.cos(slope), down), rel=1e-14)
    assert end["slope_deg"][0] == pytest.approx(np.degrees(np.arctan2(down, velocity * np.cos(slope))), rel=1e-14)
    assert end["x_m"][0] == pytest.approx(velocity * np.cos(slope) * time, rel=1e-13)
    assert end["z_m"][0] == pytest.approx(-drop, rel=1e-13)
    assert end["time_s"][0] == pytest.approx(time, rel=1e-13)
    assert end["s_m"][0] == pytest.approx(length, rel=1e-12)


def test_stations_of_a_flight_lie_on_its_parabola_evenly_along_it():
    solution = chutecalc.solve(
        chute(inlet={"velocity_m_s": 2.0, "slope_deg": -40.0}, segments=[{"kind": "fall", "drop_m": 1.0}])
    )
    stations = solution.stations(points=11)
    x, z, s = (stations[name][0] for name in ("x_m", "z_m", "s_m"))
    forward, up = 2.0 * np.cos(np.radians(40.0)), 2.0 * np.sin(np.radians(40.0))

    assert np.allclose(z, up * x / forward - 0.5 * G * (x / forward) ** 2, rtol=0, atol=1e-13)
    assert np.allclose(np.diff(s), s[-1] / 10, rtol=1e-12)
    for k in range(10):
        length, _ = quad(lambda at: np.hypot(1.0, up / forward - G * at / forward**2), x[k], x[k + 1], epsabs=1e-14)
        assert length == pytest.approx(s[1] - s[0], rel=1e-10)


@pytest.mark.parametrize("incidence", [1.0, 20.0, 30.0, 45.0])
def test_impact_on_a_vee(incidence):
    velocity, wall, beta, delta = 4.0, 25.0, 50.0, 45.0
    friction = vee_friction(wall, beta, delta)
    solution = chutecalc.solve(
        chute(
            material={"internal_friction_deg": delta},
            sections=vee(beta),
            inlet={"velocity_m_s": velocity, "slope_deg": 30.0 + incidence},
            segments=[{"kind": "straight", "slope_deg": 30.0, "length_m": 0.1}],
        )
    )

    i = np.radians(incidence)
    assert solution.segments[0].entry["velocity_m_s"][0] == pytest.approx(
        velocity * (np.cos(i) - friction * np.sin(i)), rel=1e-14
    )


def test_an_impact_from_the_stall_incidence_on_leaves_nothing():
    friction = vee_friction(25.0, 50.0, 45.0)
    steepest = np.degrees(np.arctan(1 / friction))
    for off, moves in ((-0.01, True), (0.01, False)):
        solution = chutecalc.solve(
            chute(
                material={"internal_friction_deg": 45.0},
                sections=vee(50.0),
                inlet={"velocity_m_s": 4.0, "slope_deg": 89.0},
                segments=[{"kind": "straight", "slope_deg": 89.0 - steepest - off, "length_m": 1e-3}],
            )
        )
        assert (solution.segments[0].entry["velocity_m_s"][0] > 0.0) == moves


def test_leaving_an_edge_and_landing_further_down_a_straight():
    velocity, first, second = 3.0, np.radians(20.0), np.radians(50.0)
    solution = chutecalc.solve(
        chute(
            sections=vee(45.0),
            inlet={"velocity_m_s": velocity, "slope_deg": 20.0},
            segments=[{"kind": "straight", "slope_deg": 50.0, "length_m": 5.0}],
        )
    )

    time = 2 * velocity * np.sin(second - first) / (G * np.cos(second))
    x, down = velocity * np.cos(first) * time, velocity * np.sin(first) + G * time
    length = x / np.cos(second)
    arriving, slope = np.hypot(velocity * np.cos(first), down), np.arctan2(down, velocity * np.cos(first))
    friction = vee_friction(25.0, 45.0, 50.0)
    after = arriving * np.cos(slope - second) - friction * arriving * np.sin(slope - second)

    flight, straight = solution.trajectory.results
    assert (flight.name, flight.kind) == ("straight:flight", "flight")
    assert flight.duration[0] == pytest.approx(time, rel=1e-12)
    assert arriving * np.sin(slope - second) == pytest.approx(velocity * np.sin(second - first), rel=1e-12)
    assert straight.entry["x_m"][0] == pytest.approx(x, rel=1e-12)
    assert straight.entry["z_m"][0] == pytest.approx(-length * np.sin(second), rel=1e-12)
    assert straight.entry["velocity_m_s"][0] == pytest.approx(after, rel=1e-12)
    assert straight.entry["s_m"][0] == flight.exit["s_m"][0]


def test_a_flight_past_the_end_misses_by_the_distance_on_the_normal_through_it():
    velocity, slope, floor, length = 5.0, np.radians(10.0), np.radians(50.0), 1.0
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": velocity, "slope_deg": 10.0},
            segments=[{"kind": "straight", "slope_deg": 50.0, "length_m": length}],
        )
    )
    (finding,) = [item for item in solution.findings() if item.code == "passed_by"]

    # along the floor: v cos(a1 - a0) t + g sin(a1) t²/2 = length; off it: v sin(a1 - a0) t - g cos(a1) t²/2
    turn = floor - slope
    time = np.roots([0.5 * G * np.sin(floor), velocity * np.cos(turn), -length]).max()
    gap = velocity * np.sin(turn) * time - 0.5 * G * np.cos(floor) * time**2

    assert solution.status[0] == "missed"
    assert finding.numbers["gap_m"][0] == pytest.approx(gap, rel=1e-12)


def test_a_curve_is_the_limit_of_many_short_straights():
    """The impacts at their joints take what the curve's centripetal load takes: error falls with their number."""
    off = []
    for count in (50, 100, 200):
        slopes = 80.0 - 60.0 * (np.arange(count) + 0.5) / count
        pieces = [
            {"kind": "straight", "slope_deg": float(a), "length_m": 2.0 * np.radians(60.0) / count} for a in slopes
        ]
        inlet = {"velocity_m_s": 4.0, "slope_deg": 80.0}
        polygon = chutecalc.solve(chute(inlet=inlet, segments=pieces))
        arc = chutecalc.solve(chute(inlet=inlet, segments=[{"kind": "curve", "radius_m": 2.0, "to_slope_deg": 20.0}]))
        off.append(abs(polygon.exit_velocity[0] / arc.exit_velocity[0] - 1))
    assert off[0] < 0.02
    # the impacts' own loss, i²/2 each, is of the order of the turn of one joint
    assert off[1] / off[0] == pytest.approx(0.5, abs=0.05)
    assert off[2] / off[1] == pytest.approx(0.5, abs=0.05)


def test_contact_lost_goes_on_in_a_fall_from_where_the_stream_left():
    solution = chutecalc.solve(
        chute(
            liners={"wall": {"friction_deg": 0.0}},
            inlet={"velocity_m_s": 3.0, "slope_deg": 10.0},
            segments=[
                {"name": "crest", "kind": "curve", "radius_m": 2.0, "to_slope_deg": 80.0},
                {"kind": "fall", "drop_m": 1.0},
            ],
        )
    )
    crest, fall = solution.trajectory.results

    assert solution.status[0] == "ok"
    assert crest.status[0] == "contact_lost"
    assert fall.entry["velocity_m_s"][0] == pytest.approx(crest.exit["velocity_m_s"][0], rel=1e-14)
    # the fall ends 1 m below the crest's drawn end, wherever the stream left it; energy is conserved
    level = -2.0 * (np.cos(np.radians(10.0)) - np.cos(np.radians(80.0))) - 1.0
    assert fall.exit["z_m"][0] == pytest.approx(level, rel=1e-13)
    assert fall.exit["velocity_m_s"][0] == pytest.approx(np.sqrt(9.0 - 2 * G * level), rel=1e-10)


def test_nothing_catches_a_stream_that_loses_contact_before_another_contact_segment():
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 5.0, "slope_deg": 10.0},
            segments=[
                {"name": "crest", "kind": "curve", "radius_m": 1.0, "to_slope_deg": 80.0},
                {"name": "after", "kind": "straight", "slope_deg": 80.0, "length_m": 1.0},
            ],
        )
    )
    assert solution.status[0] == "missed"
    assert [result.status[0] for result in solution.trajectory.results] == ["contact_lost", "missed"]
    # what is lost on the crest is a warning, for something follows; that this does not catch it is the failure
    severity = {finding.code: (finding.severity, finding.segment) for finding in solution.findings()}
    assert severity["contact_lost"] == ("warning", "crest")
    assert severity["passed_by"] == ("failure", "after")


def test_all_roots_at_which_a_polynomial_falls_are_found():
    """Of degree 4 and less, within the horizon and beyond it, beside each other and far apart."""
    sets = [
        (0.2, 0.4, 0.6, 0.8),
        (0.1, 0.11, 0.5, 3.0),
        (-1.0, 0.3, 0.9, 2.5),
        (0.02, 0.98, 1.5, 1.9),
        (-2.0, -1.0, 0.5, 9.0),
    ]
    for roots in sets:
        for sign in (1.0, -1.0):
            rising = sign * np.poly(roots)[::-1]
            curve = Quartic()
            curve.value = np.append(rising, 0.0)
            found = np.asarray(curve.falls)[: falls_through_zero(curve, 2.0)]
            falling = roots[0::2] if sign > 0.0 else roots[1::2]  # from +∞ at -∞ through the first
            expected = [root for root in falling if 0.0 < root < 2.0]
            assert found == pytest.approx(expected, rel=1e-12)


def test_a_stream_that_has_nothing_to_fall_is_there_at_once():
    path = Flight()
    path.gravity = G
    for path.forward, path.downward in ((0.0, 0.0), (2.0, 0.0), (2.0, 0.3)):
        assert time_to_drop(path, 0.0) == 0.0
