"""Segments placed where the stream strikes them as wanted, or refused where a brute grid finds no place either."""

import re
from pathlib import Path

import numpy as np
import pytest

import chutecalc
from chutecalc.errors import UsageError

HEAD = {
    "flow": {"rate_t_h": 800.0},
    "material": {"density_kg_m3": 850.0, "internal_friction_deg": 45.0},
    "liners": {"wall": {"friction_deg": 22.0}},
    "sections": {"body": {"shape": "rectangular", "width_m": 0.9}},
}
SPECS = Path(__file__).parents[2] / "specs"
SIDES = {"hood": -1.0, "plate": -1.0, "curve": 1.0, "straight": 1.0}
WITHIN = 1e-9
"""Incidence, degrees, and share within which a written spec must do what was asked."""


NEAR = 0.01
"""Distance along the surface within which the grid has a strike where it is wanted, m."""
RESOLVED = 0.1
"""What the grid resolves of an incidence, degrees: a shift by ``NEAR`` turns an arc of 0.5 m by a degree, but with its
start, so that the incidence changes by what the stream turns on that way, and by the spacing of slopes, 0.0005°."""


def scene(random):
    """Return a random spec with a fall and one segment, and a random wish for that."""
    kind = str(random.choice(list(SIDES)))
    table = {"name": "one", "kind": kind}
    if kind in ("hood", "curve"):
        table |= {"radius_m": random.uniform(0.5, 5.0), "to_slope_deg": random.uniform(-20.0, 90.0)}
    else:
        table |= {"length_m": random.uniform(0.3, 3.0), "slope_deg": random.uniform(0.0, 90.0)}
    if kind in ("hood", "curve") and random.random() < 0.5:
        table["from_slope_deg"] = random.uniform(-60.0, min(80.0, table["to_slope_deg"]))
    inlet = {"velocity_m_s": random.uniform(0.5, 6.0), "slope_deg": random.uniform(-40.0, 80.0)}
    wish = {"share": float(random.choice([0.0, random.uniform(0.0, 0.9)]))}
    if random.random() < 0.8:
        wish["incidence"] = random.uniform(0.0, 40.0)
    if "incidence" not in wish or random.random() < 0.7:
        place = "x" if random.random() < 0.5 else "z"
        wish[place] = random.uniform(-0.5, 4.0) * (1.0 if place == "x" else -1.0)
    return HEAD | {"inlet": inlet, "segments": [{"kind": "fall", "onto_next": True}, table]}, wish


def struck(spec):
    """Return how the stream first meets the last segment of a spec: its share, incidence, x and z, or None."""
    solution = chutecalc.solve(chutecalc.parse(spec), 1e-12)
    solved = next(each for each in solution.trajectory.segment_solutions if each.number == 1)
    arrival = solved.contact.arrival
    if not np.isfinite(arrival.share[0]):
        return None
    entry = solved.entry
    return arrival.share[0], np.degrees(arrival.incidence[0]), entry.x[0], entry.z[0]


def missing_slope(table):
    return table["kind"] in ("hood", "curve") and "from_slope_deg" not in table


def grid_misses(data, wish):
    """Return how near the incidence of a wish can be had on a fine grid of starts and slopes, without closed forms.

    A second grid lies about the best of the first.
    """
    table, inlet = data["segments"][1], data["inlet"]
    downward = inlet["velocity_m_s"] * np.sin(np.radians(inlet["slope_deg"]))
    free = "incidence" in wish and ("x" in wish or "z" in wish)
    ends = table.get("to_slope_deg", 90.0)
    low, high = 0.0 if table["kind"] == "straight" else -89.9, ends - 1e-6 if table["kind"] == "hood" else 90.0
    slopes = np.linspace(low, high, 400) if free else np.array([table.get(slope_key(table), np.nan)])
    times = np.linspace(0.0, 4.0, 4001)
    if "x" in wish or "z" in wish:
        forward = inlet["velocity_m_s"] * np.cos(np.radians(inlet["slope_deg"]))
        x, z = forward * times, -downward * times - 0.5 * 9.80665 * times**2
        off = x - wish["x"] if "x" in wish else np.where(downward + 9.80665 * times >= 0.0, wish["z"] - z, np.nan)
        near = np.flatnonzero((off[:-1] <= 0.0) & (off[1:] > 0.0))
        times = times[near] + 1e-3 * off[near] / (off[near] - off[near + 1])
    if not len(times) or high <= low:
        return np.inf
    slope, time, best = tried(data, wish, slopes, times)
    if not best < 5.0:
        return best
    slopes = np.clip(np.linspace(slope - 0.5, slope + 0.5, 2001), low, high) if free else slopes
    times = times if len(times) == 1 else np.maximum(np.linspace(time - 0.002, time + 0.002, 2001), 0.0)
    return tried(data, wish, slopes, times)[2]


def slope_key(table):
    return "from_slope_deg" if table["kind"] in ("hood", "curve") else "slope_deg"


def tried(data, wish, slopes, times):
    """Return the slope and time of the strike, of all combinations, whose incidence is nearest, and how near it is."""
    table, inlet = data["segments"][1], data["inlet"]
    arc, key = table["kind"] in ("hood", "curve"), slope_key(table)
    begins, time = (each.ravel() for each in np.meshgrid(slopes, times))
    forward, downward = (inlet["velocity_m_s"] * f(np.radians(inlet["slope_deg"])) for f in (np.cos, np.sin))
    x, z = forward * time, -downward * time - 0.5 * 9.80665 * time**2
    turn = np.radians(table["to_slope_deg"] - begins) if arc else np.zeros(len(begins))
    length = table["radius_m"] * np.abs(turn) if arc else np.full(len(begins), table["length_m"])
    slope = np.radians(begins) + turn * (wish["share"] * (np.arange(400)[:, None] + 0.5) / 400)  # midpoint rule
    step = length * wish["share"] / 400
    starts = x - (np.cos(slope) * step).sum(axis=0), z + (np.sin(slope) * step).sum(axis=0)
    first = table | {key: min(10.0, table.get("to_slope_deg", 90.0) - 1.0), "start_m": [0.0, 0.0]}
    chute = chutecalc.parse(HEAD | {"inlet": inlet, "segments": [data["segments"][0], first]})
    changes = {"segments.one.start_m.1": starts[0], "segments.one.start_m.2": starts[1], f"segments.one.{key}": begins}
    solution = chutecalc.solve(chute.vary(changes))
    arrival = next(each for each in solution.trajectory.segment_solutions if each.number == 1).contact.arrival
    close = np.abs(arrival.share - wish["share"]) * length < NEAR
    off = np.abs(np.degrees(arrival.incidence) - wish.get("incidence", np.degrees(arrival.incidence)))
    off = np.where(close & np.isfinite(off), off, np.inf)
    return begins[off.argmin()], time[off.argmin()], off.min()


def nearest(data, wish, message):
    """Return how near the incidence of a wish can be had, as a message says; infinite where it is not to be had."""
    table = data["segments"][1]
    if found := re.search(r"the nearest is an incidence of (?:less than |more than )?([\d.]+)°", message):
        return abs(float(found[1]) - wish["incidence"])
    if found := re.search(r"the nearest is a share of ([\d.e-]+)", message):
        longest = table.get("length_m", table.get("radius_m", 0.0) * np.pi)
        return 0.0 if (wish["share"] - float(found[1])) * longest < 2 * NEAR else np.inf
    return np.inf


def check(seed):
    """Return whether a random scene was placed; assert that it does what was asked, or that no grid finds a place."""
    random = np.random.default_rng(seed)
    data, wish = scene(random)
    table = data["segments"][1]
    if missing_slope(table) and not {"incidence"} < wish.keys() - {"share"}:
        return None  # the spec does not tell the slope, and the wish does not either
    try:
        placement = chutecalc.place(data, {"one": wish})
    except UsageError as error:
        return False, data, wish, str(error)
    found = struck(placement.text)
    assert found is not None, seed
    grazing = max(np.radians(found[1]), 1e-4)  # the places are written to 1e-12 m
    assert found[0] == pytest.approx(wish["share"], abs=WITHIN / grazing), seed
    if "incidence" in wish:
        assert found[1] == pytest.approx(wish["incidence"], abs=WITHIN * 180 / np.pi), seed
    for key, value in (("x", found[2]), ("z", found[3])):
        if key in wish:
            assert value == pytest.approx(wish[key], abs=WITHIN / grazing), seed
    return True, data, wish, ""


@pytest.mark.parametrize("first", range(0, 600, 100))
def test_random_scenes_are_placed_or_impossible(first):
    outcomes = []
    for seed in range(first, first + 100):
        if (found := check(seed)) is None:
            continue
        placed, data, wish, message = found
        outcomes.append(placed)
        if not placed:
            assert grid_misses(data, wish) > min(nearest(data, wish, message), 2 * RESOLVED) - RESOLVED, (seed, message)
    assert 15 <= sum(outcomes) <= 85  # both occur


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
