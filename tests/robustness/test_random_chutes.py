"""Random chutes of everything that a spec can say: each ends with a status, right numbers, and disturbs no other."""

import tomllib
from collections import Counter
from contextlib import suppress
from itertools import islice
from pathlib import Path

import numpy as np
import pytest

import chutecalc
from chutecalc.fields.table import Table
from chutecalc.spec.chute_spec import ChuteSpec, Project
from tests import seeds
from tests.robustness import many
from tests.robustness.chutes import drawn, draws, noting_spec, random_specs
from tests.robustness.faults import check_faults
from tests.robustness.holds import check, check_told, check_variants

FOUND = sorted((Path(__file__).parent / "found").glob("*.toml"))
TOGETHER = 25
"""Chutes of one test."""
MOST_REFUSED = 0.35
"""Of all draws; about 0.24 are."""
RUNS = (0.12, 0.5)
"""Least and largest share of solved chutes that the stream runs through; about 0.27."""
BATCHES = seeds.times(30)


@pytest.mark.parametrize("first", range(0, seeds.times(500), TOGETHER))
def test_every_chute_ends_with_a_status_and_its_numbers(first):
    """So many solved chutes, and as many refused ones as come between them."""
    solved = refused = 0
    for data, solution, error in draws(first):
        with noting_spec(data):
            if solution is None:
                check_faults(error, data)
                refused += 1
            else:
                check(solution)
                if solved % 12 == 0:
                    check_told(chutecalc.parse(data))
                solved += 1
        if solved == TOGETHER:
            return
        assert refused <= 3 * TOGETHER, "most draws are refused: nothing much is tested"


def test_what_is_drawn_is_mostly_solved_and_ends_in_every_way():
    outcomes = Counter(
        "refused" if solution is None else str(solution.status[0]) for _, solution, _ in islice(draws(1), 800)
    )
    assert set(outcomes) == {"refused", "ok", "stall", "choke", "contact_lost", "missed"}
    assert outcomes["refused"] < MOST_REFUSED * outcomes.total()
    solved = outcomes.total() - outcomes["refused"]
    assert RUNS[0] < outcomes["ok"] / solved < RUNS[1]


def test_what_is_drawn_has_every_key_of_every_table():
    """But words, which nothing is worked out from, and `use`, in whose place a library has keys."""
    schema = ChuteSpec.model_json_schema()
    tables = {"ChuteSpec": schema} | schema["$defs"]
    every = {(table, key) for table, described in tables.items() for key in described["properties"]}
    chutes = []
    for data in islice(random_specs(2), 1500):
        with suppress(chutecalc.SpecError):
            chutes.append(chutecalc.parse(data))
    given = {pair for chute in chutes for pair in given_keys(chute.spec)}
    words = {"format", "title", "name", "source", "use", "project", *Project.model_fields}
    assert {key for _, key in every - given} == words
    assert given <= every


def test_variants_over_all_of_what_a_spec_may_say(tmp_path):
    """The same for more than a minute: ``python -m tests.robustness.many``."""
    tally = many.run(seeds.times(3000), 0, tmp_path)
    assert tally.faults == []
    assert tally.outcomes["refused"] < MOST_REFUSED * tally.outcomes.total()


def given_keys(value):
    """Yield every key that a checked spec gives, with the name of its table."""
    if isinstance(value, Table):
        for key in value.model_fields_set:
            yield type(value).__name__, key
            yield from given_keys(getattr(value, key))
    elif isinstance(value, list | dict):
        for item in value.values() if isinstance(value, dict) else value:
            yield from given_keys(item)


@pytest.mark.parametrize("path", FOUND, ids=lambda path: path.stem)
def test_what_random_chutes_have_found_before(path, monkeypatch):
    """The title begins with how the stream has to end, or two endings where the last digit decides.

    Some taper by more than specs may since then.
    """
    monkeypatch.setattr("chutecalc.segments.guide.MOST_TAPER", 1e4)
    data = tomllib.loads(path.read_text(encoding="utf-8"))
    solution = drawn(data).solution
    assert solution.status[0] in data["title"].split(":")[0].split(" or ")
    check(solution)
    check_variants(chutecalc.parse(data))


KEYS = {
    "flow.rate_t_h": (300.0, 3000.0),
    "material.internal_friction_deg": (30.0, 60.0),
    "material.density_kg_m3": (700.0, 2500.0),
}


@pytest.mark.parametrize("number", range(1000, 1000 + BATCHES))
def test_a_design_does_not_depend_on_the_batch_it_is_in(number):
    random = seeds.generator(number, 1)
    values = {key: random.uniform(*limits, 11) for key, limits in KEYS.items()}
    for data, solution, _ in islice(draws(number), TOGETHER):
        if solution is None:
            continue  # reported above
        with noting_spec(data):
            base = chutecalc.parse(data)
            try:
                batch = chutecalc.solve(base.vary(values))
            except chutecalc.SpecError as error:  # a hood that not every one of the streams can fall into
                check_faults(error, data)
                continue
            compare(base, values, batch)
            return
    raise AssertionError("most draws are refused: nothing is tested")


def compare(base, values, batch):
    """A batch, its designs alone, and the same batch turned round."""
    alone = [chutecalc.solve(base.vary({key: column[k] for key, column in values.items()})) for k in range(11)]
    turned = chutecalc.solve(base.vary({key: column[::-1] for key, column in values.items()}))
    assert batch.status.tolist() == [one.status[0] for one in alone] == turned.status.tolist()[::-1]
    for name in ("velocity_m_s", "s_m", "time_s"):
        columns = [segment.exit[name] for segment in batch.segments]
        for number, column in enumerate(columns):
            expected = [one.segments[number].exit[name][0] for one in alone]
            assert np.array_equal(column, expected, equal_nan=True), (name, number)
            assert np.array_equal(turned.segments[number].exit[name][::-1], column, equal_nan=True), (name, number)


def test_a_chute_varied_at_its_own_rate_is_the_same_chute():
    """Its stream meets the steel that it was drawn by: the same outcome, and the same velocity within its error."""
    compared = 0
    for data, solution, _ in islice(draws(78), 200):
        if solution is None:
            continue
        with noting_spec(data):
            own = chutecalc.solve(chutecalc.parse(data).vary({"flow.rate_t_h": [data["flow"]["rate_t_h"]]}))
            assert own.status[0] == solution.status[0]
            assert own.exit_velocity == pytest.approx(solution.exit_velocity, rel=1e-9, nan_ok=True)
            compared += 1
    assert compared > 70


def test_a_choke_of_one_design_is_not_told_of_the_next_that_flies_through():
    """Its fill and depth once were those at which the design before it choked."""
    chute = chutecalc.parse(
        {
            "flow": {"rate_t_h": 50.0},
            "material": {"density_kg_m3": 1500.0, "internal_friction_deg": 33.0},
            "liners": {"wall": {"friction_deg": 30.0}},
            "sections": {"body": {"shape": "box", "width_m": 0.4, "height_m": 0.3}},
            "inlet": {"velocity_m_s": 4.5, "slope_deg": 48.8},
            "segments": [
                {"kind": "straight", "slope_deg": 62.1, "length_m": 0.3},
                {"kind": "curve", "radius_m": 7.8, "to_slope_deg": 17.0},
            ],
            "model": {"steel": "follows_stream"},
        }
    )
    changes = {
        "flow.rate_t_h": [500.0, 50.0],
        "inlet.velocity_m_s": [0.4, 4.5],
        "inlet.slope_deg": [62.1, 48.8],
    }
    both, alone = chutecalc.solve(chute.vary(changes)), chutecalc.solve(chute)
    assert both.status.tolist() == ["choke", "ok"]
    told = [finding.code for finding in both.findings() if finding.mask[1]]
    assert told == [finding.code for finding in alone.findings()]
    assert np.isnan(both.trajectory.segment_solutions[0].contact.bounds[:, 1]).all()
