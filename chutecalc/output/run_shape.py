"""The shape of a run's document, from the same catalogues as its numbers."""

from chutecalc.design import Status
from chutecalc.output.cases import COMPARED, WORST
from chutecalc.output.shape import (
    CASE,
    FINITE,
    NUMBER,
    SOURCE,
    SPEC,
    TEXT,
    TOLERANCE,
    TRUTH,
    Shape,
    by_name,
    column_shape,
    columns,
    document,
    list_of,
    maybe,
    numbers,
    one_of,
    record,
    ref,
)
from chutecalc.results.band import COLUMNS as BAND_COLUMNS
from chutecalc.results.belts import RECEIVER_COLUMNS
from chutecalc.results.columns import COLUMNS, NUMERIC, REPORTED
from chutecalc.results.edges import EDGE_NUMBERS
from chutecalc.results.finding import Severity
from chutecalc.results.findings import CRITERIA
from chutecalc.results.impacts import IMPACT_COLUMNS
from chutecalc.results.inlet import INLET_NUMBERS
from chutecalc.results.loads import LOAD_COLUMNS

STATUS = one_of(Status.LABELS, "ok, or the failure that ends the stream")


def run_shape(sensitivity: Shape) -> Shape:
    """Return the shape of the document of a run.

    Args:
        sensitivity: shape of the sensitivities of a chute.
    """
    results = _results()
    compared = columns(COMPARED.values(), "what states are compared by")
    chute = record(
        "a chute in the state that is shown in full, and its other states",
        source=SOURCE,
        spec=SPEC,
        case=CASE,
        **results,
        cases=by_name(record("an operating state", compared=compared, **results), "the other states by name"),
        worst_cases=maybe(record("name of the worst state in each number", **dict.fromkeys(WORST, maybe(TEXT)))),
        band=maybe(_band()),
        sensitivity=maybe(sensitivity),
    )
    return document("run", "What chutes do, in the order of their specs.", tolerance=TOLERANCE, chutes=list_of(chute))


def run_definitions() -> dict[str, Shape]:
    """Return what the shape of a run refers to, by name."""
    known = {name: column_shape(column) for name, column in COLUMNS.items()}
    part = {
        "name": TEXT,
        "kind": TEXT,
        "status": STATUS,
        "entry": ref("ends"),
        "exit": ref("ends"),
        "minimum": ref("extremes"),
        "maximum": ref("extremes"),
        "duration_s": NUMBER,
        "landing_margin_m": NUMBER,
        "stations": maybe(list_of(ref("station"), "null unless --points or --stations is given")),
    }
    segment = record(
        "a segment",
        **part,
        impact=maybe(columns(IMPACT_COLUMNS.values(), "null where no stream strikes it")),
        strikes_roof=maybe(TRUTH),
        loads=maybe(columns(LOAD_COLUMNS.values(), "null for a fall")),
        edges=list_of(ref("edge")),
        flight=maybe(ref("flight")),
        flights_again=list_of(ref("flight"), "further flights, where the stream leaves it and meets it again"),
    )
    finding = record(
        "a finding",
        code=one_of(sorted({criterion.code for criterion in CRITERIA})),
        severity=one_of(Severity),
        segment=maybe(TEXT),
        key=maybe(TEXT),
        s_m=NUMBER,
        message=TEXT,
        numbers=by_name(NUMBER, "numbers of the message, whose names end in their units"),
    )
    edge = record(
        "an edge of a stream in flight",
        name=one_of(("lower", "middle", "upper", "free")),
        segment=maybe(TEXT | {"description": "on which it lands"}),
        **numbers(EDGE_NUMBERS),
    )
    return {
        "ends": columns((COLUMNS[name] for name in NUMERIC), "the stream at an end"),
        "extremes": columns((COLUMNS[name] for name in REPORTED), "extremes along a part"),
        "station": {"type": "object", "properties": known, "additionalProperties": False},
        "edge": edge,
        "flight": record("a flight", **part),
        "segment": segment,
        "finding": finding,
        "inlet": record("the stream where it enters", **numbers(INLET_NUMBERS), edges=list_of(ref("edge"))),
        "receiver": columns(RECEIVER_COLUMNS.values(), "landing on the receiving belt"),
    }


def _results() -> dict[str, Shape]:
    """Return the shapes of the results of one state."""
    return {
        "error_estimate": NUMBER | {"description": "relative, of the velocity at the exit"},
        "status": STATUS,
        "inlet": ref("inlet"),
        "exit": ref("ends"),
        "segments": list_of(ref("segment")),
        "last_flights": list_of(ref("flight"), "flights behind the last surface"),
        "receiver": maybe(ref("receiver")),
        "findings": list_of(ref("finding")),
    }


def _band() -> Shape:
    """Return the shape of the band of the model."""
    variant = record("", momentum_factor=FINITE, longitudinal_ratio=FINITE)
    ends = record("", least=NUMBER, largest=NUMBER)
    ranges = record("", **dict.fromkeys(BAND_COLUMNS, ends))
    rows = dict.fromkeys(("entry", "exit", "minimum", "maximum"), ranges)
    end = record("variants that end otherwise", status=TEXT, segment=TEXT, s_m=ends, variants=list_of(variant))
    return record(
        "the band of the model's own assumptions",
        note=TEXT,
        variants=list_of(variant),
        exit=ranges,
        segments=list_of(record("", name=TEXT, **rows)),
        ends=list_of(end),
    )
