"""One contact segment for many designs: their numbers into rows, the compiled solver along them, and what it found."""

from array import array
from functools import cache
from typing import NamedTuple

import numpy as np

from chutecalc.core import batch, dense, designs, gauss, march, section, state
from chutecalc.core.slide import Slide as Way
from chutecalc.design import Status
from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.circle import series
from chutecalc.physics.section import Circle, Section
from chutecalc.solver.collocation import rule, transfer
from chutecalc.solver.slide import Slide

NEAR_REST = (16, 24)  # the rules of a panel in r: on fewer nodes it is taken half as often
ROOM = 64  # panels kept before more room is asked for


class Effort(NamedTuple):
    """How hard to work."""

    whole: tuple[tuple[int, int], tuple[int, int]]
    """Pairs of rules for the whole stretch in one panel, the second for designs that the first does not solve."""
    later: tuple[int, int]
    """For panels of those that neither solves."""
    tolerance: float
    """Error that one panel over the whole stretch may have, relative in v²."""
    share: float
    """The same of each of several panels (in r: of the way): their errors add up, and near a stop they grow."""
    inner_tolerance: float
    """The same between the ends of a panel, where errors are shown but not handed on."""
    complete: bool
    """Keep the panels, right at every place and not at the ends alone; go on past a choke."""


def effort(rtol: float, complete: bool) -> Effort:
    """What it takes to have velocities right within a relative error."""
    first = (6, 8) if rtol >= 1e-7 else (6, 12) if rtol >= 1e-9 else (8, 16)
    whole, later = (((8, 24), (16, 24)), (8, 24)) if complete else ((first, (16, 24)), (8, 16))
    return Effort(whole, later, rtol, max(1e-3 * rtol, 3e-15), rtol, complete)


class Panels:
    """The panels of n designs along a segment, those of a design one after the other."""

    def __init__(self, slide: Slide, numbers: Array, kept: Array, count: Index) -> None:
        self.slide, self.numbers, self.kept, self.count = slide, numbers, kept.ravel(), np.ascontiguousarray(count)
        self.first = np.cumsum(count) - count

    def of(self, design: int) -> Array:
        """A design's panels, a row each: 1 in r, nodes, facet, piece, start and end in c or r, the knots of y or c."""
        first = self.first[design]
        return self.kept.reshape(-1, state.PANEL)[first : first + self.count[design]]

    def velocities(self, places: Array, out: Array) -> None:
        """v² at places, shape (places, designs); where no panel is, what stands there stays."""
        assert places.shape == out.shape == (len(places), len(self.count))  # the compiled loop does not look
        dense.velocities(self.kept, self.first, self.count, self._rules, places, out)

    def times(self, places: Array, out: Array) -> None:
        """Seconds since the contact began, likewise."""
        assert places.shape == out.shape == (len(places), len(self.count))
        stream = _stream(self.slide, 0)
        dense.times(stream, self.numbers, self.kept, self.first, self.count, self._rules, places, out)

    def knots(self) -> Array:
        """Places of the panels' knots after their starts, shape (knots, designs); NaN for what a design has too few."""
        sizes = self.kept.reshape(-1, state.PANEL)[:, 1].astype(np.intp) + 1
        ends = np.concatenate([np.zeros(1, dtype=np.intp), np.cumsum(sizes)])
        counts = ends[self.first + self.count] - ends[self.first]
        places = np.full((max(counts.max(initial=0), 1), len(counts)), np.nan)
        dense.knot_places(self.kept, self.first, self.count, self._rules, places)
        return places

    @property
    def _rules(self) -> dict[int, gauss.Rule]:
        return {
            count: compiled_rule(count) for count in set(self.kept.reshape(-1, state.PANEL)[:, 1].astype(int).tolist())
        }


class Stretch(NamedTuple):
    """What became of the designs on a segment, an entry each."""

    status: Index
    place: Array
    """c where the stretch ends."""
    velocity_squared: Array
    error: Array
    """Relative, of v²; after a stall, of the place in c."""
    beyond: Array
    """After a choke: c where the stream would end on the segment between higher walls; NaN else."""
    beyond_status: Index
    """After a choke: how it would end there."""
    tried: Index
    """Panels solved, also such as were refused."""
    panels: Panels | None
    """Those taken, where they are kept."""

    @classmethod
    def standing(cls, place: Array, velocity_squared: Array, error: Array) -> "Stretch":
        """Designs that go no way on the segment, and are well."""
        status = np.full(place.shape, Status.OK)
        none, tried = np.full(place.shape, np.nan), np.zeros(place.shape, dtype=np.intp)
        return cls(status, place, velocity_squared, error, none, status, tried, None)


def solve_stretch(slide: Slide, place: Array, velocity_squared: Array, error: Array, effort: Effort) -> Stretch:
    """Carries n streams along one contact segment.

    Args:
        slide: the segment and the flow.
        place: c where each stream meets the segment, in [0, 1), shape (n,).
        velocity_squared: y there, m²/s², positive, shape (n,).
        error: its relative error, shape (n,).
        effort: how hard to work.

    Returns:
        How and where each ended. Statuses are those of :class:`~chutecalc.design.Status`.

    Raises:
        RuntimeError: a stretch took more than 2000 panels: a fault of the solver, not of the chute.
    """
    if not place.size:
        return Stretch.standing(place, velocity_squared, error)
    numbers = _numbers(slide, place, velocity_squared, error)
    results, kept = _solved(slide, numbers, effort)
    status, tried, count = results[:, [0, 7, 8]].T.astype(np.intp)
    if (status == state.GAVE_UP).any():
        raise RuntimeError(f"a contact segment was not solved in {march.MOST} panels")
    ends, choke = results[:, 1:4].T, results[:, 4:7].T
    choked = ~np.isnan(choke[0])
    panels = Panels(slide, numbers, kept, count) if effort.complete else None
    there, y, off = (np.where(choked, *pair) for pair in zip(choke, ends, strict=True))
    outcome = np.where(choked, Status.CHOKE, status)
    return Stretch(outcome, there, y, off, np.where(choked, ends[0], np.nan), status, tried, panels)


def _numbers(slide: Slide, place: Array, velocity_squared: Array, error: Array) -> Array:
    """A row for each design, as :func:`chutecalc.core.batch.solve_rows` reads it."""
    columns: list[Array | float] = [slide.side, slide.gravity, slide.entry_slope, slide.turn, slide.length]
    columns += [slide.flow, slide.density, slide.vertical_ratio, place, velocity_squared, error]
    for piece in zip(*slide.wall, strict=True):
        columns += piece
    for drawn in (slide.section, slide.end_section):
        if isinstance(drawn, Circle):
            columns += [drawn.wall_height, drawn.radius]
        elif drawn is not None:
            columns += [drawn.wall_height, drawn.base]
            for wall in zip(drawn.lengths, drawn.inclinations, strict=True):
                columns += wall
    numbers = np.empty((len(place), len(columns)))
    for number, column in enumerate(columns):
        numbers[:, number] = column
    return numbers


def _solved(slide: Slide, numbers: Array, effort: Effort) -> tuple[Array, Array]:
    """Results by row, and the panels kept, a row each."""
    results = np.empty((len(numbers), batch.RESULTS))
    work, room, done = _work(effort), ROOM if effort.complete else 0, 0
    kept = [np.empty((0, state.PANEL))]
    while done < len(numbers):
        stream = _stream(slide, room)
        before, done = done, designs.solve(stream, work, numbers, results, done, len(numbers))
        if effort.complete:
            kept.append(np.array(stream.kept)[: stream.panels * state.PANEL].reshape(-1, state.PANEL))
        room = max(16 * ROOM, 2 * room if done == before else room)
    return results, np.concatenate(kept)


def _stream(slide: Slide, room: int) -> state.Stream:
    """A stream of the segment's kind, with room for so many panels."""
    first, count = _section(slide.section), len(slide.drawn.area)
    last = None if slide.end_section is None else _section(slide.end_section)
    own = section.Facets(count, first.circle, _series() if first.circle else array("d", [0.0]))
    way = Way(own, first, last, len(slide.wall.starts))
    way.equilibrium = slide.equilibrium
    return state.Stream(way, room)


def _section(drawn: Section) -> section.Section:
    """The compiled solver's own record of a section."""
    return section.Section(0, True) if isinstance(drawn, Circle) else section.Section(len(drawn.lengths), False)


@cache
def _series() -> "array[float]":
    return array("d", series().ravel().tolist())


@cache
def compiled_rule(count: int) -> gauss.Rule:
    """The rule of so many nodes as the compiled solver holds it."""
    own = rule(count)
    columns = np.ascontiguousarray(own.integral.T).ravel().tolist()
    return gauss.Rule(count, own.knots.tolist(), own.weights.tolist(), columns)


@cache
def _pair(coarse: int, fine: int) -> gauss.Pair:
    columns = np.ascontiguousarray(transfer(coarse, fine).T).ravel().tolist()
    return gauss.Pair(compiled_rule(coarse), compiled_rule(fine), columns)


@cache
def _work(effort: Effort) -> state.Effort:
    work = state.Effort(*(_pair(*pair) for pair in (*effort.whole, effort.later, NEAR_REST)))
    work.tolerance, work.share, work.inner_tolerance = effort.tolerance, effort.share, effort.inner_tolerance
    work.complete = effort.complete
    return work
