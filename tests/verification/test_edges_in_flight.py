"""The edges of a stream at every landing after a flight: each is a parabola of its own, found here in closed form."""

import numpy as np
import pytest

import chutecalc
from tests.conftest import ROOT, chute

G = 9.80665
SLOPE = np.radians(30.0)
"""Slope of the floor that the stream leaves."""
START, DROP = np.array([0.9, -1.4]), np.radians(55.0)
"""Where the floor begins that catches it, m, and its slope."""


def two_floors(**more):
    """Return a floor whose stream flies onto another one."""
    head = {"kind": "straight", "name": "head", "slope_deg": 30.0, "length_m": 0.8}
    catch = {"kind": "straight", "name": "catch", "start_m": START.tolist(), "slope_deg": 55.0, "length_m": 4.0, **more}
    fall = {"kind": "fall", "onto_next": True}
    return chute(inlet={"velocity_m_s": 3.0, "slope_deg": 30.0}, segments=[head, fall, catch])


def landing(position, velocity):
    """Return distance along the catching floor, velocity and incidence, of a parabola that meets its line."""
    normal, along = np.array([np.sin(DROP), np.cos(DROP)]), np.array([np.cos(DROP), -np.sin(DROP)])
    time = max(np.roots([-0.5 * G * normal[1], velocity @ normal, (position - START) @ normal]).real)
    arrives = velocity - [0.0, G * time]
    point = position + velocity * time - [0.0, 0.5 * G * time**2]
    return (point - START) @ along, np.hypot(*arrives), np.degrees(np.arctan2(-arrives[1], arrives[0]) - DROP)


def free_edge(solution):
    (edge,) = [edge for edge in solution.edges if edge.name == "free"]
    return edge


def left(solution):
    """Return where the free surface leaves the head, and its velocity: at the depth there, normal to the floor."""
    end = {name: values[0] for name, values in solution.segments["head"].exit.items()}
    up = np.array([np.sin(SLOPE), np.cos(SLOPE)])
    return np.array([end["x_m"], end["z_m"]]) + end["depth_m"] * up, end["velocity_m_s"] * np.array(
        [np.cos(SLOPE), -np.sin(SLOPE)]
    )


def test_the_free_surface_lands_where_its_parabola_meets_the_floor():
    solution = chutecalc.solve(two_floors())
    edge = free_edge(solution)
    distance, velocity, incidence = landing(*left(solution))
    assert (edge.leaves, edge.segment[0], edge.misses[0]) == ("head", "catch", False)
    # the positions are of order 1 m, solved to 1e-10 of the velocity
    assert edge.numbers["landing_distance_m"][0] == pytest.approx(distance, rel=1e-9)
    assert edge.numbers["landing_velocity_m_s"][0] == pytest.approx(velocity, rel=1e-9)
    assert edge.numbers["incidence_deg"][0] == pytest.approx(incidence, rel=1e-9)
    assert edge.s_m[0] == solution.segments["catch"].entry["s_m"][0]


@pytest.mark.parametrize("off", [-1e-6, 1e-6])
def test_a_free_surface_that_passes_the_end_is_told(off):
    distance, *_ = landing(*left(chutecalc.solve(two_floors())))
    solution = chutecalc.solve(two_floors(length_m=float(distance - off)))
    told = [finding for finding in solution.findings() if finding.code == "edge_misses"]
    assert len(told) == (off > 0)
    if told:
        assert (told[0].segment, told[0].severity) == ("catch", "warning")
        assert told[0].message().startswith("the free surface of the stream, which leaves head ")
        assert "beyond its end; make the segment longer" in told[0].message()


@pytest.mark.parametrize("off", [-1e-6, 1e-6])
def test_the_incidence_of_a_free_surface_is_judged_beside_that_of_the_stream(off):
    solution = chutecalc.solve(two_floors())
    middle = solution.segments["catch"].impact["incidence_deg"][0]
    edge = free_edge(solution).numbers["incidence_deg"][0]
    assert edge > middle + 1.0  # it flies longer, and comes down steeper
    limited = two_floors().put({"limits.max_impact_angle_deg": float(edge - off)})
    told = [finding for finding in chutecalc.solve(limited).findings() if finding.code == "steep_impact"]
    assert len(told) == (off > 0)
    if told:
        assert told[0].segment == "catch"
        assert told[0].message().startswith("the free surface of the stream that leaves head strikes the surface at ")
        assert told[0].numbers["incidence_deg"][0] == edge
    both = chutecalc.solve(two_floors().put({"limits.max_impact_angle_deg": 1.0})).findings()
    (once,) = [finding for finding in both if finding.code == "steep_impact"]  # the stream and its edge in one line
    assert [once.numbers[name][0] for name in ("incidence_deg", "edge_deg")] == [middle, edge]
    assert f"at {middle:.4g}°, its free surface at {edge:.4g}° (limit 1°" in once.message()


def test_an_edge_from_a_belt_that_strikes_more_steeply_than_the_middle_is_named():
    solution = chutecalc.solve(chutecalc.load(ROOT / "specs" / "belt_hood_spoon.toml"))
    (told,) = [finding for finding in solution.findings() if finding.code == "steep_impact"]
    lower, middle, _, _ = solution.edges
    assert middle.numbers["incidence_deg"][0] < 20.0 < lower.numbers["incidence_deg"][0]
    assert told.message().startswith("the lower edge strikes the surface at 22.14°")


def test_a_spoon_placed_below_the_line_of_a_hood_misses_what_lies_below_that_line():
    """The stream hangs under the hood by its depth: its free surface falls before the start of the spoon."""
    solution = chutecalc.solve(chutecalc.load(ROOT / "specs" / "coal_hood_spoon.toml"))
    edge, hood = free_edge(solution), solution.segments["hood"]
    x, z, depth = (hood.exit[name][0] for name in ("x_m", "z_m", "depth_m"))
    a, v = np.radians(hood.exit["slope_deg"][0]), hood.exit["velocity_m_s"][0]
    assert (edge.numbers["x_m"][0], edge.numbers["z_m"][0]) == pytest.approx(
        (x - depth * np.sin(a), z - depth * np.cos(a)), rel=1e-14
    )
    start = solution.segments["drop"].exit
    fall = edge.numbers["z_m"][0] - start["z_m"][0]
    time = (np.sqrt((v * np.sin(a)) ** 2 + 2 * G * fall) - v * np.sin(a)) / G
    before = start["x_m"][0] - edge.numbers["x_m"][0] - v * np.cos(a) * time
    assert edge.numbers["before_m"][0] == pytest.approx(before, rel=1e-9)
    (told,) = [finding for finding in solution.findings() if finding.code == "edge_misses"]
    assert f"it passes {before:.4g} m before its start; begin the segment earlier" in told.message()


def test_in_a_batch_each_design_has_the_edges_that_it_has_alone():
    base = two_floors(length_m=2.5)
    velocities = np.array([1.0, 2.0, 2.4, 9.0])
    many = chutecalc.solve(base.vary({"inlet.velocity_m_s": velocities}))
    edge = free_edge(many)
    assert edge.target.tolist() == [2, 2, 2, -1]
    assert set(edge.misses[:3].tolist()) == {True, False}
    for k, velocity in enumerate(velocities[:3]):
        alone = free_edge(chutecalc.solve(base.vary({"inlet.velocity_m_s": [velocity]})))
        for name, values in edge.numbers.items():
            assert np.array_equal(values[k], alone.numbers[name][0], equal_nan=True), name
    assert all(np.isnan(values[3]) for name, values in edge.numbers.items() if name.startswith("landing"))


def test_what_crosses_a_pipe_from_wall_to_wall_has_no_edges():
    assert chutecalc.solve(chutecalc.load(ROOT / "specs" / "pipe_two_bends.toml")).edges == []


@pytest.mark.parametrize("others", [[4.0], [6.0], [4.0, 3.0, 6.0]])
def test_edges_do_not_depend_on_the_batch(others):
    base = chutecalc.load(ROOT / "specs" / "belt_hood_spoon.toml")
    alone = chutecalc.solve(base.vary({"inlet.belt.velocity_m_s": [4.316]}))  # its upper edge passes behind the hood
    batch = chutecalc.solve(base.vary({"inlet.belt.velocity_m_s": [4.316, *others]}))
    for own, one in zip(alone.edges, batch.edges, strict=False):
        for name, values in own.numbers.items():
            assert one.numbers[name][0] == pytest.approx(values[0], nan_ok=True, abs=0.0), (own.name, name)
    assert np.isfinite(alone.edges[2].numbers["gap_m"][0])
