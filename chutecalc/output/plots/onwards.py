"""How a stream flies on from the last surface: to the mouth of the chute, to its belt, or where nothing catches it."""

from collections.abc import Sequence

import numpy as np

from chutecalc.design import Status
from chutecalc.output.plots.flights import LEAVES, STATIONS, Line, Throw, crossings, flown, thrown
from chutecalc.output.plots.traces import LOST, Steel, Trace
from chutecalc.physics.arrays import Array
from chutecalc.results.columns import COLUMNS
from chutecalc.results.part import FLIGHT
from chutecalc.results.solved import SolvedChute

FURTHER = 0.2
"""A stream that is lost is drawn to this far below everything else, over the height of the chute."""
FAR = 100.0
"""A belt is so many times longer than it is drawn."""
SAME = 1e-9
"""Distance between points that are the same, over the height of the chute."""


def flight_to_exit(
    solution: SolvedChute, last: Trace, throws: Sequence[Throw], received: Sequence[Line], size: float
) -> Trace | None:
    """Return the flight from the last surface to the mouth of a closed section or to a belt that has a place.

    Args:
        solution: solution of one design.
        last: the last trace of its stream.
        throws: how its edges fly on.
        received: the belt that it goes to, as a line, if there is one.
        size: greater side of the chute, m.

    Returns:
        The flight; None if the stream leaves the chute where it leaves the surface, or fails.
    """
    path, ends = _leaves(solution, last), solution.trajectory.ends
    away = np.hypot(ends.landing_x[0] - path.x, ends.landing_z[0] - path.z)
    gained = ends.landing_velocity[0] * np.sin(ends.landing_slope[0]) - path.downward
    if not (solution.ok[0] and away > SAME * size and gained > 0.0):
        return None
    return _onwards(last, path, throws, FLIGHT, float(gained / path.gravity), _lengthened(received))


def lost_stream(
    solution: SolvedChute, stream: Sequence[Trace], throws: Sequence[Throw], surfaces: Sequence[Steel]
) -> Trace | None:
    """Return how a stream flies on that misses or leaves its chute; None if it does not.

    Args:
        solution: solution of one design.
        stream: the traces of its stream.
        throws: how its edges fly on.
        surfaces: of the chute.
    """
    if solution.trajectory.status_numbers[0] not in (Status.MISSED, Status.CONTACT_LOST):
        return None
    path = _leaves(solution, stream[-1])
    return _onwards(stream[-1], path, throws, LOST, *_caught(path, surfaces, _below([*surfaces, *stream])))


def failing_end(
    solution: SolvedChute, last: Trace, lost: Trace | None, surfaces: Sequence[Steel], received: Sequence[Line]
) -> Trace:
    """Return where a stream fails: at its end, or where it passes nearest to what it misses.

    Args:
        solution: solution of one design that fails.
        last: the last trace of its stream.
        lost: how it flies on.
        surfaces: of the chute.
        received: the belt that it goes to, as a line, if there is one.
    """
    trajectory = solution.trajectory
    failed = {each.segment.name for each in trajectory.segment_solutions if each.status[0] == Status.MISSED}
    missed = [steel.path for steel in surfaces if steel.name in failed] or received
    if lost is None or trajectory.status_numbers[0] != Status.MISSED or not missed:
        return last.at(-1)
    away = np.min([np.hypot(*(lost.path[:, :, None] - line[:, None, :])).min(axis=1) for line in missed], axis=0)
    return lost.at(int(away.argmin()))


def _leaves(solution: SolvedChute, last: Trace) -> Throw:
    """Return how the path of a stream leaves its last trace."""
    x, z, slope, velocity = (float(last.columns[name][-1]) for name in LEAVES)
    return thrown(x, z, slope, velocity, float(solution.design.gravity[0]))


def _lengthened(received: Sequence[Line]) -> Line | None:
    """Return the belt at its whole length, if there is one."""
    for line in received:
        middle: Line = line.mean(axis=1)[:, None]
        return middle + FAR * (line - middle)
    return None


def _below(seen: Sequence[Steel | Trace]) -> float:
    """Return a height below all that is drawn, m."""
    heights = np.concatenate([each.path[1] for each in seen])
    return float(np.nanmin(heights) - FURTHER * max(np.nanmax(heights) - np.nanmin(heights), 1.0))


def _caught(path: Throw, surfaces: Sequence[Steel], level: float) -> tuple[float, Line | None]:
    """Return the time until a path meets a surface, and that surface; else until it is down at a level, and None."""
    time = np.linspace(0.0, path.time_to(level), STATIONS)
    flown = path.at(time)
    found = [(meets[0], steel.path) for steel in surfaces if (meets := _after_start(crossings(flown, steel.path))).size]
    piece, landed = min(found, key=lambda each: each[0], default=(STATIONS - 1.0, None))
    return float(time[-1] * piece / (STATIONS - 1)), landed


def _after_start(pieces: Array) -> Array:
    """Return the crossings of a path behind its first piece, which begins on the surface that it leaves."""
    return pieces[pieces > 1.0]


def _onwards(last: Trace, path: Throw, throws: Sequence[Throw], kind: str, until: float, landed: Line | None) -> Trace:
    """Return the flight from the end of the chute, to the belt or to nowhere."""
    time = np.linspace(0.0, until, STATIONS)
    x, z = path.at(time)
    length = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(z)))])
    columns = {name: np.full(STATIONS, np.nan) for name in COLUMNS}
    columns |= {"s_m": last.columns["s_m"][-1] + length, "x_m": x, "z_m": z, "velocity_m_s": path.velocity(time)}
    columns |= {"time_s": time, "slope_deg": np.degrees(np.arctan2(path.downward + path.gravity * time, path.forward))}
    return Trace(kind, kind, 0.0, columns, flown(throws or [path], columns, landed)[0])
