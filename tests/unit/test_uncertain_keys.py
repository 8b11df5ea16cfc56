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
        ({"shear_test": [[1, 1], [1, 2]]}, "shear_test", (1.5, 0.5, 1.0)),  # τ = 1.5 σ, s² = 0.5 over Σσ² = 2
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
        ({"uniform": [-5, 0]}, "lies outside what its key takes"),
        ({"uniform": [90, 95]}, "lies outside what its key takes"),
        ({"triangular": [20, 32, 25]}, "do not rise"),
        ({"triangular": [20, 25]}, "must be 3 numbers"),
        ({"normal": 1, "uniform": [1, 2]}, "must have one distribution, not 2"),
        ({"shear_test": [[1, 1]]}, "2 or more rows"),
        ({"shear_test": [[1, 1], [2, -1]]}, "2 or more rows"),
        ({"shear_test": [[1, 1], [2, 2]]}, "on one line"),
        ({"gauss": 1}, "has no distribution gauss"),
        ([1, 2], "must be a number above 0"),
    ],
)
def test_what_is_no_scatter_is_refused(value, problem):
    (found,) = faults({FRICTION: value})
    assert problem in found[1]
    assert found[0] == FRICTION


def test_other_faults():
    assert faults({"flow.rate_th": 1}) == [("flow.rate_th", "is not a number in the spec")]
    assert "not a friction angle" in faults({"flow.rate_t_h": {"shear_test": [[1, 1], [1, 2]]}})[0][1]
    assert "is given twice" in faults({"flow.rate_t_h": 1, "flow.rate_kg_s": 1})[0][1]


TWO = {"flow.rate_t_h": 1, FRICTION: 1}


@pytest.mark.parametrize(
    ("pairs", "problem"),
    [
        ("x", "row 1 that is not"),
        ([["flow.rate_t_h", FRICTION]], "row 1 that is not"),
        ([["flow.rate_t_h", "x", 0.5]], "names x in row 1"),
        ([["flow.rate_t_h", FRICTION, 1.0]], "must be between"),
        ([["flow.rate_t_h", "flow.rate_t_h", 0.5]], "twice"),
        ([["flow.rate_t_h", FRICTION, 0.5], [FRICTION, "flow.rate_t_h", 0.4]], "twice in row 2"),
        ([["flow.rate_t_h", ["x"], 0.5]], "in row 1"),
    ],
)
def test_what_is_no_correlation_is_refused(pairs, problem):
    (found,) = faults(TWO | {"correlation": pairs})
    assert found[0] == "correlation"
    assert problem in found[1]


def test_correlations_that_contradict_each_other_are_refused():
    keys = [*TWO, "material.density_kg_m3"]
    pairs = [[keys[0], keys[1], 0.9], [keys[1], keys[2], 0.9], [keys[0], keys[2], -0.9]]
    (found,) = faults(TWO | {keys[2]: 1, "correlation": pairs})
    assert "not positive definite (least eigenvalue -0.8)" in found[1]
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
