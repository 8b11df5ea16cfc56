"""Places segments of a spec one after the other, and shows that the stream strikes each as wanted."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import degrees
from pathlib import Path
from reprlib import repr as short
from typing import Any

import tomli_w

from chutecalc.api.cases import solve_cases
from chutecalc.api.chute import Chute
from chutecalc.api.load import checked, library_for
from chutecalc.api.written import text_of
from chutecalc.errors import SpecError, UsageError
from chutecalc.results.cases import Cases
from chutecalc.segments.registry import KINDS
from chutecalc.spec.bounded import excess_of_tables
from chutecalc.spec.frozen import FALL, Drawn, frozen_text
from chutecalc.spec.library import Library
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.spec.parse import parse_text
from chutecalc.spec.paths import is_number, item_names
from chutecalc.studies.place.approach import lacks_place, launch_to
from chutecalc.studies.place.attempt import Attempt
from chutecalc.studies.place.stand import ENDS, angle_of
from chutecalc.studies.place.strike import NotReachedError
from chutecalc.studies.place.struck import Struck, struck_by
from chutecalc.studies.place.wish import read_wish


@dataclass(frozen=True)
class PlacedSegment:
    """A segment where the stream strikes it as wanted."""

    name: str
    kind: str
    start_m: tuple[float, float]
    """x and z of its drawn start."""
    slopes: dict[str, float]
    """Its slope, or that at the start of an arc, degrees, by its key in the spec."""
    ends_deg: float | None
    """Slope at the end of an arc, degrees."""
    strikes: dict[str, Struck | None]
    """How the stream strikes it, by the name of the state, the design point first; None where it does not."""

    @property
    def strike(self) -> Struck:
        """How the stream strikes it at the design point."""
        strike = self.strikes[DESIGN_POINT]
        assert strike is not None
        return strike


@dataclass(frozen=True)
class Placement:
    """A spec in which segments have been placed."""

    text: str
    """TOML text of the spec, comments kept."""
    segments: tuple[PlacedSegment, ...]
    """The placed segments in the order of the stream."""
    cases: Cases | None
    """The whole chute at its design point and in its cases; None while other segments have no place yet."""

    def __repr__(self) -> str:
        """Return where the segments start."""
        places = (f"{each.name} at ({each.start_m[0]:.6g}, {each.start_m[1]:.6g}) m" for each in self.segments)
        return f"<Placement of {', '.join(places)}>"


def place(
    spec: str | Mapping[str, Any] | Chute,
    wishes: Mapping[str, Mapping[str, float | str]],
    source: str = "spec",
    library: str | Path | Library | None = None,
) -> Placement:
    """Place segments so that the stream strikes them as wanted.

    The stream before each segment is solved; from there it flies on a parabola. Place and incidence give the slope of
    the surface where it is struck, and a share of the segment's length gives its start. What a spec lacks for that,
    ``start_m`` and a slope, may be missing in it.

    Args:
        spec: a chute of one design, TOML text of a spec, or its tables.
        wishes: for each segment, by name or number from 1: ``incidence`` (degrees), ``x`` or ``z`` (m), and ``share``,
            in other units as ``x_ft``. Incidence and place together change its slope. With one of them alone the slope
            stays as it is. The share ``"edges"`` is the least with which all edges of the stream strike the segment, at
            the design point and in each case; ``"edges+0.05"`` is that with a margin.
        source: name of the spec in messages.
        library: of materials and liners that the spec may use, or its file; a chute has its own.

    Raises:
        UsageError: a wish cannot be had. The message says what is the nearest that can.
        SpecError: the spec has faults, its cases and uncertainty among them if all segments have places then.

    >>> import chutecalc
    >>> placement = place(chutecalc.STARTER, {"spoon": {"incidence": 10, "z": -2}})
    >>> placement
    <Placement of spoon at (0, -2) m>
    >>> placement.segments[0].slopes, round(placement.segments[0].strike.incidence_deg, 9)
    ({'from_slope_deg': 80.0}, 10.0)
    """
    text, source = _text_of(spec, source)
    given = library_for(parse_text(text, source), spec.library if isinstance(spec, Chute) else library)
    original, placed = text, []
    for name, wanted in _in_order(parse_text(text, source), wishes, source):
        data = parse_text(text, source)
        number, wish = item_names(data["segments"]).index(name), read_wish(name, wanted)
        _check_before(data["segments"], number, name, source)
        try:
            drawn = Attempt(data, number, launch_to(data, number, source, given), wish, source, given).drawn()
        except (NotReachedError, UsageError) as error:
            raise UsageError(f"{source}: {name} cannot be placed so: {error}") from None
        text = frozen_text(text, {number: Drawn(drawn.start, drawn.slopes)})
        table = data["segments"][number]
        ends = angle_of(table, ENDS)
        shape = table["kind"], drawn.start, drawn.slopes, None if ends is None else degrees(ends)
        placed.append(PlacedSegment(name, *shape, {DESIGN_POINT: drawn.struck}))
    data = parse_text(text, source)
    names = item_names(data["segments"])
    if any(lacks_place(data["segments"], number) for number in range(len(names))):
        return Placement(text, tuple(placed), None)
    cases = solve_cases(checked(Chute(data, source, original, library=given)))
    for each in placed:
        for state, solution in cases.solutions.items():
            each.strikes.setdefault(state, struck_by(solution, names.index(each.name)))
    return Placement(text, tuple(placed), cases)


def _text_of(spec: str | Mapping[str, Any] | Chute, source: str) -> tuple[str, str]:
    """Return the TOML text of a spec and its name.

    Raises:
        UsageError: it is none of these, or a chute of several designs.
        SpecError: the tables have too much in them.
    """
    if isinstance(spec, str):
        return spec, source
    if isinstance(spec, Chute):
        if spec.count != 1:
            raise UsageError(f"place takes a chute of one design, not {spec.count}")
        return text_of(spec), spec.source
    if not isinstance(spec, Mapping):
        raise UsageError(f"place takes TOML text, a table or a chute, not {short(spec)}")
    if fault := excess_of_tables(spec):
        raise SpecError([fault], source)
    return tomli_w.dumps(dict(spec)), source


def _in_order(
    data: dict[str, Any], wishes: Mapping[str, Mapping[str, float | str]], source: str
) -> list[tuple[str, Mapping[str, float | str]]]:
    """Return names of segments with their wishes, in the order of the stream.

    Raises:
        UsageError: there is no such segment, it cannot be placed, or there are no wishes.
    """
    tables = data.get("segments")
    if not wishes or not isinstance(wishes, Mapping):
        raise UsageError("place takes segments with their wishes, such as hood incidence=10 x=1.2")
    if not isinstance(tables, list) or not all(isinstance(table, dict) for table in tables):
        raise UsageError(f"{source}: the spec has no [[segments]]")
    names, found = item_names(tables), {}
    for name, given in wishes.items():
        number = int(name) - 1 if is_number(name) else names.index(name) if name in names else -1
        if not 0 <= number < len(names):
            raise UsageError(f"{source}: there is no segment {name}. Use {', '.join(filter(None, names))}.")
        kind = tables[number].get("kind")
        if kind not in KINDS or not KINDS[kind].guides:
            raise UsageError(f"{source}: {name} is of kind {kind} and has no surface to be struck. Place what guides.")
        if number and tables[number - 1].get("kind") != FALL:
            remedy = f'add [[segments]] with kind = "{FALL}" and onto_next = true before {name}'
            raise UsageError(f"{source}: {name} follows {names[number - 1]} without a flight between: {remedy}.")
        if number in found:
            raise UsageError(f"{source}: {names[number]} is given twice, also as {name}: give all its wishes together")
        found[number] = names[number], given
    return [found[number] for number in sorted(found)]


def _check_before(tables: list[dict[str, Any]], number: int, name: str, source: str) -> None:
    """Check that the segments before one have places.

    Raises:
        UsageError: one has not.
    """
    for before in range(number):
        if lacks_place(tables, before):
            other = item_names(tables)[before]
            raise UsageError(
                f"{source}: {other}, which stands before {name}, has no place yet. Place both in one command:"
                f" {other} with its wishes, then {name} with its own"
            )
