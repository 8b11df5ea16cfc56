"""Uncertainty against exact distributions: normal sums, closed Sobol indices, the root at which a chute stalls."""

import numpy as np
import pytest
from scipy import stats

import chutecalc
from chutecalc.api.scatter import HALF_WIDTH
from chutecalc.studies.uncertain.quantiles import Joint, quantiles_of
from chutecalc.studies.uncertain.sampling import FEWEST, REPLICATES, cubes
from chutecalc.studies.uncertain.statistics import SHARES, summary
from tests.conftest import chute, vee, vee_friction

G = 9.80665
MANY = 5.0
"""Standard errors within which a number must be: 16 replicates give Student's t of 15, 1e-4 beyond."""


def fall(velocity=3.0, slope=90.0, **uncertainty):
    return chute(
        inlet={"velocity_m_s": velocity, "slope_deg": slope, "at_m": [0.0, 10.0]},
        segments=[{"kind": "fall", "drop_m": 2.0}],
        uncertainty=uncertainty,
    )


HEIGHTS = {"inlet.at_m.2": {"normal": 0.3}, "segments.fall.drop_m": 0.4 * HALF_WIDTH}
"""Of the end z = at - drop, with standard deviations of 0.3 and 0.4 m."""


@pytest.mark.parametrize(("correlation", "variance"), [(None, 0.25), (0.6, 0.25 - 2 * 0.6 * 0.12), (-0.9, 0.466)])
def test_a_sum_of_normal_numbers_is_normal(correlation, variance):
    pairs = {"correlation": [[*HEIGHTS, correlation]]} if correlation else {}
    found = chutecalc.uncertain(fall(**HEIGHTS, **pairs), samples=16_384, columns=["exit_z_m"])
    exact = stats.norm(8.0, np.sqrt(variance))
    own = found.summaries["exit_z_m"]
    assert abs(own.mean - 8.0) < MANY * own.error < 1e-3
    assert own.deviation == pytest.approx(np.sqrt(variance), rel=2e-3)
    errors = MANY * own.quantile_errors + 0.02 / found.count**0.5
    np.testing.assert_array_less(np.abs(own.quantiles - exact.ppf(SHARES)), errors)
    assert stats.kstest(found.columns["exit_z_m"], exact.cdf).statistic < 1.0 / found.count**0.5
    if correlation:
        given = np.corrcoef([found.values[path] for path in HEIGHTS])[0, 1]
        assert given == pytest.approx(correlation, abs=5e-3)


def test_quantiles_of_a_velocity_are_those_of_its_square():
    """v² = v0² + 2 g h is normal where h is, and v rises with it."""
    found = chutecalc.uncertain(fall(**{"segments.fall.drop_m": {"normal": 0.1}}))
    exact = np.sqrt(9.0 + 2 * G * stats.norm(2.0, 0.1).ppf(SHARES))
    own = found.summaries["exit_velocity_m_s"]
    assert own.quantiles == pytest.approx(exact, rel=1e-4)
    squares = found.columns["exit_velocity_m_s"] ** 2
    assert squares.mean() == pytest.approx(9.0 + 4 * G, abs=2 * G * 0.1 / 1024)  # σ / slices: the outer ones are wide
    assert squares.std() == pytest.approx(2 * G * 0.1, rel=1e-3)
    ends = np.sqrt(9.0 + 2 * G * stats.norm(2.0, 0.1).ppf([0.05, 0.95]))
    assert found.tornado.columns["exit_velocity_m_s"][0] == pytest.approx(ends, rel=1e-9)


def product_indices(velocity, drop):
    """Return first and total indices of x = v √(2 h/g), a product of independent numbers, uniform in these ranges."""
    (a, b), (c, d) = velocity, drop
    mean, square = (a + b) / 2, (a * a + a * b + b * b) / 3
    root = 2 / 3 * (d**1.5 - c**1.5) / (d - c)
    moments = np.array([[mean, square], [root * np.sqrt(2 / G), (c + d) / 2 * 2 / G]])
    means, squares = moments[:, 0] ** 2, moments[:, 1]
    own = squares - means
    total = squares.prod() - means.prod()
    return own * means[::-1] / total, own * squares[::-1] / total


def test_sobol_indices_of_a_product():
    ranges = [1.0, 5.0], [0.5, 3.5]
    uniform = dict(
        zip(("inlet.velocity_m_s", "segments.fall.drop_m"), ({"uniform": each} for each in ranges), strict=True)
    )
    found = chutecalc.uncertain(fall(slope=0.0, **uniform), samples=8192, columns=["exit_x_m"])
    first, total = product_indices(*ranges)
    own = found.indices["exit_x_m"]
    assert (np.abs(own.first - first) < MANY * own.first_error + 1e-3).all()
    assert (np.abs(own.total - total) < MANY * own.total_error + 1e-3).all()
    assert (own.first_error < 0.02).all()
    assert (total > first + 0.02).all()  # so that the two are told apart


def test_sobol_indices_of_a_sum():
    found = chutecalc.uncertain(fall(**HEIGHTS), columns=["exit_z_m"])
    own = found.indices["exit_z_m"]
    assert own.first == pytest.approx([0.36, 0.64], abs=0.01)
    assert own.total == pytest.approx([0.36, 0.64], abs=0.01)


def test_the_mean_converges_faster_than_that_of_random_numbers():
    """Errors of the mean of x = v √(2 h/g) over N fall by 1/N and faster; those of random numbers by 1/√N.

    The samples are those of the study, which the first of them shows; x is worked out here, so that many cost nothing.
    """
    keys = {"inlet.velocity_m_s": {"uniform": [1.0, 5.0]}, "segments.fall.drop_m": {"uniform": [0.5, 3.5]}}
    case = fall(slope=0.0, **keys)
    exact = 3.0 * 2 / 3 * (3.5**1.5 - 0.5**1.5) / 3.0 * np.sqrt(2 / G)
    joint = Joint(case.uncertain)

    def of_samples(count, seed):
        velocity, drop = np.concatenate([joint(cube[:, :2]) for cube in cubes(4, count // REPLICATES, seed)]).T
        return summary(velocity * np.sqrt(2 * drop / G))

    study = chutecalc.uncertain(case, FEWEST, 0, ["exit_x_m"]).summaries["exit_x_m"]
    assert of_samples(FEWEST, 0)[:3] == pytest.approx(study[:3], rel=1e-9)
    counts = FEWEST * 4 ** np.arange(4)
    errors, told = [], []
    for count in counts:
        runs = [of_samples(int(count), seed) for seed in range(8)]
        errors.append(np.sqrt(np.mean([(own.mean - exact) ** 2 for own in runs])))
        told.append(np.sqrt(np.mean([own.error**2 for own in runs])))
    order = np.polyfit(np.log(counts), np.log(errors), 1)[0]
    assert order < -0.9
    random = 1.2 / np.sqrt(counts[-1])  # the standard deviation of x over √N
    assert errors[-1] < 0.05 * random
    ratio = np.array(errors) / told  # that told is that made: χ of 8 runs, 0.1 % beyond on each side
    assert ((ratio > 0.3) & (ratio < 1.9)).all()


def stalling(**uncertainty):
    """Return a straight vee on which μ_e does not depend on depth."""
    return chute(
        inlet={"velocity_m_s": 2.0, "slope_deg": 30.0},
        liners={"wall": {"friction_deg": 22.0}},
        sections=vee(),
        segments=[{"kind": "straight", "slope_deg": 30.0, "length_m": 3.0}],
        uncertainty=uncertainty,
    )


def stall_angle():
    """Return the wall friction angle at which v² falls to 0 just at the end."""
    friction = np.tan(np.radians(30.0)) + 4.0 / (2 * G * 3.0 * np.cos(np.radians(30.0)))
    return float(np.degrees(np.arctan(friction / vee_friction(45.0, 45.0, 50.0))))  # μ_e is tan φ times a constant


@pytest.mark.parametrize("deviation", [2.0, 3.0, 4.0])
def test_the_chance_of_a_stall_is_that_of_its_root(deviation):
    found = chutecalc.uncertain(stalling(**{"liners.wall.friction_deg": {"normal": deviation}}), samples=65_536)
    exact = stats.norm(22.0, deviation).sf(stall_angle())
    own = found.chances["stall"]
    assert 0.001 < exact < 0.5
    assert abs(own.share - exact) < MANY * own.error + 2.0 / found.count
    slices = found.count // REPLICATES  # one point in each, so that the count of a replicate is right to 1 point
    assert own.error < 0.52 / slices / REPLICATES**0.5
    limit = found.values["liners.wall.friction_deg"][found.status == "stall"].min()
    assert limit == pytest.approx(stall_angle(), abs=0.01 * deviation)


def test_where_some_fail_the_indices_are_of_failure():
    keys = {"liners.wall.friction_deg": {"normal": 4.0}, "material.density_kg_m3": 50}
    found = chutecalc.uncertain(stalling(**keys))
    assert list(found.indices) == ["fails"]
    own = found.indices["fails"]
    assert own.first == pytest.approx([1.0, 0.0], abs=0.05)
    assert own.total == pytest.approx([1.0, 0.0], abs=0.05)
    assert np.isnan(found.columns["exit_velocity_m_s"][~found.ok]).all()
    assert "stall" in found.status


POINTS = [[2.0, 1.1], [4.0, 1.9], [8.0, 3.9], [16.0, 7.3]]


def test_a_shear_test_is_students_t_of_the_slope():
    """By the normal equations of a line through the origin, as NumPy's least squares have it."""
    found = chutecalc.uncertain(stalling(**{"liners.wall.friction_deg": {"shear_test": POINTS}}), samples=16_384)
    normal, shear = np.array(POINTS).T
    (slope,), (residual,), *_ = np.linalg.lstsq(normal[:, None], shear, rcond=None)
    error = np.sqrt(residual / 3 * np.linalg.inv(normal[None] @ normal[:, None])[0, 0])
    tangents = np.tan(np.radians(found.values["liners.wall.friction_deg"]))
    assert stats.kstest(tangents, stats.t(3, slope, error).cdf).statistic < 1.0 / found.count**0.5
    below = stats.t(3, slope, error).cdf(0.0)  # slopes that no friction has
    exact = np.degrees(np.arctan(stats.t(3, slope, error).ppf(below + np.array(SHARES) * (1.0 - below))))
    (key,) = found.keys.keys
    assert quantiles_of(key)(SHARES) == pytest.approx(exact, rel=1e-9)


def test_a_distribution_is_cut_off_at_the_bounds_of_its_key():
    (key,) = stalling(**{"liners.wall.friction_deg": {"normal": 11.0}}).uncertain.keys
    low, high = -22.0 / 11.0, (85.0 - 22.0) / 11.0
    exact = stats.truncnorm(low, high, 22.0, 11.0)
    shares = np.array([1e-9, 0.01, 0.5, 0.99, 1 - 1e-9])
    own = quantiles_of(key)
    assert own(shares) == pytest.approx(exact.ppf(shares), rel=1e-6)
    assert own([0.0, 1.0]) == pytest.approx([0.0, 85.0], abs=1e-6)
    assert own.outside == pytest.approx(stats.norm.cdf(low), rel=1e-6)
    found = chutecalc.uncertain(stalling(**{"liners.wall.friction_deg": {"normal": 11.0}}))
    values = found.values["liners.wall.friction_deg"]
    assert values.mean() == pytest.approx(exact.mean(), rel=1e-4)
    assert values.std() == pytest.approx(exact.std(), rel=1e-3)


@pytest.mark.parametrize("scale", [1.0, 1e-300, 1e300])
def test_mean_and_deviation_hold_for_numbers_of_any_size(scale):
    """Of 1 to N: (N + 1)/2 and the root of N (N + 1)/12; 1e300 has no square."""
    count = 1024
    own = summary(scale * np.random.default_rng(1).permutation(np.arange(1.0, count + 1)))
    assert own.mean == pytest.approx(scale * (count + 1) / 2, rel=1e-12)
    assert own.deviation == pytest.approx(scale * np.sqrt(count * (count + 1) / 12), rel=1e-12)
    far = summary(1e9 + np.random.default_rng(1).permutation(np.arange(1.0, count + 1)))
    assert far.deviation == pytest.approx(np.sqrt(count * (count + 1) / 12), rel=1e-9)


@pytest.mark.parametrize(("limit", "sign"), [("exit_z_m<=8.5", 1.0), ("exit_z_m>=7.2", -1.0)])
def test_the_chance_that_a_limit_is_exceeded_is_that_of_a_normal_number(limit, sign):
    found = chutecalc.uncertain(fall(**HEIGHTS), limits=[limit])
    value = float(limit[-3:])
    exact = stats.norm(8.0, 0.5).sf(value) if sign > 0 else stats.norm(8.0, 0.5).cdf(value)
    own = found.exceeded[limit]
    assert abs(own.share - exact) < MANY * own.error < 0.01
    assert own.at_most == pytest.approx(own.share + 2.0 * own.error)
    assert found.exceeded["any"] == own


def test_limits_count_among_those_that_do_not_fail_and_all_together_among_all():
    """v² falls linearly with tan φ, to 0 at the angle of the stall: below 1 m/s is the share between two angles."""
    root = np.tan(np.radians(stall_angle()))
    rest = 4.0 + 2 * G * 3.0 * np.sin(np.radians(30.0))
    slow = float(np.degrees(np.arctan(root * (rest - 1.0) / rest)))
    keys = {"liners.wall.friction_deg": {"uniform": [10.0, 45.0]}}
    found = chutecalc.uncertain(stalling(**keys), limits=["exit_velocity_m_s>=1"])
    assert slow < stall_angle() < 45.0
    own, all_ = found.exceeded["exit_velocity_m_s>=1"], found.exceeded["any"]
    assert own.share == pytest.approx((stall_angle() - slow) / (stall_angle() - 10.0), abs=2e-3)
    assert all_.share == pytest.approx((45.0 - slow) / 35.0, abs=2e-3)
    assert all_.share == pytest.approx(found.chances["fails"].share + own.share * found.chances["ok"].share, rel=1e-12)


def test_replicates_are_nets():
    """Each has one point in each of its equal slices of every axis, and no point at an end."""
    for cube in cubes(3, 64, seed=7):
        assert (np.sort(np.floor(64 * cube), axis=0) == np.arange(64)[:, None]).all()
        assert ((cube > 0.0) & (cube < 1.0)).all()
