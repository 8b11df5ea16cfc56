"""Impacts, what they press and wear, streams that meet a crest again, and what is never reached."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import chutecalc
from chutecalc.design import Status
from tests.conftest import chute
from tests.verification.test_yield_locus import ROWS, friction

G = 9.80665
PLAIN = {
    "flow": {"rate_t_h": 300.0},
    "material": {"density_kg_m3": 1000.0, "internal_friction_deg": 45.0},
    "liners": {"wall": {"friction_deg": 20.0}},
    "sections": {"body": {"shape": "rectangular", "width_m": 0.6}},
}


def solved(**tables):
    return chutecalc.solve(chutecalc.parse(PLAIN | tables))


def added(stress, more, rows):
    """Return what τ grows by over what σ does, kPa."""
    total = stress + more
    return (friction(total, rows, 50.0) * total - friction(stress, rows, 50.0) * stress) / more


@pytest.mark.parametrize(("length", "whole"), [(3.0, True), (0.01, False)])
def test_an_impact_has_the_friction_that_its_pressure_on_the_footprint_adds(length, whole):
    velocity, angle, slope = 6.0, np.radians(20.0), np.radians(40.0)
    solution = chutecalc.solve(
        chute(
            liners={"wall": {"yield_locus_kpa": [[1.0, 0.6], [20.0, 6.0]]}},
            inlet={"velocity_m_s": velocity, "slope_deg": 60.0},
            sections={"body": {"shape": "rectangular", "width_m": 0.5}},
            segments=[{"kind": "straight", "slope_deg": 40.0, "length_m": length}],
        )
    )
    depth = 1000 / 3.6 / 800 / velocity / 0.5
    footprint = depth / np.sin(angle) if whole else length
    assert whole == (depth / np.sin(angle) < length)
    pressure = 0.8 * velocity**2 * np.sin(angle) * depth / footprint
    mu = added(0.8 * G * np.cos(slope) * depth, pressure, [[1.0, 0.6], [20.0, 6.0]])
    ratio = (1 - np.sin(np.radians(50.0))) / (1 + np.sin(np.radians(50.0)))
    after = velocity * (np.cos(angle) - mu * (1 + ratio * depth / 0.5) * np.sin(angle))
    impact = {name: values[0] for name, values in solution.segments[0].impact.items()}
    assert impact["pressure_kpa"] == pytest.approx(pressure, rel=1e-13)
    assert impact["footprint_m"] == pytest.approx(footprint, rel=1e-13)
    assert solution.segments[0].entry["velocity_m_s"][0] == pytest.approx(after, rel=1e-13)
    # friction of floor and sides over the footprint takes what there is of energy along the floor
    work = 1000 / 3.6 * ((velocity * np.cos(angle)) ** 2 - after**2) / 2
    assert impact["wear_w_m2"] * footprint * 0.5 * (1 + ratio * depth / 0.5) == pytest.approx(work, rel=1e-12)


def test_a_slow_impact_wears_with_its_own_velocities():
    solution = solved(
        inlet={"velocity_m_s": 0.6, "slope_deg": 60.0},
        segments=[{"kind": "straight", "slope_deg": 30.0, "length_m": 2.0}],
    )
    impact = {name: values[0] for name, values in solution.segments[0].impact.items()}
    depth, ratio = 300 / 3600 / 0.6 / 0.6, np.tan(np.radians(22.5)) ** 2
    after = 0.6 * (0.75**0.5 - np.tan(np.radians(20.0)) * (1 + ratio * depth / 0.6) * 0.5)
    work = 300 / 3.6 * (0.75 * 0.36 - after**2) / 2
    assert impact["velocity_after_m_s"] == pytest.approx(after, rel=1e-12)
    assert impact["wear_w_m2"] * impact["footprint_m"] * 0.6 * (1 + ratio * depth / 0.6) == pytest.approx(work)


def test_an_impact_that_stops_the_stream_wears_what_it_had_along_the_floor():
    solution = solved(
        inlet={"velocity_m_s": 5.0, "slope_deg": 85.0},
        liners={"wall": {"friction_deg": 35.0}},
        segments=[{"kind": "straight", "slope_deg": 20.0, "length_m": 2.0}],
    )
    assert solution.status[0] == "stall"
    impact = {name: values[0] for name, values in solution.segments[0].impact.items()}
    depth = 300 / 3600 / 5.0 / 0.6
    ratio = np.tan(np.radians(22.5)) ** 2
    work = 300 / 3.6 * (5.0 * np.cos(np.radians(65.0))) ** 2 / 2
    assert impact["wear_w_m2"] * impact["footprint_m"] * 0.6 * (1 + ratio * depth / 0.6) == pytest.approx(work)


@pytest.mark.parametrize("law", ["paper", "equilibrium"])
@pytest.mark.parametrize("rows", [[[0.5, 0.30], [3.0, 1.0]], [[2.0, 0.6], [4.0, 1.6]]])
def test_many_short_straights_on_a_locus_tend_to_the_curve(rows, law):
    """Their impacts press as the curve does, and adhesion counts once: the error falls with their number."""
    tables = {
        "model": {"friction_law": law},
        "liners": {"wall": {"yield_locus_kpa": rows}},
        "sections": {"body": {"shape": "chamfered", "base_m": 0.3, "chamfer_deg": 60.0}},
        "inlet": {"velocity_m_s": 9.0, "slope_deg": 80.0},
    }
    arc = solved(**tables, segments=[{"kind": "curve", "radius_m": 2.0, "to_slope_deg": 20.0}])
    off = []
    for count in (100, 200, 400):
        slopes = 80.0 - 60.0 * (np.arange(count) + 0.5) / count
        length = 2.0 * np.radians(60.0) / count
        pieces = [{"kind": "straight", "length_m": length, "slope_deg": float(a)} for a in slopes]
        off.append(abs(solved(**tables, segments=pieces).exit_velocity[0] / arc.exit_velocity[0] - 1))
    assert off[0] < 0.02
    # as with a constant angle: the impacts' own loss is of the order of the turn of one joint
    assert off[1] / off[0] == pytest.approx(0.5, abs=0.06)
    assert off[2] / off[1] == pytest.approx(0.5, abs=0.06)


def test_a_plate_shows_the_pressure_and_the_wear_of_its_impact():
    solution = solved(
        inlet={"velocity_m_s": 5.0, "slope_deg": 30.0},
        segments=[{"kind": "plate", "slope_deg": 60.0, "length_m": 1.0}, {"kind": "fall", "drop_m": 0.5}],
    )
    plate = solution.segments[0]
    assert plate.entry["pressure_kpa"][0] == pytest.approx((5.0 * np.sin(np.radians(30.0))) ** 2, rel=1e-12)
    assert plate.entry["wear_w_m2"][0] == plate.impact["wear_w_m2"][0] > 0.0
    assert plate.maximum["pressure_kpa"][0] == plate.impact["pressure_kpa"][0]


def crest(velocity, start=-50.0, end=40.0):
    return solved(
        inlet={"velocity_m_s": velocity, "slope_deg": start},
        segments=[{"kind": "curve", "radius_m": 3.0, "to_slope_deg": end}],
    )


def test_a_crest_that_rises_is_met_again():
    """Thrown off at once, down on it again where the parabola meets the circle, on along it to the end."""
    start, velocity, radius = np.radians(-50.0), 6.0, 3.0
    forward, up = velocity * np.cos(start), -velocity * np.sin(start)
    # circle of the crest through (0, 0), its centre below
    centre = (radius * np.sin(-start), -radius * np.cos(start))

    def clearance(t):
        x, z = forward * t, up * t - G * t * t / 2
        return np.hypot(x - centre[0], z - centre[1]) - radius

    time = brentq(clearance, 0.05, 0.7, xtol=1e-15)
    x, down = forward * time, G * time - up
    slope = np.arcsin((x - centre[0]) / radius)
    arriving, incidence = np.hypot(forward, down), np.arctan2(down, forward) - slope
    flow, ratio, mu = 300 / 3600, np.tan(np.radians(22.5)) ** 2, np.tan(np.radians(20.0))
    after = arriving * (np.cos(incidence) - mu * (1 + ratio * flow / arriving / 0.36) * np.sin(incidence))

    def rate(s, v):
        a = slope + s / radius
        n = G * np.cos(a) - v * v / radius
        return (G * np.sin(a) - mu * (1 + ratio * flow / v / 0.36) * n) / v

    end = (np.radians(40.0) - slope) * radius
    run = solve_ivp(rate, (0.0, end), [after], "DOP853", rtol=1e-12, atol=1e-14)
    solution = crest(velocity)
    again = solution.trajectory.results[-1]
    assert solution.status[0] == "ok"
    assert [result.status[0] for result in solution.trajectory.results] == ["contact_lost", "ok", "ok"]
    assert again.entry["slope_deg"][0] == pytest.approx(np.degrees(slope), rel=1e-11)
    assert again.impact["incidence_deg"][0] == pytest.approx(np.degrees(incidence), rel=1e-11)
    assert solution.exit_velocity[0] == pytest.approx(run.y[0, -1], rel=1e-10)
    assert solution.exit_velocity[0] == pytest.approx(3.9635, abs=5e-5)
    assert [finding.severity for finding in solution.findings() if finding.code == "contact_lost"] == ["warning"]


@pytest.mark.parametrize("start", [-60.0, -30.0, -5.0])
def test_a_crest_is_met_again_up_to_the_velocity_that_clears_it(start):
    """R g cos a0 < v² ≤ R g / cos a0: beyond that the parabola stays clear of the whole circle."""
    cosine = np.cos(np.radians(start))
    for square, met in ((0.999 / cosine, True), (1.001 / cosine, False), (1.001 * cosine, True)):
        solution = crest(float(np.sqrt(3.0 * G * square)), start, 85.0)
        assert solution.trajectory.segment_solutions[0].status[0] == Status.CONTACT_LOST, square  # at once
        assert (len(solution.trajectory.segment_solutions) > 1) == met, square


def test_in_a_batch_each_crest_is_met_as_it_is_alone():
    base = chutecalc.parse(
        PLAIN
        | {
            "inlet": {"velocity_m_s": 6.0, "slope_deg": -50.0},
            "segments": [{"kind": "curve", "radius_m": 3.0, "from_slope_deg": -50.0, "to_slope_deg": 40.0}],
        }
    )
    velocities = np.array([3.0, 5.0, 6.0, 6.5, 7.0, 9.0])
    many = chutecalc.solve(base.vary({"inlet.velocity_m_s": velocities}))
    for k, velocity in enumerate(velocities):
        alone = crest(float(velocity))
        assert alone.status[0] == many.status[k]
        assert np.array_equal(alone.exit_velocity, many.exit_velocity[k : k + 1], equal_nan=True)
    assert {"ok", "contact_lost"} <= set(many.status.tolist())


def test_what_falls_straight_down_never_reaches_a_distance():
    """After a floor that the stream flew past, the run is from its end; after a hood to 90° alone it is refused."""
    passed = solved(
        inlet={"velocity_m_s": 0.0, "slope_deg": 90.0},
        segments=[
            {"kind": "fall", "onto_next": True},
            {"kind": "straight", "slope_deg": 30.0, "length_m": 1.0, "start_m": [0.0, -1.0]},
            {"kind": "fall", "run_m": 0.5},
        ],
    )
    assert passed.status[0] == "ok"  # it lands: the floor begins right under it
    beside = solved(
        inlet={"velocity_m_s": 0.0, "slope_deg": 90.0},
        segments=[
            {"kind": "fall", "onto_next": True},
            {"kind": "straight", "slope_deg": 30.0, "length_m": 1.0, "start_m": [-0.9, -1.0], "may_be_passed": True},
            {"kind": "fall", "run_m": 3.0},
        ],
    )
    assert beside.status[0] == "missed"
    assert [segment.status[0] for segment in beside.segments[1:]] == ["passed", "missed"]
    assert np.isnan(beside.exit_velocity[0])
    hood = [{"name": "hood", "kind": "hood", "radius_m": 1.0, "from_slope_deg": 20.0, "to_slope_deg": 80.0}]
    base = chutecalc.parse(
        PLAIN | {"inlet": {"velocity_m_s": 8.0, "slope_deg": 20.0}, "segments": [*hood, {"kind": "fall", "run_m": 1.0}]}
    )
    with pytest.raises(chutecalc.SpecError, match="never reached") as caught:
        base.vary({"segments.hood.to_slope_deg": [80.0, 90.0]})
    assert caught.value.designs.tolist() == [False, True]
    steep = chutecalc.solve(base.vary({"segments.hood.to_slope_deg": [80.0, 89.99999]}))
    assert steep.status.tolist() == ["ok", "missed"]  # a metre aside after 10,000 km of fall


def test_slip_ratio_scales_the_wear_of_an_impact():
    def wear(**liner):
        segments = [{"kind": "straight", "slope_deg": 40.0, "length_m": 1.0}]
        solution = chutecalc.solve(
            chute(inlet={"velocity_m_s": 4.0, "slope_deg": 60.0}, liners={"wall": liner}, segments=segments)
        )
        return solution.segments[0].impact["wear_w_m2"][0]

    assert wear(friction_deg=25.0, slip_ratio=0.7) == pytest.approx(0.7 * wear(friction_deg=25.0), rel=1e-14)


def test_the_factor_of_the_walls_holds_at_an_impact_too():
    """A 60° vee, where f is 1.5 and more: the impact's friction is that of f times weight and momentum."""
    beta, ratio = np.radians(60.0), np.tan(np.radians(20.0)) ** 2
    solution = chutecalc.solve(
        chute(
            liners={"wall": {"yield_locus_kpa": ROWS}},
            sections={"body": {"shape": "vee", "chamfer_deg": 60.0}},
            inlet={"velocity_m_s": 5.0, "slope_deg": 55.0},
            segments=[{"kind": "straight", "slope_deg": 40.0, "length_m": 3.0}],
        )
    )
    k = np.cos(beta) ** 2 + ratio * np.sin(beta) ** 2
    depth = np.sqrt(1000 / 3.6 / 800 / 5.0 * np.tan(beta))  # A = H²/tan β
    factor = 1 + (1 - k) * np.cos(beta) / k  # (1 + χ)/(1 + χ - m) with (1 + χ - m) cos β = k
    angle = np.radians(15.0)
    weight, pressure = factor * 0.8 * G * np.cos(np.radians(40.0)) * depth, factor * 0.8 * (5.0 * np.sin(angle)) ** 2
    mu = added(weight, pressure, ROWS) * (1 + k * (1 - np.cos(beta)) / np.cos(beta))
    after = 5.0 * (np.cos(angle) - mu * np.sin(angle))
    assert solution.segments[0].entry["velocity_m_s"][0] == pytest.approx(after, rel=1e-12)


@pytest.mark.parametrize("start", [-0.5, -1.5])
def test_the_landing_margin_is_the_way_to_the_nearer_end(start):
    """A stream that falls straight down at x = 0 onto a straight of 3 m at 45°, which begins at x = start."""
    case = chute(
        inlet={"velocity_m_s": 1.0, "slope_deg": 90.0},
        segments=[
            {"kind": "fall", "onto_next": True},
            {"kind": "straight", "start_m": [start, -2.0], "slope_deg": 45.0, "length_m": 3.0},
            {"kind": "fall", "drop_m": 1.0},
        ],
    )
    fall, straight, onwards = chutecalc.solve(case).segments
    along = -start * np.sqrt(2.0)
    assert straight.landing_margin == pytest.approx([min(along, 3.0 - along)], rel=1e-9)
    assert np.isnan([fall.landing_margin, onwards.landing_margin]).all()
    assert np.isnan(chutecalc.solve(chute()).segments[0].landing_margin).all()  # the stream begins on it
