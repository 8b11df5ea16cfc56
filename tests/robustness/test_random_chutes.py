"""Random chutes of everything that a spec can say: each ends with a status, right numbers, and disturbs no other."""

import tomllib
from collections import Counter
from itertools import chain, islice
from pathlib import Path

import numpy as np
import pytest

import chutecalc
from chutecalc.fields.table import Table
from chutecalc.spec.chute_spec import ChuteSpec, Project
from tests import seeds
from tests.robustness.chutes import MAKERS, ClosedMaker, Maker, drawn, draws, noting_spec
from tests.robustness.faults import check_faults

FOUND = sorted((Path(__file__).parent / "found").glob("*.toml"))
TOGETHER = 25
"""Chutes of one test."""
MOST_REFUSED = 0.35
"""Of all draws; about 0.18 are."""
RUNS = (0.12, 0.5)
"""Least and largest share of solved chutes that the stream runs through; about 0.28."""
BATCHES = seeds.times(20)


@pytest.mark.parametrize("maker", MAKERS)
@pytest.mark.parametrize("first", range(0, seeds.times(200), TOGETHER))
def test_every_chute_ends_with_a_status_and_its_numbers(first, maker):
    """So many solved chutes, and as many refused ones as come between them."""
    solved = refused = 0
    for data, solution, error in draws(first, maker=maker):
        with noting_spec(data):
            if solution is None:
                check_faults(error, data)
                refused += 1
            else:
                check(solution)
                solved += 1
        if solved == TOGETHER:
            return
        assert refused <= 3 * TOGETHER, "most draws are refused: nothing much is tested"


def test_what_is_drawn_is_mostly_solved_and_ends_in_every_way():
    outcomes = Counter(
        "refused" if solution is None else str(solution.status[0]) for _, solution, _ in islice(draws(1), 500)
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
    drawn_ones = chain.from_iterable(islice(draws(2, maker=maker), 400) for maker in MAKERS)
    chutes = (data for data, solution, _ in drawn_ones if solution is not None)
    given = {pair for data in chutes for pair in given_keys(ChuteSpec.model_validate(data))}
    words = {"format", "title", "name", "source", "use", "project", *Project.model_fields}
    assert {key for _, key in every - given} == words
    assert given <= every


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
def test_what_random_chutes_have_found_before(path):
    """The title begins with how the stream has to end, or two endings where the last digit decides."""
    data = tomllib.loads(path.read_text(encoding="utf-8"))
    solution = drawn(data).solution
    assert solution.status[0] in data["title"].split(":")[0].split(" or ")
    check(solution)


def check(solution):
    """What holds of every solved chute."""
    status = solution.status[0]
    assert np.isfinite(solution.exit_velocity[0]) == (status == "ok")
    failures = [finding.code for finding in solution.findings() if finding.severity == "failure"]
    codes = {"ok": [[]], "missed": [["missed"], ["passed_by"], ["contact_lost", "missed"]]}
    assert failures in codes.get(status, [[status]])
    for finding in solution.findings():
        assert "nan" not in finding.message()
    table = solution.stations(points=7)
    reached = np.isfinite(table["s_m"][0])
    if not reached.any():  # flew off at the inlet, through pipes, or past all onto its belt
        passed = [segment.status[0] == "passed" for segment in solution.segments if segment.kind != "fall"]
        assert status in ("missed", "choke") or (status == "ok" and all(passed))
        return
    velocity, s, z = (table[name][0][reached] for name in ("velocity_m_s", "s_m", "z_m"))
    assert np.isfinite(velocity).all()
    assert (velocity >= 0.0).all()
    assert (np.diff(s) >= -1e-9 * max(1.0, s[-1])).all()
    assert not (table["depth_m"][0] < 0.0).any()
    assert not (table["pressure_kpa"][0] < 0.0).any()
    if solution.design.longitudinal_ratio[0] > 0.0:  # pressure along the stream drives it too
        return
    energy = (
        0.5 * velocity**2 + solution.design.gravity[0] * z
    )  # nothing but gravity drives; rounding is of v², not of the sum
    assert (np.diff(energy) <= 1e-9 * (1.0 + 0.5 * (velocity[:-1] ** 2 + velocity[1:] ** 2))).all()


KEYS = {
    "flow.rate_t_h": (300.0, 3000.0),
    "material.internal_friction_deg": (30.0, 60.0),
    "material.density_kg_m3": (700.0, 2500.0),
}


@pytest.mark.parametrize("maker", [Maker, ClosedMaker])
@pytest.mark.parametrize("number", range(1000, 1000 + BATCHES))
def test_a_design_does_not_depend_on_the_batch_it_is_in(number, maker):
    random = seeds.generator(number, 1)
    values = {key: random.uniform(*limits, 11) for key, limits in KEYS.items()}
    for data, solution, _ in islice(draws(number, maker=maker), TOGETHER):
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


@pytest.mark.parametrize("maker", MAKERS, ids=lambda maker: maker.__name__)
def test_a_chute_varied_at_its_own_rate_is_the_same_chute(maker):
    """Its stream meets the steel that it was drawn by: the same outcome, and the same velocity within its error."""
    compared = 0
    for data, solution, _ in islice(draws(78, maker=maker), 60):
        if solution is None:
            continue
        with noting_spec(data):
            own = chutecalc.solve(chutecalc.parse(data).vary({"flow.rate_t_h": [data["flow"]["rate_t_h"]]}))
            assert own.status[0] == solution.status[0]
            assert own.exit_velocity == pytest.approx(solution.exit_velocity, rel=1e-9, nan_ok=True)
            compared += 1
    assert compared > 20
