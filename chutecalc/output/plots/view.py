"""Finds the lines of a chute seen from the side: its stream guided, in flight, and lost; its surfaces; its belts."""

from collections.abc import Sequence
from itertools import zip_longest

import numpy as np

from chutecalc.output.plots.belt_lines import feed_lines, receiver_lines
from chutecalc.output.plots.flights import SHARES, STATIONS, Line, Throw, belt_throws, flown, surface_line, thrown
from chutecalc.output.plots.onwards import failing_end, flight_to_exit, lost_stream
from chutecalc.output.plots.traces import DEEPEST, STRUCK, Lines, Steel, Trace, View, extent
from chutecalc.results.columns import COLUMNS
from chutecalc.results.drawn import drawn_surfaces
from chutecalc.results.part import Part
from chutecalc.results.solved import SolvedChute


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
    if further := flight_to_exit(solution, stream[-1], throws, received, size):
        stream.append(further)
    lost = lost_stream(solution, stream, throws, surfaces)
    end = None if solution.ok[0] else failing_end(solution, stream[-1], lost, surfaces, received)
    return View(stream, lost, end, surfaces, feed_lines(solution), received, _impacts(solution), size)


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
            edges, throws = flown(throws, at, None if following is None else _landed(following[0], surfaces))
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


def _surfaces(solution: SolvedChute) -> list[Steel]:
    """Return the surfaces that have a place, in the order of the spec."""
    found = []
    for segment, surface in drawn_surfaces(solution):
        high = np.broadcast_to(segment.wall_height(SHARES), SHARES.shape)
        top = surface_line(surface, np.where(np.isfinite(high), high, np.nan))
        found.append(Steel(segment, surface, surface_line(surface), top))
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


def _impacts(solution: SolvedChute) -> Lines:
    """Return where the stream strikes surfaces, and with what pressure and wear."""
    struck = [each for each in solution.trajectory.results if each.impact and np.isfinite(each.impact[STRUCK[0]][0])]
    numbers = {name: np.array([each.impact[name][0] for each in struck]) for name in STRUCK}
    return {"s_m": np.array([each.entry["s_m"][0] for each in struck]), **numbers}


def _guided(at: Lines, side: float, deepest: float, gravity: float) -> tuple[list[Line], list[Throw]]:
    """Return the edges on a surface, that on it first, and how they leave it."""
    depth = np.minimum(at["depth_m"], deepest)  # none where the stream has come to rest
    slope = np.radians(at["slope_deg"])
    foot = np.stack([at["x_m"], at["z_m"]])
    edges = [foot, foot + side * depth * np.stack([np.sin(slope), np.cos(slope)])]
    leaves = float(at["slope_deg"][-1]), float(at["velocity_m_s"][-1])
    known = [edge[:, -1].tolist() for edge in edges if np.isfinite(edge[:, -1]).all()]
    return edges, [thrown(x, z, *leaves, gravity) for x, z in known]


def _at_inlet(solution: SolvedChute) -> Trace:
    """Return the inlet as a trace of one station, for a stream that reaches nothing."""
    inlet = {name: values[:1] for name, values in solution.inlet.items()}
    nowhere = {name: np.full(1, np.nan) for name in COLUMNS}
    columns = nowhere | inlet | {"s_m": np.zeros(1)}
    return Trace("inlet", "inlet", 0.0, columns, [np.stack([columns["x_m"], columns["z_m"]])])
