"""How a stream lies in its section at one place of a segment, and what the walls bear there."""

from typing import Any

from chutecalc.core import floats, friction, section, slide

LYING, PRESSING = 5, 8
"""How many tables come out of each."""
LIE, PRESS = LYING, PRESSING  # as Python sees them


def lie(way: "slide.Slide", place: float, y: float, row: int, design: int, out: Any) -> None:
    """Depth, width of the free surface, wetted length of the drawn facets on one side; m; height of the drawn top.

    Args:
        way: the segment and the flow.
        place: share of its length.
        y: v² there.
        row, design: where in the tables.
        out: five tables; what does not exist is not a number.
    """
    for number in range(LYING):
        out[number, row, design] = floats.NAN
    if not y > 0.0:  # a stream that stands still has no depth
        return
    slide.draw(way, place)
    area = slide.flow_area(way, y)
    k = section.facet_of(way.facets, area)
    depth, width = section.depth_and_width(way.facets, k, area)
    friction.loads_at(way.facets, k, area)
    if way.taper:
        chamfer = section.wetted_below(way.here, way.facets, k, area)
    else:
        chamfer = section.wetted_below(way.first, way.facets, k, area)
    out[0, row, design], out[1, row, design], out[2, row, design] = depth, width, chamfer
    out[3, row, design] = way.facets.loads.missing[0]
    last = way.facets.count - 1
    if last > 0 and (way.facets.circle or last >= way.first.walls):
        out[4, row, design] = way.facets.height[last]


def press(way: "slide.Slide", place: float, y: float, row: int, design: int, out: Any) -> None:
    """Normal acceleration; what the wall's friction is read at, and μ; μ_e, and as if all walls bore the weight alike.

    And the greatest pressures on the centre section, on the chamfers and on the vertical side walls, Pa. A wall at
    inclination ψ, ζ below the free surface, bears f K(ψ) ρ n ζ; each is pressed hardest at its foot, and the centre
    section with f ρ n H. The friction law's one factor f for all walls makes friction on them add up to μ_e ρ n A a
    metre of chute. Where there is no centre section its place is taken by the foot of the flanks.

    Args:
        way, place, y, row, design: as of :func:`lie`.
        out: eight tables.
    """
    for number in range(PRESSING):
        out[number, row, design] = floats.NAN
    if not y >= 0.0:
        return
    slide.draw(way, place)
    area, normal = slide.flow_area(way, y), slide.normal(way, place, y)
    k = section.facet_of(way.facets, area)
    depth, _ = section.depth_and_width(way.facets, k, area)
    friction.loads_at(way.facets, k, area)
    hydrostatic, missing = way.facets.loads.excess[0], way.facets.loads.missing[0]
    excess, factor = friction.raised(way.equilibrium, way.facets.loads)
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
