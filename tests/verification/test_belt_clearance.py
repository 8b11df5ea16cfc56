"""How far the steel stands above the receiving belt, against points along it."""

import numpy as np
import pytest

import chutecalc
from tests.conftest import chute

STATIONS = 20_001
FALL = {"kind": "fall", "onto_next": True, "name": "fall"}


def scene(radius=3.0, belt=(1.0, -4.2), slope=0.0, psi=0.0, spoon_end=20.0, **more):
    """Return a chute: a hood, a fall and a spoon above a belt."""
    return chute(
        inlet={"velocity_m_s": 4.0, "slope_deg": 10.0},
        segments=[
            {"kind": "hood", "name": "hood", "from_slope_deg": 12.0, "to_slope_deg": 80.0, "radius_m": 1.0},
            FALL,
            {"kind": "curve", "name": "spoon", "from_slope_deg": 75.0, "to_slope_deg": spoon_end, "radius_m": radius}
            | {"start_m": [0.8, -1.2]},
        ],
        receiver={"velocity_m_s": 4.0, "friction_deg": 30.0, "at_m": list(belt)}
        | {"slope_deg": slope, "plan_angle_deg": psi},
        **more,
    )


def points(solution):
    """Yield x and z of points along the drawn surfaces: of arcs about their centres, not by the chord of the code."""
    for solved in solution.trajectory.segment_solutions:
        if solved.contact is not None:
            surface, share = solved.contact.surface, np.linspace(0.0, 1.0, STATIONS)
            slope = surface.slope[0] + share * surface.turn[0]
            radius = surface.length[0] / surface.turn[0]
            x = surface.x[0] + radius * (np.sin(slope) - np.sin(slope[0]))
            z = surface.z[0] + radius * (np.cos(slope) - np.cos(slope[0]))
            yield x, z


@pytest.mark.parametrize(
    "slope", [-20.0, 0.0, 15.0, 40.0]
)  # at 40° the spoon is lowest where it is parallel to the belt
@pytest.mark.parametrize("psi", [0.0, 60.0])
def test_the_clearance_is_the_least_distance_of_points_from_the_line(slope, psi):
    solution = chutecalc.solve(scene(slope=slope, psi=psi))
    assert solution.ok[0]
    b = np.arctan(np.tan(np.radians(slope)) * np.cos(np.radians(psi)))
    least = min(float(((x - 1.0) * np.sin(b) + (z + 4.2) * np.cos(b)).min()) for x, z in points(solution))
    exact = solution.receiver["clearance_m"][0]
    # between two points an arc of radius R sags by at most ds²/(8 R), here ds is a 20,000th of 3 m
    assert exact == pytest.approx(least, abs=1e-8)
    assert exact <= least + 1e-13


@pytest.mark.parametrize("varied", ["segments.spoon.radius_m", "receiver.slope_deg", "liners.wall.friction_deg"])
def test_all_ways_to_solve_agree(varied):
    base = scene()
    values = {"segments.spoon.radius_m": [2.6, 2.8, 3.0], "receiver.slope_deg": [-5.0, 0.0, 8.0]}
    values = np.array(values.get(varied, [18.0, 20.0, 22.0]))
    each = [chutecalc.solve(base.put({varied: float(one)})).receiver["clearance_m"][0] for one in values]
    batch = base.vary({varied: values})
    assert chutecalc.solve(batch).receiver["clearance_m"] == pytest.approx(each, rel=1e-13)
    assert chutecalc.exits(batch).receiver["clearance_m"] == pytest.approx(each, rel=1e-13)
    function = base.function([varied], ["receiver_clearance_m"])
    assert function(values) == pytest.approx(each, rel=1e-13)
    if varied == "liners.wall.friction_deg":
        assert len(set(each)) == 1  # steel stands still


@pytest.mark.parametrize("off", [-1e-6, 0.0, 1e-6])
def test_steel_on_belt(off):
    solution = chutecalc.solve(scene())
    end = solution.segments["spoon"].exit
    x, z = (float(end[name][0]) for name in ("x_m", "z_m"))
    low = chutecalc.solve(scene(belt=(x, z - off)))
    told = [finding for finding in low.findings() if finding.code == "steel_on_belt"]
    assert len(told) == (off <= 0.0)
    if told:
        assert (told[0].segment, told[0].severity) == ("spoon", "warning")
        assert told[0].s_m[0] == pytest.approx(end["s_m"][0], rel=1e-12)
        assert ("touches the receiving belt" if off == 0.0 else "reaches 1e-06 m below") in told[0].message()
        assert f"at x {x:.4g} m, z {z:.4g} m" in told[0].message()


@pytest.mark.parametrize("off", [-1e-6, 1e-6])
def test_a_spec_may_ask_for_more_clearance(off):
    clearance = float(chutecalc.solve(scene()).receiver["clearance_m"][0])
    solution = chutecalc.solve(scene(limits={"min_belt_clearance_m": clearance + off}))
    told = [finding for finding in solution.findings() if finding.code == "steel_on_belt"]
    assert len(told) == (off > 0.0)
    if told:
        assert f"stands only {clearance:.4g} m above the receiving belt" in told[0].message()
        assert "set in the spec" in told[0].message()


def test_only_a_belt_with_a_place_has_a_clearance():
    tables = scene().data
    tables = tables | {"receiver": {key: value for key, value in tables["receiver"].items() if key != "at_m"}}
    solution = chutecalc.solve(chutecalc.parse(tables))
    assert np.isnan(solution.receiver["clearance_m"][0])
    assert "steel_on_belt" not in [finding.code for finding in solution.findings()]
