"""Quantities along a solved segment, at any places of it: how the stream lies in its section, and what its walls bear.

Places are rows, a column for each design; so are v² there, and what comes out, a table for each quantity. What does not
exist is not a number.
"""

import math
from typing import Any

from chutecalc.core import batch, flight, floats, records, slide, walls

TRIES = 60
"""Newton's: six do but next to the apex of a steep throw."""


def lying(way: "slide.Slide", numbers: Any, start: int, surfaces: Any, places: Any, squared: Any, out: Any) -> None:
    """How the stream lies in its section, see :func:`chutecalc.core.walls.lie`.

    Args:
        way: of the segment's kind.
        numbers: of all designs, a row each, as they were solved with.
        start: where in a row the segment's wall begins.
        surfaces: entry slope, turn and length of the segment, a row each.
        places: shares of the segment's length.
        squared: v² there.
        out: five tables.
    """
    for design in range(places.shape[1]):
        batch.put_back(way, numbers, design, start, surfaces[design, 0], surfaces[design, 1], surfaces[design, 2])
        for row in range(places.shape[0]):
            walls.lie(way, places[row, design], squared[row, design], row, design, out)


def pressing(way: "slide.Slide", numbers: Any, start: int, surfaces: Any, places: Any, squared: Any, out: Any) -> None:
    """What the walls bear, see :func:`chutecalc.core.walls.press`.

    Args:
        way, numbers, start, surfaces, places, squared: as of :func:`lying`.
        out: eight tables.
    """
    for design in range(places.shape[1]):
        batch.put_back(way, numbers, design, start, surfaces[design, 0], surfaces[design, 1], surfaces[design, 2])
        for row in range(places.shape[0]):
            walls.press(way, places[row, design], squared[row, design], row, design, out)


def flying(paths: Any, times: Any, distances: Any, out: Any) -> None:
    """Time since a flight began, x, z, velocity and slope at distances flown.

    Newton's method from uniform acceleration between the same ends.

    Args:
        paths: a column for each design: where the flight begins, x and z; velocities forward and downward; gravity.
        times: how long it takes, s.
        distances: m, a column for each design.
        out: five tables.
    """
    path = records.Flight()
    for design in range(distances.shape[1]):
        begin(path, paths, design)
        for row in range(distances.shape[0]):
            time = time_at(path, times[design], distances[row, design])
            out[0, row, design], out[1, row, design] = time, flight.x_at(path, time)
            out[2, row, design], out[3, row, design] = flight.z_at(path, time), flight.velocity_at(path, time)
            out[4, row, design] = flight.slope_at(path, time)


def begin(path: "records.Flight", paths: Any, design: int) -> None:
    """Reads a flight."""
    path.x, path.z, path.forward = float(paths[0, design]), float(paths[1, design]), float(paths[2, design])
    path.downward, path.gravity = float(paths[3, design]), float(paths[4, design])


def flown(paths: Any, times: Any, out: Any) -> None:
    """Distances flown in times, m; a column for each design, as of :func:`flying`."""
    path = records.Flight()
    for design in range(times.shape[1]):
        begin(path, paths, design)
        for row in range(times.shape[0]):
            out[row, design] = flight.path_length(path, times[row, design])


def time_at(path: "records.Flight", whole: float, distance: float) -> float:
    """When a flight of a length in time has covered a distance."""
    total, start = flight.path_length(path, whole), flight.velocity_at(path, 0.0)
    push = 2.0 * (total - start * whole) / (whole * whole) if whole > 0.0 else 0.0
    divisor = start + floats.root(max(start * start + 2.0 * push * distance, 0.0))
    time = 2.0 * distance / divisor if divisor > 0.0 else 0.0
    for _ in range(TRIES):
        velocity = flight.velocity_at(path, time)
        step = floats.quotient(flight.path_length(path, time) - distance, velocity) if velocity > 0.0 else 0.0
        time = min(max(time - step, 0.0), whole)
        if not math.fabs(step) > 1e-15 * whole:
            break
    return time if distance == distance and whole == whole else floats.NAN
