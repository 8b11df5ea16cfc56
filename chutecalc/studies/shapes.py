"""Shapes of the documents of studies."""

from collections.abc import Callable

from chutecalc.api.scatter import DISTRIBUTIONS
from chutecalc.output.run_shape import run_shape
from chutecalc.output.shape import (
    CASE,
    COUNT,
    FINITE,
    NUMBER,
    SOURCE,
    SPEC,
    TEXT,
    TOLERANCE,
    TRUTH,
    VALUE,
    Shape,
    by_name,
    columns,
    document,
    list_of,
    maybe,
    one_of,
    record,
)
from chutecalc.results.finding import Severity
from chutecalc.studies.friction.columns import FRICTION_COLUMNS
from chutecalc.studies.friction.study import Best
from chutecalc.studies.regression import verdict
from chutecalc.studies.sweep.adjustment import KEEP
from chutecalc.studies.uncertain.importance import Indices

OUTCOMES = (
    *(verdict.OK, verdict.DRIFTED, verdict.CHANGED, verdict.EDITED),
    *(verdict.NO_BASELINE, verdict.BROKEN_BASELINE, verdict.NO_SPEC),
)
NUMBERS = list_of(NUMBER)
VALUES = by_name(VALUE, "path of a key, or its short name")
SOLUTIONS = list_of(VALUES, "values of the keys, for each design")
OUTCOME = list_of(by_name({}, "column of a sweep; of several states an object by state"), "of each design")
CHANCES = by_name(record("", share=NUMBER, error=NUMBER, at_most=FINITE), "outcome, limit or warning")


def _run() -> Shape:
    key = record(
        "",
        path=TEXT,
        value=NUMBER,
        derivative=NUMBER,
        error=NUMBER,
        percent_per_unit=NUMBER,
        percent_per_percent=NUMBER,
        smooth=TRUTH,
    )
    sensitivity = record("change of the exit velocity by each key", column=TEXT, value=NUMBER, keys=list_of(key))
    return run_shape(sensitivity)


def _sweep() -> Shape:
    return document(
        "sweep",
        "Rows of a sweep, a design or a station each.",
        source=SOURCE,
        spec=SPEC,
        tolerance=TOLERANCE,
        parameters=list_of(record("", name=TEXT, paths=list_of(TEXT), values=COUNT), "what was varied"),
        zip=TRUTH | {"description": "whether values were taken side by side instead of in all combinations"},
        keep=one_of(KEEP),
        rows=list_of(by_name(VALUE, "column of the sweep")),
    )


def _friction_study() -> Shape:
    return document(
        "friction_study",
        "The friction study of the paper: sweep without a spec.",
        keep=one_of(KEEP),
        wall_friction_deg=FINITE,
        base_m=NUMBER,
        area_m2=NUMBER,
        rows=list_of(columns(FRICTION_COLUMNS.values())),
        best=list_of(record("", **dict.fromkeys(Best._fields, NUMBER)), "best chamfer angles of each material"),
    )


def _uncertain() -> Shape:
    key = record(
        "",
        path=TEXT,
        value=NUMBER,
        distribution=one_of(DISTRIBUTIONS),
        numbers=list_of(FINITE),
        cut_off=NUMBER,
        quantiles=NUMBERS,
    )
    column = record(
        "",
        mean=NUMBER,
        mean_error=NUMBER,
        standard_deviation=NUMBER,
        quantiles=NUMBERS,
        quantile_errors=NUMBERS,
        spec=NUMBER,
        alone=list_of(NUMBERS, "at the outer quantiles of each key, all others as in the spec"),
    )
    return document(
        "uncertain",
        "What samples of an uncertain chute say.",
        source=SOURCE,
        spec=SPEC,
        case=CASE,
        tolerance=TOLERANCE,
        samples=COUNT,
        replicates=COUNT,
        seed=COUNT,
        keys=list_of(key),
        correlation=list_of(NUMBERS),
        shares=list_of(FINITE, "of the samples, below the quantiles"),
        columns=by_name(column, "column of a sweep"),
        chances=CHANCES,
        exceeded=CHANCES,
        warnings=maybe(CHANCES),
        indices=by_name(record("Sobol indices", **dict.fromkeys(Indices._fields, NUMBERS)), "column"),
        no_indices=maybe(TEXT | {"description": "why there are none"}),
    )


def _place() -> Shape:
    finding = record("", code=TEXT, severity=one_of(Severity), segments=TEXT)
    return document(
        "place",
        "Where segments must stand.",
        solutions=list_of(by_name({"type": ["number", "array"]}, "path of a key")),
        outcome=list_of(by_name(by_name(NUMBER, "path of a number of the strike"), "state")),
        findings=list_of(finding),
    )


def _keys() -> dict[str, Shape]:
    values = list_of(VALUE)
    key = record("", paths=list_of(TEXT), bounds=maybe(values), choices=maybe(values))
    return {"source": SOURCE, "spec": SPEC, "keys": by_name(key, "path of a key, or its short name")}


def _aim() -> Shape:
    return document(
        "aim",
        "All values of keys that give what is wanted.",
        **_keys(),
        targets=by_name(FINITE, "column of a sweep"),
        case=CASE,
        tried=TEXT | {"description": "how the designs of the search end"},
        solutions=SOLUTIONS,
        outcome=OUTCOME,
        nearest=maybe(record("what comes closest where there is no solution", values=VALUES, outcome=by_name({}))),
    )


def _optimise() -> Shape:
    edge = record(
        "where a design begins to fail as a key changes",
        key=TEXT,
        value=FINITE,
        status=TEXT,
        states=list_of(TEXT),
        distance=FINITE,
    )
    decides = record(
        "a limit that decides",
        limit=TEXT,
        values=by_name(VALUE, "state"),
        change_per_unit=NUMBER,
        edge=maybe(edge),
    )
    answer = record(
        "",
        on_bound=maybe(one_of(("lower", "upper"))),
        change_per_unit=NUMBER,
        within_1_per_cent=list_of(VALUE),
        fails=list_of(edge),
    )
    return document(
        "optimise",
        "The best values of keys.",
        **_keys(),
        objectives=by_name(one_of(("minimise", "maximise")), "column of a sweep"),
        subject=list_of(TEXT, "limits"),
        states=list_of(TEXT),
        feasible=TRUTH,
        violations=list_of(record("", limit=TEXT, state=TEXT, value=VALUE, by=NUMBER)),
        solutions=SOLUTIONS,
        outcome=OUTCOME,
        worst=by_name(NUMBERS, "objective"),
        binding=list_of(list_of(decides), "of each design"),
        keys_at_optimum=by_name(answer, "key"),
    )


def _check() -> Shape:
    drift = record(
        "a number that drifted",
        segment=TEXT,
        visit=COUNT,
        row=TEXT,
        column=TEXT,
        s_m=NUMBER,
        was=NUMBER,
        **{"is": NUMBER},
        off_by=NUMBER,
    )
    design = record(
        "",
        spec=SOURCE,
        outcome=one_of(OUTCOMES),
        tolerance=FINITE | {"description": "relative tolerance of the comparison"},
        notes=list_of(TEXT),
        changes=list_of(record("", kind=TEXT, segment=TEXT, message=TEXT)),
        drifts=list_of(drift),
    )
    return document("check", "Designs against their baselines.", tolerance=TOLERANCE, designs=list_of(design))


SHAPES: dict[str, Callable[[], Shape]] = {
    "run": _run,
    "sweep": _sweep,
    "friction_study": _friction_study,
    "uncertain": _uncertain,
    "place": _place,
    "aim": _aim,
    "optimise": _optimise,
    "check": _check,
}
"""Of the documents of the commands, by their names."""
