"""Pictures of closed sections: the drawn floor and its roof, a stream under the roof, and the flight to the mouth."""

import itertools

import numpy as np
import pytest

import chutecalc
from chutecalc.solver.steel import drawn_surface
from tests.conftest import chute
from tests.unit.test_plot import by_name, drawn, load

RADIUS, HEIGHT, ENTRY, LENGTH = 2.0, 0.6, np.radians(20.0), 3.0
CENTRE = -RADIUS * np.array([np.sin(ENTRY), np.cos(ENTRY)])
"""Of the bend, below its floor."""


def bend(velocity, *curves):
    """Return a pipe that steepens from 20° to 80° over a crest, in one curve or several, and goes on straight."""
    arcs = [
        {"kind": "curve", "name": f"bend{to:g}", "radius_m": RADIUS, "to_slope_deg": to} for to in curves or (80.0,)
    ]
    down = {"kind": "straight", "name": "down", "slope_deg": 80.0, "length_m": LENGTH}
    return chute(
        sections={"body": {"shape": "pipe", "radius_m": 0.5 * HEIGHT}},
        inlet={"velocity_m_s": velocity, "slope_deg": 20.0},
        segments=[*arcs, down],
    )


def from_centre(points):
    return np.hypot(*(np.asarray(points) - CENTRE).T)


@pytest.mark.parametrize("velocity", [5.0, 8.0])
@pytest.mark.parametrize("curves", [(80.0,), (50.0, 80.0)])
def test_the_floor_is_drawn_as_the_floor_whichever_side_the_stream_strikes(velocity, curves):
    _, axes, (solution,) = drawn(bend(velocity, *curves))
    floors = [line.get_xydata() for line in by_name(axes["side"], "surface")]
    roofs = [line.get_xydata() for line in by_name(axes["side"], "roof")]
    first = {each.number: each.contact for each in reversed(solution.trajectory.segment_solutions)}
    assert any(contact.side[0] < 0.0 for contact in first.values())  # the roof is struck first
    for arc in range(len(curves)):
        assert np.allclose(from_centre(floors[arc]), RADIUS, rtol=1e-12)
        assert np.allclose(from_centre(roofs[arc]), RADIUS + HEIGHT, rtol=1e-12)
    for one, other in itertools.pairwise(floors):
        assert np.allclose(one[-1], other[0], rtol=0, atol=1e-12)
    turned = np.radians(80.0) - ENTRY
    assert np.allclose(floors[-1][0], CENTRE + RADIUS * np.array([np.sin(ENTRY + turned), np.cos(ENTRY + turned)]))
    assert np.allclose(floors[-1][-1] - floors[-1][0], LENGTH * np.array([np.cos(1.3962634), -np.sin(1.3962634)]))


def test_the_drawn_surface_of_a_taper_struck_at_its_roof_is_its_floor():
    tapering = {"shape": "box", "width_m": 0.5, "height_m": 0.6}
    smaller = tapering | {"height_m": 0.4}
    arc = {"kind": "curve", "name": "bend", "radius_m": RADIUS, "to_slope_deg": 80.0, "section": "body"}
    down = {"kind": "straight", "name": "down", "slope_deg": 80.0, "length_m": LENGTH, "section": ["body", "small"]}
    solution = chutecalc.solve(
        chute(
            sections={"body": tapering, "small": smaller},
            inlet={"velocity_m_s": 5.0, "slope_deg": 20.0},
            segments=[arc, down],
        )
    )
    contact = next(each.contact for each in solution.trajectory.segment_solutions if each.segment.name == "down")
    assert contact.side[0] == -1.0
    drawn_as = drawn_surface(contact)
    exact = CENTRE + RADIUS * np.array([np.sin(np.radians(80.0)), np.cos(np.radians(80.0))])
    assert (drawn_as.x[0], drawn_as.z[0]) == pytest.approx(exact, abs=1e-12)
    assert drawn_as.slope[0] == pytest.approx(np.radians(80.0), rel=1e-15)
    assert drawn_as.length[0] == LENGTH
    assert contact.surface.length[0] == pytest.approx(np.hypot(LENGTH, 0.2), rel=1e-12)


def test_a_stream_under_the_roof_hangs_there_at_its_depth():
    _, axes, (solution,) = drawn(bend(8.0))
    band = next(each for each in by_name(axes["side"], "stream") if len(each.get_paths()))
    corners = np.array([path.vertices[:4] for path in band.get_paths()])
    assert np.allclose(from_centre(corners[:, 0]), RADIUS + HEIGHT, rtol=1e-12)
    stations = solution.stations(points=101)
    under = (stations["segment"][0] == "bend80") & (stations["s_m"][0] > 1.0) & np.isfinite(stations["depth_m"][0])
    depth = stations["depth_m"][0][under]
    assert np.allclose(from_centre(corners[:, 3]), RADIUS + HEIGHT - depth[:-1], rtol=1e-9)


@pytest.mark.parametrize("velocity", [5.0, 8.0])
def test_the_flight_to_the_mouth_is_drawn(velocity):
    _, axes, (solution,) = drawn(bend(velocity))
    *_, last = by_name(axes["side"], "flight")
    corners = np.array([path.vertices[:4] for path in last.get_paths()])
    path = np.concatenate([corners[:, 0], corners[-1:, 1]])
    floor = by_name(axes["side"], "surface")[-1].get_xydata()
    along = (floor[-1] - floor[0]) / LENGTH
    assert (path[-1] - floor[-1]) @ along == pytest.approx(0.0, abs=1e-9)  # the mouth is normal to the floor
    assert path[-1] == pytest.approx([solution.exit["x_m"][0], solution.exit["z_m"][0]], abs=1e-9)
    line = by_name(axes["velocity_m_s"], "velocity_m_s")[0]
    assert line.get_ydata()[-1] == pytest.approx(solution.exit_velocity[0], rel=1e-9)
    assert line.get_xdata()[-1] == pytest.approx(solution.exit["s_m"][0], rel=1e-4)  # by chords of its path


@pytest.mark.parametrize("velocity", [5.0, 8.0])
def test_edges_of_a_flight_stay_under_the_roof(velocity):
    _, axes, _ = drawn(bend(velocity))
    first = by_name(axes["side"], "edge")[:2]
    for edge in first:
        points = edge.get_xydata()
        inside = points[points[:, 1] > -1.4]  # above the end of the bend's roof
        assert from_centre(inside).max() <= RADIUS + HEIGHT + 1e-3  # the roof is drawn in chords


@pytest.mark.parametrize("name", ["grain_spout", "clinker_box"])
def test_a_stream_that_stays_on_the_floor_has_no_flight(name):
    _, axes, _ = drawn(load(name))
    assert not by_name(axes["side"], "flight")
    assert len(by_name(axes["side"], "roof")) == len(by_name(axes["side"], "surface"))
