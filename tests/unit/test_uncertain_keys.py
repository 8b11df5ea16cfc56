"""The table ``[uncertainty]``: forms, spellings of paths, faults with their lines."""

import pytest

import chutecalc
from chutecalc.errors import SpecError
from tests.conftest import chute

FRICTION = "liners.wall.friction_deg"


def scatter(value, path=FRICTION):
    """Return how the number at a path scatters."""
    (key,) = chute(uncertainty={path: value}).uncertain.keys
    return key.scatter


def faults(table, **tables):
    with pytest.raises(SpecError) as error:
        chute(uncertainty=table, **tables)
    return [(fault.path.removeprefix("uncertainty."), fault.problem) for fault in error.value.faults]


def test_plus_minus_is_95_percent_of_a_normal_distribution():
    assert scatter(1.96) == ("normal", (pytest.approx(1.0, rel=1e-4),), "± 1.96")


@pytest.mark.parametrize(
    ("value", "kind", "numbers"),
    [
        ({"normal": 1}, "normal", (1.0,)),
        ({"uniform": [22, 28]}, "uniform", (22.0, 28.0)),
        ({"triangular": [20, 25, 32]}, "triangular", (20.0, 25.0, 32.0)),
        ({"triangular": [20, 20, 32]}, "triangular", (20.0, 20.0, 32.0)),
        ({"shear_test": [[1, 1], [1, 2]]}, "shear_test", (1.5, 0.5, 1.0, 0.0)),  # τ = 1.5 σ, s² = 0.5 over Σσ² = 2
    ],
)
def test_distributions(value, kind, numbers):
    assert scatter(value)[:2] == (kind, numbers)


def test_paths_in_quotes_or_dotted_in_any_unit():
    text = """
[uncertainty]
flow.rate_kg_s = 10
"segments.spoon.radius_mm" = { uniform = [2900, 3100] }
liners.ceramic.friction_deg = { normal = 1.0 }
correlation = [["flow.rate_kg_s", "liners.ceramic.friction_deg", -0.5]]
"""
    found = chutecalc.parse(chutecalc.STARTER + text).uncertain
    assert found.paths == ("flow.rate_kg_s", "segments.spoon.radius_mm", "liners.ceramic.friction_deg")
    assert found.keys[1].parameter.value_in_unit == 3000.0
    assert found.correlation.tolist() == [[1.0, 0.0, -0.5], [0.0, 1.0, 0.0], [-0.5, 0.0, 1.0]]
    assert not found.are_independent


def test_a_liner_may_be_called_as_a_distribution():
    liners = {"normal": {"friction_deg": 25.0}}
    (key,) = chute(liners=liners, uncertainty={"liners": {"normal": {"friction_deg": 2}}}).uncertain.keys
    assert key.path == "liners.normal.friction_deg"


@pytest.mark.parametrize(
    ("value", "problem"),
    [
        (0, "must be a number above 0"),
        (True, "must be a number above 0"),
        ("2", "must be a number above 0"),
        (float("nan"), "must be a number above 0"),
        ({"normal": -1}, "normal must be a number above 0"),
        ({"uniform": [28, 22]}, "do not rise"),
        ({"uniform": [22]}, "must be 2 numbers"),
        ({"uniform": [-5, 22]}, "reaches from -5 to 22, and values must be at least 0° and at most 85°"),
        ({"triangular": [20, 25, 95]}, "reaches from 20 to 95, and values must be"),
        (25.01, "spreads 95 % of the values from -0.01 to 50.01, and they must be at least 0° and at most 85°"),
        (1e300, "spreads 95 % of the values from -1e+300 to 1e+300"),
        ({"normal": 12.8}, "spreads 95 % of the values from -0.08"),
        ({"triangular": [20, 32, 25]}, "do not rise"),
        ({"triangular": [20, 25]}, "must be 3 numbers"),
        ({"normal": 1, "uniform": [1, 2]}, "must have one distribution, not 2"),
        ({"shear_test": [[1, 1]]}, "2 or more rows"),
        ({"shear_test": [[1, 1], [2, -1]]}, "2 or more rows"),
        ({"shear_test": [[1, 1], [2, 2]]}, "on one line"),
        ({"shear_test": [[1, 9], [9, 1]]}, "scatter too much: shear over normal stress is 0.22 ± 1"),
        ({"gauss": 1}, "has no distribution gauss"),
        ([1, 2], "must be a number above 0"),
    ],
)
def test_what_is_no_scatter_is_refused(value, problem):
    (found,) = faults({FRICTION: value})
    assert problem in found[1]
    assert found[0] == FRICTION


@pytest.mark.parametrize("value", [25.0, {"normal": 12.7}, {"uniform": [0, 85]}, {"triangular": [0, 0, 45]}])
def test_what_ends_at_the_bounds_of_its_key_is_taken(value):
    assert scatter(value).numbers


def test_the_remedy_for_too_wide_a_spread_is_taken():
    with pytest.raises(SpecError) as error:
        chute(flow={"rate_t_h": 1234.56}, uncertainty={"flow.rate_t_h": 1e20})
    assert error.value.faults[0].remedy == "use at most 1234 for plus/minus, or uniform or triangular"
    assert chute(flow={"rate_t_h": 1234.56}, uncertainty={"flow.rate_t_h": 1234}).uncertain.keys
    with pytest.raises(SpecError) as error:
        chutecalc.parse(chutecalc.STARTER + '[uncertainty]\n"inlet.velocity_m_s" = 1')
    assert error.value.faults[0].remedy == "use uniform or triangular"


def test_other_faults():
    assert faults({"flow.rate_th": 1}) == [("flow.rate_th", "is not a number in the spec")]
    assert "not a friction angle" in faults({"flow.rate_t_h": {"shear_test": [[1, 1], [1, 2]]}})[0][1]
    assert "is given twice" in faults({"flow.rate_t_h": 1, "flow.rate_kg_s": 1})[0][1]


TWO = {"flow.rate_t_h": 1, FRICTION: 1}


@pytest.mark.parametrize(
    ("pairs", "problem"),
    [
        ("x", "row 1 is not two keys and a number"),
        ([["flow.rate_t_h", FRICTION]], "row 1 is not two keys and a number"),
        ([["flow.rate_t_h", "x", 0.5]], "row 1 names x, which this table does not call uncertain"),
        ([["flow.rate_t_h", "material.density_kg_m3", 0.5]], "row 1 names material.density_kg_m3, which this table"),
        ([["flow.rate_t_h", FRICTION, 1.0]], "row 1 has 1; a correlation must be greater than -1 and less than 1"),
        ([["flow.rate_t_h", FRICTION, -1.5]], "row 1 has -1.5; a correlation must be"),
        ([["flow.rate_t_h", "flow.rate_t_h", 0.5]], "row 1 pairs flow.rate_t_h with itself"),
        (
            [["flow.rate_t_h", FRICTION, 0.0], [FRICTION, "flow.rate_t_h", 0.4]],
            "row 2 pairs liners.wall.friction_deg and",
        ),
        ([["flow.rate_t_h", ["x"], 0.5]], "row 1 names ['x']"),
    ],
)
def test_what_is_no_correlation_is_refused(pairs, problem):
    (found,) = faults(TWO | {"correlation": pairs})
    assert found[0] == "correlation"
    assert problem in found[1]


def test_all_rows_that_are_wrong_are_told_at_once():
    pairs = [["flow.rate_t_h", FRICTION, 2.0], ["flow.rate_t_h", FRICTION, 0.5], ["a", FRICTION, 0.1], 1]
    assert [problem.split()[:2] for _, problem in faults(TWO | {"correlation": pairs})] == [
        ["row", "1"],
        ["row", "3"],
        ["row", "4"],
    ]


def test_correlations_that_contradict_each_other_are_refused():
    keys = [*TWO, "material.density_kg_m3"]
    pairs = [[keys[0], keys[1], 0.9], [keys[1], keys[2], 0.9], [keys[0], keys[2], -0.9]]
    with pytest.raises(SpecError) as error:
        chute(uncertainty=TWO | {keys[2]: 1, "correlation": pairs})
    (found,) = error.value.faults
    assert "contradict each other" in found.problem
    assert all(key in found.problem for key in keys)
    assert "multiply all of them by 0.555 or less" in found.remedy
    for factor in (0.555, 0.556):  # least eigenvalue 1 - 2 (0.9 factor): 0 at 1/1.8
        table = TWO | {keys[2]: 1, "correlation": [[*pair[:2], factor * pair[2]] for pair in pairs]}
        if factor < 1.0 / 1.8:
            assert chute(uncertainty=table).uncertain.keys
        else:
            assert faults(table)
    pairs[2][2] = 0.9
    assert chute(uncertainty=TWO | {keys[2]: 1, "correlation": pairs}).uncertain.keys


def test_all_faults_are_told_at_once_with_their_lines():
    text = """
[cases.wet]
"flow.rate_x" = 1
[uncertainty]
"flow.rate_t_h" = -1
liners.ceramic.friction_deg = { gauss = 1 }
correlation = [["a", "b", 0.5]]
"""
    with pytest.raises(SpecError) as error:
        chutecalc.parse(chutecalc.STARTER + text, "spoon.toml")
    first = chutecalc.STARTER.count("\n") + 1
    lines = {fault.path: fault.line - first for fault in error.value.faults}
    assert lines == {
        "cases.wet.flow.rate_x": 2,
        "uncertainty.flow.rate_t_h": 4,
        "uncertainty.liners.ceramic.friction_deg": 5,
        "uncertainty.correlation": 6,
    }


def test_a_case_is_uncertain_about_its_own_values():
    case = chute(cases={"wet": {FRICTION: 30.0}}, uncertainty={FRICTION: 2})
    assert case.uncertain.keys[0].parameter.value == 25.0
    assert case.cases["wet"].uncertain.keys[0].parameter.value == 30.0


def test_a_distribution_of_nothing_and_stresses_of_no_test_are_refused():
    assert faults({FRICTION: {}}) == [(FRICTION, "must have one distribution, not 0")]
    for stress in (1e300, 1e-300):
        ((path, problem),) = faults({FRICTION: {"shear_test": [[stress, stress], [2.0 * stress, stress], [3.0, 1.0]]}})
        assert path == FRICTION
        assert "1e-06 to 1e+09" in problem
