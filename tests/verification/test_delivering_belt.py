"""The belt that the stream comes from: its load by polygons, sliding by integration in time, edges by parabolas."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import chutecalc
from chutecalc.physics.head_pulley import discharge, slide, slide_start
from chutecalc.physics.troughed_belt import belt_load, load_area, loaded_width, usable_width
from tests import seeds
from tests.conftest import chute

G = 9.80665
ONE = np.ones(1)
TROUGHS = [  # middle roll and covered width, m; trough and surcharge angle, deg
    (0.38, 0.85, 35.0, 15.0),
    (0.38, 0.20, 35.0, 15.0),  # on the middle roll alone
    (0.38, 0.38, 35.0, 15.0),
    (0.50, 1.10, 0.0, 20.0),  # flat
    (0.30, 1.00, 45.0, 0.0),  # as a liquid
    (0.01, 1.20, 20.0, 25.0),  # two rolls, nearly
]
POINTS = 1000


def radians(*angles):
    return [np.radians(angle) * ONE for angle in angles]


def polygon_area(roll, covered, trough, surcharge):
    """Return the area of a load drawn point by point, by the surveyor's formula."""
    flat, side = min(roll, covered), max(covered - roll, 0.0) / 2
    half, rise = flat / 2 + side * np.cos(trough), side * np.sin(trough)
    across = np.linspace(half, -half, POINTS + 1)
    # the parabola through both ends of the level that meets it there at the surcharge angle
    top = rise + (half**2 - across**2) * np.tan(surcharge) / (2 * half)
    x, z = np.concatenate([[-flat / 2, flat / 2], across]), np.concatenate([[0.0, 0.0], top])
    return 0.5 * abs(np.dot(x, np.roll(z, -1)) - np.dot(z, np.roll(x, -1))), half


@pytest.mark.parametrize(("roll", "covered", "trough", "surcharge"), TROUGHS)
def test_the_area_of_a_load_is_that_of_its_outline(roll, covered, trough, surcharge):
    lam, theta = radians(trough, surcharge)
    drawn, half = polygon_area(roll, covered, lam[0], theta[0])
    # chords cut a parabola of height f and chord W into n equal steps: they leave out its area over n², exactly
    cut = (2 * half) ** 2 * np.tan(theta[0]) / 6 / POINTS**2
    assert load_area(covered * ONE, roll * ONE, lam, theta)[0] == pytest.approx(drawn + cut, rel=1e-13)


@pytest.mark.parametrize(("roll", "covered", "trough", "surcharge"), TROUGHS)
def test_the_loaded_width_is_that_whose_load_has_the_area(roll, covered, trough, surcharge):
    lam, theta = radians(trough, surcharge)
    drawn, half = polygon_area(roll, covered, lam[0], theta[0])
    area = drawn + (2 * half) ** 2 * np.tan(theta[0]) / 6 / POINTS**2
    assert loaded_width(area * ONE, roll * ONE, lam, theta)[0] == pytest.approx(covered, rel=1e-13)


def test_loaded_width_and_area_are_inverse_for_any_trough():
    random = seeds.generator(5048)
    covered, roll = random.uniform(0.01, 3, 1000), random.uniform(0.01, 2, 1000)
    trough, surcharge = np.radians(random.uniform(0, 60, 1000)), np.radians(random.uniform(1, 40, 1000))
    again = loaded_width(load_area(covered, roll, trough, surcharge), roll, trough, surcharge)
    assert again == pytest.approx(covered, rel=4e-15)


def test_the_usable_width_changes_its_rule_at_two_metres():
    assert usable_width(np.array([0.65, 1.0, 2.0, 2.4])) == pytest.approx([0.535, 0.85, 1.75, 2.15], rel=1e-15)


def test_a_belt_with_its_usable_width_covered_is_full():
    lam, theta = radians(30.0, 20.0)
    full = load_area(usable_width(ONE), 0.35 * ONE, lam, theta)
    load = belt_load(2.5 * full, 2.5 * ONE, ONE, 0.35 * ONE, lam, theta)
    assert load.fill[0] == pytest.approx(1.0, rel=1e-15)
    assert load.width[0] == pytest.approx(0.85, rel=1e-14)
    assert load.depth[0] == pytest.approx(full[0] / 0.85, rel=1e-14)


SLIDES = [  # belt velocity, m/s; incline, deg; belt radius and radius, m; friction coefficient
    (2.0, 0.0, 0.5, 0.5, 0.5),
    (1.0, 0.0, 0.5, 0.5, 0.5),
    (0.5, 0.0, 0.65, 0.85, 0.6),
    (1.2, 12.0, 0.4, 0.5, 0.35),
    (0.8, -30.0, 0.5, 0.5, 0.3),  # slides at once
    (2.2, 0.0, 0.5, 0.5, 0.9),  # nearly fast enough
    (0.3, 5.0, 0.5, 0.6, 4.0),
]


def slid_in_time(velocity, incline, belt_radius, radius, friction):
    """Return slope and velocity where a block leaves a cylinder: turned with it, then sliding, integrated in time."""
    own = velocity * radius / belt_radius

    def pressing(angle, speed):
        return G * np.cos(angle) - speed**2 / radius

    # where friction fails to hold it, by bisection of the balance of forces
    low, high = max(0.0, -np.radians(incline)), np.arccos(own**2 / (G * radius))
    for _ in range(200):
        middle = 0.5 * (low + high)
        if G * np.sin(middle) < friction * pressing(middle, own):
            low = middle
        else:
            high = middle

    def motion(_, state):
        angle, speed = state
        return [speed / radius, G * np.sin(angle) - friction * pressing(angle, speed)]

    def lifts_off(_, state):
        return pressing(*state)

    lifts_off.terminal, lifts_off.direction = True, -1
    found = solve_ivp(motion, (0.0, 100.0), [low, own], method="DOP853", rtol=1e-13, atol=1e-14, events=lifts_off)
    return found.y_events[0][0]


@pytest.mark.parametrize(("velocity", "incline", "belt_radius", "radius", "friction"), SLIDES)
def test_a_sliding_stream_leaves_where_its_motion_in_time_says(velocity, incline, belt_radius, radius, friction):
    slope, speed = slid_in_time(velocity, incline, belt_radius, radius, friction)
    found = discharge(
        velocity=velocity * ONE,
        incline=np.radians(incline) * ONE,
        belt_radius=belt_radius * ONE,
        radius=radius * ONE,
        gravity=G * ONE,
        friction=np.arctan(friction) * ONE,
    )
    # the integrator keeps 1e-13 a step, some hundred steps, and errors grow by e^(2μα), 8 at most
    assert found.slope[0] == pytest.approx(slope, abs=1e-10)
    assert found.velocity[0] == pytest.approx(speed, rel=1e-10)
    assert (found.x[0], found.z[0]) == pytest.approx((radius * np.sin(slope), radius * np.cos(slope)), abs=1e-10)


def test_known_angles_and_velocities():
    for velocity, slope, speed in ((2.0, 22.46, 2.1287), (1.0, 52.72, 1.7233)):
        held, slides = (
            discharge(velocity * ONE, 0 * ONE, 0.5 * ONE, 0.5 * ONE, G * ONE, friction)
            for friction in (None, np.arctan(0.5) * ONE)
        )
        assert np.cos(held.slope[0]) == pytest.approx(velocity**2 / (G * 0.5), rel=1e-14)
        assert held.velocity[0] == velocity
        assert np.degrees(slides.slope[0]) == pytest.approx(slope, abs=0.005)
        assert slides.velocity[0] == pytest.approx(speed, abs=5e-5)


def test_the_limits_of_friction_are_a_held_stream_and_one_that_keeps_its_energy():
    froude = np.array([0.01, 0.3, 0.6, 0.9])
    for incline in (-20.0, 0.0, 20.0):
        start = np.radians(incline) * ONE
        below = froude[froude < np.cos(start)]
        kept = (below + 2 * np.cos(max(0.0, -start[0]))) / 3
        assert np.cos(slide(below, start, 0 * ONE)) == pytest.approx(kept, rel=1e-14)
        # the rougher the belt, the later the stream leaves, up to where one that is held does
        later = np.array([slide(below, start, np.radians(phi) * ONE) for phi in (0, 10, 30, 60, 80, 89)])
        assert (np.diff(later, axis=0) >= 0.0).all()
        assert (later <= np.arccos(below)).all()
        assert slide(below, start, np.arctan(1e7) * ONE) == pytest.approx(np.arccos(below), abs=1e-6)


def test_sliding_begins_where_friction_no_longer_holds():
    froude = np.array([0.05, 0.4, 0.95])
    angle = slide_start(froude, 0 * ONE, np.radians(28.0) * ONE)
    assert np.sin(angle) == pytest.approx(np.tan(np.radians(28.0)) * (np.cos(angle) - froude), abs=2e-16)


def test_the_last_digit_of_a_stream_just_too_slow_to_be_thrown():
    froude = 1.0 - np.arange(1, 200) * 2.0**-53
    for friction in (0.0, 1e-6, 0.5, 100.0):
        angle = slide(froude, 0 * ONE, np.arctan(friction) * ONE)
        assert np.isfinite(angle).all()
        assert np.abs(angle).max() < 1e-6


BELT = {"velocity_m_s": 3.0, "incline_deg": 6.0, "pulley_radius_m": 0.4, "belt_thickness_m": 0.02}


def fed(segments, **belt):
    """Return a chute with a belt before it, with other keys of the belt than the usual ones."""
    data = chute(segments=segments).data
    return chutecalc.parse(data | {"inlet": {"belt": BELT | belt}})


def placed(**more):
    """Return a fall onto a straight floor that stands in the way of the stream."""
    floor = {"kind": "straight", "name": "floor", "start_m": [0.4, -0.6], "slope_deg": 50.0, "length_m": 6.0, **more}
    return [{"kind": "fall", "onto_next": True}, floor]


@pytest.mark.parametrize("belt", [{}, {"velocity_m_s": 0.9}, {"velocity_m_s": 0.9, "friction_deg": 25.0}])
def test_edges_land_where_their_parabolas_meet_the_floor(belt):
    start, slope = np.array([0.4, -0.6]), np.radians(50.0)
    solution = chutecalc.solve(fed(placed(), material_depth_m=0.1, **belt))
    assert [edge.name for edge in solution.edges] == ["lower", "middle", "upper"]
    for edge, radius in zip(solution.edges, (0.42, 0.47, 0.52), strict=True):
        leaves = discharge(
            solution.design.belt.velocity,
            np.radians(6.0) * ONE,
            0.42 * ONE,
            radius * ONE,
            G * ONE,
            np.radians(25.0) * ONE if "friction_deg" in belt else None,
        )
        speed, a = leaves.velocity[0], leaves.slope[0]
        position = radius * np.array([np.sin(a), np.cos(a)])
        # distance above the floor along its normal, a quadratic in time
        normal, along = np.array([np.sin(slope), np.cos(slope)]), np.array([np.cos(slope), -np.sin(slope)])
        velocity = speed * np.array([np.cos(a), -np.sin(a)])
        time = max(np.roots([-0.5 * G * normal[1], velocity @ normal, (position - start) @ normal]).real)
        landing = position + velocity * time - [0.0, 0.5 * G * time**2]
        arrives = velocity - [0.0, G * time]
        numbers = {name: values[0] for name, values in edge.numbers.items()}
        assert (numbers["x_m"], numbers["z_m"]) == pytest.approx(position, rel=1e-14)
        assert (numbers["landing_x_m"], numbers["landing_z_m"]) == pytest.approx(landing, rel=1e-11)
        assert numbers["landing_distance_m"] == pytest.approx((landing - start) @ along, rel=1e-11)
        assert numbers["landing_velocity_m_s"] == pytest.approx(np.hypot(*arrives), rel=1e-12)
        incidence = np.degrees(np.arctan2(-arrives[1], arrives[0])) - 50.0
        assert numbers["incidence_deg"] == pytest.approx(incidence, rel=1e-11)
        assert np.isnan(numbers["gap_m"])
        assert (edge.segment[0], edge.misses[0]) == ("floor", False)


def test_the_middle_edge_is_the_stream_that_is_solved():
    solution = chutecalc.solve(fed(placed(), material_depth_m=0.2))
    middle, floor = solution.edges[1].numbers, solution.segments["floor"]
    assert middle["landing_x_m"] == floor.entry["x_m"]
    assert middle["incidence_deg"] == floor.impact["incidence_deg"]
    assert middle["velocity_m_s"] == solution.inlet["velocity_m_s"]


def test_an_edge_that_passes_the_end_says_by_how_much():
    at = chutecalc.solve(fed(placed(), material_depth_m=0.1)).edges
    middle, upper = (at[k].numbers["landing_distance_m"][0] for k in (1, 2))
    short = chutecalc.solve(fed(placed(length_m=0.5 * (middle + upper)), material_depth_m=0.1))
    lower, _, upper = short.edges
    assert (lower.misses[0], upper.misses[0], upper.segment[0]) == (False, True, "")
    gap = upper.numbers["gap_m"][0]
    slope, length = np.radians(50.0), 0.5 * (middle + at[2].numbers["landing_distance_m"][0])
    normal, along = np.array([np.sin(slope), np.cos(slope)]), np.array([np.cos(slope), -np.sin(slope)])
    end = np.array([0.4, -0.6]) + length * along
    position = np.array([upper.numbers["x_m"][0], upper.numbers["z_m"][0]])
    a = np.radians(upper.numbers["slope_deg"][0])
    velocity = upper.numbers["velocity_m_s"][0] * np.array([np.cos(a), -np.sin(a)])
    # where it crosses the normal through the end
    time = max(np.roots([0.5 * G * np.sin(slope), velocity @ along, (position - end) @ along]).real)
    crossing = position + velocity * time - [0.0, 0.5 * G * time**2]
    assert gap == pytest.approx((crossing - end) @ normal, rel=1e-10)


def test_edges_meet_a_hood_on_its_circle():
    hood = {"kind": "hood", "start_m": [0.35, 0.72], "radius_m": 1.4, "from_slope_deg": 20.0, "to_slope_deg": 75.0}
    solution = chutecalc.solve(fed([{"kind": "fall", "onto_next": True}, hood], velocity_m_s=4.0, material_depth_m=0.1))
    centre = np.array([0.35, 0.72]) - 1.4 * np.array([np.sin(np.radians(20.0)), np.cos(np.radians(20.0))])
    for edge in solution.edges:
        landing = np.array([edge.numbers["landing_x_m"][0], edge.numbers["landing_z_m"][0]])
        assert np.hypot(*(landing - centre)) == pytest.approx(1.4, rel=1e-12)
        # on its parabola
        x, z, a = (edge.numbers[name][0] for name in ("x_m", "z_m", "slope_deg"))
        time = (landing[0] - x) / (4.0 * np.cos(np.radians(a)))
        assert landing[1] == pytest.approx(z - 4.0 * np.sin(np.radians(a)) * time - 0.5 * G * time**2, rel=1e-11)


def test_edges_meet_steel_that_the_middle_placed():
    """A curve drawn tangent to a falling stream stands where the middle of the stream has it."""
    segments = [
        {"kind": "fall", "drop_m": 1.0},
        {"kind": "curve", "name": "spoon", "radius_m": 2.0, "to_slope_deg": 20},
    ]
    solution = chutecalc.solve(fed(segments, material_depth_m=0.1))
    lower, middle, upper = solution.edges
    assert middle.numbers["landing_distance_m"] == 0.0
    assert middle.numbers["landing_z_m"] == solution.segments["spoon"].entry["z_m"]
    assert lower.misses[0]  # it flies below the start of the spoon
    assert upper.numbers["landing_distance_m"] > 0.0


def test_a_stream_that_enters_on_a_surface_has_no_landing():
    solution = chutecalc.solve(fed([{"kind": "straight", "slope_deg": 30.0, "length_m": 1.0}], material_depth_m=0.1))
    for edge in solution.edges:
        assert np.isnan(edge.numbers["landing_x_m"]).all()
        assert edge.segment[0] == ""
        assert not edge.misses.any()


def test_without_depth_there_are_no_edges():
    assert chutecalc.solve(fed(placed())).edges == []
    assert chutecalc.solve(chute()).edges == []


def test_the_depth_follows_the_rate_in_a_batch_as_in_single_designs():
    """Designs whose middles land on different segments too, and those that miss all: each as alone, to the last bit."""
    ledge = {"kind": "straight", "name": "ledge", "start_m": [0.5, 0.1], "slope_deg": 50.0, "length_m": 0.5}
    ledge["may_be_passed"] = True
    segments = [{"kind": "fall", "onto_next": True}, ledge, *placed()[1:]]
    segments[2] = segments[2] | {"start_m": [1.2, -1.6], "length_m": 3.0}
    segments.insert(2, {"kind": "fall", "onto_next": True})
    base = fed(segments, width_m=1.0, trough_deg=35.0, surcharge_deg=15.0, friction_deg=25.0)
    rates, velocities = np.array([200.0, 900.0, 400.0, 600.0, 700.0]), np.array([1.0, 3.0, 4.0, 1.5, 9.0])
    many = chutecalc.solve(base.vary({"flow.rate_t_h": rates, "inlet.belt.velocity_m_s": velocities}))
    assert len(set(many.edges[1].target.tolist())) == 3
    for k, (rate, velocity) in enumerate(zip(rates, velocities, strict=True)):
        alone = chutecalc.solve(base.vary({"flow.rate_t_h": [rate], "inlet.belt.velocity_m_s": [velocity]}))
        load = belt_load(
            *(np.array([n]) for n in (rate / 3.6 / 800, velocity, 1.0, 1 / 3 + 0.01)), *radians(35.0, 15.0)
        )
        assert many.inlet["material_depth_m"][k] == pytest.approx(load.depth[0], rel=1e-14)
        assert many.inlet["roll_m"][k] == pytest.approx(1 / 3 + 0.01, rel=1e-15)
        for name in alone.inlet:
            assert np.array_equal(many.inlet[name][k], alone.inlet[name][0], equal_nan=True), name
        singles = {(edge.leaves, edge.name): edge for edge in alone.edges}
        for edge in many.edges:
            single = singles.get((edge.leaves, edge.name))
            if single is None:  # of a flight that this design does not make
                assert all(np.isnan(values[k]) for values in edge.numbers.values())
                continue
            assert edge.segment[k] == single.segment[0]
            assert edge.misses[k] == single.misses[0]
            for name, values in edge.numbers.items():
                assert np.array_equal(values[k], single.numbers[name][0], equal_nan=True), name


def test_a_function_of_the_rate_records_the_depth_and_the_slide():
    base = fed(
        placed(), velocity_m_s=1.2, width_m=1.0, roll_m=0.38, trough_deg=35.0, surcharge_deg=15.0, friction_deg=25.0
    )
    f = base.function(["flow.rate_t_h", "inlet.belt.friction_deg"])
    assert f.traced
    for rate, friction in ((900.0, 25.0), (300.0, 33.0)):
        solution = chutecalc.solve(base.put({"flow.rate_t_h": rate, "inlet.belt.friction_deg": friction}))
        assert f(rate, friction) == pytest.approx(solution.exit_velocity[0], rel=1e-12)
