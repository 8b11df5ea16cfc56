"""Findings about where things stand: steel that one stream places for all cases, belts, and faces of plates."""

import numpy as np
import pytest

import chutecalc
from tests.conftest import ROOT, chute

BELT = {"velocity_m_s": 3.0, "pulley_radius_m": 0.4}
CASES = {"slow": {"flow.rate_t_h": 500.0}}
FALL = {"kind": "fall", "drop_m": 1.0}
FLOOR = {"kind": "straight", "name": "floor", "slope_deg": 50.0, "length_m": 2.0}
SPOON = {"kind": "curve", "name": "spoon", "radius_m": 2.0, "from_slope_deg": 60.0, "to_slope_deg": 30.0}
THROWN = {"velocity_m_s": 3.0, "slope_deg": 10.0}


def told(solution, code):
    return [finding for finding in solution.findings() if finding.code == code]


@pytest.mark.parametrize(
    ("inlet", "segments", "more", "names"),
    [
        (THROWN, [FALL, FLOOR], {}, "floor stands"),
        (THROWN, [{"kind": "fall", "run_m": 1.0}, FLOOR, FALL, SPOON], {}, "floor, spoon stand"),
        ({"belt": BELT}, [FLOOR], {}, "floor stands"),
        (THROWN, [FALL, FLOOR], {"cases": {}}, None),
        (THROWN, [FALL, FLOOR], {"model": {"steel": "follows_stream"}}, None),
        (THROWN, [{"kind": "fall", "onto_next": True}, FLOOR | {"start_m": [0.5, -1.0]}], {}, None),
        (THROWN, [FLOOR, FLOOR | {"name": "next", "slope_deg": 45.0}], {}, None),
        ({"velocity_m_s": 2.0, "slope_deg": 90.0}, [FALL, FLOOR], {}, None),  # down the same line at any velocity
        ({"velocity_m_s": 2.0, "slope_deg": 90.0}, [FALL, FLOOR, FALL, SPOON], {}, "spoon stands"),
    ],
)
def test_placed_by_stream(inlet, segments, more, names):
    base = chutecalc.parse(chute(segments=segments).data | {"inlet": inlet, "cases": CASES} | more)
    found = told(chutecalc.solve(base), "placed_by_stream")
    assert len(found) == (names is not None)
    if names:
        (note,) = found
        assert (note.severity, note.where(), note.mask.tolist()) == ("note", "cases", [True])
        assert note.message().startswith(f"{names} where the stream of the design point comes down")
        assert not told(chutecalc.solve(base.cases["slow"]), "placed_by_stream")  # once for the chute


def test_a_frozen_chute_is_not_placed_by_its_stream():
    base = chutecalc.load(ROOT / "specs" / "placed_by_stream.toml")
    assert told(chutecalc.solve(base), "placed_by_stream")
    assert not told(chutecalc.solve(chutecalc.parse(chutecalc.freeze(base))), "placed_by_stream")


@pytest.mark.parametrize("side", [-1.0, 1.0])
@pytest.mark.parametrize("off", [-1e-9, 1e-9])
def test_far_landing(side, off):
    slope = np.radians(10.0)
    belt = {"velocity_m_s": 4.0, "friction_deg": 30.0, "slope_deg": 10.0}
    limits = {"max_landing_offset_m": 0.5}
    base = chute(inlet=THROWN, segments=[FALL, FLOOR], receiver=belt | {"at_m": [3.0, -5.0]}, limits=limits)
    lands = chutecalc.solve(base).receiver
    x, z = lands["landing_x_m"][0], lands["landing_z_m"][0]
    away = side * (0.5 + off)  # along the belt's own slope: the line stays where it is
    at = [float(x - away * np.cos(slope)), float(z + away * np.sin(slope))]
    solution = chutecalc.solve(base.put({"receiver.at_m": at}))
    found = told(solution, "far_landing")
    assert len(found) == (off > 0)
    if found:
        where = "beyond" if side > 0 else "before"
        assert (found[0].severity, found[0].segment) == ("warning", "floor")
        assert found[0].message().startswith(f"the stream lands 0.5 m {where} at_m of the receiving belt (limit 0.5 m)")
        wider = base.put({"receiver.at_m": at, "limits.max_landing_offset_mm": 501.0})
        assert not told(chutecalc.solve(wider), "far_landing")


def test_a_belt_without_a_place_or_a_limit_is_not_far():
    belt = {"velocity_m_s": 4.0, "friction_deg": 30.0}
    for place, limits in (({}, {"max_landing_offset_m": 0.5}), ({"at_m": [-50.0, -5.0]}, {})):
        solution = chutecalc.solve(chute(inlet=THROWN, segments=[FALL, FLOOR], receiver=belt | place, limits=limits))
        assert not told(solution, "far_landing")


@pytest.mark.parametrize(
    ("stream", "plate", "start", "struck"),
    [
        (10.0, 70.0, [0.8, 0.5], True),  # hangs in the way
        (10.0, 90.0, [0.8, 0.5], True),  # a wall that faces the inlet
        (-60.0, -20.0, [0.1, 0.25], True),  # rises less than the stream: struck from below
        (60.0, 20.0, [0.0, -1.0], False),  # fallen onto from above
    ],
)
def test_a_plate_is_struck_on_its_lower_face(stream, plate, start, struck):
    segments = [
        {"kind": "fall", "onto_next": True},
        {"kind": "plate", "name": "plate", "slope_deg": plate, "length_m": 2.0, "start_m": start},
        {"kind": "fall", "drop_m": 5.0},
    ]
    solution = chutecalc.solve(chute(inlet={"velocity_m_s": 4.0, "slope_deg": stream}, segments=segments))
    assert solution.status[0] == ("ok" if struck else "missed")
    if struck:
        assert solution.segments["plate"].exit["slope_deg"][0] == pytest.approx(plate, rel=1e-14)
    else:
        (finding,) = told(solution, "passed_by")
        assert "A plate is struck on its lower face" in finding.message()
