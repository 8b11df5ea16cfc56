"""Flights to where they land: placed segments, hoods struck again, segments flown past, plates, belts."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.optimize import brentq

import chutecalc
from chutecalc.physics.belt import loading
from tests.conftest import chute, vee

G = 9.80665
ONTO = {"kind": "fall", "name": "throw", "onto_next": True}


def parabola(velocity, slope_deg, x0=0.0, z0=0.0):
    u, w = velocity * np.cos(np.radians(slope_deg)), velocity * np.sin(np.radians(slope_deg))
    return lambda t: (x0 + u * t, z0 - w * t - 0.5 * G * t * t)


@pytest.mark.parametrize(("slope", "length"), [(20.0, 6.0), (45.0, 6.0), (70.0, 30.0)])
def test_onto_a_placed_straight(slope, length):
    start = (0.3, -1.0)
    fly = parabola(4.0, 10.0)

    def above(t):
        x, z = fly(t)
        return (z - start[1]) * np.cos(np.radians(slope)) + (x - start[0]) * np.sin(np.radians(slope))

    time = brentq(above, 0.0, 5.0, xtol=1e-15)
    x, z = fly(time)
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 4.0, "slope_deg": 10.0},
            segments=[ONTO, {"kind": "straight", "slope_deg": slope, "length_m": length, "start_m": list(start)}],
        )
    )
    throw, landed = solution.segments
    assert throw.status[0] == "ok"
    assert landed.entry["x_m"][0] == pytest.approx(x, abs=1e-13)
    assert landed.entry["z_m"][0] == pytest.approx(z, abs=1e-13)
    assert throw.duration[0] == pytest.approx(time, rel=1e-13)
    assert throw.exit["velocity_m_s"][0] == pytest.approx(np.sqrt(16 - 2 * G * z), rel=1e-13)
    assert landed.exit["x_m"][0] == pytest.approx(start[0] + length * np.cos(np.radians(slope)), rel=1e-13)
    # only what lies after the landing is computed
    travelled = landed.exit["s_m"][0] - landed.entry["s_m"][0]
    assert travelled == pytest.approx(length - np.hypot(x - start[0], z - start[1]), rel=1e-12)


@pytest.mark.parametrize(
    ("kind", "radius", "slopes", "start"),
    [
        ("curve", 1.5, (80.0, -20.0), (1.0, -0.6)),
        ("hood", 1.5, (5.0, 85.0), (0.3, 0.12)),
        ("curve", 6.0, (5.0, 40.0), (0.3, -0.15)),
    ],
)
def test_onto_a_placed_arc(kind, radius, slopes, start):
    fly = parabola(4.0, -5.0)
    first, last = np.radians(slopes)
    sign = 1.0 if last < first else -1.0  # centre of a spoon above it, of a crest and a hood below
    centre = np.array(start) + sign * radius * np.array([np.sin(first), np.cos(first)])

    def outside(t):
        return np.hypot(*(np.array(fly(t)) - centre)) - radius

    times = np.linspace(1e-6, 2.0, 4001)
    crossings = []
    for low, high in pairwise(times):
        if outside(low) * outside(high) < 0:
            time = brentq(outside, low, high, xtol=1e-15)
            x, z = np.array(fly(time)) - centre
            slope = np.arctan2(-sign * x, -sign * z)  # of the tangent there
            if min(slopes) <= np.degrees(slope) <= max(slopes):
                crossings.append((time, slope))
    time, slope = crossings[0]
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 4.0, "slope_deg": -5.0},
            sections=vee(),
            segments=[
                ONTO,
                {
                    "kind": kind,
                    "radius_m": radius,
                    "from_slope_deg": slopes[0],
                    "to_slope_deg": slopes[1],
                    "start_m": list(start),
                },
            ],
        )
    )
    landed = solution.segments[1]
    assert solution.segments[0].duration[0] == pytest.approx(time, rel=1e-11)
    assert landed.entry["slope_deg"][0] == pytest.approx(np.degrees(slope), rel=1e-11)
    assert (landed.entry["x_m"][0], landed.entry["z_m"][0]) == pytest.approx(fly(time), rel=1e-11)


def test_a_placed_segment_that_is_missed_says_by_how_much():
    # straight down from (0.5, 0) at 60°, 1 m long; the stream passes the normal through its end 1 m above it or so
    fly = parabola(6.0, 0.0)
    slope = np.radians(60.0)
    end = np.array([0.2, -0.3]) + np.array([np.cos(slope), -np.sin(slope)])

    def along(t):
        x, z = np.array(fly(t)) - end
        return x * np.cos(slope) - z * np.sin(slope)

    time = brentq(along, 0.0, 3.0)
    x, z = np.array(fly(time)) - end
    gap = x * np.sin(slope) + z * np.cos(slope)
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 6.0, "slope_deg": 0.0},
            segments=[ONTO, {"kind": "straight", "slope_deg": 60.0, "length_m": 1.0, "start_m": [0.2, -0.3]}],
        )
    )
    (finding,) = [item for item in solution.findings() if item.severity == "failure"]
    assert (solution.status[0], finding.code) == ("missed", "passed_by")
    assert finding.numbers["gap_m"][0] == pytest.approx(gap, rel=1e-11)
    assert "from its end" in finding.message()


def test_a_stream_that_falls_short_is_told_so():
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 1.0, "slope_deg": 0.0},
            segments=[ONTO, {"kind": "straight", "slope_deg": 30.0, "length_m": 1.0, "start_m": [2.0, -0.5]}],
        )
    )
    (finding,) = [item for item in solution.findings() if item.severity == "failure"]
    assert solution.status[0] == "missed"
    assert "falls short" in finding.message()


def test_a_short_segment_that_may_be_passed_is_flown_past_onto_the_one_after_it():
    short = {"name": "short", "kind": "straight", "slope_deg": 60.0, "length_m": 0.05, "may_be_passed": True}
    long = {"name": "long", "kind": "straight", "slope_deg": 60.0, "length_m": 5.0}
    inlet = {"velocity_m_s": 3.0, "slope_deg": 20.0}
    both = chutecalc.solve(chute(inlet=inlet, segments=[short, long]))
    one = chutecalc.solve(chute(inlet=inlet, segments=[long | {"length_m": 5.05}]))
    assert [result.status[0] for result in both.segments] == ["passed", "ok"]
    assert "passed_by" in [item.code for item in both.findings()]
    assert both.exit_velocity[0] == pytest.approx(one.exit_velocity[0], rel=1e-13)
    assert both.exit["s_m"][0] == pytest.approx(one.exit["s_m"][0], rel=1e-13)
    assert both.exit["time_s"][0] == pytest.approx(one.exit["time_s"][0], rel=1e-12)


def test_a_flight_past_a_segment_that_may_be_passed_falls_on():
    short = {"name": "short", "kind": "straight", "slope_deg": 60.0, "length_m": 0.05, "may_be_passed": True}
    solution = chutecalc.solve(
        chute(inlet={"velocity_m_s": 3.0, "slope_deg": 20.0}, segments=[short, {"kind": "fall", "drop_m": 2.0}])
    )
    drop = 0.05 * np.sin(np.radians(60.0)) + 2.0
    assert solution.exit_velocity[0] == pytest.approx(np.sqrt(9 + 2 * G * drop), rel=1e-13)


def test_a_stream_that_lifts_off_a_crest_lands_on_what_follows():
    # v² = R g cos a at 0°: it flies from the start, with the parabola of a stone
    crest = {"kind": "curve", "radius_m": 0.5, "to_slope_deg": 50.0}
    after = {"kind": "straight", "slope_deg": 50.0, "length_m": 8.0}
    velocity = np.sqrt(0.5 * G) * 1.2
    solution = chutecalc.solve(
        chute(inlet={"velocity_m_s": velocity, "slope_deg": 0.0}, sections=vee(), segments=[crest, after])
    )
    turn = np.radians(50.0)
    start = np.array([0.5 * np.sin(turn), -0.5 * (1 - np.cos(turn))])
    fly = parabola(velocity, 0.0)

    def above(t):
        x, z = np.array(fly(t)) - start
        return z * np.cos(turn) + x * np.sin(turn)

    time = brentq(above, 0.2, 5.0, xtol=1e-15)
    assert [result.status[0] for result in solution.segments] == ["contact_lost", "ok"]
    assert [result.name for result in solution.trajectory.results] == ["curve", "straight:flight", "straight"]
    assert (solution.segments[1].entry["x_m"][0], solution.segments[1].entry["z_m"][0]) == pytest.approx(fly(time))
    (lost,) = [item for item in solution.findings() if item.code == "contact_lost"]
    assert lost.severity == "warning"


def test_a_hood_that_the_stream_drops_off_is_struck_again():
    radius, first, velocity = 1.2, np.radians(5.0), 3.0
    fly = parabola(velocity, 5.0)
    centre = -radius * np.array([np.sin(first), np.cos(first)])

    def outside(t):
        return np.hypot(*(np.array(fly(t)) - centre)) - radius

    time = brentq(outside, 0.1, 1.0, xtol=1e-15)
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": velocity, "slope_deg": 5.0},
            sections=vee(),
            segments=[{"kind": "hood", "radius_m": radius, "to_slope_deg": 80.0}],
        )
    )
    assert [result.name for result in solution.trajectory.results] == ["hood", "hood:flight", "hood"]
    flight, again = solution.trajectory.results[1:]
    assert flight.duration[0] == pytest.approx(time, rel=1e-11)
    assert (again.entry["x_m"][0], again.entry["z_m"][0]) == pytest.approx(fly(time), rel=1e-11)
    (hood,) = solution.segments
    assert (hood.status[0], solution.status[0]) == ("ok", "ok")
    assert hood.exit["s_m"][0] == again.exit["s_m"][0]
    assert hood.minimum["velocity_m_s"][0] == pytest.approx(3.0)
    # a batch in which one drops off and one does not: neither disturbs the other
    both = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": velocity, "slope_deg": 5.0},
            sections=vee(),
            segments=[{"kind": "hood", "radius_m": radius, "to_slope_deg": 80.0}],
        ).vary({"inlet.velocity_m_s": [3.0, 6.0]})
    )
    alone = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 6.0, "slope_deg": 5.0},
            sections=vee(),
            segments=[{"kind": "hood", "radius_m": radius, "to_slope_deg": 80.0}],
        )
    )
    assert both.exit_velocity.tolist() == [solution.exit_velocity[0], alone.exit_velocity[0]]
    assert both.segments[0].exit["time_s"].tolist() == [
        hood.exit["time_s"][0],
        alone.segments[0].exit["time_s"][0],
    ]


def test_a_plate_is_struck_and_left():
    plate = {"kind": "plate", "slope_deg": 50.0, "length_m": 1.0, "start_m": [0.3, 0.3]}
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 5.0, "slope_deg": 10.0},
            sections=vee(),
            segments=[ONTO, plate, {"kind": "fall", "drop_m": 3.0}],
        )
    )
    struck, fall = solution.segments[1:]
    mu = struck.entry["equivalent_friction"][0]
    before, angle = struck.impact["velocity_before_m_s"][0], np.radians(struck.impact["incidence_deg"][0])
    after = before * (np.cos(angle) - mu * np.sin(angle))
    assert struck.status[0] == "ok"
    assert struck.exit["s_m"][0] == struck.entry["s_m"][0]
    assert struck.exit["velocity_m_s"][0] == pytest.approx(after, rel=1e-13)
    assert fall.entry["slope_deg"][0] == pytest.approx(50.0, rel=1e-13)
    # down to 3 m below the plate's drawn end
    level = 0.3 - np.sin(np.radians(50.0)) - 3.0
    drop = struck.exit["z_m"][0] - level
    assert fall.exit["velocity_m_s"][0] == pytest.approx(np.sqrt(after**2 + 2 * G * drop), rel=1e-13)
    assert "contact_lost" not in [item.code for item in solution.findings()]


def test_a_fall_by_its_run():
    solution = chutecalc.solve(
        chute(inlet={"velocity_m_s": 4.0, "slope_deg": -20.0}, segments=[{"kind": "fall", "run_m": 2.5}])
    )
    time = 2.5 / (4 * np.cos(np.radians(20.0)))
    fall = solution.segments[0]
    assert fall.duration[0] == pytest.approx(time, rel=1e-14)
    assert fall.exit["x_m"][0] == pytest.approx(2.5, rel=1e-14)
    _, height = parabola(4.0, -20.0)(time)
    assert fall.exit["z_m"][0] == pytest.approx(height, rel=1e-13)


@pytest.mark.parametrize("velocity", [1.2, 4.0])
def test_discharge_from_a_belt(velocity):
    belt = {
        "velocity_m_s": velocity,
        "incline_deg": 12.0,
        "pulley_radius_m": 0.4,
        "belt_thickness_m": 0.02,
        "material_depth_m": 0.2,
    }
    data = {"belt": belt, "at_m": [10.0, 20.0]}
    base = chute(segments=[{"kind": "fall", "drop_m": 1.0}])
    tables = base.data | {"inlet": data}
    solution = chutecalc.solve(chutecalc.parse(tables))
    radius = 0.4 + 0.02 + 0.1
    held = velocity**2 / (G * radius) < np.cos(np.radians(12.0))
    own = velocity * radius / 0.42 if held else velocity  # it turns with the pulley
    slope = np.arccos(own**2 / (G * radius)) if held else -np.radians(12.0)
    entry, inlet = solution.segments[0].entry, solution.inlet
    assert entry["velocity_m_s"][0] == pytest.approx(own, rel=1e-15)
    assert inlet["discharge_froude"][0] == pytest.approx(own**2 / (G * radius), rel=1e-14)
    assert entry["slope_deg"][0] == pytest.approx(np.degrees(slope), rel=1e-13)
    assert entry["x_m"][0] == pytest.approx(10 + radius * np.sin(slope), rel=1e-14)
    assert entry["z_m"][0] == pytest.approx(20 + radius * np.cos(slope), rel=1e-14)
    lower = np.arccos(velocity**2 / (G * 0.42)) if held else slope  # the belt holds it for longer
    assert inlet["lower_edge_x_m"][0] == pytest.approx(10 + 0.42 * np.sin(lower), rel=1e-14)
    assert inlet["lower_edge_z_m"][0] == pytest.approx(20 + 0.42 * np.cos(lower), rel=1e-14)


def test_the_receiving_belt():
    receiver = {"velocity_m_s": 4.0, "slope_deg": -5.0, "friction_deg": 10.0}
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 3.0, "slope_deg": 35.0},
            liners={"wall": {"friction_deg": 0.0}},
            segments=[{"kind": "straight", "slope_deg": 35.0, "length_m": 1.0}],
            receiver=receiver,
        )
    )
    belt, v = solution.receiver, np.sqrt(9 + 2 * G * np.sin(np.radians(35.0)))
    angle, mu = np.radians(40.0), np.tan(np.radians(10.0))
    along, across = v * np.cos(angle), v * np.sin(angle)
    pull = mu * np.cos(np.radians(-5.0)) + np.sin(np.radians(-5.0))
    assert belt["velocity_along_m_s"][0] == pytest.approx(along, rel=1e-13)
    assert belt["velocity_into_m_s"][0] == pytest.approx(across, rel=1e-13)
    assert belt["velocity_ratio"][0] == pytest.approx(along / 4, rel=1e-13)
    assert belt["impact_pressure_kpa"][0] == pytest.approx(0.8 * across**2, rel=1e-13)
    assert belt["wear_w_m2"][0] == pytest.approx(mu * 800 * across**2 * (4 - along), rel=1e-12)
    assert belt["acceleration_length_m"][0] == pytest.approx((16 - along**2) / (2 * G * pull), rel=1e-12)
    assert belt["acceleration_power_kw"][0] == pytest.approx(1 / 3.6 * 4 * (4 - along), rel=1e-12)
    # with the friction of the impact first, here less than what is lacking
    landed = along + mu * across
    assert landed < 4.0
    assert belt["landed_velocity_m_s"][0] == pytest.approx(landed, rel=1e-13)
    assert belt["landed_acceleration_length_m"][0] == pytest.approx((16 - landed**2) / (2 * G * pull), rel=1e-12)
    # what would match does match
    match = np.radians(belt["matching_slope_deg"][0] + 5.0)
    assert v * np.cos(match) == pytest.approx(4.0, rel=1e-12)
    assert belt["matching_velocity_m_s"][0] * np.cos(angle) == pytest.approx(4.0, rel=1e-12)


def falling_onto(drop, velocity, slope, friction):
    """Return a stream that falls straight down onto a belt."""
    receiver = {"velocity_m_s": velocity, "slope_deg": slope, "friction_deg": friction}
    segments = [{"kind": "fall", "drop_m": drop}]
    inlet = {"velocity_m_s": 0.0, "slope_deg": 90.0}
    solution = chutecalc.solve(chute(inlet=inlet, segments=segments, receiver=receiver))
    return {name: values[0] for name, values in solution.receiver.items()}, solution


def test_a_stream_that_runs_back_first_is_brought_to_the_belts_speed_behind_where_it_fell():
    belt, solution = falling_onto(2.5, 1.0, -12.0, 25.0)
    along = -np.sqrt(2 * G * 2.5) * np.sin(np.radians(12.0))
    push = np.tan(np.radians(25.0)) * np.cos(np.radians(12.0)) - np.sin(np.radians(12.0))
    assert push == pytest.approx(0.25, abs=0.005)
    assert belt["acceleration_length_m"] == pytest.approx((1 - along**2) / (2 * G * push), rel=1e-12)
    assert belt["acceleration_length_m"] < 0.0
    assert belt["landed_velocity_m_s"] == 1.0  # its impact alone brings it there
    assert belt["landed_acceleration_length_m"] == 0.0
    assert not [finding for finding in solution.findings() if finding.code == "not_accelerated"]


def test_a_belt_too_steep_for_its_friction_never_brings_a_stream_to_its_speed():
    belt, solution = falling_onto(3.0, 2.0, -18.0, 14.0)
    assert belt["acceleration_length_m"] == np.inf
    assert [finding.code for finding in solution.findings() if finding.code == "not_accelerated"]


def test_no_velocity_matches_a_belt_square_to_the_stream():
    belt, _ = falling_onto(1.0, 2.0, 0.0, 25.0)
    assert np.isnan(belt["matching_velocity_m_s"])
    failed = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 1.0, "slope_deg": 0.0},
            segments=[{"kind": "straight", "slope_deg": 0.0, "length_m": 50.0}],
            receiver={"velocity_m_s": 2.0, "slope_deg": 0.0, "friction_deg": 25.0},
        )
    )
    assert failed.status[0] == "stall"
    assert all(np.isnan(values[0]) for values in failed.receiver.values())


@pytest.mark.parametrize("slope", [-20.0, 0.0, 15.0])
@pytest.mark.parametrize("start", [-3.0, -1.0, 0.5, 6.0])
def test_acceleration_on_a_belt_is_the_motion_of_a_block(slope, start):
    """Friction towards the belt's speed, weight along it: integrated until the speeds are one."""
    one, mu, speed = np.ones(1), 0.45, 2.0
    # a stream of that velocity along the belt and none into it
    load = loading(
        velocity=abs(start) * one,
        slope=np.radians(slope) + (np.pi if start < 0 else 0.0) * one,
        belt_velocity=speed * one,
        belt_slope=np.radians(slope) * one,
        friction=mu * one,
        plan_angle=0.0 * one,
        density=one,
        mass_rate=one,
        gravity=G * one,
    )
    assert load.velocity_along[0] == pytest.approx(start, rel=1e-12)
    pull = np.sign(speed - start) * mu * G * np.cos(np.radians(slope)) + G * np.sin(np.radians(slope))
    if pull * (speed - start) <= 0.0:
        assert load.acceleration_length[0] == np.inf
        return
    velocity, distance, dt = start, 0.0, 1e-4
    while (velocity - speed) * (start - speed) > 0.0:
        velocity, distance = velocity + pull * dt, distance + velocity * dt + pull * dt * dt / 2
    assert load.acceleration_length[0] == pytest.approx(distance, abs=2 * abs(speed) * dt)  # it stops within one step


@pytest.mark.parametrize("slope", [5.0, 30.0, 55.0])
def test_the_matching_slope_lies_on_the_streams_side_of_the_belt(slope):
    """An exit slope next to the one there is: flatter streams match from above the belt, steeper ones from below."""
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 5.0, "slope_deg": slope},
            liners={"wall": {"friction_deg": 0.0}},
            segments=[{"kind": "straight", "slope_deg": slope, "length_m": 0.001}],
            receiver={"velocity_m_s": 4.0, "slope_deg": 20.0, "friction_deg": 30.0},
        )
    )
    match = solution.receiver["matching_slope_deg"][0]
    assert solution.exit_velocity[0] * np.cos(np.radians(match - 20.0)) == pytest.approx(4.0, rel=1e-12)
    assert (match > 20.0) == (slope > 20.0)
