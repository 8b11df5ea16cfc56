"""Error estimates of whole chutes: through falls, landings, impacts and losses of contact."""

import numpy as np
import pytest

import chutecalc
from chutecalc.design import Status
from chutecalc.solver import chain
from chutecalc.solver.chain import run_chain
from chutecalc.solver.chain_input import borrow_state
from tests import seeds
from tests.robustness import extrapolation
from tests.robustness.extrapolation import Flow, Real
from tests.robustness.test_edges import ROUNDING

BASE = {
    "flow": {"rate_t_h": 300.0},
    "material": {"density_kg_m3": 1000.0, "internal_friction_deg": 45.0},
    "liners": {"wall": {"friction_deg": 20.0}},
    "sections": {"body": {"shape": "rectangular", "width_m": 0.6}},
    "model": {"steel": "follows_stream"},
}
COUNT = seeds.times(61)


def between(random, low, high):
    return np.exp(random.uniform(np.log(low), np.log(high), COUNT))


def falls(kind, seed):
    """Curve, fall, straight, fall, straight: variants of one chute, and what each number is."""
    random = seeds.generator(seed, kind == "run")
    fall = {"kind": "fall", f"{kind}_m": 1.0}
    numbers = {
        "flow.rate_t_h": between(random, 50.0, 2000.0),
        "liners.wall.friction_deg": random.uniform(5.0, 35.0, COUNT),
        "inlet.velocity_m_s": between(random, 0.3, 8.0),
        "segments.1.radius_m": between(random, 0.3, 8.0),
        f"segments.2.{kind}_m": between(random, 0.3, 2.0),
        "segments.3.length_m": between(random, 0.1, 2.0),
        f"segments.4.{kind}_m": between(random, 0.3, 2.0),
        "segments.5.length_m": between(random, 0.1, 4.0),
    }
    segments = [
        {"kind": "curve", "radius_m": 2.0, "from_slope_deg": 70.0, "to_slope_deg": 10.0},
        dict(fall),
        {"kind": "straight", "slope_deg": 1.0, "length_m": 1.0},
        dict(fall),
        {"kind": "straight", "slope_deg": 25.0, "length_m": 1.0},
    ]
    inlet = {"velocity_m_s": 3.0, "slope_deg": 70.0}
    tables = BASE | {"inlet": inlet, "segments": segments, "model": {"steel": "follows_stream"}}
    return chutecalc.parse(tables).vary(numbers), numbers


def slowly(design, kind, numbers):
    """Solve in 80-bit numbers: velocities after each of the five, NaN from a stall on."""
    one, ratio = np.ones(COUNT), design.vertical_ratio.astype(Real)
    gravity, flow = design.gravity.astype(Real), design.volume_rate.astype(Real)
    mu, width = np.tan(np.radians(numbers["liners.wall.friction_deg"].astype(Real))), Real(0.6)

    def slide(velocity, slope, turn, length):
        moving = velocity > 0
        fields = Flow(
            gravity=gravity,
            side=1.0,
            slope=slope,
            turn=turn,
            length=length,
            rate=flow,
            base=width,
            chamfer=np.pi / 2,
            sine=np.sin(np.radians(45.0)),
            friction=mu,
            equilibrium=0.0,
            velocity=np.where(moving, velocity, Real(1)),
        )
        ended = extrapolation.solve(Flow(*(np.asarray(field).astype(Real) * one for field in fields)))
        return np.where(moving & (ended.status == extrapolation.OK), ended.velocity, np.nan)

    def fly(velocity, slope, measure):
        u, w = velocity * np.cos(slope), velocity * np.sin(slope)
        time = measure / u if kind == "run" else (np.sqrt(w * w + 2 * gravity * measure) - w) / gravity
        return np.hypot(u, w + gravity * time), np.arctan2(w + gravity * time, u)

    def strike(velocity, slope, surface):
        i = np.where(slope > surface, slope - surface, np.nan)  # else it flies over the edge: not followed here
        friction = mu * (1 + ratio * flow / velocity / width**2)
        return np.maximum(velocity * (np.cos(i) - friction * np.sin(i)), 0)

    first, last = (np.radians(Real(angle)) for angle in (70, 10))
    radius = numbers["segments.1.radius_m"].astype(Real)
    velocity = slide(numbers["inlet.velocity_m_s"].astype(Real), first, last - first, radius * (first - last))
    slope, ends = last, [velocity]
    for number, angle in ((2, 1), (4, 25)):
        velocity, slope = fly(velocity, slope, numbers[f"segments.{number}.{kind}_m"].astype(Real))
        ends.append(velocity)
        surface = np.radians(Real(angle))
        length = numbers[f"segments.{number + 1}.length_m"].astype(Real)
        velocity, slope = slide(strike(velocity, slope, surface), surface, 0.0, length), surface
        ends.append(velocity)
    return ends


@pytest.mark.skipif(np.finfo(Real).nmant < 63, reason="the slow solver needs 80-bit numbers")
@pytest.mark.parametrize("kind", ["run", "drop"])
def test_errors_through_falls_and_impacts_are_within_their_estimates(kind):
    base, numbers = falls(kind, 0)
    with np.errstate(invalid="ignore", divide="ignore"):
        right = slowly(base.design, kind, numbers)
    compared = 0
    for rtol in (1e-4, 1e-6, 1e-8, 1e-10, 1e-12):
        for complete in (False, True):
            segment_solutions, _ = run_chain(base.design, rtol, complete)
            for solved, velocity in zip(segment_solutions, right, strict=True):
                ran = (solved.status == Status.OK) & np.isfinite(velocity)
                off = np.abs(solved.exit.velocity[ran] / velocity[ran].astype(float) - 1)
                bad = ~(off <= np.abs(solved.exit.error[ran]) + ROUNDING)
                assert not bad.any(), (rtol, complete, solved.segment.name, off[bad], solved.exit.error[ran][bad])
                compared += ran.sum()
    assert compared > 10 * 5 * COUNT * 0.4  # a good part stalls


def random_chain(random):
    """Curves, crests, hoods, plates and straights behind falls, flights onto placed segments, and joints."""
    uniform = random.uniform
    slope = uniform(10, 80)
    segments = [{"kind": "curve", "radius_m": uniform(0.5, 5), "from_slope_deg": slope, "to_slope_deg": uniform(0, 80)}]
    for _ in range(random.integers(1, 4)):
        link = random.choice(["drop", "run", "onto", "joint"])
        if link != "joint":
            measures = {"drop": {"drop_m": uniform(0.1, 3)}, "run": {"run_m": uniform(0.1, 2)}}
            segments.append({"kind": "fall"} | measures.get(link, {"onto_next": True}))
        segment = {"kind": "straight", "slope_deg": uniform(1, 60), "length_m": uniform(0.3, 5)}
        begin, which = uniform(10, 80), random.random()
        if which < 0.3:
            segment = {"kind": "curve", "from_slope_deg": begin, "to_slope_deg": uniform(0, begin - 1)}
        elif which < 0.45 and link in ("drop", "run"):  # tangent to the stream
            segment = {"kind": "curve", "to_slope_deg": uniform(-5, 10)}
        elif which < 0.6:
            segment = {"kind": "hood", "from_slope_deg": uniform(0, 40), "to_slope_deg": uniform(50, 85)}
        elif which < 0.7:
            segment = {"kind": "plate", "slope_deg": uniform(40, 85), "length_m": uniform(0.5, 2)}
        if segment["kind"] in ("curve", "hood"):
            segment["radius_m"] = uniform(0.5, 5)
        if link == "onto":
            segment["start_m"] = [uniform(0.2, 3), uniform(-4, 0)]
        segments.append(segment)
    sections = (
        {"shape": "rectangular", "width_m": 0.6},
        {"shape": "chamfered", "base_m": 0.3, "chamfer_deg": 50.0},
        {"shape": "circular", "radius_m": 0.4},
    )
    liner = {"friction_deg": uniform(0, 32)}
    if random.random() < 0.2:
        liner = {"yield_locus_kpa": [[0.5, 0.3], [1.0, 0.5], [4.0, 1.4]]}
    return BASE | {
        "flow": {"rate_t_h": uniform(50, 2000)},
        "liners": {"wall": liner},
        "sections": {"body": sections[random.integers(3)]},
        "inlet": {"velocity_m_s": uniform(0.5, 8), "slope_deg": slope},
        "segments": segments,
    }


OFF = 1e-6


def end_value(solved):
    """Return the number at a segment's end that has an error: the velocity, or the position of a stall."""
    if solved.status[0] != Status.STALL:
        return solved.exit.velocity[0]
    return solved.contact.end.share[0]


def off_at_the_inlet(kinds):
    state = borrow_state(kinds)
    state.inlet.error = OFF
    return state


def never_again(kinds, state):
    """Nobody else gets what is off."""


def test_an_error_at_the_inlet_goes_through_a_chain_as_another_velocity_there_does(monkeypatch):
    """The estimate's linear maps against differences of solved chutes: everything before the end contributes."""
    random, ends, kinds = seeds.generator(7), 0, set()
    for number in range(seeds.times(150)):
        try:
            design = chutecalc.parse(random_chain(random)).design
        except chutecalc.SpecError:  # a hood or curve that turns in the wrong direction
            continue
        monkeypatch.setattr(chain, "borrow_state", off_at_the_inlet)
        monkeypatch.setattr(chain, "return_state", never_again)
        segment_solutions, _ = run_chain(design, 1e-13)
        monkeypatch.undo()
        slower, faster = (
            run_chain(design._replace(inlet_velocity=design.inlet_velocity * (1 + off)), 1e-13)[0]
            for off in (-OFF, OFF)
        )
        if not len(segment_solutions) == len(slower) == len(faster):  # at an edge
            continue
        for solved, less, more in zip(segment_solutions, slower, faster, strict=True):
            if solved.status[0] >= Status.MISSED or not solved.status[0] == less.status[0] == more.status[0]:
                continue
            change = (
                abs(end_value(more) - end_value(less))
                / 2
                / (1.0 if solved.status[0] == Status.STALL else end_value(solved))
            )
            estimate = abs(solved.exit.error[0])
            # differences are off by their own curvature, OFF² times what errors have grown to the third, and by what
            # the three solutions are, 1e-13 and what that has grown to
            slack = 1e-3 * estimate + 1e-12 * (1.0 + estimate / OFF) ** 2
            assert change <= estimate + slack, (number, solved.segment, change, estimate)
            assert change >= 0.9 * estimate - slack - 1e-11, (number, solved.segment, change, estimate)
            ends, kinds = ends + 1, kinds | {(solved.segment.kind, int(solved.status[0]))}
    assert ends > seeds.times(200)
    assert {("fall", 0), ("plate", 0), ("hood", 0), ("curve", 0), ("curve", 1), ("curve", 3), ("straight", 1)} <= kinds


def test_a_stall_that_is_not_in_the_last_segment_has_its_error():
    rest = {"kind": "straight", "slope_deg": 0.0, "length_m": 20.0}
    tables = BASE | {"inlet": {"velocity_m_s": 3.0, "slope_deg": 10.0}}
    alone = chutecalc.solve(chutecalc.parse(tables | {"segments": [rest]}))
    more = chutecalc.solve(chutecalc.parse(tables | {"segments": [rest, {"kind": "fall", "drop_m": 1.0}, rest]}))
    assert alone.status[0] == more.status[0] == "stall"
    assert 0.0 < more.error_estimate[0] == alone.error_estimate[0] < 1e-9
    struck = [rest | {"slope_deg": 10.0, "length_m": 1.0}, {"kind": "fall", "drop_m": 3.0}, rest, rest]
    at_impact = chutecalc.solve(
        chutecalc.parse(tables | {"segments": struck, "liners": {"wall": {"friction_deg": 30}}})
    )
    assert at_impact.status[0] == "stall"
    assert np.isfinite(at_impact.error_estimate[0])
