"""Random tapers with a top: errors within their estimates, and no design's digits another one's business."""

import numpy as np
import pytest

import chutecalc
from chutecalc.design import Status
from chutecalc.solver.chain import run_chain
from tests import seeds

COUNT = seeds.times(24)
ROUNDING = 1e-12
"""Of a velocity, relative: events that divide the segment are found within 1e-13 of their margin."""
SECTIONS = {
    "chamfered": {"shape": "chamfered", "base_m": 0.9, "chamfer_deg": 35.0, "chamfer_m": 0.15},
    "rectangular": {"shape": "rectangular", "width_m": 1.0},
    "circular": {"shape": "circular", "radius_m": 0.6},
}
ARC = {"kind": "curve", "radius_m": 3.0, "from_slope_deg": 20.0, "to_slope_deg": 50.0, "section": ["body", "end"]}


def tapers(shape, kind, seed=3):
    """Return a tapered crest or spoon, and changes that make many of it."""
    random = seeds.generator(seed, len(shape), kind == "crest")
    end = random.uniform(-10.0, 55.0, COUNT)
    start = end - random.uniform(1.0, 30.0, COUNT) if kind == "crest" else end + random.uniform(0.1, 1.0, COUNT) * 30.0
    own = {
        "chamfered": {"base_m": (0.05, 2.0), "chamfer_deg": (5.0, 85.0)},
        "rectangular": {"width_m": (0.1, 2.0)},
        "circular": {"radius_m": (0.1, 1.5)},
    }[shape]
    spec = {
        "flow": {"rate_t_h": 1000.0},
        "material": {"density_kg_m3": 1500.0, "internal_friction_deg": 50.0},
        "liners": {"wall": {"friction_deg": 20.0}},
        "sections": {"body": SECTIONS[shape], "end": dict(SECTIONS[shape])},
        "inlet": {"velocity_m_s": 3.0, "slope_deg": 20.0},
        "segments": [ARC],
    }
    changes = {
        "flow.rate_t_h": np.exp(random.uniform(np.log(20.0), np.log(4000.0), COUNT)),
        "inlet.velocity_m_s": np.exp(random.uniform(np.log(0.3), np.log(15.0), COUNT)),
        "liners.wall.friction_deg": random.uniform(2.0, 45.0, COUNT),
        "inlet.slope_deg": start,
        "segments.1.from_slope_deg": start,
        "segments.1.to_slope_deg": end,
        "segments.1.radius_m": np.exp(random.uniform(np.log(0.5), np.log(10.0), COUNT)),
    }
    changes |= {
        f"sections.{end}.{key}": random.uniform(*ends, COUNT) for end in ("body", "end") for key, ends in own.items()
    }
    return chutecalc.parse(spec), changes


def first_segment(design, rtol, complete=True):
    segment_solutions, _ = run_chain(design, rtol, complete)
    return segment_solutions[0]


@pytest.mark.parametrize("kind", ["crest", "spoon"])
@pytest.mark.parametrize("shape", list(SECTIONS))
def test_errors_along_a_taper_are_within_their_estimates(shape, kind):
    base, changes = tapers(shape, kind)
    design = base.vary(changes).design
    known = first_segment(design, 1e-13)
    right = known.exit
    for rtol in (1e-6, 1e-10):
        for complete in (False, True):
            solved = first_segment(design, rtol, complete)
            end = solved.exit
            assert (solved.status == known.status).all()
            ran = solved.status == Status.OK
            off = np.abs(end.velocity[ran] / right.velocity[ran] - 1.0)
            assert (off <= end.error[ran] + right.error[ran] + ROUNDING).all(), (shape, kind, rtol, complete)


@pytest.mark.parametrize("rtol", [1e-4, 1e-6, 1e-8])
def test_a_pipe_that_narrows_until_the_stream_nearly_fills_it_tells_its_error(rtol):
    """Beyond its end a full circle would flow, where depth has a branch point: what the estimate has to see coming."""
    narrow = chutecalc.parse(
        {
            "flow": {"rate_t_h": 1390.0},
            "material": {"density_kg_m3": 1500.0, "internal_friction_deg": 50.0},
            "liners": {"wall": {"friction_deg": 42.2}},
            "sections": {name: {"shape": "circular", "radius_m": r} for name, r in (("body", 1.45), ("end", 0.167))},
            "inlet": {"velocity_m_s": 7.25, "slope_deg": -1.98},
            "segments": [ARC | {"radius_m": 9.01, "from_slope_deg": -1.98, "to_slope_deg": 18.5}],
        }
    ).design
    right, end = (first_segment(narrow, tolerance, complete=False).exit for tolerance in (1e-13, rtol))
    assert abs(end.velocity[0] / right.velocity[0] - 1.0) <= end.error[0] + right.error[0] + ROUNDING


@pytest.mark.parametrize("kind", ["crest", "spoon"])
@pytest.mark.parametrize("shape", list(SECTIONS))
def test_digits_along_a_taper_do_not_depend_on_the_batch(shape, kind):
    base, changes = tapers(shape, kind)
    together = first_segment(base.vary(changes).design, 1e-12)
    for k in range(COUNT):
        one = base.vary({path: values[k : k + 1] for path, values in changes.items()})
        alone = first_segment(one.design, 1e-12)
        assert np.array_equal(alone.exit.velocity, together.exit.velocity[k : k + 1], equal_nan=True), k
        assert alone.status[0] == together.status[k]


def test_a_stream_that_creeps_along_a_taper_counts_as_stalled_alone_as_in_company():
    """A vee with adhesion: the deeper the stream, the less its walls hold it, and it never quite stops."""
    random = np.random.default_rng(3)
    base = chutecalc.parse(
        {
            "flow": {"rate_t_h": 1537.0},
            "material": {"density_kg_m3": 1500.0, "internal_friction_deg": 50.0},
            "liners": {"wall": {"yield_locus_kpa": [[1.0, 3.4], [6.0, 5.4]]}},
            "sections": {name: {"shape": "vee", "chamfer_deg": 46.0} for name in ("body", "end")},
            "inlet": {"velocity_m_s": 2.27, "slope_deg": 33.0},
            "segments": [ARC | {"radius_m": 9.3, "from_slope_deg": 33.0, "to_slope_deg": 8.5}],
        }
    )
    changes = {f"sections.{end}.chamfer_deg": random.uniform(45.0, 48.0, 3) for end in ("body", "end")}
    together = first_segment(base.vary(changes).design, 1e-10)
    creeping = 0
    for k in range(3):
        alone = first_segment(base.vary({path: values[k : k + 1] for path, values in changes.items()}).design, 1e-10)
        assert alone.status[0] == together.status[k] == Status.STALL, k
        assert np.array_equal(alone.exit.velocity, together.exit.velocity[k : k + 1]), k
        creeping += 0.0 < alone.exit.velocity[0] < 1e-3
    assert creeping


def test_digits_of_a_struck_pipe_do_not_depend_on_the_batch():
    """Its depth is a series, summed in the same order for one design as for many."""
    random, count = np.random.default_rng(4), 200
    base = chutecalc.parse(
        {
            "flow": {"rate_t_h": 900.0},
            "material": {"density_kg_m3": 800.0, "internal_friction_deg": 45.0},
            "liners": {"wall": {"friction_deg": 20.0}},
            "sections": {"body": {"shape": "circular", "radius_m": 0.6}, "end": {"shape": "circular", "radius_m": 0.3}},
            "inlet": {"velocity_m_s": 4.0, "slope_deg": 60.0},
            "segments": [{"kind": "straight", "slope_deg": 45.0, "length_m": 2.0, "section": ["body", "end"]}],
        }
    )
    changes = {
        "inlet.velocity_m_s": random.uniform(2.0, 6.0, count),
        "inlet.slope_deg": random.uniform(50.0, 75.0, count),
        "flow.rate_t_h": random.uniform(200.0, 1200.0, count),
    }
    together = chutecalc.solve(base.vary(changes))
    depth = together.segments[0].entry["depth_m"]
    for k in range(count):
        alone = chutecalc.solve(base.vary({path: values[k : k + 1] for path, values in changes.items()}))
        assert alone.exit_velocity[0] == together.exit_velocity[k], k
        assert alone.segments[0].entry["depth_m"][0] == depth[k], k


def test_a_panel_in_r_that_is_cut_tells_the_error_of_its_part():
    """From near rest in a pipe that narrows: the panel along which it gains speed ends at the crown of the arc."""
    body = {"shape": "circular", "radius_m": 0.26853717228150786}
    narrows = {
        "kind": "curve",
        "radius_m": 9.862475066817206,
        "to_slope_deg": 30.0,
        "section": ["body", "other"],
    }
    base = chutecalc.parse(
        {
            "format": 1,
            "flow": {"rate_t_h": 12.92926423323508},
            "material": {"density_kg_m3": 800.0, "internal_friction_deg": 50.0},
            "liners": {"wall": {"friction_deg": 20.0}},
            "sections": {"body": body, "other": {**body, "radius_m": 0.18884798702853697}},
            "inlet": {"velocity_m_s": 0.0010543221262226472, "slope_deg": 60.0},
            "segments": [narrows],
        }
    )
    right = chutecalc.exits(base, 1e-13).exit["velocity_m_s"][0]
    for rtol in (1e-3, 1e-5, 1e-7, 1e-9):
        ends = chutecalc.exits(base, rtol)
        off = abs(ends.exit["velocity_m_s"][0] / right - 1.0)
        assert off <= ends.error_estimate[0] + 1e-14  # rounding of both
