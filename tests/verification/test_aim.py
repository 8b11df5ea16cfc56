"""Aims against brute grids: every solution that a fine grid brackets is found, and what is found is what was asked."""

from dataclasses import replace

import numpy as np
import pytest

import chutecalc
from chutecalc.studies.aim.bracket import bracketed_roots
from chutecalc.studies.keys import key_arguments, read_keys
from chutecalc.studies.variants import Variants
from tests import seeds
from tests.conftest import ROOT
from tests.verification.aim_cases import case, judge

SPOON = "segments.spoon.radius_m"


def test_every_solution_that_a_fine_grid_brackets_is_found():
    verdicts = [judge(seed) for seed in range(seeds.times(10))]
    assert [wrong for _, wrong in verdicts if wrong] == []
    assert [verdict for verdict, _ in verdicts].count("found") >= len(verdicts) // 2


def test_a_grid_shows_what_is_not_found(monkeypatch):
    """The judge of the test above sees a solution that is lost, and one that is off."""
    monkeypatch.delenv(seeds.SEED, raising=False)
    of = case(0)
    found = chutecalc.aim(of.chute, {of.path: of.bounds}, {of.column: of.target})
    assert found.count
    monkeypatch.setattr("tests.verification.aim_cases.case", lambda seed: of)
    for values in (found.values[of.path][:0], found.values[of.path] * (1.0 + 1e-5)):
        wrong = replace(found, values={of.path: values})
        monkeypatch.setattr(chutecalc, "aim", lambda *_, wrong=wrong, **__: wrong)
        assert judge(0)[0] == "wrong"


def test_all_solutions_of_two_targets_are_found():
    """Against the crossings of the zero lines of both on a fine grid."""
    chute = chutecalc.load(ROOT / "specs" / "coal_hood_spoon.toml")
    keys = {"segments.spoon.to_slope_deg": (10.0, 60.0), SPOON: (1.0, 6.0)}
    parameters = [key.parameter for key in read_keys(key_arguments(keys), chute)]
    columns = ["exit_velocity_m_s", "exit_x_m"]
    variants = Variants(chute, parameters, columns)
    axes = [np.linspace(*bounds, 101) for bounds in keys.values()]
    grid = [each.ravel() for each in np.meshgrid(*axes, indexing="ij")]
    known = [variants(grid)[name][0].reshape(101, 101) for name in columns]
    for place in ((15, 30), (75, 20)):
        targets = {name: float(values[place] * 1.0001) for name, values in zip(columns, known, strict=True)}
        aim = chutecalc.aim(chute, keys, targets)
        cells = np.ones((100, 100), dtype=bool)
        for name, values in zip(columns, known, strict=True):
            corners = np.stack([values[i : i + 100, j : j + 100] for i in (0, 1) for j in (0, 1)]) - targets[name]
            cells &= (corners.min(axis=0) < 0.0) & (corners.max(axis=0) > 0.0)
        crossed = np.argwhere(cells)
        assert len(crossed)
        solutions = np.stack(list(aim.values.values()), axis=1)
        for i, j in crossed:
            middle = np.array([axes[0][i : i + 2].mean(), axes[1][j : j + 2].mean()])
            assert np.abs((solutions - middle) / np.array([50.0, 5.0])).max(axis=1).min() < 0.03


def test_both_solutions_of_a_column_that_turns_are_found_however_close():
    """The velocity at the exit of a chamfered spoon is least at some chamfer angle: two solutions above that."""
    chute = chutecalc.load(ROOT / "specs" / "paper" / "r3_d55_chamfered.toml")
    path, column = "sections.spoon.chamfer_deg", "exit_velocity_m_s"
    (key,) = read_keys([f"{path}=20:89"], chute)
    variants = Variants(chute, [key.parameter], [column], rtol=1e-12)
    x = np.linspace(20.0, 89.0, 4001)
    values = variants([x])[column][0]
    turn = int(values.argmin())
    assert 0 < turn < 4000
    for share in (1e-3, 1e-6, 1e-8):
        target = float(values[turn]) * (1.0 + share)
        found = chutecalc.aim(chute, {path: (20, 89)}, {column: target}).values[path]
        assert len(found) == 2
        assert found[0] < x[turn] < found[1] or share < 1e-7


def test_noise_on_a_level_stretch_is_no_root(monkeypatch):
    """Neither on the target, where there is no end of solutions, nor off it."""
    asked = []

    def stretch(level):
        def residual(x):
            asked.append(len(x))
            noise = 1e-15 * np.random.default_rng(len(asked)).normal(size=len(x))
            return np.where(x < 0.4, 0.4 - x, level + noise)

        return residual

    assert bracketed_roots(stretch(-0.1)).tolist() == pytest.approx([0.4])
    assert sum(asked) < 2000
    monkeypatch.delenv(seeds.SEED, raising=False)
    of = case(8)  # where it ends stays level over part of the rolls, and is the target
    with pytest.raises(chutecalc.UsageError, match="without end"):
        chutecalc.aim(of.chute, {of.path: of.bounds}, {of.column: of.target})


def test_what_cannot_be_had_is_said_with_the_nearest():
    """No velocity of the belt gives so fast an end; slow belts miss the hood."""
    chute = chutecalc.load(ROOT / "specs" / "transfer_90.toml")
    path = "inlet.belt.velocity_m_s"
    aim = chutecalc.aim(chute, {path: (0.5, 6.0)}, {"exit_velocity_m_s": 30.0})
    assert aim.count == 0
    assert aim.nearest is not None
    assert "missed" in aim.tried


def test_more_keys_start_from_scattered_points():
    chute = chutecalc.load(ROOT / "specs" / "coal_hood_spoon.toml")
    bounds = {
        "segments.hood.radius_m": (1.0, 4.0),
        SPOON: (1.0, 5.0),
        "segments.spoon.to_slope_deg": (10.0, 50.0),
        "flow.rate_t_h": (500.0, 2000.0),
    }
    wanted = {"segments.hood.radius_m": 2.2, SPOON: 3.1, "segments.spoon.to_slope_deg": 31.0, "flow.rate_t_h": 1300.0}
    columns = ["exit_velocity_m_s", "exit_slope_deg", "exit_x_m", "max_depth_m"]
    parameters = [key.parameter for key in read_keys(key_arguments(bounds), chute)]
    block = Variants(chute, parameters, columns, rtol=1e-12)([np.array([value]) for value in wanted.values()])
    aim = chutecalc.aim(chute, bounds, {name: float(block[name][0, 0]) for name in columns})
    solutions = np.stack([aim.values[name] for name in wanted], axis=1)
    assert np.abs(solutions / np.array([*wanted.values()]) - 1.0).max(axis=1).min() < 1e-6


@pytest.mark.parametrize(
    ("spec", "keys", "at", "columns", "problem"),
    [
        (
            "grain_spout",
            {"segments.elbow.radius_m": (0.5, 2.0), "segments.elbow.to_slope_deg": (5.0, 48.0)},
            (1.1, 30.0),
            ("exit_velocity_m_s", "max_depth_m"),  # which is at the inlet
            "without end: no key moves max_depth_m there. Choose another target than max_depth_m",
        ),
        (
            "belt_hood_spoon",
            {SPOON: (1.0, 5.0), "segments.drop.drop_m": (0.5, 3.0)},
            (3.0, 1.5),
            ("exit_velocity_m_s", "max_depth_m"),
            "without end",
        ),
    ],
)
def test_a_line_of_solutions_is_refused(spec, keys, at, columns, problem):
    """Samples of it would look like a few solutions."""
    base = chutecalc.load(ROOT / "specs" / f"{spec}.toml")
    parameters = [key.parameter for key in read_keys(key_arguments(keys), base)]
    block = Variants(base, parameters, columns, rtol=1e-12)([np.array([value]) for value in at])
    with pytest.raises(chutecalc.UsageError, match=problem):
        chutecalc.aim(base, keys, {name: float(block[name][0, 0]) for name in columns})
