"""Designs as the compiled chain reads them: its records, and a row of numbers each."""

from collections import defaultdict
from functools import cache, lru_cache
from threading import get_ident
from typing import NamedTuple

import numpy as np

from chutecalc.core import floats, records, section, slide, state
from chutecalc.design import Contact, Design, Fall
from chutecalc.physics.arrays import Array
from chutecalc.physics.wetting import Kind as SectionKind
from chutecalc.physics.wetting import kind_of, records_of
from chutecalc.physics.wetting import numbers_of as section_numbers


class Kind(NamedTuple):
    """What records a segment takes, whatever its numbers are."""

    fall: bool
    plate: bool = False
    side: float = 1.0
    equilibrium: bool = False
    pieces: int = 1
    first: SectionKind = SectionKind(circle=True, walls=0, facets=1)
    last: SectionKind | None = None


Kinds = tuple[Kind, ...]
_NO_ROOM, _NO_ENDS, _NO_TABLES = floats.zeros(1), np.empty((1, 1)), np.empty((1, 1, 1))
_FREE: defaultdict[Kinds, list[records.Course]] = defaultdict(list)
"""Records that nobody uses now: making them takes longer than a solution."""


def kinds_of(design: Design) -> Kinds:
    """Of its segments."""
    return tuple(_kind(segment, design) if isinstance(segment, Contact) else Kind(True) for segment in design.segments)


def _kind(contact: Contact, design: Design) -> Kind:
    first, last = kind_of(contact.section), contact.end_section and kind_of(contact.end_section)
    pieces = len(contact.wall.starts)
    return Kind(False, contact.deflects, contact.side, design.equilibrium, pieces, first, last)


def take(kinds: Kinds) -> records.Course:
    """Records of a chute, to be given back."""
    free = _FREE[kinds]
    try:
        return free.pop()
    except IndexError:
        return _course(kinds)


def give_back(kinds: Kinds, course: records.Course) -> None:
    """Has another solution use them; what this one's user was given goes with the user."""
    course.ends, course.lying, course.pressing = _NO_ENDS, _NO_TABLES, _NO_TABLES
    _FREE[kinds].append(course)


def shrink(course: records.Course) -> None:
    """Lets go of the room for what a solution keeps."""
    course.legs, course.room = _NO_ROOM, 0
    course.first.own.log.kept, course.first.own.log.room = _NO_ROOM, 0


def _course(kinds: Kinds) -> records.Course:
    log, following, last = state.Log(0), None, None
    own = state.Stream(slide.Slide(_no_facets(), section.Section(0, True), None, 1), log)  # what a fall has
    for number in range(len(kinds) - 1, -1, -1):
        kind = kinds[number]
        own = own if kind.fall else state.Stream(_slide(kind), log)
        segment = records.Segment(number, following is None, own, following)
        segment.fall, segment.plate = kind.fall, kind.plate
        following, last = segment, last or segment
    assert following is not None
    assert last is not None
    return records.Course(following, last)


def _slide(kind: Kind) -> slide.Slide:
    first, facets = records_of(kind.first)
    last = None if kind.last is None else records_of(kind.last)[0]
    way = slide.Slide(facets, first, last, kind.pieces)
    way.equilibrium, way.side = kind.equilibrium, kind.side
    return way


def stream_of(kind: Kind) -> state.Stream:
    """A stream of a segment's kind to look at solved ones with; each thread has its own."""
    return _stream(kind, get_ident())


@lru_cache(maxsize=128)
def _stream(kind: Kind, thread: int) -> state.Stream:
    return state.Stream(_slide(kind), state.Log(0))


class Numbers(NamedTuple):
    """Designs in numbers."""

    rows: Array
    """A row for each, as :func:`chutecalc.core.batch.solve_rows` reads it; one, where they differ in nothing."""
    starts: list[int]
    """Where each segment's wall begins."""
    again: int
    """Number of the segment from which on they differ."""


def numbers_of(design: Design) -> Numbers:
    """The numbers of designs."""
    columns, starts, begins = columns_of(design)
    lengths = [1 if isinstance(column, float) else len(column) for column in columns]
    count = max(lengths)
    rows = np.empty((count, len(columns)))
    if count == 1:
        rows[0] = [column if isinstance(column, float) else column.item() for column in columns]
        return Numbers(rows, starts, 0)
    for number, column in enumerate(columns):
        rows[:, number] = column
    return Numbers(rows, starts, again_at(design, begins, next(k for k, size in enumerate(lengths) if size > 1)))


def columns_of(design: Design) -> tuple[list[Array | float], list[int], list[int]]:
    """The numbers of a row; where each segment's wall begins among them, and where each segment does."""
    columns: list[Array | float] = [design.density, design.gravity, design.volume_rate, design.vertical_ratio]
    columns += [*design.inlet_position, design.inlet_velocity, design.inlet_slope]
    starts, begins = [], []
    for segment in design.segments:
        begins.append(len(columns))
        if isinstance(segment, Fall):
            columns += [_or_nan(segment.drop), _or_nan(segment.run)]
            starts.append(len(columns))
            continue
        columns += segment.start or (np.nan, np.nan)
        columns += [_or_nan(segment.entry_slope), segment.exit_slope, _or_nan(segment.radius), _or_nan(segment.length)]
        starts.append(len(columns))
        for piece in zip(*segment.wall, strict=True):
            columns += piece
        columns += section_numbers(segment.section)
        columns += [] if segment.end_section is None else section_numbers(segment.end_section)
    return columns, starts, begins


def again_at(design: Design, begins: list[int], first: int) -> int:
    """The segment from which on designs differ, whose numbers do from that one on.

    A fall that ends on the next segment is another one where that differs.
    """
    segment = max(sum(begin <= first for begin in begins) - 1, 0)
    before = design.segments[segment - 1]
    return segment - 1 if segment and isinstance(before, Fall) and before.onto_next else segment


def _or_nan(values: Array | None) -> Array | float:
    return np.nan if values is None else values


@cache
def _no_facets() -> section.Facets:
    return section.Facets(1, False, floats.zeros(1))
