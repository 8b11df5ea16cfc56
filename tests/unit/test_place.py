"""Segments placed where the stream strikes them as wanted, or refused where a brute grid finds no place either."""

import re
from pathlib import Path

import numpy as np
import pytest

import chutecalc
from chutecalc.errors import UsageError
from tests.verification.place_cases import HEAD, judge

SPECS = Path(__file__).parents[2] / "specs"


@pytest.mark.parametrize("first", range(0, 600, 100))
def test_random_scenes_are_placed_or_impossible(first):
    outcomes = [judge(seed) for seed in range(first, first + 100)]
    assert not [wrong for _, wrong in outcomes if wrong]
    verdicts = [verdict for verdict, _ in outcomes]
    assert verdicts.count("placed") >= 15  # both occur
    assert verdicts.count("refused") >= 15


def test_several_segments_are_placed_one_after_the_other():
    text = (SPECS / "transfer_90.toml").read_text(encoding="utf-8")
    wishes = {"spoon": {"incidence": 5, "z": -4.5}, "hood": {"incidence": 8, "x": 0.9, "share": 0.2}}
    placement = chutecalc.place(text, wishes)
    assert [each.name for each in placement.segments] == ["hood", "spoon"]
    solution = chutecalc.solve(chutecalc.parse(placement.text))
    for name, incidence in (("hood", 8.0), ("spoon", 5.0)):
        assert solution.segments[name].impact["incidence_deg"][0] == pytest.approx(incidence, abs=1e-9)
    assert [line for line in text.splitlines() if "#" in line and "drop_m" not in line and "run_m" not in line] == [
        line for line in placement.text.splitlines() if "#" in line
    ]


@pytest.mark.parametrize(
    ("wishes", "message"),
    [
        ({}, "takes segments with their wishes"),
        ({"lid": {"incidence": 1}}, "there is no segment lid. Use fall, spoon."),
        ({"fall": {"x": 1}}, "has no surface to be struck"),
        ({"spoon": {}}, "nothing is asked"),
        ({"spoon": {"x": 1, "z": 2}}, "one too many"),
        ({"spoon": {"incidence": 99, "slope": 3}}, "incidence must be a number from 0 to 90, not 99"),
        (
            {"spoon": {"incidence": 5, "share": 1.0}},
            "share must be a number, at least 0 and below 1, or edges",
        ),
        ({"spoon": {"incidence": 5, "z": -2, "share": "edges+1"}}, "share must be edges, or edges+0.05 with a margin"),
        ({"spoon": {"incidence": 5}}, "it has no from_slope_deg: give it, or both incidence and x or z"),
        ({"spoon": {"incidence": 5, "x": 1}}, "the stream falls straight down: the nearest is x 0 m. Give z instead"),
        ({"spoon": {"incidence": 5, "z": 1}}, "its flight begins to fall at z 0 m: that is the nearest"),
    ],
)
def test_what_cannot_be_had_is_said(wishes, message):
    with pytest.raises(UsageError, match=re.escape(message)):
        chutecalc.place(chutecalc.STARTER, wishes)


def test_the_nearest_incidence_can_be_had():
    hood = {"name": "lid", "kind": "hood", "radius_m": 2.0, "to_slope_deg": 50.0}
    data = HEAD | {"inlet": {"velocity_m_s": 3.0, "slope_deg": 0.0}}
    data["segments"] = [{"kind": "fall", "onto_next": True}, hood]
    with pytest.raises(UsageError, match="a hood must steepen; the nearest is an incidence of less than") as refused:
        chutecalc.place(data, {"lid": {"x": 1.0, "incidence": 40.0}})
    nearest = float(re.search(r"less than ([\d.]+)°", str(refused.value))[1])
    slope = np.degrees(np.arctan(9.80665 / 9.0))  # of the stream at x = 1 m: g x / v²
    assert nearest == pytest.approx(50.0 - slope, abs=1e-4)
    chutecalc.place(data, {"lid": {"x": 1.0, "incidence": nearest - 1e-3}})


def test_a_segment_without_a_flight_before_is_refused():
    floor = {"kind": "straight", "slope_deg": 50.0, "length_m": 1.0}
    data = HEAD | {"inlet": {"velocity_m_s": 3.0, "slope_deg": 50.0}, "segments": [floor, floor | {"name": "next"}]}
    with pytest.raises(UsageError, match=r'add .* kind = "fall" and onto_next = true before next'):
        chutecalc.place(data, {"next": {"incidence": 5.0, "x": 2.0}})


def test_a_chute_that_stalls_before_cannot_be_placed_on():
    flat = {"name": "bed", "kind": "straight", "slope_deg": 1.0, "length_m": 50.0}
    data = HEAD | {"inlet": {"velocity_m_s": 1.0, "slope_deg": 1.0}}
    data["segments"] = [flat, {"kind": "fall", "onto_next": True}, flat | {"name": "next"}]
    with pytest.raises(UsageError, match="stall at bed"):
        chutecalc.place(data, {"next": {"incidence": 5.0, "x": 60.0}})


@pytest.mark.parametrize(
    "own", ["start_mm = [900, 300]", "start_ft = [3, 1]", "from_slope_rad = 0.4\nstart_mm = [1, 2]"]
)
def test_a_place_in_other_units_is_replaced(own):
    text = BELT.replace("to_slope_deg = 88\n", f"to_slope_deg = 88\n{own}\n")
    placement = chutecalc.place(text, {"hood": {"incidence": 10, "x_ft": 3.0, "share": 0.1}})
    assert placement.segments[0].strike.x_m == pytest.approx(3.0 * 0.3048, abs=1e-9)
    assert not re.search("start_mm|start_ft|slope_rad", placement.text)


BELT = """\
[flow]
rate_t_h = 1600
[material]
density_kg_m3 = 850
internal_friction_deg = 48
[liners.ceramic]
friction_deg = 25
[sections.hood]
shape = "rectangular"
width_m = 1.0
[inlet.belt]
velocity_m_s = 4.5
pulley_radius_m = 0.5
width_m = 1.2
trough_deg = 35
surcharge_deg = 15
[[segments]]
kind = "fall"
onto_next = true
[[segments]]
name = "hood"
kind = "hood"
radius_m = 2.0
to_slope_deg = 88
[cases.surge]
"flow.rate_t_h" = 1900
[cases.slow_belt]
"inlet.belt.velocity_m_s" = 3.6
"flow.rate_t_h" = 1300
"""


def all_edges_strike(share):
    """Return whether all edges strike a hood, with a share of its length before the strike, in every state."""
    placement = chutecalc.place(BELT, {"hood": {"incidence": 10, "x": 1.0, "share": share}})
    cases = chutecalc.solve_cases(chutecalc.parse(placement.text))
    return not any(edge.misses[0] for solution in cases.solutions.values() for edge in solution.edges)


def test_the_share_for_all_edges_is_the_least_that_lets_them_strike():
    placement = chutecalc.place(BELT, {"hood": {"incidence": 10, "x": 1.0, "share": "edges"}})
    share = placement.segments[0].strike.share
    assert all_edges_strike(share + 1e-9)
    assert not all_edges_strike(share - 1e-3)  # it is found to 1e-3
    assert [*placement.segments[0].strikes] == ["design", "surge", "slow_belt"]
    slow = placement.segments[0].strikes["slow_belt"]
    assert slow.share > share
    assert slow.edges.keys() == {"lower", "upper"}


def test_a_margin_goes_beyond_the_least_share():
    shares = {
        wish: chutecalc.place(BELT, {"hood": {"incidence": 10, "x": 1.0, "share": wish}}).segments[0].strike.share
        for wish in ("edges", "edges+0.05")
    }
    assert shares["edges+0.05"] == pytest.approx(shares["edges"] + 0.05, abs=1e-9)
    with pytest.raises(UsageError, match=r"from a share of .* on, but with the margin it would begin at"):
        chutecalc.place(BELT, {"hood": {"incidence": 10, "x": 1.0, "share": "edges+0.5"}})


def test_edges_that_no_share_can_catch_are_named():
    short = BELT.replace("radius_m = 2.0\n", "radius_m = 0.4\n")
    with pytest.raises(UsageError, match=r"no share lets .* strike it .* its \w+ (edge )?\((design, )?(surge|slow)"):
        chutecalc.place(short, {"hood": {"incidence": 10, "x": 1.0, "share": "edges"}})


def test_what_is_placed_is_solved_in_all_cases():
    placement = chutecalc.place(BELT, {"hood": {"incidence": 10, "x": 1.0, "share": 0.05}})
    assert placement.cases.names == ["design", "surge", "slow_belt"]
    for name, solution in placement.cases.solutions.items():
        struck = placement.segments[0].strikes[name]
        assert struck.incidence_deg == solution.segments["hood"].impact["incidence_deg"][0]


def test_faults_of_cases_and_uncertainty_are_those_of_the_spec():
    wrong = BELT + '[cases.bad]\n"flow.rate_th" = 3\n[uncertainty]\n"flow.rat" = 4\n'
    with pytest.raises(chutecalc.SpecError, match="rate_th") as refused:
        chutecalc.place(wrong, {"hood": {"incidence": 10, "x": 1.0}})
    lines = wrong.splitlines()
    assert [lines[fault.line - 1] for fault in refused.value.faults] == ['"flow.rate_th" = 3', '"flow.rat" = 4']


def test_what_stands_before_is_to_be_placed_first():
    text = BELT.replace(
        "[cases.surge]",
        '[[segments]]\nkind = "fall"\nonto_next = true\n[[segments]]\nname = "spoon"\n'
        'kind = "curve"\nradius_m = 3\nto_slope_deg = 35\n[cases.surge]',
    )
    with pytest.raises(UsageError, match="hood, which stands before spoon, has no place yet"):
        chutecalc.place(text, {"spoon": {"incidence": 20, "z": -4.5}})
    hood = {"hood": {"incidence": 10, "x": 1.0}}
    assert chutecalc.place(text, hood).cases is None
    assert chutecalc.place(text, hood | {"spoon": {"incidence": 20, "z": -4.5}}).cases is not None
