"""Tabulate quantities along a solved segment at any shares: the stream in its section, and the loads on its walls.

Shares have shape (shares, designs); so have v² there and the results, a table for each quantity. NaN stands for what
does not exist.
"""

import math
from typing import Any

from chutecalc.core import batch, flight, floats, guide_surface, records, wall_loads

MAX_ITERATIONS = 60
"""Bound on Newton's iterations: six suffice except next to the apex of a steep throw."""


def tabulate_stream_section(
    guide: "guide_surface.Guide",
    numbers: Any,
    start: int,
    surfaces: Any,
    shares: Any,
    velocities_squared: Any,
    out: Any,
) -> None:
    """Write the stream in its section, see :func:`chutecalc.core.wall_loads.write_stream_section`.

    Args:
        guide: a record of the segment's layout.
        numbers: rows of all designs, as they were solved with.
        start: offset of the segment's wall in a row.
        surfaces: entry slope, turn and length of the segment, a row each.
        shares: shares of the segment's length.
        velocities_squared: v² there, m²/s².
        out: seven tables.
    """
    for design in range(shares.shape[1]):
        batch.restore_guide(
            guide, numbers, design, start, surfaces[design, 0], surfaces[design, 1], surfaces[design, 2]
        )
        for row in range(shares.shape[0]):
            wall_loads.write_stream_section(
                guide, shares[row, design], velocities_squared[row, design], row, design, out
            )


def tabulate_wall_loads(
    guide: "guide_surface.Guide",
    numbers: Any,
    start: int,
    surfaces: Any,
    shares: Any,
    velocities_squared: Any,
    out: Any,
) -> None:
    """Write the loads on the walls, see :func:`chutecalc.core.wall_loads.write_wall_loads`.

    Args:
        guide, numbers, start, surfaces, shares, velocities_squared: as in :func:`tabulate_stream_section`.
        out: eight tables.
    """
    for design in range(shares.shape[1]):
        batch.restore_guide(
            guide, numbers, design, start, surfaces[design, 0], surfaces[design, 1], surfaces[design, 2]
        )
        for row in range(shares.shape[0]):
            wall_loads.write_wall_loads(guide, shares[row, design], velocities_squared[row, design], row, design, out)


def tabulate_flight(paths: Any, times: Any, distances: Any, out: Any) -> None:
    """Write time since a flight began, x, z, velocity and slope at distances flown.

    The time follows by Newton's method from uniform acceleration between the same ends.

    Args:
        paths: a column for each design: start of the flight, x and z; velocities forward and downward; gravity.
        times: duration of the flight, s.
        distances: m, a column for each design.
        out: five tables.
    """
    path = records.Flight()
    for design in range(distances.shape[1]):
        read_flight(path, paths, design)
        for row in range(distances.shape[0]):
            time = flight_time_at(path, times[design], distances[row, design])
            out[0, row, design], out[1, row, design] = time, flight.x_at(path, time)
            out[2, row, design], out[3, row, design] = flight.z_at(path, time), flight.velocity_at(path, time)
            out[4, row, design] = flight.slope_at(path, time)


def read_flight(path: "records.Flight", paths: Any, design: int) -> None:
    """Read a design's flight."""
    path.x, path.z, path.forward = float(paths[0, design]), float(paths[1, design]), float(paths[2, design])
    path.downward, path.gravity = float(paths[3, design]), float(paths[4, design])


def flight_lengths(paths: Any, times: Any, out: Any) -> None:
    """Write the distances flown in given times, m; a column for each design, as in :func:`tabulate_flight`."""
    path = records.Flight()
    for design in range(times.shape[1]):
        read_flight(path, paths, design)
        for row in range(times.shape[0]):
            out[row, design] = flight.path_length(path, times[row, design])


def flight_time_at(path: "records.Flight", whole: float, distance: float) -> float:
    """Return the time at which a flight of a given duration has covered a distance."""
    total, start = flight.path_length(path, whole), flight.velocity_at(path, 0.0)
    acceleration = 2.0 * (total - start * whole) / (whole * whole) if whole > 0.0 else 0.0
    divisor = start + floats.root(max(start * start + 2.0 * acceleration * distance, 0.0))
    time = 2.0 * distance / divisor if divisor > 0.0 else 0.0
    for _ in range(MAX_ITERATIONS):
        velocity = flight.velocity_at(path, time)
        step = floats.quotient(flight.path_length(path, time) - distance, velocity) if velocity > 0.0 else 0.0
        time = min(max(time - step, 0.0), whole)
        if not math.fabs(step) > 1e-15 * whole:
            break
    return time if distance == distance and whole == whole else floats.NAN
