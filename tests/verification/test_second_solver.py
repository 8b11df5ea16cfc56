"""Whole chutes against a second solver that shares nothing with chutecalc but the formulas."""

import copy
from collections import Counter

import pytest

import chutecalc
from tests import seeds
from tests.conftest import spec
from tests.verification.second_cases import case, differences, judge, ours_of, outcome, theirs_of

BLOCK = 100
CHUTES = seeds.times(500)


@pytest.mark.parametrize("first", range(0, CHUTES, BLOCK))
def test_random_chutes(first):
    verdicts = {seed: judge(seed) for seed in range(first, min(first + BLOCK, CHUTES))}
    wrong = {seed: what for seed, (verdict, what) in verdicts.items() if verdict == "wrong"}
    assert not wrong, wrong
    counts = Counter(verdict for verdict, _ in verdicts.values())
    # about one in a thousand creeps for so long that steps run out here, or stops slower than 1 mm/s there
    assert counts["undecided"] <= 2, counts
    assert counts["creep"] + counts["edge"] <= 2, counts


def test_the_random_chutes_reach_every_outcome():
    outcomes = Counter()
    kinds = Counter()
    for seed in range(400):
        data, chute = case(seed)
        outcomes[theirs_of(chute)["status"]] += 1
        kinds.update(segment["kind"] for segment in data["segments"])
    assert set(outcomes) == {"ok", "stall", "choke", "contact_lost", "missed"}
    assert min(outcomes.values()) >= 3, outcomes
    assert set(kinds) == {"straight", "curve", "hood", "plate", "fall"}


@pytest.mark.parametrize("seed", range(0, 300, 6))
def test_the_promise_that_the_comparison_rests_on(seed):
    """chutecalc asked for less or for more is within what it promises: that is where the tolerance comes from."""
    _, chute = case(seed)
    tight = theirs_of(chute, 1e-12)
    for rtol in (1e-6, 1e-8, 1e-10):
        loose = theirs_of(chute, rtol)
        assert outcome(loose) == outcome(tight)
        off = [one for one in differences(loose, tight) if one.off > 10 * rtol]
        assert not off, (rtol, off)


LOCUS = {"yield_locus_kpa": [[0.5, 0.30], [1.0, 0.45], [3.0, 0.9], [8.0, 1.6]]}
BOX = {"body": {"shape": "rectangular", "width_m": 0.5}}
WALLED = {"body": {"shape": "chamfered", "base_m": 0.4, "chamfer_deg": 50.0, "wall_height_m": 0.25}}
PIPE = {"body": {"shape": "circular", "radius_m": 0.3}}


def straight(slope, length, **more):
    return {"kind": "straight", "slope_deg": float(slope), "length_m": float(length), **more}


def arc(first, to, radius, kind="curve", **more):
    return {
        "kind": kind,
        "from_slope_deg": float(first),
        "to_slope_deg": float(to),
        "radius_m": float(radius),
        **more,
    }


def inlet(velocity, slope):
    return {"velocity_m_s": float(velocity), "slope_deg": float(slope)}


# name: (spec, path of the number, low, high)
EDGES = {
    "stall on a straight": (
        {"sections": BOX, "inlet": inlet(1, 27), "segments": [straight(27, 8)]},
        ("inlet", "velocity_m_s"),
        0.2,
        6,
    ),
    "stall in a pipe": (
        {"sections": PIPE, "inlet": inlet(1, 20), "segments": [straight(20, 4)]},
        ("inlet", "velocity_m_s"),
        0.5,
        8,
    ),
    "stall on a locus": (
        {"sections": BOX, "liners": {"wall": LOCUS}, "inlet": inlet(3, 12), "segments": [straight(12, 3)]},
        ("inlet", "velocity_m_s"),
        0.5,
        15,
    ),
    "stall by friction": (
        {"sections": PIPE, "inlet": inlet(4, 90), "segments": [arc(90, 0, 2)]},
        ("liners", "wall", "friction_deg"),
        10,
        50,
    ),
    "choke in a spoon": (
        {"sections": WALLED, "inlet": inlet(4, 60), "segments": [arc(60, 0, 2)]},
        ("inlet", "velocity_m_s"),
        1.5,
        12,
    ),
    "choke by slope": (
        {"sections": WALLED, "inlet": inlet(3, 40), "segments": [straight(40, 1), straight(30, 4)]},
        ("segments", 1, "slope_deg"),
        5,
        39,
    ),
    "contact on a crest": (
        {"inlet": inlet(1, 20), "segments": [arc(20, 35, 2)]},
        ("inlet", "velocity_m_s"),
        0.8,
        4.4,
    ),
    "contact by slope": (
        {"inlet": inlet(3, 20), "segments": [arc(20, 60, 2)]},
        ("segments", 0, "to_slope_deg"),
        22,
        80,
    ),
    "contact under a hood": (
        {"inlet": inlet(4, -30), "segments": [arc(-30, 60, 1.5, "hood")]},
        ("inlet", "velocity_m_s"),
        2,
        9,
    ),
    "an impact that stops": (
        {"inlet": inlet(5, 60), "segments": [straight(10, 0.2)]},
        ("inlet", "slope_deg"),
        40,
        89,
    ),
    "an impact that stops on a locus": (
        {"liners": {"wall": LOCUS}, "sections": BOX, "inlet": inlet(5, 60), "segments": [straight(10, 0.2)]},
        ("inlet", "slope_deg"),
        40,
        89,
    ),
    "past the end of a straight": (
        {"inlet": inlet(3, 0), "segments": [straight(45, 1.5)]},
        ("inlet", "velocity_m_s"),
        0.5,
        9,
    ),
    "past the end of an arc": (
        {"inlet": inlet(3, 5), "segments": [arc(70, 50, 4), arc(50, 20, 4)]},
        ("inlet", "velocity_m_s"),
        1,
        9,
    ),
    "a rising crest met at a tangent": (
        {"inlet": inlet(4, -30), "segments": [arc(-30, 10, 1.2)]},
        ("inlet", "velocity_m_s"),
        3.2,
        5,
    ),
    "a hood grazed by a flight": (
        {
            "inlet": inlet(5, -40),
            "segments": [
                {"kind": "fall", "onto_next": True},
                arc(-20, 60, 1, "hood", start_m=[0.9, 0.6]),
            ],
        },
        ("inlet", "velocity_m_s"),
        3.5,
        5.6,
    ),
    "too far for a fall": (
        {"inlet": inlet(4, 80), "segments": [{"kind": "fall", "run_m": 1.0}]},
        ("inlet", "slope_deg"),
        80,
        89.99999,
    ),
    "short of the next": (
        {
            "inlet": inlet(3, 30),
            "segments": [{"kind": "fall", "onto_next": True}, straight(40, 2, start_m=[1.0, -1.0])],
        },
        ("inlet", "velocity_m_s"),
        0.5,
        5,
    ),
    "choke where a section narrows": (
        {
            "sections": WALLED | {"narrow": WALLED["body"] | {"base_m": 0.1}},
            "inlet": inlet(3, 35),
            "segments": [straight(35, 3, section=["body", "narrow"])],
        },
        ("inlet", "velocity_m_s"),
        1.8,
        8,
    ),
}


def put(data, path, value):
    changed = copy.deepcopy(data)
    table = changed
    for key in path[:-1]:
        table = table[key]
    table[path[-1]] = value
    return changed


@pytest.mark.parametrize("name", EDGES)
def test_edges_are_where_the_second_solver_has_them(name):
    """Between two chutes of different outcome, this solver's edge; chutecalc must have it within 1e-9."""
    tables, path, low, high = EDGES[name]
    data = spec(**{key: value for key, value in tables.items() if key != "inlet"})
    data["inlet"] = tables["inlet"]

    def here(value):
        return outcome(ours_of(put(data, path, value)))

    def there(value):
        return outcome(theirs_of(chutecalc.parse(put(data, path, value))))

    below, above = here(low), here(high)
    assert below != above
    while high - low > 2e-13 * high:
        middle = (low + high) / 2
        if here(middle) == below:
            low = middle
        else:
            high = middle
            above = here(middle)
    for share in (1e-6, 1e-9):
        assert there(low * (1 - share)) == below, share
        assert there(high * (1 + share)) == above, share
