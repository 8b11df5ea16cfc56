"""Designs as the compiled chain reads them: its records, and a row of numbers each."""

from functools import cache
from typing import NamedTuple

import numpy as np

from chutecalc.core import floats, records, section, slide, state
from chutecalc.design import Contact, Design, Fall
from chutecalc.physics.arrays import Array
from chutecalc.physics.wetting import numbers_of as section_numbers
from chutecalc.physics.wetting import records as records_of


def course_of(design: Design, panels: int, legs: int, again: int) -> records.Course:
    """Records of a chute's kind.

    Args:
        design: the chute.
        panels, legs: room for so many.
        again: number of the segment from which on its designs differ.
    """
    log = state.Log(panels)
    following: records.Segment | None = None
    differing: records.Segment | None = None
    last = len(design.segments) - 1
    own = state.Stream(slide.Slide(_no_facets(), section.Section(0, True), None, 1), log)  # what a fall has
    for number in range(last, -1, -1):
        drawn = design.segments[number]
        if isinstance(drawn, Contact):
            own = stream_of(drawn, design, log)
        segment = records.Segment(number, number == last, own, following)
        segment.fall, segment.plate = isinstance(drawn, Fall), drawn.kind == "plate"
        following = segment
        differing = segment if number == again else differing
    assert following is not None
    assert differing is not None
    return records.Course(following, differing, legs)


def stream_of(contact: Contact, design: Design, log: state.Log) -> state.Stream:
    """A stream of a segment's kind."""
    first, facets = records_of(contact.section)
    last = None if contact.end_section is None else records_of(contact.end_section)[0]
    way = slide.Slide(facets, first, last, len(contact.wall.starts))
    way.equilibrium, way.side = design.equilibrium, contact.side
    return state.Stream(way, log)


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
    columns: list[Array | float] = [design.density, design.gravity, design.volume_rate, design.vertical_ratio]
    columns += [*design.inlet_place, design.inlet_velocity, design.inlet_slope]
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
    lengths = [1 if isinstance(column, float) else len(column) for column in columns]
    count = max(lengths)
    if count == 1:
        rows = np.array([[float(column if isinstance(column, float) else column[0]) for column in columns]])
        return Numbers(rows, starts, 0)
    rows = np.empty((count, len(columns)))
    for number, column in enumerate(columns):
        rows[:, number] = column
    varied = next(number for number, size in enumerate(lengths) if size > 1)
    again = max(sum(begin <= varied for begin in begins) - 1, 0)
    before = design.segments[again - 1]
    if again and isinstance(before, Fall) and before.onto_next:  # which ends where that begins
        again -= 1
    return Numbers(rows, starts, again)


def _or_nan(values: Array | None) -> Array | float:
    return np.nan if values is None else values


@cache
def _no_facets() -> section.Facets:
    return section.Facets(1, False, floats.zeros(1))
