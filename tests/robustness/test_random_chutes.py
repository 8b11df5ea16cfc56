"""Random chutes of everything that a spec can say: each ends with a status, right numbers, and disturbs no other."""

import numpy as np
import pytest

import chutecalc
from tests.robustness.chutes import random_chute


def solved(data):
    """The solution, or None where the spec is at fault."""
    try:
        return chutecalc.solve(chutecalc.parse(data))
    except chutecalc.SpecError:
        return None


@pytest.mark.parametrize("first", range(0, 200, 25))
def test_every_chute_ends_with_a_status_and_its_numbers(first):
    for seed in range(first, first + 25):
        data = random_chute(seed)
        solution = solved(data)
        if solution is not None:
            check(solution, seed)


@pytest.mark.parametrize("seed", [100561, 100664, 305556, 404915])
def test_streams_that_stop_or_choke_within_the_last_digit_of_a_place(seed):
    check(solved(random_chute(seed)), seed)


def check(solution, seed):
    status = solution.status[0]
    assert np.isfinite(solution.exit_velocity[0]) == (status == "ok"), seed
    failures = [finding.code for finding in solution.findings() if finding.severity == "failure"]
    assert failures == ([] if status == "ok" else [status]), seed
    for finding in solution.findings():
        assert "nan" not in finding.message(), seed
    table = solution.stations(points=7)
    reached = np.isfinite(table["s_m"][0])
    if not reached.any():  # flew off at the inlet
        assert status == "missed", seed
        return
    velocity, s, z = (table[name][0][reached] for name in ("velocity_m_s", "s_m", "z_m"))
    assert np.isfinite(velocity).all(), seed
    assert (velocity >= 0.0).all(), seed
    assert (np.diff(s) >= -1e-9 * max(1.0, s[-1])).all(), seed
    assert not (table["depth_m"][0] < 0.0).any(), seed
    assert not (table["pressure_kpa"][0] < 0.0).any(), seed
    energy = 0.5 * velocity**2 + 9.80665 * z  # nothing but gravity drives; rounding is of v², not of the sum
    assert (np.diff(energy) <= 1e-9 * (1.0 + 0.5 * (velocity[:-1] ** 2 + velocity[1:] ** 2))).all(), seed


KEYS = {
    "flow.rate_t_h": (300.0, 3000.0),
    "material.internal_friction_deg": (30.0, 60.0),
    "material.density_kg_m3": (700.0, 2500.0),
}


@pytest.mark.parametrize("seed", range(1000, 1020))
def test_a_design_does_not_depend_on_the_batch_it_is_in(seed):
    random = np.random.default_rng(seed)
    try:
        base = chutecalc.parse(random_chute(seed))
        values = {key: random.uniform(*limits, 11) for key, limits in KEYS.items()}
        batch = chutecalc.solve(base.vary(values))
        alone = [chutecalc.solve(base.vary({key: column[k] for key, column in values.items()})) for k in range(11)]
    except chutecalc.SpecError:
        return  # faults have tests of their own
    turned = chutecalc.solve(base.vary({key: column[::-1] for key, column in values.items()}))
    assert batch.status.tolist() == [one.status[0] for one in alone] == turned.status.tolist()[::-1]
    for name in ("velocity_m_s", "s_m", "time_s"):
        columns = [way.exit[name] for way in batch.segments]
        for number, column in enumerate(columns):
            expected = [one.segments[number].exit[name][0] for one in alone]
            assert np.array_equal(column, expected, equal_nan=True), (seed, name, number)
            assert np.array_equal(turned.segments[number].exit[name][::-1], column, equal_nan=True), (seed, name)
