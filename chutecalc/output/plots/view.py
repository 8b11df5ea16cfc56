"""Finds the lines of a chute seen from the side: its stream guided, in flight, and lost; its surfaces; its belts."""

from collections.abc import Sequence
from itertools import zip_longest

import numpy as np

from chutecalc.design import Status
from chutecalc.output.plots.belts import feed_lines, receiver_lines
from chutecalc.output.plots.flights import (
    LEAVES,
    SHARES,
    STATIONS,
    Line,
    Throw,
    belt_throws,
    crossings,
    surface_line,
    thrown,
)
from chutecalc.output.plots.traces import DEEPEST, LOST, Lines, Steel, Trace, View, extent
from chutecalc.physics.arrays import Array
from chutecalc.results.columns import COLUMNS
from chutecalc.results.part import FLIGHT, Part
from chutecalc.results.solved import SolvedChute
from chutecalc.solver.steel import drawn_surface

FURTHER = 0.2
"""A stream that is lost is drawn to this far below everything else, over the height of the chute."""
FAR = 100.0
"""A belt is so many times longer than it is drawn."""
SAME = 1e-9
"""Distance between points that are the same, over the height of the chute."""


def view(solution: SolvedChute) -> View:
    """Return what is to be seen of the first design.

    Args:
        solution: solution of one design.
    """
    surfaces = _surfaces(solution)
    reached = _reached(solution)
    inlet = np.stack([solution.inlet[name][:1] for name in ("x_m", "z_m")])
    paths = [np.stack([at["x_m"], at["z_m"]]) for _, at in reached]
    size = float(extent([inlet, *(steel.path for steel in surfaces), *paths]).max())
    stream, throws = _stream(solution, reached, surfaces, DEEPEST * size)
    received = receiver_lines(solution, size)
    x, z, slope, velocity = (float(stream[-1].columns[name][-1]) for name in LEAVES)
    path = thrown(x, z, slope, velocity, float(solution.design.gravity[0]))
    lost = None
    if solution.trajectory.status_numbers[0] in (Status.MISSED, Status.CONTACT_LOST):
        lost = _onwards(stream[-1], path, throws, LOST, *_caught(path, surfaces, _below([*surfaces, *stream])))
    elif (beyond := _time_beyond(solution, path, size)) > 0.0:
        stream.append(_onwards(stream[-1], path, throws, FLIGHT, beyond, _lengthened(received)))
    end = None if solution.ok[0] else _end(solution, stream[-1], lost, surfaces, received)
    return View(stream, lost, end, surfaces, feed_lines(solution), received, size)


def _end(
    solution: SolvedChute, last: Trace, lost: Trace | None, surfaces: Sequence[Steel], received: Sequence[Line]
) -> Trace:
    """Return where a stream fails: at its end, or where it passes nearest to what it misses."""
    failed = {
        solved.segment.name for solved in solution.trajectory.segment_solutions if solved.status[0] == Status.MISSED
    }
    missed = [steel.path for steel in surfaces if steel.name in failed] or received
    if lost is None or solution.trajectory.status_numbers[0] != Status.MISSED or not missed:
        return last.at(-1)
    away = np.min([np.hypot(*(lost.path[:, :, None] - line[:, None, :])).min(axis=1) for line in missed], axis=0)
    return lost.at(int(away.argmin()))


def _stream(
    solution: SolvedChute, reached: Sequence[tuple[Part, Lines]], surfaces: Sequence[Steel], deepest: float
) -> tuple[list[Trace], list[Throw]]:
    """Return the traces of the stream, and how its edges would fly on from the last."""
    design = solution.design
    throws = belt_throws(design.belt, design.gravity) if design.belt else []
    stream = []
    for (part, at), following in zip_longest(reached, reached[1:]):
        if part.contact is None:
            throws = throws or [Throw(*part.solved.path[:, 0].tolist())]
            edges, throws = _flown(throws, at, None if following is None else _landed(following[0], surfaces))
            side = 0.0
        else:
            side = float(part.contact.side[0])  # a closed section has a roof too
            edges, throws = _guided(at, side, deepest, float(design.gravity[0]))
        stream.append(Trace(part.name, part.kind, side, at, edges))
    return stream or [_at_inlet(solution)], throws


def _landed(part: Part, surfaces: Sequence[Steel]) -> Line | None:
    """Return the line that a flight ends on: of a closed segment with all before it, as edges may land there first."""
    if part.contact is None:
        return None
    if not part.segment.closed:
        return surface_line(part.contact.surface)
    names, side = [steel.name for steel in surfaces], float(part.contact.side[0])
    found = [steel for steel in surfaces[: names.index(part.segment.name) + 1] if steel.closed]
    return np.concatenate([steel.path if steel.side == side else steel.top for steel in found], axis=1)


def _time_beyond(solution: SolvedChute, path: Throw, size: float) -> float:
    """Return how long the stream flies from the last surface to the mouth of the chute, or on to its belt; 0 if not."""
    ends = solution.trajectory.ends
    away = np.hypot(ends.landing_x[0] - path.x, ends.landing_z[0] - path.z)
    gained = ends.landing_velocity[0] * np.sin(ends.landing_slope[0]) - path.downward
    return float(gained / path.gravity) if away > SAME * size else 0.0


def _lengthened(received: Sequence[Line]) -> Line | None:
    """Return the belt at its whole length, if there is one."""
    for line in received:
        middle: Line = line.mean(axis=1)[:, None]
        return middle + FAR * (line - middle)
    return None


def _surfaces(solution: SolvedChute) -> list[Steel]:
    """Return the surfaces that have a place, in the order of the spec."""
    visits = {solved.number: solved for solved in reversed(solution.trajectory.segment_solutions)}
    found = []
    for _, solved in sorted(visits.items()):
        if solved.contact is not None:
            segment, surface = solved.contact.segment, drawn_surface(solved.contact)
            high = np.broadcast_to(segment.wall_height(SHARES), SHARES.shape)
            top = surface_line(surface, np.where(np.isfinite(high), high, np.nan))
            steel = Steel(segment.name, segment.side, surface_line(surface), top, segment.closed)
            found += [steel] if np.isfinite(steel.path).all() else []
    return found


def _reached(solution: SolvedChute) -> list[tuple[Part, Lines]]:
    """Return the parts that the stream reached, with their columns along it."""
    stations = solution.stations(points=STATIONS)
    found = []
    for number, part in enumerate(solution.trajectory.parts):
        rows = slice(number * STATIONS, (number + 1) * STATIONS)
        reached = np.isfinite(stations["s_m"][0, rows])
        if reached.any():
            found.append((part, {name: values[0, rows][reached] for name, values in stations.items()}))
    return found


def _guided(at: Lines, side: float, deepest: float, gravity: float) -> tuple[list[Line], list[Throw]]:
    """Return the edges on a surface, that on it first, and how they leave it."""
    depth = np.minimum(at["depth_m"], deepest)  # none where the stream has come to rest
    slope = np.radians(at["slope_deg"])
    foot = np.stack([at["x_m"], at["z_m"]])
    edges = [foot, foot + side * depth * np.stack([np.sin(slope), np.cos(slope)])]
    leaves = float(at["slope_deg"][-1]), float(at["velocity_m_s"][-1])
    known = [edge[:, -1].tolist() for edge in edges if np.isfinite(edge[:, -1]).all()]
    return edges, [thrown(x, z, *leaves, gravity) for x, z in known]


def _flown(throws: list[Throw], at: Lines, landed: Line | None) -> tuple[list[Line], list[Throw]]:
    """Return the edges of a flight, and how they would fly on."""
    time = at["time_s"] - at["time_s"][0]
    usual = float(time[-1])
    x, z = at["x_m"][0], at["z_m"][0]
    edges = []
    for throw in throws:
        is_path = np.hypot(throw.x - x, throw.z - z) <= 1e-9 * (1.0 + np.hypot(x, z))
        ends = usual if is_path or landed is None else throw.time_of_landing(landed, usual)
        edges.append(throw.at(time * (ends / usual if usual else 1.0)))
    return edges, [throw.after(usual) for throw in throws]


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


def _onwards(last: Trace, path: Throw, throws: list[Throw], kind: str, until: float, landed: Line | None) -> Trace:
    """Return the flight from the end of the chute, to the belt or to nowhere."""
    time = np.linspace(0.0, until, STATIONS)
    x, z = path.at(time)
    flown = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(z)))])
    columns = {name: np.full(STATIONS, np.nan) for name in COLUMNS}
    columns |= {"s_m": last.columns["s_m"][-1] + flown, "x_m": x, "z_m": z, "velocity_m_s": path.velocity(time)}
    columns |= {"time_s": time, "slope_deg": np.degrees(np.arctan2(path.downward + path.gravity * time, path.forward))}
    return Trace(kind, kind, 0.0, columns, _flown(throws or [path], columns, landed)[0])


def _at_inlet(solution: SolvedChute) -> Trace:
    """Return the inlet as a trace of one station, for a stream that reaches nothing."""
    inlet = {name: values[:1] for name, values in solution.inlet.items()}
    nowhere = {name: np.full(1, np.nan) for name in COLUMNS}
    columns = nowhere | inlet | {"s_m": np.zeros(1)}
    return Trace("inlet", "inlet", 0.0, columns, [np.stack([columns["x_m"], columns["z_m"]])])
