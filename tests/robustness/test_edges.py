"""Random single segments up to the edges of what a spec may say, against a slow solver in 80-bit numbers.

Five of each of 24 kinds by default; ``CHUTECALC_STRESS=200 pytest tests/robustness/test_edges.py`` takes so many.
"""

import warnings

import numpy as np
import pytest

import chutecalc
from chutecalc.design import Status
from chutecalc.solver.chain import run_chain
from tests import seeds
from tests.robustness import extrapolation
from tests.robustness.extrapolation import Flow

COUNT = seeds.stress()
TOLERANCES = (1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13)
ROUNDING = 2e-13
"""Of a velocity, relative: what doubles leave of streams that start or end next to rest or cling to a balance."""
KINDS = ("spoon", "crest", "hood", "straight")
SHAPES = ("chamfered", "vee", "rectangular")

pytestmark = pytest.mark.skipif(
    np.finfo(np.longdouble).nmant < 63, reason="the slow solver needs 80-bit numbers, which this machine does not have"
)


def between(random, low, high, count):
    """Evenly in the logarithm."""
    return np.exp(random.uniform(np.log(low), np.log(high), count))


def mixed(random, count, share, one, other):
    """Return the one in a share of the designs, the other in the rest."""
    return np.where(random.random(count) < share, one, other)


def batch(kind, shape, law, count, seed):
    """Random variants of one segment, and the same for the slow solver."""
    random = seeds.generator(seed, KINDS.index(kind), SHAPES.index(shape), law == "equilibrium")
    n = count
    beta = mixed(random, n, 0.2, between(random, 0.1, 1.0, n), random.uniform(1.0, 90.0, n))
    beta = mixed(random, n, 0.1, 90.0, beta) if shape == "chamfered" else np.minimum(beta, 89.0)
    base = mixed(random, n, 0.1, 1e-3, between(random, 0.05, 3.0, n)) if shape != "vee" else np.zeros(n)
    delta, phi = random.uniform(0.0, 89.0, n), random.uniform(0.0, 60.0, n)
    rate = mixed(random, n, 0.3, between(random, 1e-3, 5e4, n), between(random, 10.0, 5e3, n))
    velocity = mixed(random, n, 0.3, between(random, 1e-3, 100.0, n), between(random, 0.3, 20.0, n))
    room = 9e3 if shape == "vee" else 90.0 * base  # of a stream that enters no deeper and no larger than is taken
    rate = np.minimum(rate, 3600.0 * velocity * room)
    radius = mixed(random, n, 0.3, between(random, 0.05, 500.0, n), between(random, 0.5, 10.0, n))
    end = random.uniform(-20.0, 60.0, n)
    start = {
        "spoon": end + random.uniform(0.02, 1.0, n) * (90.0 - end),
        "crest": end - random.uniform(1.0, 30.0, n),
        "hood": end - random.uniform(1.0, 60.0, n),
        "straight": random.uniform(0.01, 90.0, n),
    }[kind]
    end = start if kind == "straight" else end
    sections = {
        "chamfered": {"shape": "chamfered", "base_m": 0.5, "chamfer_deg": 45.0},
        "vee": {"shape": "vee", "chamfer_deg": 45.0},
        "rectangular": {"shape": "rectangular", "width_m": 0.5},
    }
    arc = {"kind": "hood" if kind == "hood" else "curve", "radius_m": 3.0, "from_slope_deg": 30.0, "to_slope_deg": 60.0}
    segment = arc if kind != "straight" else {"kind": "straight", "slope_deg": 40.0, "length_m": 3.0}
    changes = {
        "flow.rate_t_h": rate,
        "material.internal_friction_deg": delta,
        "liners.wall.friction_deg": phi,
        "inlet.velocity_m_s": velocity,
        "inlet.slope_deg": start,
    }
    changes |= {"chamfered": {"sections.body.base_m": base}, "rectangular": {"sections.body.width_m": base}}.get(
        shape, {}
    )
    changes |= {} if shape == "rectangular" else {"sections.body.chamfer_deg": beta}
    if kind == "straight":
        changes |= {"segments.1.slope_deg": start, "segments.1.length_m": radius}
    else:
        changes |= {"segments.1.radius_m": radius, "segments.1.from_slope_deg": start, "segments.1.to_slope_deg": end}
    chute = chutecalc.parse(
        {
            "model": {"friction_law": law},
            "flow": {"rate_t_h": 1000.0},
            "material": {"density_kg_m3": 1000.0, "internal_friction_deg": 40.0},
            "liners": {"wall": {"friction_deg": 20.0}},
            "sections": {"body": sections[shape]},
            "inlet": {"velocity_m_s": 3.0, "slope_deg": 30.0},
            "segments": [segment],
        }
    ).vary(changes)
    slope, turn = np.radians(start), np.radians(end) - np.radians(start)
    one = np.ones(n)
    flow = Flow(
        gravity=chute.design.gravity * one,
        side=(-1.0 if kind == "hood" else 1.0) * one,
        slope=slope,
        turn=turn,
        length=radius if kind == "straight" else radius * np.abs(turn),
        rate=chute.design.volume_rate * one,
        base=base,
        chamfer=np.pi / 2 * one if shape == "rectangular" else np.radians(beta),
        sine=np.sin(np.radians(delta)),
        friction=np.tan(np.radians(phi)),
        equilibrium=one * (law == "equilibrium"),
        velocity=velocity,
    )
    return chute, flow


CASES = [(kind, shape, law) for kind in KINDS for shape in SHAPES for law in ("paper", "equilibrium")]


def test_edges_against_the_slow_solver():
    """One test, for the slow solver's sake: all cases in one batch cost little more than one."""
    batches = {case: batch(*case, COUNT, 0) for case in CASES}
    flows = [flow for _, flow in batches.values()]
    solved = extrapolation.solve(Flow(*map(np.concatenate, zip(*flows, strict=True))))
    for number, (case, (chute, flow)) in enumerate(batches.items()):
        slowly = solved.some(slice(number * COUNT, (number + 1) * COUNT))
        for rtol in TOLERANCES:
            for complete in (False, True):
                compare(chute, flow, slowly, rtol, complete, case)
    known = solved.status >= 0  # the slow solver gives up on streams that cling to a balance: too stiff for it
    assert known.mean() > 0.75
    assert {Status.OK, Status.STALL, Status.CONTACT_LOST} <= set(solved.status.tolist())


def compare(chute, flow, slowly, rtol, complete, case):
    """Outcome, velocity and position of a stall, against those of the slow solver."""
    status, velocity = slowly.status, slowly.velocity.astype(float)
    known = status >= 0
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        segment_solutions, _ = run_chain(chute.design, rtol, complete)
    end = segment_solutions[0].exit  # of a hood that is struck again: the first time
    slips_off = (flow.side < 0) & (status == Status.CONTACT_LOST) & (slowly.share == 0)  # a hood that deflects nothing
    found = np.broadcast_to(segment_solutions[0].status, COUNT)
    agrees = (found == status) | slips_off & (found == Status.MISSED)
    assert agrees[known].all(), (np.flatnonzero(known & ~agrees), case, rtol, complete)
    with np.errstate(invalid="ignore"):
        faster = end.velocity / velocity - 1.0
    farther = end.distance / flow.length - slowly.share.astype(float)
    judge(faster, end.error, known & (status == Status.OK), (case, rtol, complete))
    judge(farther, end.error, known & (status == Status.STALL), (case, rtol, complete))


def judge(off, estimate, chosen, what):
    """No error beyond its estimate, in the designs chosen."""
    rows = np.flatnonzero(chosen)
    bad = rows[~(np.abs(off[rows]) <= estimate[rows] + ROUNDING)]
    assert not bad.size, (bad, off[bad], estimate[bad], what)


@pytest.mark.parametrize(("kind", "shape", "law"), CASES)
def test_more_wall_friction_is_never_faster(kind, shape, law):
    chute, _ = batch(kind, shape, law, 4 * COUNT, 1)
    friction = np.degrees(np.arctan(chute.design.segments[0].wall.slopes[0]))

    def ends(more):
        _, ended = run_chain(
            chute.vary({"liners.wall.friction_deg": friction * more}).design, 1e-10, dense_output=False
        )
        return ended

    slow, fast = ends(1.0 + 1e-6), ends(1.0)
    went = (slow.status == Status.OK) & (fast.status == Status.OK)
    worth = slow.error + fast.error + ROUNDING
    assert (slow.velocity <= fast.velocity * (1.0 + worth))[went].all()
    if kind in {"spoon", "straight"}:  # a crest may be left by the faster stream alone
        assert not ((slow.status == Status.OK) & (fast.status == Status.STALL)).any()
