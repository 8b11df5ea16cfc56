"""Quantities along a solved segment, at any places of it: how the stream lies in its section, and what its walls bear.

Places are rows, a column for each design; so are v² there, and what comes out, a table for each quantity. What does not
exist is not a number.
"""

import math
from typing import Any

from chutecalc.core import batch, flight, floats, records, section, slide

LYING, PRESSING, FLYING = 5, 8, 5
"""How many tables come out of each."""
TABLES = 8  # room for any, as Python sees it
TRIES = 60
"""Newton's: six do but next to the apex of a steep throw."""


def lying(way: "slide.Slide", numbers: Any, start: int, surfaces: Any, places: Any, squared: Any, out: Any) -> None:
    """Depth, width of the free surface, wetted length of the drawn facets on one side; m; height of the drawn top.

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
            lie(way, places[row, design], squared[row, design], row, design, out)


def lie(way: "slide.Slide", place: float, y: float, row: int, design: int, out: Any) -> None:
    """The same at one place."""
    for number in range(LYING):
        out[number, row, design] = floats.NAN
    if not y > 0.0:  # a stream that stands still has no depth
        return
    slide.draw(way, place)
    area = slide.flow_area(way, y)
    k = section.facet_of(way.facets, area)
    depth, width = section.depth_and_width(way.facets, k, area)
    _, _, missing, _ = section.loads(way.facets, k, area)
    if way.taper:
        chamfer = section.wetted_below(way.here, way.facets, k, area)
    else:
        chamfer = section.wetted_below(way.first, way.facets, k, area)
    out[0, row, design], out[1, row, design], out[2, row, design] = depth, width, chamfer
    out[3, row, design] = missing
    last = way.facets.count - 1
    if last > 0 and (way.facets.circle or last >= way.first.walls):
        out[4, row, design] = way.facets.height[last]


def pressing(way: "slide.Slide", numbers: Any, start: int, surfaces: Any, places: Any, squared: Any, out: Any) -> None:
    """Normal acceleration; what the wall's friction is read at, and μ; μ_e, and as if all walls bore the weight alike.

    And the greatest pressures on the centre section, on the chamfers and on the vertical side walls, Pa. A wall at
    inclination ψ, ζ below the free surface, bears f K(ψ) ρ n ζ; each is pressed hardest at its foot, and the centre
    section with f ρ n H. The friction law's one factor f for all walls makes friction on them add up to μ_e ρ n A a
    metre of chute. Where there is no centre section its place is taken by the foot of the flanks.

    Args:
        way, numbers, start, surfaces, places, squared: as of :func:`lying`.
        out: eight tables.
    """
    for design in range(places.shape[1]):
        batch.put_back(way, numbers, design, start, surfaces[design, 0], surfaces[design, 1], surfaces[design, 2])
        for row in range(places.shape[0]):
            press(way, places[row, design], squared[row, design], row, design, out)


def press(way: "slide.Slide", place: float, y: float, row: int, design: int, out: Any) -> None:
    """The same at one place."""
    for number in range(PRESSING):
        out[number, row, design] = floats.NAN
    if not y >= 0.0:
        return
    slide.draw(way, place)
    area, normal = slide.flow_area(way, y), slide.normal(way, place, y)
    k = section.facet_of(way.facets, area)
    depth, _ = section.depth_and_width(way.facets, k, area)
    hydrostatic, _, missing, _ = section.loads(way.facets, k, area)
    excess, factor = slide.law_and_factor(way, k, area)
    weight = way.density * max(normal, 0.0)
    stress = weight * factor * depth if y > 0.0 else floats.INFINITY
    wall = slide.wall_friction(way, stress)
    even = slide.wall_friction(way, weight * floats.quotient(depth, 1.0 - missing))
    out[0, row, design], out[1, row, design], out[2, row, design] = normal, stress, wall
    if excess < floats.INFINITY:
        out[3, row, design] = wall * (1.0 + excess)
    if y == 0.0:  # a heap at rest, without a depth
        return
    out[4, row, design] = even * (1.0 + floats.quotient(hydrostatic, 1.0 - missing))
    chamfer, side = pressure_on(way, factor * weight, depth, False), pressure_on(way, factor * weight, depth, True)
    centre = factor * weight * depth
    floor = section.floor_width(way.here) if way.taper else section.floor_width(way.first)
    if not way.facets.circle and floor == 0.0:
        centre = side if chamfer != chamfer or side > chamfer else chamfer
    out[5, row, design], out[6, row, design], out[7, row, design] = centre, chamfer, side


def pressure_on(way: "slide.Slide", weight: float, depth: float, upright: bool) -> float:
    """The greatest on the chamfers, or on the walls above what is drawn: 0 on dry ones, not a number without any."""
    most = floats.NAN
    for k in range(way.facets.count):
        arc = way.facets.circle and k == 0
        drawn = arc or (not way.facets.circle and k < way.first.walls)
        if drawn == upright or arc or (drawn and way.facets.sine[k] == 0.0):
            continue
        ratio = 1.0 - (1.0 - way.vertical_ratio) * way.facets.sine[k] * way.facets.sine[k]
        pressure = ratio * weight * max(depth - way.facets.height[k], 0.0)
        if not most >= pressure:
            most = pressure
    return most


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
