"""Designs through their chutes: rows of numbers to the compiled chain, and the legs that it found as arrays."""

import numpy as np

from chutecalc.core import designs, march, records, state, walls
from chutecalc.core.answer import Answer
from chutecalc.core.replay import Recipe
from chutecalc.design import Contact, Design, Status
from chutecalc.errors import Fault, SpecError
from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.motion import ROOF
from chutecalc.solver.course import Kinds, Numbers, give_back, kinds_of, numbers_of, shrink, take
from chutecalc.solver.effort import effort
from chutecalc.solver.leg import AT, ContactLeg, Ends, Leg, columns, whole
from chutecalc.solver.panels import Panels, Way

ROOM = 32
"""Panels, and legs, kept of a chute before more room is asked for."""


def run_chain(design: Design, rtol: float, complete: bool = True) -> tuple[list[Leg], Ends]:
    """Solves a chute, or n of them.

    Args:
        design: the chute.
        rtol: relative error allowed to the velocity.
        complete: keep what it takes to tell the stream at every place; without it only the ends of segments are known.

    Returns:
        The legs in order, one or more a segment, and how each design ends.

    Raises:
        SpecError: a hood that is drawn tangent to a falling stream does not steepen from there, or a curve does not
            turn.
        RuntimeError: a segment took more than 2000 panels: a fault of the solver, not of the chute.
    """
    chain = Chain(design, effort(rtol, complete))
    return chain.legs(), chain.ends


def run_ends(kinds: Kinds, numbers: Numbers, rtol: float, lying: bool = False, pressing: bool = False) -> Ends:
    """The same for the ends alone.

    Args:
        kinds, numbers: of the designs.
        rtol: as of :func:`run_chain`.
        lying, pressing: whether the tables of that name are asked for.
    """
    course = take(kinds)
    tables = begin(course, numbers, lying, pressing)
    course.ends_only = True
    if designs.solve(course, effort(rtol, False), numbers.rows, 0, len(numbers.rows)) < len(numbers.rows):
        raise RuntimeError(NOT_SOLVED)
    faults = course.faults
    give_back(kinds, course)
    return told(kinds, faults, *tables)


def answer_of(kinds: Kinds, recipe: Recipe, work: state.Effort, lying: bool, pressing: bool) -> Answer:
    """What answers for one design after the other, with records of its own."""
    numbers, course = np.empty((1, len(recipe.taken))), take(kinds)
    begin(course, Numbers(numbers, [], 0), lying, pressing)
    course.ends_only = True
    return Answer(recipe, course, work, np.empty((1, recipe.varied)), numbers)


NOT_SOLVED = f"a contact segment was not solved in {march.MOST} panels"
Tables = tuple[Array, Array, Array]
NOT_ASKED = np.empty(0)


def begin(course: records.Course, numbers: Numbers, lying: bool, pressing: bool) -> Tables:
    """Has records ready for so many designs, and tells the tables that they will fill."""
    count = len(numbers.rows)
    course.faults, course.tells_lying, course.tells_pressing = 0, lying, pressing
    course.ends = ends = np.empty((len(records.ENDS), count))
    lies = presses = NOT_ASKED
    if lying:
        course.lying = lies = np.empty((walls.LIE, 1, count))
    if pressing:
        course.pressing = presses = np.empty((walls.PRESS, 1, count))
    course.again = course.first
    while course.again.number < numbers.again:
        course.again = course.again.next
    return ends, lies, presses


def told(kinds: Kinds, faults: int, ends: Array, lying: Array, pressing: Array) -> Ends:
    """How designs end.

    Raises:
        SpecError: some have curves that are not tangent to the stream that falls into them.
    """
    if faults:
        refused = ends[0] == state.NOT_TANGENT
        row = int(refused.argmax())
        at, slope = int(ends[4, row]), np.degrees(ends[6, row])
        what = "a roof has to steepen" if kinds[at].side == ROOF else "an arc has to turn"
        problem = f"{what}, and the stream falls into this one at {slope:.6g}°"
        fault = Fault(f"segments.{at + 1}.to_slope_deg", problem, "change it, or give from_slope_deg")
        raise SpecError([fault], designs=refused)
    return Ends(ends[0].astype(np.intp), ends[1], ends[2], ends[3], ends[4], ends[5], ends[6], lying, pressing)


class Chain:
    """Designs, and what the compiled chain wrote down of them."""

    def __init__(self, design: Design, work: state.Effort) -> None:
        """Solves."""
        self.design, self.work, self.kinds, numbers = design, work, kinds_of(design), numbers_of(design)
        self.numbers, self.starts, self.again = numbers
        self.count = len(self.numbers)
        course = take(self.kinds)
        tables = begin(course, numbers, False, False)
        course.ends_only = False
        self.rows, self.kept = self._run(course, len(self.kinds) * self.count + ROOM)
        faults = course.faults
        shrink(course)
        give_back(self.kinds, course)
        self.ends = told(self.kinds, faults, *tables)

    def _run(self, course: records.Course, legs: int) -> tuple[Array, Array]:
        """Legs, a row each, and the panels kept, in one row; of one design after the other."""
        found, kept, log, done, panels = [], [], course.first.own.log, 0, legs if self.work.complete else 1
        while done < self.count:
            own_legs, own_panels = np.empty(records.NUMBERS * legs), np.empty(state.PANEL * panels)
            course.legs, course.room, course.count = own_legs, legs, 0
            log.kept, log.room, log.count = own_panels, panels, 0
            course.full = log.full = False
            before, done = done, designs.solve(course, self.work, self.numbers, done, self.count)
            found.append(own_legs[: course.count * records.NUMBERS])
            kept.append(own_panels[: log.count * state.PANEL])
            if done < self.count and not (course.full or log.full):
                raise RuntimeError(NOT_SOLVED)
            panels *= 2 if log.full and done == before else 1
            legs *= 2 if course.full and done == before else 1
        whole = found + kept if len(found) == 1 else (np.concatenate(found), np.concatenate(kept))
        return whole[0].reshape(-1, records.NUMBERS), whole[1]

    def legs(self) -> list[Leg]:
        """What became of the designs on each segment."""
        panels = self.rows[:, AT["panels"]].astype(np.intp)
        self.first = np.cumsum(panels) - panels
        number, strikes = self.rows[:, AT["segment"]], self.rows[:, AT["strikes"]]
        if len(self.rows) == len(self.kinds) and self.count == 1:  # each segment once
            return [self._leg(segment, self.rows, np.array([segment])) for segment in range(len(self.kinds))]
        legs: list[Leg] = []
        for segment in range(len(self.kinds)):
            of_segment = number == segment
            if segment < self.again:  # solved once, or once for each time that room was made
                of_segment &= self.rows[:, AT["row"]] == 0
            times = range(int(strikes[of_segment].max()) + 1)
            legs += [self._leg(segment, self.rows, np.flatnonzero(of_segment & (strikes == again))) for again in times]
        return legs

    def _leg(self, number: int, rows: Array, chosen: Index) -> Leg:
        """What designs did on a segment, from its rows; what others did not do is left open."""
        own, segment, count = rows[chosen], self.design.segments[number], 1 if number < self.again else self.count
        first = self.first[chosen]
        if len(chosen) < count:
            table, begins = np.full((records.NUMBERS, count), np.nan), np.zeros(count, dtype=np.intp)
            at = own[:, AT["row"]].astype(np.intp)
            table[AT["status"]] = table[AT["met"]] = Status.NOT_REACHED
            table[AT["beyond_status"] :] = 0.0
            table[:, at], begins[at] = own.T, first
        else:
            table, begins = np.ascontiguousarray(own.T), first
        contact = self._contact(number, segment, table, begins) if isinstance(segment, Contact) else None
        return Leg(number, segment, table, contact)

    def _contact(self, number: int, contact: Contact, table: Array, first: Index) -> ContactLeg:
        """The same of a guiding surface."""
        surfaces = np.ascontiguousarray(columns(table, "surface_slope", 3).T)
        way = Way(self.kinds[number], self.numbers[: len(surfaces)], self.starts[number], surfaces)
        return ContactLeg(contact, table, way, Panels(way, self.kept, first, whole(table, "panels")))
