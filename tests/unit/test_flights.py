"""The edges of a stream in flight, against closed forms and the laws of free fall."""

import numpy as np
import pytest

import chutecalc
from chutecalc.output.plots.flights import Throw, belt_throws, crossings
from chutecalc.output.plots.view import view
from tests.conftest import ROOT, spec

GRAVITY = 9.80665
BELT = {
    "velocity_m_s": 4.0,
    "incline_deg": 8.0,
    "pulley_radius_m": 0.5,
    "belt_thickness_m": 0.02,
    "material_depth_m": 0.2,
}


def seen(name):
    solution = chutecalc.solve(chutecalc.load(ROOT / "specs" / f"{name}.toml"))
    return view(solution), solution


def test_a_throw_is_free_fall():
    throw = Throw(x=1.0, z=2.0, forward=3.0, downward=-1.0, gravity=GRAVITY)
    time = np.linspace(0.0, 1.0, 1001)
    x, z = throw.at(time)
    assert np.allclose(np.gradient(x, time), 3.0, rtol=1e-9)
    assert np.allclose(np.diff(z, 2) / (time[1] - time[0]) ** 2, -GRAVITY, rtol=1e-6)
    assert np.allclose(throw.velocity(time) ** 2, 10.0 + 2 * GRAVITY * (2.0 - z), rtol=1e-13)  # energy
    later = throw.after(0.4)
    assert np.allclose(later.at(time), throw.at(time + 0.4), rtol=0, atol=1e-13)
    assert throw.at(np.array(throw.time_to(-3.0)))[1] == pytest.approx(-3.0, abs=1e-13)


def test_an_edge_lands_where_a_parabola_meets_a_line():
    throw = Throw(x=0.0, z=1.0, forward=2.0, downward=0.0, gravity=GRAVITY)
    slope = np.radians(30.0)
    line = np.array([[0.0, 4.0], [0.0, -4.0 * np.tan(slope)]])
    # 1 - g t²/2 = -2 t tan 30°
    exact = (2.0 * np.tan(slope) + np.sqrt(4.0 * np.tan(slope) ** 2 + 2.0 * GRAVITY)) / GRAVITY
    usual = 0.8 * exact
    step = 1.5 * usual / 302  # a piece of the path is off by g step²/8, which the line is met later or earlier by
    assert throw.time_of_landing(line, usual) == pytest.approx(exact, abs=GRAVITY * step**2)
    assert throw.time_of_landing(line + 100.0, usual) == usual


def test_crossings_of_paths_at_random():
    rng = np.random.default_rng(5)
    for _ in range(50):
        path, other = rng.normal(size=(2, 6)), rng.normal(size=(2, 5))
        found = crossings(path, other)
        for at in found:
            k = min(int(at), 4)
            x, z = path[:, k] + (at - k) * (path[:, k + 1] - path[:, k])
            ends = np.hypot(other[0] - x, other[1] - z)
            sides = np.hypot(*np.diff(other))
            assert (np.abs(ends[1:] + ends[:-1] - sides) < 1e-9).any()  # the point is on a side of the other
        assert len(crossings(other, path)) == len(found)


@pytest.mark.parametrize("velocity", [4.0, 1.5])
def test_the_edges_of_a_feeding_belt_leave_at_their_own_radius(velocity):
    data = spec(segments=[{"kind": "fall", "drop_m": 2.0}])
    design = chutecalc.parse(data | {"inlet": {"belt": BELT | {"velocity_m_s": velocity}}}).design
    lower, middle, upper = belt_throws(design.belt, design.gravity)
    for edge, radius in zip((lower, middle, upper), (0.52, 0.62, 0.72), strict=True):
        assert np.hypot(edge.x, edge.z) == pytest.approx(radius, rel=1e-12)
        assert edge.x * edge.forward - edge.z * edge.downward == pytest.approx(0.0, abs=1e-12)  # along the pulley
        own = np.hypot(edge.forward, edge.downward)
        held = velocity**2 / (GRAVITY * radius) < np.cos(np.radians(8.0))
        assert own == pytest.approx(velocity * radius / 0.52 if held else velocity, rel=1e-12)
    assert (middle.x, middle.z) == pytest.approx([float(each[0]) for each in design.inlet_position], abs=1e-12)


def test_a_stream_from_a_belt_has_three_edges_and_its_path_is_the_middle_one():
    drawn, solution = seen("belt_hood_spoon")
    throw = drawn.stream[0]
    assert len(throw.edges) == 3
    assert np.allclose(throw.edges[1], throw.path, rtol=0, atol=1e-12)
    assert np.hypot(*(throw.edges[2] - throw.edges[0])[:, 0]) == pytest.approx(
        2.0 * (solution.design.belt.middle_radius[0] - solution.design.belt.lower_radius[0]), rel=1e-12
    )


def test_edges_end_on_the_surface_that_the_stream_lands_on():
    drawn, _ = seen("crest_flight")
    flight = next(trace for trace in drawn.stream if trace.kind == "flight")
    floor = next(steel.path for steel in drawn.surfaces if steel.name == "lower")
    along = floor[:, -1] - floor[:, 0]
    for edge in flight.edges:
        off = edge[:, -1] - floor[:, 0]
        assert abs(along[0] * off[1] - along[1] * off[0]) / np.hypot(*along) < 1e-4


def test_a_chute_that_the_stream_does_not_reach_is_drawn_with_its_name():
    drawn, _ = seen("fails/missed_spoon")
    assert [steel.name for steel in drawn.surfaces] == ["spoon"]
    assert len(drawn.lost.edges) == 3
