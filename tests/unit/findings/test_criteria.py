"""What holds for findings of all kinds."""

import pytest

import chutecalc
from chutecalc.results.criterion import criterion
from chutecalc.results.finding import Severity
from tests.conftest import ROOT, chute
from tests.unit.findings.chutes import along, codes, found, rectangular, solved


def test_findings_of_the_papers_worked_example_are_those_that_physics_names():
    def of(name):
        return chutecalc.solve(chutecalc.load(ROOT / f"specs/paper/{name}.toml"))

    for shape in ("square", "chamfered"):
        for delta in (30, 55):
            share = found(of(f"r1_d{delta}_{shape}"), "thick_stream").numbers["share"][0]
            assert 0.13 <= round(share, 2) <= 0.16
    assert found(of("r1_d30_square"), "slow_stream").numbers["froude"][0] == pytest.approx(1.99, abs=0.005)


def test_a_finding_masks_the_designs_it_is_about():
    base = chute(sections=rectangular(0.5), segments=[{"kind": "straight", "slope_deg": 5.0, "length_m": 1.0}])
    solution = chutecalc.solve(base.vary({"inlet.velocity_m_s": [1.0, 8.0, 1.5, 9.0], "inlet.slope_deg": 5.0}))
    stall = found(solution, "stall")
    assert (stall.mask == (solution.status == "stall")).all()
    assert stall.mask.any()
    assert not stall.mask.all()


@pytest.mark.parametrize("walls", [{}, {"wall_height_m": 0.5}])
def test_what_a_stall_or_a_choke_brings_with_it_is_not_told_beside_it(walls):
    """On its way there the stream is above its chamfers, thick, and slow; a design that gets through is told so."""
    base = chute(
        sections={"body": {"shape": "chamfered", "base_m": 0.6, "chamfer_deg": 45.0, "chamfer_m": 0.1, **walls}},
        flow={"rate_t_h": 200.0},
        **along(5.0, length=9.0, velocity=3.0),
    )
    told = {"thick_stream", "slow_stream", "above_chamfer"}
    solution = chutecalc.solve(base)
    assert solution.findings()[0].code == ("choke" if walls else "stall")
    assert told.isdisjoint(codes(solution))
    both = chutecalc.solve(base.vary({"inlet.velocity_m_s": [3.0, 0.5], "segments.1.length_m": [9.0, 0.001]}))
    assert both.status.tolist() == [solution.status[0], "ok"]
    others = {finding.code: finding.mask.tolist() for finding in both.findings() if finding.code in told}
    assert others == {code: [False, True] for code in ("slow_stream", "above_chamfer")}


def test_a_code_is_registered_once():
    with pytest.raises(ValueError, match="the finding 'stall' is registered twice, the second time in tests"):
        criterion("stall", Severity.NOTE, summary="")(lambda scene: [])


@pytest.mark.parametrize(
    ("limits", "source"),
    [({}, "rule of thumb"), ({"max_fill": 0.1}, "set in the spec"), ({"max_closed_fill": 0.1}, "rule of thumb")],
)
def test_a_message_names_the_source_of_the_limit_that_it_quotes(limits, source):
    """In an open section that of an open section, whatever the spec says of closed ones."""
    filled = rectangular(wall_height_m=0.2)  # Q/(v b) = 0.174 m deep at its entry
    finding = found(solved(sections=filled, limits=limits, **along(60.0)), "overfull")
    assert f", {source})" in finding.message()
