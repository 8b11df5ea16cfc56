"""Places segments of a spec one after the other, and shows that the stream strikes each as wanted."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import degrees
from typing import Any

import numpy as np
import tomli_w

from chutecalc.api.chute import Chute
from chutecalc.api.solution import Solution
from chutecalc.api.solve import solve
from chutecalc.api.written import text_of
from chutecalc.design import Contact, Status
from chutecalc.errors import UsageError
from chutecalc.segments.registry import KINDS
from chutecalc.spec.frozen import FALL, Drawn, frozen_text
from chutecalc.spec.parse import parse_text
from chutecalc.spec.paths import is_number, item_names
from chutecalc.studies.place.approach import RTOL, arrival_on_last, chute_up_to, launch_to
from chutecalc.studies.place.stand import Stand, length_of, stand_for, start_of
from chutecalc.studies.place.strike import Launch, NotReachedError
from chutecalc.studies.place.wish import Wish, read_wish

CLOSE = 1e-9
"""Distance, m, and angle, rad, within which the stream strikes as wanted."""
GRAZING = 1e-4
"""Incidence, rad. A stream at i strikes 1/i further along for each unit that the surface is off, down to this one."""
HALVINGS = 40


@dataclass(frozen=True)
class PlacedSegment:
    """A segment where the stream strikes it as wanted."""

    name: str
    kind: str
    start_m: tuple[float, float]
    """x and z of its drawn start."""
    slopes: dict[str, float]
    """Its slope, or that at the start of an arc, degrees, by its key in the spec."""
    x_m: float
    """Where the middle of the stream strikes it: x,"""
    z_m: float
    """z,"""
    share: float
    """and share of its length from the start."""
    incidence_deg: float
    velocity_m_s: float
    """Velocity before the impact,"""
    velocity_after_m_s: float
    """and after it."""
    edges: dict[str, float]
    """Incidence of the other edges of the stream, degrees, by name (:class:`chutecalc.Edge`); NaN where one misses."""


@dataclass(frozen=True)
class Placement:
    """A spec in which segments have been placed."""

    text: str
    """TOML text of the spec, comments kept."""
    segments: tuple[PlacedSegment, ...]
    """The placed segments in the order of the stream."""

    def __repr__(self) -> str:
        """Return where the segments start."""
        places = (f"{each.name} at ({each.start_m[0]:.6g}, {each.start_m[1]:.6g}) m" for each in self.segments)
        return f"<Placement of {', '.join(places)}>"


def place(
    spec: str | Mapping[str, Any] | Chute, wishes: Mapping[str, Mapping[str, float]], source: str = "spec"
) -> Placement:
    """Place segments so that the stream strikes them as wanted.

    The stream before each segment is solved; from there it flies on a parabola. Place and incidence give the slope of
    the surface where it is struck, and a share of the segment's length gives its start. What a spec lacks for that,
    ``start_m`` and a slope, may be missing in it.

    Args:
        spec: a chute of one design, TOML text of a spec, or its tables.
        wishes: for each segment, by name or number from 1: ``incidence`` (degrees), ``x`` or ``z`` (m), and ``share``,
            in other units as ``x_ft``. Incidence and place together change its slope. With one of them alone the slope
            stays as it is.
        source: name of the spec in messages.

    Raises:
        UsageError: a wish cannot be had. The message says what is the nearest that can.
        SpecError: the spec has faults.

    >>> import chutecalc
    >>> placement = place(chutecalc.STARTER, {"spoon": {"incidence": 10, "z": -2}})
    >>> placement
    <Placement of spoon at (0, -2) m>
    >>> placement.segments[0].slopes, round(placement.segments[0].incidence_deg, 9)
    ({'from_slope_deg': 80.0}, 10.0)
    """
    text, source = _text_of(spec, source)
    data = parse_text(text, source)
    placed = []
    for name, given in _in_order(data, wishes, source):
        wish, number = read_wish(name, given), item_names(data["segments"]).index(name)
        try:
            one, stand = _placed(data, number, name, wish, source)
        except (NotReachedError, UsageError) as error:
            raise UsageError(f"{source}: {name} cannot be placed so: {error}") from None
        text = frozen_text(text, {number: Drawn(one.start_m, stand.slopes)})
        data = parse_text(text, source)
        placed.append(one)
    return Placement(text, tuple(placed))


def _text_of(spec: str | Mapping[str, Any] | Chute, source: str) -> tuple[str, str]:
    """Return the TOML text of a spec and its name."""
    if isinstance(spec, str):
        return spec, source
    if not isinstance(spec, Chute):
        return tomli_w.dumps(dict(spec)), source
    if spec.count != 1:
        raise UsageError(f"place takes a chute of one design, not {spec.count}")
    return text_of(spec), spec.source


def _in_order(
    data: dict[str, Any], wishes: Mapping[str, Mapping[str, float]], source: str
) -> list[tuple[str, Mapping[str, float]]]:
    """Return names of segments with their wishes, in the order of the stream.

    Raises:
        UsageError: there is no such segment, it cannot be placed, or there are no wishes.
    """
    tables = data.get("segments")
    if not wishes:
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
        found[number] = names[number], given
    return [found[number] for number in sorted(found)]


def _placed(data: dict[str, Any], number: int, name: str, wish: Wish, source: str) -> tuple[PlacedSegment, Stand]:
    """Return a segment where it is struck as wanted, and how it stands."""
    launch = launch_to(data, number, source)
    table = data["segments"][number]
    struck = _strike(data, number, launch, wish, source)
    if struck is None:
        raise NotReachedError(_nearest(data, number, launch, wish, source))
    stand, start, solution = struck
    arrival = arrival_on_last(solution)
    x, z = launch.at(stand.strike.time)
    last = len(solution.segments) - 1
    edges = {
        edge.name: edge.numbers["incidence_deg"].item() if edge.number.item() == last else np.nan
        for edge in solution.edges
        if edge.target.item() == last and edge.name != "middle"
    }
    return (
        PlacedSegment(
            name=name,
            kind=table["kind"],
            start_m=start,
            slopes=stand.slopes,
            x_m=x,
            z_m=z,
            share=arrival.share.item(),
            incidence_deg=degrees(arrival.incidence.item()),
            velocity_m_s=arrival.velocity.item(),
            velocity_after_m_s=arrival.impact.velocity_after.item(),
            edges=edges,
        ),
        stand,
    )


def _strike(
    data: dict[str, Any], number: int, launch: Launch, wish: Wish, source: str
) -> tuple[Stand, tuple[float, float], Solution] | None:
    """Return how a segment stands, its start and the solution up to it; None if the stream strikes it otherwise."""
    stand = stand_for(launch, data["segments"][number], wish)
    table = data["segments"][number] | stand.slopes
    segment = chute_up_to(data, number, table | {"start_m": [0.0, 0.0]}, source).design.segments[-1]
    assert isinstance(segment, Contact)
    start = start_of(segment, launch, stand, wish.share)
    solution = solve(chute_up_to(data, number, table | {"start_m": list(start)}, source), RTOL)
    arrival = arrival_on_last(solution)
    incidence = segment.side * (launch.slope_at(stand.strike.time) - stand.strike.slope)
    along = abs(arrival.share.item() - wish.share) * length_of(segment).item()
    off = along * max(incidence, GRAZING), abs(arrival.incidence.item() - incidence)
    meets = arrival.status.item() <= Status.STALL and max(off) <= CLOSE
    return (stand, start, solution) if meets else None


def _nearest(data: dict[str, Any], number: int, launch: Launch, wish: Wish, source: str) -> str:
    """Return why a share cannot be had, with the greatest that can, found by halving."""
    low, high, elsewhere = 0.0, wish.share, "the stream would meet it elsewhere first, or from behind"

    def works(share: float) -> bool:
        own = Wish(wish.incidence_deg, wish.x_m, wish.z_m, share)
        try:
            return _strike(data, number, launch, own, source) is not None
        except NotReachedError:
            return False

    if not works(low):
        return f"{elsewhere}, wherever it begins. Change its slopes or radius"
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if works(middle) else (low, middle)
    return f"{elsewhere}; the nearest is a share of {low:.6g} of its length before the strike"
