"""What the operating states of a chute have to tell beside its design point, and which of them is worst in what."""

import numpy as np
import pytest

import chutecalc
from chutecalc.cli import main
from tests.conftest import ROOT, chute

LIMIT = 20.0
"""Incidence, deg, above which an impact is steep."""


def states(**incidences):
    """Return a chute that strikes a floor at an incidence at its design point, and at others in its cases.

    The inlet velocity decides: a stream that falls 1 m strikes at the angle between its trajectory and the floor.
    """
    drop, floor, forward = 1.0, np.radians(30.0), 2.0
    cases, gravity = {}, {}
    for name, incidence in incidences.items():
        # the gravity with which a level throw at 2 m/s falls 1 m to this slope: tan a = √(2 g h)/v
        slope = floor + np.radians(incidence)
        gravity[name] = float((forward * np.tan(slope)) ** 2 / (2.0 * drop))
        cases[name] = {"flow.gravity_m_s2": gravity[name]}
    design = cases.pop("design")["flow.gravity_m_s2"]
    segments = [
        {"kind": "fall", "drop_m": drop},
        {"kind": "straight", "name": "floor", "slope_deg": 30.0, "length_m": 1.0},
    ]
    base = chute(
        flow={"rate_t_h": 1000.0, "gravity_m_s2": design},
        inlet={"velocity_m_s": forward, "slope_deg": 0.0},
        model={"steel": "follows_stream"},
        segments=segments,
    )
    return chutecalc.solve_cases(chutecalc.parse(base.data | {"cases": cases}))


def told(cases, code="steep_impact"):
    return {name: [each for each in cases.findings(name) if each.code == code] for name in cases.names}


def test_a_finding_is_told_again_by_the_case_in_which_it_is_worst():
    found = told(states(design=21.0, one=22.0, two=25.0, three=20.5, mild=19.0))
    assert [name for name, each in found.items() if each] == ["two"]
    assert found["two"][0].numbers["incidence_deg"][0] == pytest.approx(25.0, rel=1e-12)
    cases = states(design=21.0, one=22.0, two=25.0, mild=19.0)
    assert cases.states_with(told(cases)["two"][0]) == ["design", "one", "two"]


def test_a_finding_that_is_worst_at_the_design_point_is_not_told_again():
    assert not any(told(states(design=25.0, one=22.0, two=24.9)).values())


def test_a_finding_that_differs_by_rounding_alone_is_not_told_again():
    cases = states(design=22.0, one=22.0 * (1.0 + 1e-12))
    assert not told(cases)["one"]
    assert told(states(design=22.0, one=22.0 * (1.0 + 1e-5)))["one"]


def test_a_finding_that_the_design_point_does_not_have_is_told_once():
    found = told(states(design=19.0, one=22.0, two=24.0))
    assert [name for name, each in found.items() if each] == ["two"]


def test_in_a_batch_each_design_has_its_own_worst_case():
    base = chutecalc.load(ROOT / "specs" / "transfer_90.toml")
    cases = chutecalc.solve_cases(base.vary({"limits.max_depth_over_radius": [0.12, 0.5, 0.13]}))
    (thick,) = told(cases, "thick_stream")["surge"]  # 0.1346 of the radius
    assert thick.mask.tolist() == [True, False, True]
    assert cases.states_with(thick, design=1) == []
    with pytest.raises(KeyError, match="there is no case 'moist'"):
        cases.findings("moist")


def test_each_case_tells_its_own_failure():
    text = (ROOT / "specs" / "rock_box_slow_belt.toml").read_text("utf-8")
    cases = chutecalc.solve_cases(chutecalc.parse(text + '\n[cases.slower]\n"inlet.belt.velocity_m_s" = 1.5\n'))
    assert [len(told(cases, "missed")[name]) for name in cases.names] == [0, 1, 1]


def test_the_lines_below_the_table_of_cases(capsys):
    assert main(["run", str(ROOT / "specs" / "transfer_90.toml")]) == 0
    lines = capsys.readouterr().out.splitlines()
    below = [line for line in lines[lines.index("cases, on the same steel") :] if line.startswith("warning ")]
    (thick,) = [line for line in below if line.startswith("warning thick_stream  surge: hood: ")]
    assert thick.endswith(" (worse than at the design point; also in dry, wet)")
    (new,) = [line for line in below if line.startswith("warning missing_load  surge: spoon: ")]
    assert new.endswith(" (also in wet)")
    (alone,) = [line for line in below if line.startswith("warning below_cut_off  wet: spoon: ")]
    assert alone.endswith("rule of thumb)")
    assert len({line.split(":")[0] for line in below}) == len(below)


def test_impacts_count_among_the_pressures_and_the_wear():
    cases = chutecalc.solve_cases(chutecalc.load(ROOT / "specs" / "transfer_90.toml"))
    for name, number in (("max_impact_pressure_kpa", "pressure_kpa"), ("max_impact_wear_w_m2", "wear_w_m2")):
        for k, state in enumerate(cases.names):
            struck = [segment.impact[number][0] for segment in cases[state].segments if segment.impact]
            assert cases.numbers[name][k, 0] == max(struck)
        assert cases.worst[name][0] == cases.names[cases.numbers[name][:, 0].argmax()]


def test_the_life_of_liners_counts_impacts():
    liner = {"thickness_mm": 20.0, "wear_mm3_per_j": 1e-4, "friction_deg": 25.0}
    segments = [
        {"kind": "fall", "drop_m": 3.0},
        {"kind": "straight", "name": "floor", "slope_deg": 60.0, "length_m": 1.0},
    ]
    base = chute(inlet={"velocity_m_s": 0.0, "slope_deg": 90.0}, liners={"steel": liner}, segments=segments)
    cases = chutecalc.solve_cases(chutecalc.parse(base.data | {"cases": {"half": {"flow.rate_t_h": 500.0}}}))
    loads = cases["half"].segments["floor"].loads
    assert loads["impact_life_h"][0] < loads["sliding_life_h"][0]
    assert cases.numbers["min_liner_life_h"][1, 0] == loads["impact_life_h"][0]
