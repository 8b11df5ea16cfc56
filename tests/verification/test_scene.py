"""What a designer tried, and was told was ok: each is told now."""

import csv
import io

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import chutecalc
from chutecalc.cli import main

G = 9.80665
HEAD = {
    "flow": {"rate_t_h": 1000.0},
    "material": {"density_kg_m3": 850.0, "internal_friction_deg": 50.0},
    "liners": {"wall": {"friction_deg": 24.0}},
    "sections": {"body": {"shape": "rectangular", "width_m": 0.9}},
    "inlet": {"velocity_m_s": 3.5, "slope_deg": 0.0},
}
ONTO = {"kind": "fall", "onto_next": True}
HOOD = {"name": "hood", "kind": "hood", "radius_m": 1.5, "from_slope_deg": 20.0, "to_slope_deg": 85.0}
SPOON = {"name": "spoon", "kind": "curve", "radius_m": 2.5, "from_slope_deg": 80.0, "to_slope_deg": 25.0}
TO_BELT = [{"name": "to_belt", "kind": "fall", "drop_m": 4.0}]
BELT = {"velocity_m_s": 4.0, "friction_deg": 30.0}
START = ("x_m", "z_m", "velocity_m_s", "slope_deg")


def chute(**tables):
    return chutecalc.parse(HEAD | tables)


def codes(solution, severity=None):
    return [finding.code for finding in solution.findings() if severity in (None, finding.severity)]


def transfer(hood, spoon):
    """Return hood and spoon at these places, before a fall to the belt."""
    segments = [ONTO, HOOD | {"start_m": hood}, ONTO, SPOON | {"start_m": spoon}, *TO_BELT]
    return chute(segments=segments, receiver=BELT)


def test_a_hood_and_a_spoon_that_the_stream_flies_past_are_a_failure():
    solution = chutecalc.solve(transfer([0.4, 1.6], [-2.0, -1.0]))
    assert solution.status[0] == "missed"
    assert codes(solution, "failure") == ["passed_by"]
    assert [segment.status[0] for segment in solution.segments[2:]] == ["not_reached"] * 3
    # the spoon alone: what the hood sends past it
    spoon = chutecalc.solve(transfer([0.3, 0.35], [-2.0, -1.0]))
    assert [segment.status[0] for segment in spoon.segments][1] == "ok"
    assert spoon.status[0] == "missed"


def test_a_sweep_of_900_designs_marks_the_band_that_hits_nothing(tmp_path, capsys):
    """Whether the parabola of each design cuts the hood's circle on its arc is worked out here, for each."""
    spec, rows = tmp_path / "chute.toml", tmp_path / "rows.csv"
    spec.write_text(
        "[flow]\nrate_t_h = 1000\n[material]\ndensity_kg_m3 = 850\ninternal_friction_deg = 50\n[liners.wall]\n"
        'friction_deg = 24\n[sections.body]\nshape = "rectangular"\nwidth_m = 0.9\n[inlet]\nvelocity_m_s = 3.5\n'
        'slope_deg = 0\n[[segments]]\nkind = "fall"\nonto_next = true\n[[segments]]\nname = "hood"\nkind = "hood"\n'
        'start_m = [0.4, 0.2]\nradius_m = 1.5\nfrom_slope_deg = 20\nto_slope_deg = 60\n[[segments]]\nkind = "fall"\n'
        "drop_m = 3\n"
    )
    command = ["sweep", str(spec), "inlet.velocity_m_s=1:6:#30", "segments.hood.start_m.2=-0.6:0.9:#30"]
    assert main([*command, "--csv", str(rows)]) == 0
    found = list(csv.DictReader(io.StringIO(rows.read_text())))
    assert len(found) == 900
    first, last = np.radians([20.0, 60.0])
    for row in found:
        v, z = float(row["inlet.velocity_m_s"]), float(row["segments.hood.start_m.2"])
        centre = np.array([0.4 - 1.5 * np.sin(first), z - 1.5 * np.cos(first)])
        time = np.linspace(0.0, 1.2, 20001)
        x, height = v * time - centre[0], -0.5 * G * time**2 - centre[1]
        outside = np.hypot(x, height) - 1.5
        angle = np.arctan2(x, height)
        out = (outside[:-1] < 0) & (outside[1:] >= 0)
        margin = np.abs(np.concatenate([angle[:-1][out] - first, angle[:-1][out] - last, [1.0]])).min()
        if margin < 1e-3 or np.abs(outside).min() < 1e-6:
            continue  # at an edge of the steel, which these samples do not resolve
        hits = bool(((angle[:-1][out] > first) & (angle[:-1][out] < last)).any())
        assert (row["status"] != "missed") == hits, row
    assert {row["status"] for row in found} >= {"ok", "missed"}


def test_an_operating_range_is_checked_on_the_steel_that_is_drawn():
    base = chute(segments=[{"kind": "fall", "run_m": 1.2}, SPOON | {"from_slope_deg": 60.0}])
    speeds = np.array([2.0, 3.0, 3.5, 3.6, 4.0])
    solution = chutecalc.solve(base.vary({"inlet.velocity_m_s": speeds}))
    drop = 0.5 * G * (1.2 / 3.5) ** 2  # of the spoon's start below the inlet
    reaches = speeds * np.sqrt(2 * drop / G) >= 1.2 * (1 - 1e-12)  # the parabola gets over the spoon's edge
    assert ((solution.status != "missed") == reaches).all()
    starts = solution.trajectory.segment_solutions[1].contact.surface
    assert np.ptp(starts.x) == np.ptp(starts.z) == 0.0


def test_a_pipe_that_would_be_filled_four_times_chokes():
    radius, area = 0.2, np.pi * 0.2**2
    rate = 4 * area * 850.0 * 3.0 * 3.6
    straight = [{"kind": "straight", "slope_deg": 40.0, "length_m": 2.0}]
    pipe = {"sections": {"body": {"shape": "pipe", "radius_m": radius}}, "segments": straight}
    inlet = {"velocity_m_s": 3.0, "slope_deg": 40.0}
    solution = chutecalc.solve(chute(flow={"rate_t_h": rate}, inlet=inlet, **pipe))
    assert (solution.status[0], codes(solution, "failure")) == ("choke", ["choke"])


def test_a_convex_bend_of_a_pipe_does_not_throw_the_stream_through_its_wall():
    pipe = {"sections": {"body": {"shape": "pipe", "radius_m": 0.3}}, "flow": {"rate_t_h": 400.0}}
    bend = {"name": "bend", "kind": "curve", "radius_m": 2.0, "to_slope_deg": 80.0}
    after = {"name": "down", "kind": "straight", "slope_deg": 80.0, "length_m": 4.0}
    solution = chutecalc.solve(chute(inlet={"velocity_m_s": 5.0, "slope_deg": 10.0}, segments=[bend, after], **pipe))
    assert solution.status[0] == "ok"
    stations = solution.stations(points=50)
    x, z = (stations[name][0][np.isfinite(stations["x_m"][0])] for name in ("x_m", "z_m"))
    centre = 2.0 * np.array([-np.sin(np.radians(10.0)), -np.cos(np.radians(10.0))])
    along = np.arctan2(x - centre[0], z - centre[1])
    inside = along < np.radians(80.0)  # in the bend: between its two walls
    radius = np.hypot(x - centre[0], z - centre[1])[inside]
    assert (radius > 2.0 - 1e-9).all()
    assert (radius < 2.6 + 1e-9).all()


@pytest.mark.parametrize(
    ("change", "remedy"),
    [
        ({"liners.wall.friction_deg": 0.45}, "friction_rad = 0.45"),
        ({"segments.1.radius_m": 1500.0}, "radius_mm = 1500"),
        ({"material.density_kg_m3": 2.5}, "density_t_m3 = 2.5"),
        ({"receiver.velocity_m_s": 90.0}, "velocity_fpm = 90"),
    ],
)
def test_a_unit_that_is_probably_mistaken_is_told_with_its_likeliest_remedy(change, remedy):
    spoon = SPOON | {"from_slope_deg": 60.0}
    base = chute(inlet={"velocity_m_s": 3.5, "slope_deg": 60.0}, segments=[spoon], receiver=BELT)
    assert "implausible" not in codes(chutecalc.solve(base))
    solution = chutecalc.solve(base.put(change))
    (finding,) = [finding for finding in solution.findings() if finding.code == "implausible"]
    assert (finding.severity, finding.key) == ("warning", *change)
    assert remedy in finding.message()


def test_a_hard_landing_and_a_stream_off_the_speed_of_its_belt_are_told():
    """6.7 m/s and 39 kPa into the belt passed without a word."""
    straight = [{"kind": "straight", "slope_deg": 75.0, "length_m": 2.5}]
    solution = chutecalc.solve(
        chute(inlet={"velocity_m_s": 3.0, "slope_deg": 75.0}, segments=straight, receiver=BELT | {"at_m": [0.0, -3.0]})
    )
    assert solution.receiver["velocity_into_m_s"][0] > 6.0
    assert {"hard_landing", "off_speed"} <= {*codes(solution, "warning")}


def test_the_components_on_a_belt_are_those_of_vectors():
    """Random streams and belts: dot products with heading, normal and the level line across; squares add to v²."""
    random = np.random.default_rng(5)
    for _ in range(50):
        v, a, ab, psi = random.uniform([1, -0.5, -0.4, -3.1], [9, 1.5, 0.4, 3.1])
        slope = float(np.degrees(a))
        base = chute(
            liners={"wall": {"friction_deg": 0.0}},
            inlet={"velocity_m_s": float(v), "slope_deg": slope},
            segments=[{"kind": "fall", "drop_m": 1.0}],
            receiver=BELT
            | {"slope_deg": float(np.degrees(ab)), "plan_angle_deg": float(np.degrees(psi)), "at_m": [0.0, -40.0]},
        )
        solution = chutecalc.solve(base)
        heading = np.array([np.cos(ab) * np.cos(psi), np.cos(ab) * np.sin(psi), -np.sin(ab)])
        across = np.array([-np.sin(psi), np.cos(psi), 0.0])
        normal = np.cross(heading, across)
        x, z = (solution.receiver[name][0] for name in ("landing_x_m", "landing_z_m"))
        assert abs(normal @ np.array([x, 0.0, z + 40.0])) < 1e-9  # it lands on the plane of the belt
        time = x / (v * np.cos(a))
        stream = np.array([v * np.cos(a), 0.0, -v * np.sin(a) - G * time])
        found = {name: solution.receiver[f"velocity_{name}_m_s"][0] for name in ("along", "into", "across")}
        assert found["along"] == pytest.approx(stream @ heading, rel=1e-10, abs=1e-10)
        assert found["into"] == pytest.approx(abs(stream @ normal), rel=1e-10, abs=1e-10)
        assert found["across"] == pytest.approx(-stream @ across, rel=1e-10, abs=1e-10)
        assert sum(value**2 for value in found.values()) == pytest.approx(stream @ stream, rel=1e-12)


@pytest.mark.parametrize("slope", [-12.0, 0.0, 10.0])
def test_friction_on_a_belt_acts_against_the_slip_along_and_across_it(slope):
    """A block on a moving plane, integrated as vectors in the plane of the belt, with the friction of the impact."""
    mu, ab, psi, v, drop = 0.6, np.radians(slope), np.radians(70.0), 3.0, 1.5
    base = chute(
        inlet={"velocity_m_s": v, "slope_deg": 0.0},
        segments=[{"kind": "fall", "drop_m": drop}],
        receiver={"velocity_m_s": 4.0, "slope_deg": slope, "friction_deg": float(np.degrees(np.arctan(mu)))}
        | {"plan_angle_deg": 70.0},
    )
    found = {name: values[0] for name, values in chutecalc.solve(base).receiver.items()}
    stream = np.array([v, 0.0, -np.sqrt(2 * G * drop)])
    heading = np.array([np.cos(ab) * np.cos(psi), np.cos(ab) * np.sin(psi), -np.sin(ab)])
    aside = np.array([-np.sin(psi), np.cos(psi), 0.0])
    slip = np.array([stream @ heading - 4.0, stream @ aside])
    into = abs(stream @ np.cross(heading, aside))
    after = slip * max(1 - mu * into / np.hypot(*slip), 0.0)
    assert found["landed_velocity_m_s"] == pytest.approx(4.0 + after[0], rel=1e-12)
    for start, column in ((slip, "acceleration_length_m"), (after, "landed_acceleration_length_m")):
        whole = np.hypot(*start)

        def rates(_, state):
            return [
                4.0 + state[1],
                G * np.sin(ab) - mu * G * np.cos(ab) * state[1] / np.hypot(state[1], state[2]),
                -mu * G * np.cos(ab) * state[2] / np.hypot(state[1], state[2]),
            ]

        def left(_, state, enough=1e-12 * whole):
            return np.hypot(state[1], state[2]) - enough

        left.terminal = True
        length = 0.0
        if whole > 0:
            block = solve_ivp(rates, (0.0, 50.0), [0.0, *start], "DOP853", events=left, rtol=1e-11, atol=1e-13)
            length = block.y[0, -1]
        # the integration has its own 1e-11, and turns fast where little slip is left
        assert found[column] == pytest.approx(length, rel=1e-8, abs=1e-12)


def test_what_a_stream_does_not_fit_into_or_touch_is_a_failure():
    """A mouth flown through, a plate with low walls, a hood drawn along a stream that curves away from it."""
    inlet = {"velocity_m_s": 3.0, "slope_deg": 0.0}
    wide = {"shape": "rectangular", "width_m": 1.0}
    pipe = {"pipe": {"shape": "pipe", "radius_m": 0.15}, "open": wide}
    straight = {"kind": "straight", "slope_deg": 5.0, "length_m": 0.1, "start_m": [0.5, -0.3], "section": "pipe"}
    through = [ONTO, straight, {"kind": "fall", "drop_m": 1.0}]
    for rate, status in ((10.0, "ok"), (3000.0, "choke")):
        flown = chutecalc.solve(chute(flow={"rate_t_h": rate}, inlet=inlet, sections=pipe, segments=through))
        assert flown.status[0] == status
    assert any(finding.code == "choke" and "whole closed section" in finding.message() for finding in flown.findings())

    plate = [{"kind": "plate", "slope_deg": 60.0, "length_m": 1.0}, {"kind": "fall", "drop_m": 1.0}]
    for height, status in ((10.0, "ok"), (0.01, "choke")):
        low = {"low": wide | {"wall_height_m": height}}
        assert chutecalc.solve(chute(inlet=inlet, sections=low, segments=plate)).status[0] == status

    for radius, status in ((0.5, "ok"), (2.0, "missed")):  # v²/g = 0.92 m
        hood = {"kind": "hood", "radius_m": radius, "to_slope_deg": 60.0}
        solution = chutecalc.solve(chute(inlet=inlet, segments=[hood, {"kind": "fall", "drop_m": 1.0}]))
        assert solution.status[0] == status
    assert next(finding.code for finding in solution.findings() if finding.segment == "hood") == "passed_by"


def test_the_depth_on_the_feed_belt_follows_the_rate_and_all_edges_meet_the_hood_or_are_told():
    belt = {"velocity_m_s": 3.5, "pulley_radius_m": 0.5, "width_m": 1.2, "trough_deg": 35.0, "surcharge_deg": 15.0}
    hood = [ONTO, HOOD | {"start_m": [0.5, 0.48], "radius_m": 1.8}, {"kind": "fall", "drop_m": 1.0}]
    base = chute(inlet={"belt": belt}, segments=hood)
    solution = chutecalc.solve(base.vary({"flow.rate_t_h": [400.0, 800.0, 1600.0]}))
    depth = solution.inlet["material_depth_m"]
    assert (np.diff(depth) > 0).all()
    assert solution.inlet["load_width_m"] * depth == pytest.approx(solution.inlet["load_area_m2"], rel=1e-14)
    misses = next(finding for finding in solution.findings() if finding.code == "edge_misses")
    lands = [lands_on_the_hood(solution.edges[k].numbers, hood[1]) for k in (0, 2)]
    assert misses.mask.tolist() == [not (one and other) for one, other in zip(*lands, strict=True)]
    assert set(misses.mask.tolist()) == {True, False}


def lands_on_the_hood(edge, hood):
    """Return for each design whether the parabola of an edge meets the drawn arc from within its circle."""
    radius, first, last = hood["radius_m"], np.radians(hood["from_slope_deg"]), np.radians(hood["to_slope_deg"])
    centre = hood["start_m"][0] - radius * np.sin(first), hood["start_m"][1] - radius * np.cos(first)
    found = []
    for x, z, v, slope in zip(*(np.broadcast_to(edge[k], 3) for k in START), strict=True):
        time = np.linspace(0.0, 1.5, 150_001)
        dx = x + v * np.cos(slope * np.pi / 180.0) * time - centre[0]
        dz = z - v * np.sin(slope * np.pi / 180.0) * time - G * time**2 / 2 - centre[1]
        out = np.hypot(dx, dz) > radius
        leaves = np.flatnonzero(~out[:-1] & out[1:])  # a roof is met on the way out
        angles = np.arctan2(dx[leaves], dz[leaves])  # of the surface's slope
        found.append(bool(((angles >= first) & (angles <= last)).any()))
    return found


def test_what_slides_on_a_slow_pulley_is_thrown_further():
    belt = {"velocity_m_s": 1.0, "pulley_radius_m": 0.5, "friction_deg": float(np.degrees(np.arctan(0.5)))}
    held = {key: value for key, value in belt.items() if key != "friction_deg"}
    runs = [chutecalc.solve(chute(inlet={"belt": each}, segments=TO_BELT)) for each in (held, belt)]
    slopes = [run.inlet["slope_deg"][0] for run in runs]
    assert slopes == [pytest.approx(78.2, abs=0.05), pytest.approx(52.7, abs=0.05)]
    x = [run.exit["x_m"][0] - run.inlet["x_m"][0] for run in runs]
    assert x[1] > 1.5 * x[0]
