"""Translate designs for the compiled core: the layout of its records, and a row of numbers for each design."""

from collections import defaultdict
from functools import cache, lru_cache
from threading import get_ident
from typing import NamedTuple

import numpy as np

from chutecalc.core import floats, guide_surface, records, section, state
from chutecalc.design import Contact, Design, Fall
from chutecalc.physics.arrays import Array
from chutecalc.physics.wetting import Kind as SectionKind
from chutecalc.physics.wetting import kind_of, records_of
from chutecalc.physics.wetting import numbers_of as section_numbers


class SegmentLayout(NamedTuple):
    """What decides the layout of a segment's records, whatever its numbers."""

    fall: bool
    plate: bool = False
    may_be_passed: bool = False
    closed: bool = False
    side: float = 1.0
    equilibrium: bool = False
    pieces: int = 1
    first: SectionKind = SectionKind(circle=True, walls=0, facets=1)
    last: SectionKind | None = None


ChuteLayout = tuple[SegmentLayout, ...]
_NO_BUFFER, _NO_ENDS, _NO_TABLES = floats.zeros(1), np.empty((1, 1)), np.empty((1, 1, 1))
_FREE: defaultdict[ChuteLayout, list[records.ChuteState]] = defaultdict(list)
"""States that are not in use; making one takes longer than solving a chute."""


def layout_of(design: Design) -> ChuteLayout:
    """Return the layout of a design's segments.

    Args:
        design: the chute.
    """
    return tuple(
        _segment_layout(segment, design) if isinstance(segment, Contact) else SegmentLayout(fall=True)
        for segment in design.segments
    )


def _segment_layout(contact: Contact, design: Design) -> SegmentLayout:
    first, last = kind_of(contact.section), contact.end_section and kind_of(contact.end_section)
    return SegmentLayout(
        fall=False,
        plate=contact.deflects,
        may_be_passed=contact.may_be_passed,
        closed=contact.closed,
        side=contact.side,
        equilibrium=design.equilibrium,
        pieces=len(contact.wall.starts),
        first=first,
        last=last,
    )


def borrow_state(layout: ChuteLayout) -> records.ChuteState:
    """Return a state for chutes of a layout, to be given back by :func:`return_state`.

    Args:
        layout: of the chute.
    """
    free = _FREE[layout]
    try:
        return free.pop()
    except IndexError:
        return _make_chute_state(layout)


def return_state(layout: ChuteLayout, chute: records.ChuteState) -> None:
    """Give back a state; the tables that it has filled belong to whoever borrowed it.

    Args:
        layout: of the chute.
        chute: its state.
    """
    chute.ends, chute.stream_section, chute.wall_loads = _NO_ENDS, _NO_TABLES, _NO_TABLES
    _FREE[layout].append(chute)


def free_buffers(chute: records.ChuteState) -> None:
    """Release the buffers of a state for solutions and panels.

    Args:
        chute: the state.
    """
    chute.solutions, chute.capacity = _NO_BUFFER, 0
    chute.first.stream.store.panels, chute.first.stream.store.capacity = _NO_BUFFER, 0


def _make_chute_state(layout: ChuteLayout) -> records.ChuteState:
    store, next_segment, last = state.PanelStore(0), None, None
    # A fall shares the stream of the segment after it; where none follows, this one.
    guide = guide_surface.Guide(_no_facets(), section.Section(walls=0, circle=True), last=None, pieces=1)
    stream = state.Stream(guide, store)
    for number in range(len(layout) - 1, -1, -1):
        segment_layout = layout[number]
        stream = stream if segment_layout.fall else state.Stream(_make_guide(segment_layout), store)
        segment = records.Segment(number, last=next_segment is None, stream=stream, next_segment=next_segment)
        segment.fall, segment.plate = segment_layout.fall, segment_layout.plate
        segment.may_be_passed, segment.closed = segment_layout.may_be_passed, segment_layout.closed
        if segment.closed:
            segment.roof = state.Stream(_make_guide(segment_layout), store)
            segment.roof.guide.side = -segment_layout.side
        next_segment, last = segment, last or segment
    assert next_segment is not None
    assert last is not None
    return records.ChuteState(next_segment, last)


def _make_guide(segment_layout: SegmentLayout) -> guide_surface.Guide:
    first, facets = records_of(segment_layout.first)
    last = None if segment_layout.last is None else records_of(segment_layout.last)[0]
    guide = guide_surface.Guide(facets, first=first, last=last, pieces=segment_layout.pieces)
    guide.equilibrium, guide.side = segment_layout.equilibrium, segment_layout.side
    return guide


def stream_for(segment_layout: SegmentLayout) -> state.Stream:
    """Return a stream with which solved segments of a layout can be evaluated; each thread has its own.

    Args:
        segment_layout: of the segment.
    """
    return _stream(segment_layout, get_ident())


@lru_cache(maxsize=128)
def _stream(segment_layout: SegmentLayout, thread: int) -> state.Stream:
    return state.Stream(_make_guide(segment_layout), state.PanelStore(0))


class DesignRows(NamedTuple):
    """Designs as rows of numbers."""

    rows: Array
    """A row for each design as :func:`chutecalc.core.batch.solve_rows` reads it; a single one where no number
    varies."""
    wall_offsets: list[int]
    """Offset of each segment's wall in a row."""
    first_varied: int
    """Number of the first segment in which designs differ, from 0."""


def design_rows(design: Design) -> DesignRows:
    """Return designs as rows of numbers.

    Args:
        design: the chute; its numbers are arrays of length 1 or n.
    """
    columns, wall_offsets, segment_offsets = row_columns(design)
    lengths = [1 if isinstance(column, float) else len(column) for column in columns]
    count = max(lengths)
    rows = np.empty((count, len(columns)))
    if count == 1:
        rows[0] = [column if isinstance(column, float) else column.item() for column in columns]
        return DesignRows(rows, wall_offsets, 0)
    for number, column in enumerate(columns):
        rows[:, number] = column
    return DesignRows(
        rows,
        wall_offsets,
        first_varied_segment(design, segment_offsets, next(k for k, size in enumerate(lengths) if size > 1)),
    )


def row_columns(design: Design) -> tuple[list[Array | float], list[int], list[int]]:
    """Return the columns of the rows.

    Args:
        design: the chute.

    Returns:
        The columns, each a number or an array of length 1 or n; the offset of each segment's wall; and of each segment.
    """
    columns: list[Array | float] = [design.density, design.gravity, design.volume_rate, design.vertical_ratio]
    columns += [design.momentum_factor, design.longitudinal_ratio]
    columns += [*design.inlet_position, design.inlet_velocity, design.inlet_slope]
    wall_offsets, segment_offsets = [], []
    for segment in design.segments:
        segment_offsets.append(len(columns))
        columns += segment.start or (np.nan, np.nan)
        if isinstance(segment, Fall):
            columns += [_or_nan(segment.drop), _or_nan(segment.run)]
            wall_offsets.append(len(columns))
            continue
        columns += [_or_nan(segment.entry_slope), segment.exit_slope, _or_nan(segment.radius), _or_nan(segment.length)]
        wall_offsets.append(len(columns))
        for piece in zip(*segment.wall, strict=True):
            columns += piece
        columns += section_numbers(segment.section)
        columns += [] if segment.end_section is None else section_numbers(segment.end_section)
    belt = design.receiver
    columns += (np.nan,) * 3 if belt is None or belt.at is None else (*belt.at, belt.slope_of_trace)
    return columns, wall_offsets, segment_offsets


def first_varied_segment(design: Design, segment_offsets: list[int], first: int) -> int:
    """Return the number of the first segment in which designs differ.

    A fall that ends where it meets the next segment differs where that one does.

    Args:
        design: the chute.
        segment_offsets: of each segment in a row.
        first: the first column that varies.
    """
    segment = max(sum(begin <= first for begin in segment_offsets) - 1, 0)
    before, here = design.segments[segment - 1], design.segments[segment]
    lands = isinstance(before, Fall) and isinstance(here, Contact) and here.start is not None
    return segment - 1 if segment and lands else segment


def _or_nan(values: Array | None) -> Array | float:
    return np.nan if values is None else values


@cache
def _no_facets() -> section.Facets:
    return section.Facets(count=1, circle=False, series=floats.zeros(1))
