"""Designs through their chutes: rows of numbers to the compiled chain, and the legs that it found as arrays."""

import numpy as np

from chutecalc.core import designs, march, records, state
from chutecalc.design import Contact, Design, Status
from chutecalc.errors import Fault, SpecError
from chutecalc.physics.arrays import Array, Index
from chutecalc.solver.course import course_of, numbers_of
from chutecalc.solver.effort import effort
from chutecalc.solver.leg import AT, Arrival, ContactLeg, Ends, Impact, Leg, Point, Stretch, columns, surface_of, whole
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
    return Chain(design, effort(rtol, complete)).solved()


class Chain:
    """Designs, and what the compiled chain wrote down of them."""

    def __init__(self, design: Design, work: state.Effort) -> None:
        self.design, self.work = design, work
        self.numbers, self.starts, self.again = numbers_of(design)
        self.count = len(self.numbers)
        self.ends = np.empty((self.count, 3))

    def solved(self) -> tuple[list[Leg], Ends]:
        """All of it."""
        rows, kept = self._run()
        panels = rows[:, AT["panels"]].astype(np.intp)
        self.kept, self.first = kept, np.cumsum(panels) - panels
        number, strikes = rows[:, AT["segment"]], rows[:, AT["strikes"]]
        legs: list[Leg] = []
        for segment in range(len(self.design.segments)):
            of_segment = number == segment
            if segment < self.again:  # solved once, or once for each time that room was made
                of_segment &= rows[:, AT["row"]] == 0
            times = range(int(strikes[of_segment].max()) + 1)
            legs += [self._leg(segment, rows, np.flatnonzero(of_segment & (strikes == again))) for again in times]
        return legs, Ends(self.ends[:, 0].astype(np.intp), self.ends[:, 1], self.ends[:, 2])

    def _run(self) -> tuple[Array, Array]:
        """Legs, a row each, and the panels kept, in one row; of one design after the other."""
        legs, panels, done = (
            len(self.design.segments) * self.count + ROOM,
            ROOM + len(self.design.segments) * self.count,
            0,
        )
        found, kept = [], []
        while done < self.count:
            self.course = course_of(self.design, panels, legs, self.again)
            log = self.course.first.own.log
            before, done = done, designs.solve(self.course, self.work, self.numbers, self.ends, done, self.count)
            found.append(np.asarray(self.course.legs)[: self.course.count * records.NUMBERS])
            kept.append(np.asarray(log.kept)[: log.count * state.PANEL])
            if done < self.count and not (self.course.full or log.full):
                self._give_up(done)
            panels *= 2 if log.full and done == before else 1
            legs *= 2 if done == before and self.course.full else 1
        whole = found + kept if len(found) == 1 else (np.concatenate(found), np.concatenate(kept))
        return whole[0].reshape(-1, records.NUMBERS), whole[1]

    def _leg(self, number: int, rows: Array, chosen: Index) -> Leg:
        """What designs did on a segment, from its rows; what others did not do is left open."""
        own, segment, count = rows[chosen], self.design.segments[number], 1 if number < self.again else self.count
        first = self.first[chosen]
        if len(chosen) < count:
            table, begins = np.full((records.NUMBERS, count), np.nan), np.zeros(count, dtype=np.intp)
            at = own[:, AT["row"]].astype(np.intp)
            table[AT["status"]] = table[AT["met"]] = Status.NOT_REACHED
            table[:, at], begins[at] = own.T, first
        else:
            table, begins = np.ascontiguousarray(own.T), first
        path = columns(table, "path_x", 5)
        start, entry, end = (Point._make(columns(table, f"{at}_distance", 9)) for at in ("start", "entry", "exit"))
        contact = self._contact(number, segment, table, begins) if isinstance(segment, Contact) else None
        time, flown, status = table[AT["flight_time"]], table[AT["distance"]], whole(table, "status")
        return Leg(number, segment, start, path, time, flown, entry, end, status, contact)

    def _contact(self, number: int, contact: Contact, table: Array, first: Index) -> ContactLeg:
        """The same of a guiding surface."""
        surface = surface_of(table, contact)
        stream = self.course.first
        while stream.number < number:
            stream = stream.next
        surfaces = np.ascontiguousarray(columns(table, "surface_slope", 3).T)
        way = Way(stream.own.way, self.numbers[: len(surfaces)], self.starts[number], surfaces)
        impact = Impact._make(columns(table, "footprint", 7))
        arrival = Arrival._make((*columns(table, "distance", 5), whole(table, "met"), impact))
        panels = None
        if self.work.complete:
            panels = Panels(stream.own, way, self.kept, first, whole(table, "panels"))
        counts = (whole(table, "beyond_status"), whole(table, "tried"), panels)
        stretch = Stretch._make((*columns(table, "end_place", 3), *counts))
        return ContactLeg(surface, way, arrival, stretch)

    def _give_up(self, row: int) -> None:
        """Says why the chain stopped at a row."""
        if self.ends[row, 0] != state.NOT_TANGENT:
            raise RuntimeError(f"a contact segment was not solved in {march.MOST} panels")
        at = self.course.fault_number
        what = "a hood has to steepen" if self.design.segments[at].kind == "hood" else "a curve has to turn"
        slope = np.degrees(self.course.fault_slope)
        problem = f"{what}, and the stream falls into this one at {slope:.6g}°"
        raise SpecError([Fault(f"segments.{at + 1}.to_slope_deg", problem, "change it, or give from_slope_deg")])
