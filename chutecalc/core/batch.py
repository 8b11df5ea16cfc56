"""Solve many chutes one after the other: rows of numbers in, solutions out."""

from typing import Any

from chutecalc.core import chain, closed, floats, guide_surface, receiver, records, section, state, wall_loads

HEADER = 10
"""Number of entries of a row before those of the segments."""
MOMENTUM_COLUMN = 4
"""Number of the entry that is the momentum factor."""


def solve_rows(chute: "records.ChuteState", options: "state.SolverOptions", numbers: Any, first: int, last: int) -> int:
    """Solve rows from the first up to the last; return the row it has come to.

    That is less than the last where there is no more room, or where the solver failed. The solutions and panels are
    those of the rows that are done.

    Args:
        chute: state of a chute of this layout; rows agree in all that comes before its segment ``first_varied``.
        options: tolerances and rules.
        numbers: a row each: density, gravity, volume rate, K_v, α_m, K_l; position, velocity and slope of the stream at
            the inlet; then the segments: start, drop and run of a fall; else start, entry and exit slope, radius,
            length, the pieces of the wall's friction law, the section at the start, and at the end of a taper; at last
            position and slope of the receiving belt.
        first, last: rows.
    """
    row = first
    while row < last:
        solution_count, panel_count = chute.count, chute.first.stream.store.count
        chute.row = row
        read_segments(chute, chute.first, numbers, row, HEADER)
        if row == first or chute.first_varied.number == 0:
            chain.start_at_inlet(chute)
            chain.solve_from(chute, options, chute.first)
        else:
            chain.restore_start(chute)
            chain.solve_from(chute, options, chute.first_varied)
        if chute.full or chute.first.stream.store.full:
            chute.count, chute.first.stream.store.count = solution_count, panel_count
            return row
        if chute.mouth_time == chute.mouth_time and chute.last.closed and chute.status == state.OK:
            closed.fly_to_mouth(chute)
        elif chute.segment_status == state.PASSED and chute.launch.velocity == chute.launch.velocity:
            records.copy_point(chute.current, chute.launch)  # it flies past the drawn end of a fall
        receiver.land_on_belt(chute)
        if chute.last.on_roof:
            write_ends(chute, chute.last, chute.last.roof)
        else:
            write_ends(chute, chute.last, chute.last.stream)
        if chute.status == state.UNSOLVED:
            return row
        row += 1
    return row


def write_ends(chute: "records.ChuteState", last: "records.Segment", stream: "state.Stream") -> None:
    """Write how a design ends."""
    row = chute.row
    chute.ends[0, row], chute.ends[1, row], chute.ends[2, row] = chute.status, chute.current.velocity, chute.error
    chute.ends[3, row], chute.ends[4, row] = chute.current.distance, chute.current.x
    chute.ends[5, row], chute.ends[6, row] = chute.current.z, chute.current.slope
    chute.ends[7, row], chute.ends[8, row] = chute.landing.x, chute.landing.z
    chute.ends[9, row], chute.ends[10, row] = chute.landing.velocity, chute.landing.slope
    chute.ends[11, row] = receiver.belt_clearance(chute)
    if chute.status == state.FAULT:
        chute.faults += 1
        chute.ends[4, row], chute.ends[6, row] = chute.fault_number, chute.fault_slope
    in_air = last.fall or (last.closed and chute.airborne)
    y = floats.NAN if chute.status != state.OK or in_air else stream.y
    if chute.with_stream_section:
        wall_loads.write_stream_section(stream.guide, stream.share, y, 0, row, chute.stream_section)
    if chute.with_wall_loads:
        wall_loads.write_wall_loads(stream.guide, stream.share, y, 0, row, chute.wall_loads)


def read_segments(chute: "records.ChuteState", segment: "records.Segment", numbers: Any, row: int, at: int) -> None:
    """Read a segment and all that follow it from a row; with the first of them the inlet."""
    if at == HEADER:
        chute.gravity = float(numbers[row, 1])
        chute.inlet.x, chute.inlet.z = float(numbers[row, 6]), float(numbers[row, 7])
        chute.inlet.velocity, chute.inlet.slope = float(numbers[row, 8]), float(numbers[row, 9])
    if segment.fall:
        segment.drop, segment.run = float(numbers[row, at + 2]), float(numbers[row, at + 3])
    else:
        segment.entry_slope, segment.exit_slope = float(numbers[row, at + 2]), float(numbers[row, at + 3])
        segment.radius, segment.length = float(numbers[row, at + 4]), float(numbers[row, at + 5])
    segment.start_x, segment.start_z = float(numbers[row, at]), float(numbers[row, at + 1])
    if segment.closed:
        read_guide(segment.roof.guide, numbers, row, at + 6)
    at = at + 4 if segment.fall else read_guide(segment.stream.guide, numbers, row, at + 6)
    if segment.final:
        chute.belt_x, chute.belt_z = float(numbers[row, at]), float(numbers[row, at + 1])
        chute.belt_slope = float(numbers[row, at + 2])
    else:
        read_segments(chute, segment.next, numbers, row, at)


def read_guide(guide: "guide_surface.Guide", numbers: Any, row: int, at: int) -> int:
    """Read the flow, the wall and the sections; return the offset of the next number."""
    guide.density, guide.gravity = float(numbers[row, 0]), float(numbers[row, 1])
    guide.momentum_root, guide.longitudinal = floats.root(float(numbers[row, 4])), float(numbers[row, 5])
    guide.flow, guide.vertical_ratio = float(numbers[row, 2]) * guide.momentum_root, float(numbers[row, 3])
    for k in range(guide.pieces):
        guide.starts[k], guide.intercepts[k] = float(numbers[row, at]), float(numbers[row, at + 1])
        guide.slopes[k] = float(numbers[row, at + 2])
        at += 3
    at = read_section(guide.first, numbers, row, at)
    return read_section(guide.last, numbers, row, at) if guide.taper else at


def restore_guide(guide: "guide_surface.Guide", numbers: Any, row: int, at: int, surface: Any) -> None:
    """Set a surface to what it was when the stream on it was solved: its entry slope, turn, length and side."""
    read_guide(guide, numbers, row, at)
    guide.entry_slope, guide.turn = float(surface[0]), float(surface[1])
    guide.length, guide.side = float(surface[2]), float(surface[3])
    guide_surface.set_constants(guide)


def read_section(cross_section: "section.Section", numbers: Any, row: int, at: int) -> int:
    """Read a section from a row; return the offset of the next number."""
    cross_section.wall_height = float(numbers[row, at])
    if cross_section.circle:
        cross_section.radius = float(numbers[row, at + 1])
        return at + 2
    cross_section.base = float(numbers[row, at + 1])
    at += 2
    for k in range(cross_section.walls):
        cross_section.lengths[k], cross_section.inclinations[k] = float(numbers[row, at]), float(numbers[row, at + 1])
        at += 2
    return at
