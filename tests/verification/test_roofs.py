"""Streams between the two walls of pipes and boxes: against open chutes, against parabolas by hand, and in batches."""

import csv
import io
from functools import partial
from math import cos, hypot, radians, sin

import numpy as np
import pytest
import tomli_w
from scipy.optimize import brentq

import chutecalc
from chutecalc.cli import main
from tests import seeds
from tests.conftest import ROOT, chute, spec
from tests.verification.second_cases import ClosedMaker, judge

G = 9.80665
RADIUS = 0.2
HEIGHT = 2 * RADIUS
PIPE = {"shape": "pipe", "radius_m": RADIUS}
BOX = {"shape": "box", "width_m": 0.5, "height_m": HEIGHT}
OPEN = {"pipe": {"shape": "circular", "radius_m": RADIUS}, "box": {"shape": "rectangular", "width_m": 0.5}}
CLOSED = [PIPE, BOX]
SHAPES = pytest.mark.parametrize("closed", CLOSED, ids=lambda section: section["shape"])
EXIT = ("s_m", "x_m", "z_m", "slope_deg", "velocity_m_s", "depth_m", "equivalent_friction", "time_s")


def bend(kind="curve", radius=2.0, **keys):
    return {"kind": kind, "radius_m": radius, **keys}


def solved(section, segments, velocity, slope, **tables):
    inlet = {"velocity_m_s": velocity, "slope_deg": slope}
    flow = {"rate_t_h": 100.0}
    return chutecalc.solve(
        chute(sections={"body": section}, segments=segments, **{"inlet": inlet, "flow": flow} | tables)
    )


def offset(slope, along=HEIGHT):
    """Return the point that is so far above a floor that begins at the inlet."""
    return [along * sin(radians(slope)), along * cos(radians(slope))]


def statuses(solution):
    return [str(segment.status[0]) for segment in solution.segments]


# against the second solver

BLOCK = 100
CHUTES = seeds.times(300)


@pytest.mark.parametrize("first", range(0, CHUTES, BLOCK))
def test_random_pipes_and_boxes(first):
    verdicts = {seed: judge(seed, ClosedMaker) for seed in range(first, min(first + BLOCK, CHUTES))}
    assert not {seed: what for seed, (verdict, what) in verdicts.items() if verdict == "wrong"}
    assert sum(verdict != "same" for verdict, _ in verdicts.values()) <= 2


# against open chutes


@SHAPES
@pytest.mark.parametrize("velocity", [6.0, 9.0, 14.0])
def test_the_roof_of_a_crest_is_a_hood(closed, velocity):
    """A stream too fast for the crest crosses to its roof: the hood about the same centre, of radius R + D.

    The same numbers come from other sums: each of the few quantities is rounded a few hundred times.
    """
    turn = {"from_slope_deg": 20.0, "to_slope_deg": 75.0}
    found = solved(closed, [bend(**turn)], velocity, 20.0)
    hood = bend("hood", 2.0 + HEIGHT, start_m=offset(20.0), **turn)
    open_ = solved(OPEN[closed["shape"]], [{"kind": "fall", "onto_next": True}, hood], velocity, 20.0)
    assert statuses(found) == ["ok"]
    assert statuses(open_) == ["ok", "ok"]
    for name in EXIT:
        assert found.exit[name] == pytest.approx(open_.exit[name], rel=1e-12), name


@SHAPES
def test_a_stream_that_leaves_the_floor_further_on(closed):
    """It slides on the crest first, where n falls to 0 it crosses."""
    turn = {"from_slope_deg": 20.0, "to_slope_deg": 88.0}
    height = 0.1
    low = {"pipe": PIPE | {"radius_m": height / 2}, "box": BOX | {"height_m": height}}[closed["shape"]]
    flow = {"rate_t_h": 10.0}
    found = solved(low, [bend(radius=3.0, **turn)], 5.0, 20.0, flow=flow)
    crest = bend(radius=3.0, **turn)
    hood = bend("hood", 3.0 + height, start_m=offset(20.0, height), **turn)
    fall = {"kind": "fall", "onto_next": True}
    part = {"pipe": {"shape": "circular", "radius_m": height / 2}, "box": OPEN["box"]}[closed["shape"]]
    open_ = solved(part, [crest, fall, hood], 5.0, 20.0, flow=flow)
    assert statuses(open_) == ["contact_lost", "ok", "ok"]
    assert open_.segments[0].exit["s_m"][0] > 0.01
    for name in EXIT:
        assert found.exit[name] == pytest.approx(open_.exit[name], rel=1e-10), name
    lost = [finding for finding in found.findings() if finding.code == "contact_lost"]
    assert {finding.severity for finding in lost} <= {"note"}


@SHAPES
def test_the_floor_of_a_hood_is_a_crest(closed):
    """The other way round: what drops off a hood lands on the crest below, of radius R - D."""
    turn = {"from_slope_deg": 10.0, "to_slope_deg": 60.0}
    found = solved(closed, [bend("hood", 4.0, **turn)], 3.0, 10.0)
    crest = bend("curve", 4.0 - HEIGHT, start_m=offset(10.0, -HEIGHT), **turn)
    open_ = solved(OPEN[closed["shape"]], [{"kind": "fall", "onto_next": True}, crest], 3.0, 10.0)
    assert statuses(open_)[-1] == "contact_lost" or statuses(open_) == ["ok", "ok"]
    assert found.segments[0].impact["velocity_after_m_s"] == pytest.approx(
        open_.segments[1].impact["velocity_after_m_s"], rel=1e-12, nan_ok=True
    )
    assert found.segments[0].kind == "hood"


# by hand


def strike(velocity, slope, centre, radius, start=(0.0, 0.0), until=2.0):
    """Return where a parabola first leaves a circle outwards or meets it from inside: time, x, z, velocity, slope."""
    vx, vz = velocity * cos(slope), -velocity * sin(slope)

    def at(t):
        return start[0] + vx * t, start[1] + vz * t - G * t * t / 2

    def beyond(t):
        x, z = at(t)
        return hypot(x - centre[0], z - centre[1]) - radius

    times = np.linspace(1e-6, until, 20001)
    signs = np.sign([beyond(t) for t in times])
    first = int(np.flatnonzero(signs != signs[0])[0])
    t = brentq(beyond, times[first - 1], times[first], xtol=1e-16, rtol=1e-15)
    x, z = at(t)
    down = vz - G * t
    return t, x, z, hypot(vx, down), np.arctan2(-down, vx)


def test_a_parabola_meets_the_circle_of_the_roof():
    """A crest that begins 10° steeper than the stream: its centre is R below the inlet, along the crest's normal."""
    first, radius, velocity = radians(30.0), 2.0, 6.0
    found = solved(BOX, [bend(radius=radius, from_slope_deg=30.0, to_slope_deg=80.0)], velocity, 20.0)
    centre = -radius * sin(first), -radius * cos(first)
    _, x, z, v, slope = strike(velocity, radians(20.0), centre, radius + HEIGHT)
    entry, impact = found.segments[0].entry, found.segments[0].impact
    angle = np.arctan2(x - centre[0], z - centre[1])  # the slope of the arc there
    assert entry["x_m"][0] == pytest.approx(x, rel=1e-13)
    assert entry["z_m"][0] == pytest.approx(z, rel=1e-13, abs=1e-14)
    assert entry["slope_deg"][0] == pytest.approx(np.degrees(angle), rel=1e-13)
    assert impact["velocity_before_m_s"][0] == pytest.approx(v, rel=1e-13)
    # the incidence is a difference of angles of about 1
    assert impact["incidence_deg"][0] == pytest.approx(np.degrees(angle - slope), abs=1e-12)


def test_the_roof_of_a_spoon_throws_the_stream_back():
    """It strikes the roof of radius R - D, which cannot carry it, and goes on to the floor of radius R."""
    first, radius, velocity, mu = radians(60.0), 3.0, 7.0, np.tan(radians(25.0))
    spoon = bend(radius=radius, from_slope_deg=60.0, to_slope_deg=5.0)
    height = 0.15
    found = solved(BOX | {"height_m": height}, [spoon], velocity, 30.0)
    assert statuses(found) == ["ok"]

    centre = radius * sin(first), radius * cos(first)
    _, x, z, v, slope = strike(velocity, radians(30.0), centre, radius - height)
    along = np.arctan2(centre[0] - x, centre[1] - z)
    incidence = along - slope
    entry = found.segments[0].entry
    assert (entry["x_m"][0], entry["z_m"][0]) == pytest.approx((x, z), rel=1e-12)
    chi = entry["equivalent_friction"][0] / mu - 1.0
    assert chi > 0.0
    area = 100 / 3.6 / 800.0 / v
    ratio = (1 - sin(radians(50.0))) / (1 + sin(radians(50.0)))
    after = v * (cos(incidence) - mu * (1 + ratio * area / 0.5**2) * sin(incidence))
    assert entry["velocity_m_s"][0] == pytest.approx(after, rel=1e-12)

    _, x, z, v, slope = strike(after, along, centre, radius, (x, z))
    floor = np.arctan2(centre[0] - x, centre[1] - z)
    rest = bend(radius=radius, from_slope_deg=np.degrees(floor), to_slope_deg=5.0)
    open_ = solved(OPEN["box"], [rest], v, np.degrees(slope))
    for name in ("slope_deg", "velocity_m_s", "depth_m"):
        assert found.exit[name] == pytest.approx(open_.exit[name], rel=1e-10), name
    assert found.exit["x_m"][0] == pytest.approx(x + open_.exit["x_m"][0], rel=1e-10)


def test_the_roof_of_a_taper_leads_from_mouth_to_mouth():
    """A straight: the line between the offset ends; its slope differs from the floor's by the taper's angle."""
    sections = {"wide": {"shape": "pipe", "radius_m": 0.3}, "narrow": {"shape": "pipe", "radius_m": 0.2}}
    length, velocity = 2.0, 6.0
    segment = {"kind": "straight", "slope_deg": 60.0, "length_m": length, "section": ["wide", "narrow"]}
    found = chutecalc.solve(
        chute(
            sections=sections,
            segments=[segment],
            inlet={"velocity_m_s": velocity, "slope_deg": 30.0},
            flow={"rate_t_h": 50.0},
        )
    )
    entry = found.segments[0].entry
    assert entry["slope_deg"][0] == pytest.approx(60.0 + np.degrees(np.arctan2(0.2, length)), rel=1e-14)
    a, vx, vz = radians(60.0), velocity * cos(radians(30.0)), -velocity * sin(radians(30.0))

    def below_roof(t):
        x, z = vx * t, vz * t - G * t * t / 2
        along, across = x * cos(a) - z * sin(a), x * sin(a) + z * cos(a)
        return 0.6 - 0.2 * along / length - across

    t = brentq(below_roof, 0.0, 0.5, xtol=1e-16)
    assert entry["x_m"][0] == pytest.approx(vx * t, rel=1e-12)


@pytest.mark.parametrize(("first", "last"), [(20.0, 70.0), (70.0, 20.0)])
def test_the_roof_of_a_tapering_bend_ends_where_the_next_one_begins(first, last):
    """So that a stream which comes along one goes on along the other: energy and place have no jump."""
    sections = {"wide": {"shape": "pipe", "radius_m": 0.3}, "narrow": {"shape": "pipe", "radius_m": 0.25}}
    segments = [
        bend(radius=3.0, from_slope_deg=first, to_slope_deg=last, section=["wide", "narrow"]),
        {"kind": "straight", "slope_deg": last, "length_m": 0.5, "section": "narrow"},
    ]
    found = chutecalc.solve(
        chute(
            sections=sections,
            segments=segments,
            inlet={"velocity_m_s": 9.0, "slope_deg": first},
            flow={"rate_t_h": 50.0},
        )
    )
    assert found.status[0] == "ok"
    if found.segments[1].entry["s_m"] == found.segments[0].exit["s_m"]:
        for name in ("x_m", "z_m"):
            assert found.segments[1].entry[name] == pytest.approx(found.segments[0].exit[name], rel=1e-13)
    falls(found)


# never lost


def falls(solution):
    """Nothing but gravity drives: v²/2 + g z never rises by more than rounding."""
    table = solution.stations(points=9)
    reached = np.isfinite(table["s_m"][0])
    v, z = table["velocity_m_s"][0][reached], table["z_m"][0][reached]
    energy = v**2 / 2 + G * z
    assert (np.diff(energy) <= 1e-9 * (1 + v[1:] ** 2)).all()


@SHAPES
@pytest.mark.parametrize("kind", ["curve", "hood"])
@pytest.mark.parametrize("radius", [0.5, 1.0, 3.0, 20.0])
def test_a_bend_never_loses_a_stream(closed, kind, radius):
    slopes = [-60.0, -20.0, 0.0, 30.0, 60.0, 89.0]
    for first in slopes:
        for last in slopes:
            if first == last or (kind == "hood" and first > last):
                continue
            for velocity in (1.5, 4.0, 8.0, 15.0):
                segments = [bend(kind, radius, from_slope_deg=first, to_slope_deg=last)]
                flow = {"rate_t_h": 2.0}
                found = solved(closed, segments, velocity, first, flow=flow, liners={"wall": {"friction_deg": 10.0}})
                climbs = radius * (cos(radians(first)) - cos(radians(min(last, 0.0)))) if first < 0 else 0.0
                if found.status[0] in ("stall", "choke"):
                    assert velocity**2 < 40 * G * (abs(climbs) + radius + HEIGHT)
                elif found.status[0] != "ok":  # it rises, and falls back out of the mouth that it came in through
                    assert (found.status[0], first < 0.0) == ("contact_lost", True)
                    assert velocity**2 / 2 < G * radius * (1 - cos(radians(first))) + G * HEIGHT
                falls(found)


@SHAPES
@pytest.mark.parametrize("kink", [-15.0, -4.0, 4.0, 15.0])
@pytest.mark.parametrize("kind", ["straight", "hood"])
def test_a_chain_of_kinks_is_mitred(closed, kink, kind):
    """Straights, or hoods, at an angle to one another: a stream on either wall, or in flight, stays inside."""
    slopes = [45.0 + k * kink for k in range(3)]
    for velocity in (2.0, 5.0, 9.0):
        for arrival in (30.0, 45.0, 60.0):
            first = bend(radius=3.0, from_slope_deg=arrival, to_slope_deg=45.0) if arrival < 45.0 else None
            chain = [
                {"kind": "straight", "slope_deg": slope, "length_m": 0.6}
                if kind == "straight"
                else bend("hood", 3.0, from_slope_deg=slope, to_slope_deg=slope + 10.0)
                for slope in slopes
            ]
            found = solved(closed, [first, *chain] if first and kind == "straight" else chain, velocity, arrival)
            assert found.status[0] in ("ok", "stall"), (velocity, arrival, statuses(found))
            falls(found)


# mouths


def through(section, across, time=0.25, length=0.3, velocity=3.0):
    """A mouth placed so that a flight passes it along the tube, so far from the drawn wall."""
    vx, vz = velocity * cos(radians(20.0)), -velocity * sin(radians(20.0))
    x, z = vx * time, vz * time - G * time * time / 2
    slope = float(np.degrees(np.arctan2(-(vz - G * time), vx)))
    start = [x - across * sin(radians(slope)), z - across * cos(radians(slope))]
    tube = {"kind": "straight", "slope_deg": slope, "length_m": length, "start_m": start}
    return partial(solved, section, [{"kind": "fall", "onto_next": True}, tube], velocity, 20.0), slope, (x, z)


@SHAPES
@pytest.mark.parametrize(
    ("across", "status"),
    [
        (-1e-6, "missed"),
        (1e-6, "ok"),
        (0.5 * HEIGHT, "passed"),
        (HEIGHT - 1e-6, "passed"),
        (HEIGHT + 1e-6, "missed"),
    ],
)
def test_a_stream_comes_in_between_the_walls(closed, across, status):
    run, _, _ = through(closed, across)
    found = run()
    assert statuses(found)[1] == status
    assert found.status[0] == ("missed" if status == "missed" else "ok")
    failures = [finding.code for finding in found.findings() if finding.severity == "failure"]
    assert failures in ([["passed_by"], ["missed"]] if status == "missed" else [[]])


def test_what_flies_through_leaves_at_the_end_of_the_tube():
    run, slope, (x, z) = through(BOX, HEIGHT - 0.01)
    found = run()
    a = radians(slope)
    xe = x - (HEIGHT - 0.01) * sin(a) + 0.3 * cos(a)
    ze = z - (HEIGHT - 0.01) * cos(a) - 0.3 * sin(a)
    end = found.exit
    along = (end["x_m"][0] - xe) * cos(a) - (end["z_m"][0] - ze) * sin(a)
    assert along == pytest.approx(0.0, abs=1e-13)
    drop = -end["z_m"][0]
    assert end["velocity_m_s"][0] == pytest.approx(np.sqrt(9.0 + 2 * G * drop), rel=1e-13)
    assert np.isnan(end["depth_m"][0])
    assert found.exit_velocity == end["velocity_m_s"]


def test_a_stream_on_a_roof_falls_into_an_open_chute():
    segments = [
        bend(radius=2.0, to_slope_deg=60.0),
        {"kind": "straight", "slope_deg": 50.0, "length_m": 8.0, "section": "trough"},
    ]
    found = chutecalc.solve(
        chute(
            sections={"body": PIPE, "trough": OPEN["pipe"]},
            segments=[segment | {"section": segment.get("section", "body")} for segment in segments],
            inlet={"velocity_m_s": 10.0, "slope_deg": 20.0},
            flow={"rate_t_h": 100.0},
        )
    )
    assert statuses(found) == ["ok", "ok"]
    end, entry = found.segments[0].exit, found.segments[1].entry
    assert hypot(end["x_m"][0], end["z_m"][0]) > 0.0
    assert entry["s_m"][0] > end["s_m"][0]  # it flies between them
    falls(found)


# batches

VELOCITIES = np.linspace(1.5, 12.0, 22)


def walls_and_more():
    """A crest on which slow streams keep to the floor and fast ones cross, then a spoon and an open trough."""
    segments = [
        bend(radius=2.0, to_slope_deg=70.0, section="body"),
        bend(radius=3.0, to_slope_deg=30.0, section="body"),
        {"kind": "straight", "slope_deg": 40.0, "length_m": 1.0, "section": "body"},
        {"kind": "straight", "slope_deg": 35.0, "length_m": 3.0, "section": "trough"},
    ]
    return chute(
        sections={"body": PIPE, "trough": OPEN["pipe"] | {"radius_m": 0.3}},
        segments=segments,
        inlet={"velocity_m_s": 3.0, "slope_deg": 20.0},
        flow={"rate_t_h": 100.0},
        liners={"wall": {"friction_deg": 15.0}},
    )


@pytest.mark.parametrize("path", ["inlet.velocity_m_s", "segments.3.length_m"])
def test_a_batch_has_the_digits_of_its_designs(path):
    """Also where designs are on different walls at the same visit, and where only what follows varies."""
    base, values = walls_and_more(), VELOCITIES if path.startswith("inlet") else VELOCITIES / 10
    together = chutecalc.solve(base.vary({path: values}))
    ends = chutecalc.exits(base.vary({path: values}), columns=["velocity_m_s", "x_m", "depth_m"])
    assert set(together.status) <= {"ok", "stall"}
    for k, value in enumerate(values):
        alone = chutecalc.solve(base.vary({path: [value]}))
        assert alone.status[0] == together.status[k]
        for one, other in zip(alone.segments, together.segments, strict=True):
            assert one.status[0] == other.status[k]
            for name in EXIT:
                for end in ("entry", "exit"):
                    first, second = getattr(one, end)[name], getattr(other, end)[name][k : k + 1]
                    assert np.array_equal(first, second, equal_nan=True), (value, name)
        for name in ("velocity_m_s", "x_m", "depth_m"):
            assert ends.exit[name][k] == pytest.approx(alone.exit[name][0], rel=4e-15, nan_ok=True), name
    if path.startswith("inlet"):
        assert len({tuple(np.sign(together.segments[0].exit["x_m"][k] - 1.3) for k in [j]) for j in range(22)}) == 2


def test_a_function_of_a_chute_with_roofs():
    base = walls_and_more()
    function = base.function(["inlet.velocity_m_s", "sections.body.radius_m"], ["exit_velocity_m_s", "exit_x_m"])
    velocity, x = function(VELOCITIES, np.full(len(VELOCITIES), 0.21))
    varied = base.vary({"inlet.velocity_m_s": VELOCITIES, "sections.body.radius_m": [0.21]})
    ends = chutecalc.exits(varied, columns=["velocity_m_s", "x_m"])
    # sine and cosine of NumPy and of C may differ in the last digit
    assert velocity == pytest.approx(ends.exit["velocity_m_s"], rel=1e-13, nan_ok=True)
    assert x == pytest.approx(ends.exit["x_m"], rel=1e-13, nan_ok=True)


def test_a_sweep_across_both_walls(tmp_path, capsys):
    path = tmp_path / "chute.toml"
    data = spec(
        sections={"body": PIPE},
        segments=[bend(radius=2.0, to_slope_deg=70.0)],
        inlet={"velocity_m_s": 3.0, "slope_deg": 20.0},
        flow={"rate_t_h": 100.0},
    )
    path.write_text(tomli_w.dumps(data), encoding="utf-8")
    assert main(["sweep", str(path), "inlet.velocity_m_s=2:12:2", "--csv", "-"]) == 0
    rows = list(csv.DictReader(io.StringIO(capsys.readouterr().out)))
    for row in rows:
        velocity = float(row["inlet.velocity_m_s"])
        single = chutecalc.solve(chutecalc.parse(data | {"inlet": {"velocity_m_s": velocity, "slope_deg": 20.0}}))
        assert row["status"] == single.status[0] == "ok"
        assert float(row["exit_velocity_m_s"]) == single.exit_velocity[0]


def test_the_standard_design_crosses_to_its_roof():
    found = chutecalc.solve(chutecalc.load(ROOT / "specs" / "pipe_two_bends.toml"))
    assert found.status[0] == "ok"
    crossed = [finding.segment for finding in found.findings() if finding.code == "contact_lost"]
    assert crossed == ["upper_bend", "leg"]
    assert found.segments[0].exit["slope_deg"] == pytest.approx(70.0)  # on its roof
    fills = [float(segment.maximum["fill"][0]) for segment in found.segments]
    assert max(fills) < 0.4
