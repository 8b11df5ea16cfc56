"""Extremes of a solution against its own stations, dense along random chutes of every kind."""

from itertools import islice

import numpy as np
import pytest

import chutecalc
from chutecalc.results.columns import REPORTED
from chutecalc.results.extremes import LARGEST, LEAST, extremes
from tests import seeds
from tests.robustness.chutes import draws, noting_spec

COUNT = 15
SLACK = 1e-9
"""Relative. An extreme is that of a parabola over a hundredth of a panel: 1e-11 of what varies there."""


@pytest.mark.parametrize("block", range(seeds.times(6)))
def test_no_station_lies_beyond_an_extreme(block):
    """Kinks of a locus, entries next to rest, tops of a throw, stalls and losses of contact among them."""
    compared = 0
    found_ones = ((data, solution) for data, solution, _ in draws(5000 + block) if solution is not None)
    for data, solution in islice(found_ones, COUNT):
        with noting_spec(data):
            compared += check_stations(solution)
            check_together(solution)
            check_positions(solution)
    assert compared > COUNT


def check_stations(solution):
    """No station lies beyond an extreme; how many columns there were."""
    compared = 0
    table = solution.stations(points=2001)
    for result in solution.trajectory.results:
        if sum(other.name == result.name for other in solution.trajectory.results) > 1:
            continue  # left and met again: its stations stand under one name
        rows = table["segment"][0] == result.name
        for name in REPORTED:
            found = table[name][0][rows]
            found = found[np.isfinite(found)]
            if found.size:
                least, most = result.minimum[name][0], result.maximum[name][0]
                assert found.max() <= most + SLACK * abs(most), (result.name, name)
                assert found.min() >= least - SLACK * abs(least) - 1e-12 * found.max(), (result.name, name)
                compared += 1
    return compared


def check_together(solution):
    """What a sweep shows of all guiding surfaces together is the greatest of what ``run`` shows of each."""
    guided = [
        result
        for result, part in zip(solution.trajectory.results, solution.trajectory.parts, strict=True)
        if part.contact is not None
    ]
    pairs = [(name, sign) for name in REPORTED for sign in (LEAST, LARGEST)]
    together = solution.trajectory.extreme_columns(pairs)
    for name, sign in pairs if guided else ():
        each = [(result.maximum if sign == LARGEST else result.minimum)[name] for result in guided]
        expected = (np.fmax if sign == LARGEST else np.fmin).reduce(each)
        assert np.allclose(together[name, sign], expected, rtol=1e-12, atol=0, equal_nan=True), (name, sign)


NUMBERS = {
    "slow_stream": "froude",
    "thick_stream": "thickness",
    "missing_load": "missing_load",
    "decelerating": "velocity_m_s",
}
"""Of findings, the number that is found where they are."""


def check_positions(solution):
    """An extreme, and a finding that quotes one, is the value of the column at its position."""
    for sampled in solution.trajectory.sampled:
        part = sampled.part
        for (name, sign), extreme in sampled.extremes.items():
            if np.isfinite(extreme.value[0]) and extreme.share[0] < 1.0:  # at the end it may be a limit
                there = part.at(extreme.share[None], [name])[name][0, 0]
                assert there == pytest.approx(extreme.value[0], rel=1e-8, abs=1e-12), (part.name, name, sign)
    parts = {part.name: part for part in solution.trajectory.parts}
    for finding in solution.findings():
        name = NUMBERS.get(finding.code, "")
        if name not in finding.numbers or sum(part.name == finding.segment for part in solution.trajectory.parts) > 1:
            continue
        part, value = parts[finding.segment], finding.numbers[name][0]
        first, last = (part.at(np.array([end]), ["s_m"])["s_m"][0, 0] for end in (0.0, 1.0))
        share = (finding.s_m[0] - first) / (last - first) if last > first else 1.0
        if share < 1.0 - 1e-12 and np.isfinite(value):
            there = part.at(np.array([share]), [name])[name][0, 0]
            assert there == pytest.approx(value, rel=1e-6, abs=1e-9), finding.code


def chute(**tables):
    base = {
        "flow": {"rate_t_h": 300.0},
        "material": {"density_kg_m3": 1000.0, "internal_friction_deg": 45.0},
        "liners": {"wall": {"friction_deg": 20.0}},
        "sections": {"body": {"shape": "rectangular", "width_m": 0.6}},
    }
    return chutecalc.solve(chutecalc.parse(base | tables))


def test_a_kink_of_a_locus_is_an_extreme():
    """Where the pressure passes the corner between the bound and the first line, μ falls from there on."""
    rows = [[0.6, 0.38], [3.0, 0.9]]
    solution = chute(
        liners={"wall": {"yield_locus_kpa": rows}},
        inlet={"velocity_m_s": 3.0, "slope_deg": 60.0},
        segments=[{"kind": "curve", "radius_m": 3.0, "to_slope_deg": 0.0}],
    )
    stations = solution.stations(points=20_001)
    spoon = solution.segments[0]
    assert spoon.maximum["equivalent_friction"][0] >= np.nanmax(stations["equivalent_friction"]) * (1 - 1e-12)
    assert spoon.minimum["equivalent_friction"][0] <= np.nanmin(stations["equivalent_friction"]) * (1 + 1e-12)


def test_what_grows_without_bound_is_infinite():
    stalled = chute(
        inlet={"velocity_m_s": 2.0, "slope_deg": 5.0},
        segments=[{"kind": "straight", "slope_deg": 5.0, "length_m": 9.0}],
    ).segments[0]
    assert stalled.status[0] == "stall"
    assert [stalled.maximum[name][0] for name in ("depth_m", "equivalent_friction", "pressure_kpa")] == [np.inf] * 3
    # μ p v stays: ρ n Q/b on a rectangular floor
    wear = np.tan(np.radians(20.0)) * 1000.0 * 9.80665 * np.cos(np.radians(5.0)) * 300 / 3600 / 0.6
    assert stalled.maximum["wear_w_m2"][0] == pytest.approx(wear, rel=1e-12)
    assert stalled.minimum["froude"][0] == 0.0
    assert np.isnan(stalled.exit["depth_m"][0])  # a stream at rest has none
    thrown = chute(
        inlet={"velocity_m_s": 3.0, "slope_deg": 10.0},
        segments=[{"kind": "curve", "radius_m": 1.5, "to_slope_deg": 80.0}, {"kind": "fall", "drop_m": 3.0}],
    ).segments[0]
    assert thrown.status[0] == "contact_lost"
    assert thrown.maximum["froude"][0] == np.inf
    assert thrown.minimum["pressure_kpa"][0] == pytest.approx(0.0, abs=1e-9)


def test_in_a_vee_friction_has_a_limit_at_a_stall():
    vee = chute(
        sections={"body": {"shape": "vee", "chamfer_deg": 45.0}},
        inlet={"velocity_m_s": 2.0, "slope_deg": 5.0},
        segments=[{"kind": "straight", "slope_deg": 5.0, "length_m": 9.0}],
    ).segments[0]
    assert vee.status[0] == "stall"
    assert vee.maximum["equivalent_friction"][0] == pytest.approx(vee.entry["equivalent_friction"][0], rel=1e-12)
    assert vee.maximum["depth_m"][0] == np.inf
    assert vee.minimum["wear_w_m2"][0] == 0.0


@pytest.mark.parametrize("up_deg", [40.0, 80.0, 89.0, 89.9, 89.999])
def test_a_thrown_stream_is_slowest_at_its_apex(up_deg):
    """v cos θ there, without air; of a steep throw that is a sharp dip."""
    thrown = chute(
        inlet={"velocity_m_s": 5.0, "slope_deg": -up_deg},
        segments=[{"kind": "fall", "drop_m": 1.0}],
    ).segments[0]
    assert thrown.minimum["velocity_m_s"][0] == pytest.approx(5.0 * np.cos(np.radians(up_deg)), rel=1e-9)
    assert thrown.maximum["velocity_m_s"][0] == thrown.exit["velocity_m_s"][0]


class Parabola:
    """A part of the stream with one quantity, greatest at a share of it."""

    def __init__(self, top):
        self.top = top

    def at(self, shares, names):
        return dict.fromkeys(names, 3.0 - (shares - self.top) ** 2)

    def limits(self, names):
        return dict.fromkeys(names, np.full(1, np.nan)) | self.at(np.ones(1), names)


@pytest.mark.parametrize("top", [0.0, 0.01, 0.04, 0.05, 0.5, 0.77, 0.96, 0.99, 1.0])
def test_an_extreme_between_an_end_and_the_next_sample_is_found(top):
    """Ten samples a tenth apart; a top next to an end lies higher than the end by what the parabola rises."""
    shares, part = np.linspace(0.0, 1.0, 11), Parabola(top)
    sampled = part.at(shares[:, None], ["depth_m"])
    most = extremes(part, sampled, shares, [("depth_m", LARGEST)])["depth_m", LARGEST]
    assert most.value[0] == pytest.approx(3.0, abs=1e-15)
    assert most.share[0] == pytest.approx(top, abs=1e-8)  # √ε of what is flat there


def test_designs_that_differ_in_what_the_stream_does_not_feel():
    """One stream for all of them, and wear for each."""
    base = chutecalc.parse(chutecalc.STARTER)
    slip = "liners.ceramic.slip_ratio"
    together = chutecalc.solve(base.vary({slip: [0.5, 1.0]}))
    for k, ratio in enumerate((0.5, 1.0)):
        alone = chutecalc.solve(base.vary({slip: ratio}))
        for part, single in zip(together.segments, alone.segments, strict=True):
            for name, values in part.maximum.items():
                assert values[k] == pytest.approx(single.maximum[name][0], rel=1e-12, nan_ok=True)
    assert len(together.findings()) == len(alone.findings())
