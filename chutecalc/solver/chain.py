"""Solve designs with the compiled core, and return what it found segment by segment as arrays."""

import numpy as np

from chutecalc.core import batch_call, records, state, stepping, wall_loads
from chutecalc.core.replay import Recipe
from chutecalc.core.single_design import SingleDesignSolver
from chutecalc.design import Contact, Design, Status
from chutecalc.errors import Fault, SpecError
from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.motion import ROOF
from chutecalc.solver.chain_input import (
    ChuteLayout,
    DesignRows,
    borrow_state,
    design_rows,
    free_buffers,
    layout_of,
    return_state,
)
from chutecalc.solver.options import solver_options
from chutecalc.solver.panels import GuideRows, Panels
from chutecalc.solver.segment_solution import FIELD, ContactSolution, Ends, SegmentSolution, field_indices, field_rows

INITIAL_CAPACITY = 32
"""Panels, and solutions of segments, that there is room for at first beside one of each segment."""


def run_chain(design: Design, rtol: float, dense_output: bool = True) -> tuple[list[SegmentSolution], Ends]:
    """Solve a chute, or n variants of it.

    Args:
        design: the chute; its numbers are arrays of length 1 or n.
        rtol: relative error allowed to the velocity.
        dense_output: keep the panels, from which the stream follows at every share; without them only the ends of
            segments are known.

    Returns:
        The solutions of the segments in order, one or more for each, and how each design ends.

    Raises:
        SpecError: a hood drawn tangent to a falling stream does not steepen from there, or a curve does not turn.
        RuntimeError: a segment took more than 2000 panels: a fault of the solver, not of the chute.
    """
    chain = Chain(design, solver_options(rtol, dense_output))
    return chain.segment_solutions(), chain.ends


def run_ends(
    layout: ChuteLayout,
    numbers: DesignRows,
    rtol: float,
    with_stream_section: bool = False,
    with_wall_loads: bool = False,
) -> Ends:
    """Solve the rows of n designs, and return how they end without anything in between.

    Args:
        layout: of the designs, see :func:`chutecalc.solver.chain_input.layout_of`.
        numbers: their rows, see :func:`chutecalc.solver.chain_input.design_rows`.
        rtol: relative error allowed to the velocity.
        with_stream_section: compute the stream in the last section.
        with_wall_loads: compute the loads on the walls there.

    Returns:
        How each design ends; tables that are not asked for are empty.

    Raises:
        SpecError: see :func:`run_chain`.
        RuntimeError: see :func:`run_chain`.
    """
    chute = borrow_state(layout)
    tables = prepare_outputs(chute, numbers, with_stream_section, with_wall_loads)
    chute.ends_only = True
    if batch_call.solve(chute, solver_options(rtol, False), numbers.rows, 0, len(numbers.rows)) < len(numbers.rows):
        raise RuntimeError(NOT_SOLVED)
    faults = chute.faults
    return_state(layout, chute)
    return checked_ends(layout, faults, *tables)


def single_design_solver(
    layout: ChuteLayout, recipe: Recipe, options: state.SolverOptions, with_stream_section: bool, with_wall_loads: bool
) -> SingleDesignSolver:
    """Return a solver for one design after the other, which owns its records.

    Args:
        layout: of the design, see :func:`chutecalc.solver.chain_input.layout_of`.
        recipe: computes a row of numbers from those that are varied.
        options: tolerances and rules.
        with_stream_section: compute the stream in the last section.
        with_wall_loads: compute the loads on the walls there.
    """
    numbers, chute = np.empty((1, len(recipe.taken))), borrow_state(layout)
    prepare_outputs(
        chute, DesignRows(rows=numbers, wall_offsets=[], first_varied=0), with_stream_section, with_wall_loads
    )
    chute.ends_only = True
    return SingleDesignSolver(recipe, chute, options, inputs=np.empty((1, recipe.varied)), numbers=numbers)


NOT_SOLVED = f"a contact segment was not solved in {stepping.MOST_PANELS} panels"
Tables = tuple[Array, Array, Array]
NO_TABLE = np.empty(0)


def prepare_outputs(
    chute: records.ChuteState, numbers: DesignRows, with_stream_section: bool, with_wall_loads: bool
) -> Tables:
    """Give the state of a chute the tables that it will fill, and return them.

    Args:
        chute: the state.
        numbers: the rows to be solved.
        with_stream_section: whether the stream in the last section is computed.
        with_wall_loads: whether the loads on the walls there are computed.

    Returns:
        The ends of the designs, a row for each of :data:`chutecalc.core.records.ENDS`; the stream in the last section;
        and the loads there.
    """
    count = len(numbers.rows)
    chute.faults, chute.with_stream_section, chute.with_wall_loads = 0, with_stream_section, with_wall_loads
    chute.ends = ends = np.empty((len(records.ENDS), count))
    section_table = load_table = NO_TABLE
    if with_stream_section:
        chute.stream_section = section_table = np.empty((wall_loads.STREAM_SECTION_ROWS, 1, count))
    if with_wall_loads:
        chute.wall_loads = load_table = np.empty((wall_loads.WALL_LOAD_ROWS, 1, count))
    chute.first_varied = chute.first
    while chute.first_varied.number < numbers.first_varied:
        chute.first_varied = chute.first_varied.next
    return ends, section_table, load_table


def checked_ends(layout: ChuteLayout, faults: int, ends: Array, stream_section: Array, wall_loads: Array) -> Ends:
    """Return how designs end.

    Args:
        layout: of the designs.
        faults: how many of them have a curve that is not tangent to its stream.
        ends, stream_section, wall_loads: tables as of :func:`prepare_outputs`, filled.

    Raises:
        SpecError: some have curves that are not tangent to the stream that falls into them.
    """
    if faults:
        refused = ends[0] == state.NOT_TANGENT
        row = int(refused.argmax())
        at, slope = int(ends[4, row]), np.degrees(ends[6, row])
        what = "a roof must steepen" if layout[at].side == ROOF else "an arc must turn"
        problem = f"{what}, and the stream falls into this one at {slope:z.6g}°"
        fault = Fault(f"segments.{at + 1}.to_slope_deg", problem, "change it, or give from_slope_deg")
        raise SpecError([fault], designs=refused)
    solution_blocks = dict(zip(records.ENDS, ends, strict=True)) | {"status": ends[0].astype(np.intp)}
    return Ends(**solution_blocks, stream_section=stream_section, wall_loads=wall_loads)


class Chain:
    """Designs, and the solutions of their segments."""

    def __init__(self, design: Design, options: state.SolverOptions) -> None:
        """Solve the designs.

        Args:
            design: the chutes.
            options: tolerance and rules, from :func:`chutecalc.solver.options.solver_options`.
        """
        self.design, self.options, self.layout, numbers = design, options, layout_of(design), design_rows(design)
        self.numbers, self.wall_offsets, self.first_varied = numbers
        self.count = len(self.numbers)
        chute = borrow_state(self.layout)
        tables = prepare_outputs(chute, numbers, with_stream_section=False, with_wall_loads=False)
        chute.ends_only = False
        self.rows, self.panels = self._run(chute, len(self.layout) * self.count + INITIAL_CAPACITY)
        faults = chute.faults
        free_buffers(chute)
        return_state(self.layout, chute)
        self.ends = checked_ends(self.layout, faults, *tables)

    def _run(self, chute: records.ChuteState, solution_capacity: int) -> tuple[Array, Array]:
        """Return the solutions of segments, a row each, and the panels in one row, of one design after the other."""
        solution_blocks, panel_blocks, done = [], [], 0
        store, panel_capacity = chute.first.stream.store, solution_capacity if self.options.dense_output else 1
        while done < self.count:
            solution_buffer = np.empty(records.SOLUTION_NUMBERS * solution_capacity)
            panel_buffer = np.empty(state.PANEL_NUMBERS * panel_capacity)
            chute.solutions, chute.capacity, chute.count = solution_buffer, solution_capacity, 0
            store.panels, store.capacity, store.count = panel_buffer, panel_capacity, 0
            chute.full = store.full = False
            first, done = done, batch_call.solve(chute, self.options, self.numbers, done, self.count)
            solution_blocks.append(solution_buffer[: chute.count * records.SOLUTION_NUMBERS])
            panel_blocks.append(panel_buffer[: store.count * state.PANEL_NUMBERS])
            if done < self.count and not (chute.full or store.full):
                raise RuntimeError(NOT_SOLVED)
            panel_capacity *= 2 if store.full and done == first else 1
            solution_capacity *= 2 if chute.full and done == first else 1
        solution_rows, panel_rows = (
            blocks[0] if len(blocks) == 1 else np.concatenate(blocks) for blocks in (solution_blocks, panel_blocks)
        )
        return solution_rows.reshape(-1, records.SOLUTION_NUMBERS), panel_rows

    def segment_solutions(self) -> list[SegmentSolution]:
        """Return the solutions of the segments in order; a segment struck several times has one for each."""
        panels = self.rows[:, FIELD["panels"]].astype(np.intp)
        self.first = np.cumsum(panels) - panels
        number, strikes = self.rows[:, FIELD["segment"]], self.rows[:, FIELD["strikes"]]
        if len(self.rows) == len(self.layout) and self.count == 1:  # each segment once
            return [
                self._segment_solution(segment, self.rows, np.array([segment])) for segment in range(len(self.layout))
            ]
        solutions: list[SegmentSolution] = []
        for segment in range(len(self.layout)):
            of_segment = number == segment
            if segment < self.first_varied:  # solved once, or once for each buffer
                of_segment &= self.rows[:, FIELD["row"]] == 0
            strikes_range = range(int(strikes[of_segment].max()) + 1)
            solutions += [
                self._segment_solution(segment, self.rows, np.flatnonzero(of_segment & (strikes == strike)))
                for strike in strikes_range
            ]
        return solutions

    def _segment_solution(self, number: int, rows: Array, chosen: Index) -> SegmentSolution:
        """Return a segment's solution from its rows; designs that have none get NaN."""
        own_rows, segment = rows[chosen], self.design.segments[number]
        count = 1 if number < self.first_varied else self.count
        first = self.first[chosen]
        if len(chosen) < count:
            table, first_panels = np.full((records.SOLUTION_NUMBERS, count), np.nan), np.zeros(count, dtype=np.intp)
            at = own_rows[:, FIELD["row"]].astype(np.intp)
            table[FIELD["status"]] = table[FIELD["arrival_status"]] = Status.NOT_REACHED
            table[FIELD["beyond_status"] :] = 0.0
            table[:, at], first_panels[at] = own_rows.T, first
        else:
            table, first_panels = np.ascontiguousarray(own_rows.T), first
        contact = self._contact(number, segment, table, first_panels) if isinstance(segment, Contact) else None
        return SegmentSolution(number, segment, table, contact)

    def _contact(self, number: int, contact: Contact, table: Array, first: Index) -> ContactSolution:
        """Return what the segment's solution has along a guiding surface."""
        surfaces = np.ascontiguousarray(field_rows(table, "surface_slope", 3).T)
        guide_rows = GuideRows(
            layout=self.layout[number],
            rows=self.numbers[: len(surfaces)],
            offset=self.wall_offsets[number],
            surfaces=surfaces,
        )
        return ContactSolution(
            contact, table, guide_rows, Panels(guide_rows, self.panels, first, field_indices(table, "panels"))
        )
