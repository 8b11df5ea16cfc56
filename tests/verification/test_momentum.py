"""A velocity profile and pressure along the stream: first integrals, jumps, and momentum balanced by differences."""

import random
from collections import Counter

import numpy as np
import pytest

import chutecalc
from chutecalc.solver.chain import run_chain
from tests import seeds
from tests.conftest import ROOT, chute, spec
from tests.verification import second_solver
from tests.verification.second_cases import ClosedMaker, Maker, case, compare, theirs_of

G = 9.80665
FACTOR, RATIO = "model.momentum_factor", "model.longitudinal_pressure_ratio"
SMOOTH = {"wall": {"friction_deg": 0.0}}
TAPERS = {
    "rectangular": ({"width_m": 0.5}, {"width_m": 0.9}),
    "vee": ({"chamfer_deg": 40.0}, {"chamfer_deg": 60.0}),
    "chamfered": (
        {"base_m": 0.5, "chamfer_deg": 30.0, "chamfer_m": 0.05},
        {"base_m": 0.3, "chamfer_deg": 65.0, "chamfer_m": 0.08},
    ),
    "circular": ({"radius_m": 0.3}, {"radius_m": 0.22}),
    "pipe": ({"radius_m": 0.3}, {"radius_m": 0.45}),
    "box": ({"width_m": 0.6, "height_m": 1.0}, {"width_m": 0.5, "height_m": 1.2}),
    "facets": (
        {"facets": [{"length_m": 0.2, "slope_deg": 0.0}, {"length_m": 0.06, "slope_deg": 35.0}]},
        {"facets": [{"length_m": 0.1, "slope_deg": 10.0}, {"length_m": 0.05, "slope_deg": 70.0}]},
    ),
}


@pytest.mark.parametrize("shape", TAPERS)
@pytest.mark.parametrize("slope", [35.0, 0.0])
def test_without_friction_a_straight_keeps_the_head_of_an_open_channel(shape, slope):
    """α_m v²/2 + K_l g cos a H - g sin a s is constant, between any walls: K_l n is the slope of the surface."""
    first, last = TAPERS[shape]
    straight = {"kind": "straight", "slope_deg": slope, "length_m": 2.0, "section": ["body", "end"]}
    base = chute(
        sections={"body": {"shape": shape} | first, "end": {"shape": shape} | last},
        liners=SMOOTH,
        inlet={"velocity_m_s": 6.0, "slope_deg": slope},
        segments=[straight],
    )
    given = [(1.0, 0.0), (1.0, 1.0), (1.25, 0.4), (1.33, 1.0)]
    factors, ratios = (np.array(each) for each in zip(*given, strict=True))
    solution = chutecalc.solve(base.vary({FACTOR: factors, RATIO: ratios}))
    assert solution.ok.all()
    at = solution.stations(points=9)
    a = np.radians(slope)
    head = 0.5 * factors[:, None] * at["velocity_m_s"] ** 2 - G * np.sin(a) * at["s_m"]
    head += ratios[:, None] * G * np.cos(a) * at["depth_m"]
    assert head == pytest.approx(head[:, :1] * np.ones((1, 9)), rel=3e-10)


def test_a_profile_changes_inertia_and_centrifugal_load_alike():
    """Without gravity's pull to speak of, v falls as e^(-μ θ) on an arc whatever the profile; a fall is not changed."""
    arc = [{"kind": "curve", "from_slope_deg": 60.0, "to_slope_deg": 0.0, "radius_m": 2.0}]
    base = chute(
        inlet={"velocity_m_s": 5.0, "slope_deg": 60.0},
        segments=arc,
    )
    design = base.vary({FACTOR: [1.0, 1.25, 2.0]}).design
    weightless = design._replace(gravity=np.array([1e-9]), mass_rate=np.array([1e-7]))  # no spec says that
    got = run_chain(weightless, 1e-10)[1].velocity
    assert got == pytest.approx(5.0 * np.exp(-np.tan(np.radians(25.0)) * np.pi / 3), rel=1e-6)
    assert np.ptp(got) < 1e-9


def test_the_worked_example_and_what_the_assumptions_change_in_it():
    """What docs/physics.md states, in per cent of the exit velocity."""
    spoon = chutecalc.load(ROOT / "specs" / "paper" / "r3_d55_chamfered.toml")

    def change(**values):
        paths = {"factor": FACTOR, "ratio": RATIO, "angle": "liners.wall.friction_deg"}
        varied = spoon.vary({paths[key]: value for key, value in values.items()})
        return 100.0 * (chutecalc.solve(varied).exit_velocity[0] / chutecalc.solve(spoon).exit_velocity[0] - 1.0)

    assert change(ratio=0.5) == pytest.approx(-1.8, abs=0.05)
    assert change(factor=1.25) == pytest.approx(-4.6, abs=0.05)
    assert change(angle=26.0) == pytest.approx(-6.7, abs=0.05)
    assert change(angle=24.0) == pytest.approx(6.5, abs=0.05)


def jumping(length=20.0, **model):
    return chute(
        sections={"body": {"shape": "rectangular", "width_m": 0.5}},
        segments=[{"kind": "straight", "slope_deg": 10.0, "length_m": length}],
        inlet={"velocity_m_s": 4.0, "slope_deg": 10.0},
        model=model,
    )


@pytest.mark.parametrize(("factor", "ratio"), [(1.0, 1.0), (1.25, 1.0), (1.33, 0.2), (1.0, 1e-4)])
def test_the_model_ends_where_the_stream_jumps(factor, ratio):
    solution = chutecalc.solve(jumping(momentum_factor=factor, longitudinal_pressure_ratio=ratio))
    assert solution.status[0] == "choke"
    end = {name: values[0] for name, values in solution.segments[0].exit.items()}
    assert end["froude"] ** 2 == pytest.approx(ratio / factor, rel=1e-9)
    assert end["depth_m"] == pytest.approx(1000 / 3.6 / 800 / 0.5 / end["velocity_m_s"], rel=1e-12)
    (failure,) = [finding for finding in solution.findings() if finding.severity == "failure"]
    assert "jumps" in failure.message()
    assert f"K_l = {ratio:g}" in failure.message()
    plain = chutecalc.solve(jumping(momentum_factor=factor))
    assert plain.status[0] == "stall"
    assert plain.segments[0].exit["s_m"][0] > end["s_m"]
    assert chutecalc.exits(jumping(momentum_factor=factor, longitudinal_pressure_ratio=ratio)).status[0] == "choke"


def test_a_jump_is_approached_as_the_root_of_the_distance():
    """(v² - v_jump²)² falls linearly: the stations next to it are right too."""
    solution = chutecalc.solve(jumping(longitudinal_pressure_ratio=1.0))
    at = solution.stations(points=100_001)
    s, y = at["s_m"][0][-40:], at["velocity_m_s"][0][-40:] ** 2
    slopes = np.diff((y - y[-1]) ** 2) / np.diff(s)
    assert slopes == pytest.approx(slopes[-1], rel=0.1)
    assert (np.diff(y) < 0.0).all()


def test_a_stream_that_comes_beyond_its_jump_ends_where_it_comes():
    base = jumping(longitudinal_pressure_ratio=1.0).vary({"inlet.velocity_m_s": [0.8, 4.0]})
    solution = chutecalc.solve(base)
    assert solution.status.tolist() == ["choke", "choke"]
    assert solution.segments[0].exit["s_m"][0] == 0.0
    assert solution.segments[0].exit["velocity_m_s"][0] == 0.8
    assert solution.segments[0].exit["s_m"][1] > 0.0


def test_between_walls_the_choke_comes_before_the_jump_and_says_so():
    low = jumping(longitudinal_pressure_ratio=1.0).vary({"sections.body.wall_height_m": 0.3})
    solution = chutecalc.solve(low)
    assert solution.segments[0].exit["depth_m"][0] == pytest.approx(0.3, rel=1e-9)
    (failure,) = [finding for finding in solution.findings() if finding.severity == "failure"]
    assert "would jump" in failure.message()


def test_neglecting_both_is_the_default_to_the_last_digit():
    given = chutecalc.solve(chute(model={"momentum_factor": 1.0, "longitudinal_pressure_ratio": 0.0}))
    assert given.exit_velocity.tobytes() == chutecalc.solve(chute()).exit_velocity.tobytes()


@pytest.mark.parametrize("maker", [Maker, ClosedMaker])
def test_random_chutes_against_the_second_solver(maker):
    """It differences the momentum of the stream, and has no bracket."""
    verdicts: Counter[str] = Counter()
    statuses: Counter[str] = Counter()
    for seed in range(seeds.times(30)):
        data, _ = case(seed, maker)
        draw = random.Random(seed)
        data["model"]["momentum_factor"] = draw.choice([1.0, 1.25, 1.33, draw.uniform(1.0, 2.0)])
        data["model"]["longitudinal_pressure_ratio"] = draw.choice([0.5, 1.0, draw.random()])
        try:
            theirs = theirs_of(chutecalc.parse(data))
        except chutecalc.SpecError:  # another stream may not fall into a hood drawn for it
            continue
        verdict, wrong = compare(data, theirs)
        assert verdict != "wrong", (seed, wrong)
        verdicts[verdict] += 1
        statuses[theirs["status"]] += 1
    assert verdicts["same"] >= 0.9 * verdicts.total(), verdicts
    assert statuses["choke"], statuses


def test_a_pipe_almost_full_is_solved_with_pressure_along_it():
    """Forces are differenced within the pipe: this stream comes within 1e-5 of filling it, and gets faster again."""
    chute = chutecalc.load(ROOT / "specs" / "pipe_two_bends.toml")
    solution = chutecalc.solve(
        chute.put(
            {"model.longitudinal_pressure_ratio": 0.1, "flow.rate_t_h": 730.5853359, "model.momentum_factor": 1.25}
        )
    )
    assert solution.status[0] in ("ok", "choke")


def test_a_panel_that_goes_on_below_a_facet_stays_smooth():
    """A crest throws the stream off above the foot of the walls, which it would pass a little further on."""
    data = spec(
        flow={"rate_t_h": 137.0},
        material={"density_kg_m3": 1088.0, "internal_friction_deg": 29.0},
        sections={"body": {"shape": "chamfered", "base_m": 0.64, "chamfer_deg": 10.4, "chamfer_m": 0.226}},
        inlet={"velocity_m_s": 0.3, "slope_deg": 24.7},
        segments=[{"kind": "curve", "radius_m": 0.156, "to_slope_deg": 89.99}],
        model={"longitudinal_pressure_ratio": 0.09},
    )
    expected = second_solver.solve(data).segments[0].exit
    for rtol in (1e-8, 1e-10, 1e-13):
        found = chutecalc.solve(chutecalc.parse(data), rtol).trajectory.segment_solutions[0].exit
        assert found.velocity[0] == pytest.approx(expected.v, rel=10 * max(rtol, 1e-12))
