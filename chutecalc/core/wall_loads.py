"""Compute the stream in its section at one share of a segment, and the loads on the walls there."""

from typing import Any

from chutecalc.core import floats, friction, guide_surface, section

SECTION_ROWS, LOAD_ROWS = 7, 8
"""Number of tables that each writes."""
STREAM_SECTION_ROWS, WALL_LOAD_ROWS = SECTION_ROWS, LOAD_ROWS  # for Python; the others are C constants if compiled


def write_stream_section(guide: "guide_surface.Guide", share: float, y: float, row: int, design: int, out: Any) -> None:
    """Write how a stream fills its section.

    These are depth, width of the free surface, wetted length of the drawn facets on one side, missing load, height of
    the drawn top, fill, and greatest width. The fill is the share of a closed section's area, or of the walls' height.

    Args:
        guide: the segment and the flow.
        share: share of its length.
        y: v² there.
        row, design: indices in the tables.
        out: seven tables; NaN for what does not exist.
    """
    for number in range(SECTION_ROWS):
        out[number, row, design] = floats.NAN
    if not y > 0.0:  # a stream at rest has no depth
        return
    guide_surface.set_section(guide, share)
    area = guide_surface.flow_area(guide, y)
    k = section.facet_of(guide.facets, area)
    depth, width = section.depth_and_width(guide.facets, k, area)
    friction.hydrostatic_loads_at(guide.facets, k, area)
    if guide.taper:
        chamfer = section.wetted_below(guide.section_here, guide.facets, k, area)
    else:
        chamfer = section.wetted_below(guide.first, guide.facets, k, area)
    out[0, row, design], out[1, row, design], out[2, row, design] = depth, width, chamfer
    out[3, row, design] = guide.facets.loads.missing[0]
    last = guide.facets.count - 1
    if last > 0 and (guide.facets.circle or last >= guide.first.walls):
        out[4, row, design] = guide.facets.height[last]
    height = guide_surface.wall_height(guide, share)
    if guide.first.closed:
        out[5, row, design] = area / section.area_at_depth(guide.facets, height)
    elif height < floats.INFINITY:
        out[5, row, design] = depth / height
    out[6, row, design] = section.widest(guide.facets, depth, width)


def write_wall_loads(guide: "guide_surface.Guide", share: float, y: float, row: int, design: int, out: Any) -> None:
    """Write normal acceleration; wall stress and μ; μ_e, and μ_e of the equilibrium law; and the greatest pressures.

    These are on the centre section, on the chamfers and on the vertical side walls, Pa. A wall at inclination ψ, ζ
    below the free surface, bears f K(ψ) ρ n ζ; each is pressed hardest at its foot, and the centre section with f ρ n
    H. The one factor f for all walls makes friction on them add up to μ_e ρ n A a metre of chute. Where there is no
    centre section, the foot of the flanks takes its place.

    Args:
        guide, share, y, row, design: as in :func:`write_stream_section`.
        out: eight tables.
    """
    for number in range(LOAD_ROWS):
        out[number, row, design] = floats.NAN
    if not y >= 0.0:
        return
    guide_surface.set_section(guide, share)
    area, normal = guide_surface.flow_area(guide, y), guide_surface.normal_acceleration(guide, share, y)
    k = section.facet_of(guide.facets, area)
    depth, _ = section.depth_and_width(guide.facets, k, area)
    friction.hydrostatic_loads_at(guide.facets, k, area)
    hydrostatic, missing = guide.facets.loads.excess[0], guide.facets.loads.missing[0]
    excess, factor = friction.friction_law(guide.equilibrium, guide.facets.loads)
    weight = guide.density * max(normal, 0.0)
    stress = weight * factor * depth if y > 0.0 else floats.INFINITY
    mu = guide_surface.wall_friction(guide, stress)
    equal_loads_friction = guide_surface.wall_friction(guide, weight * floats.quotient(depth, 1.0 - missing))
    out[0, row, design], out[1, row, design], out[2, row, design] = normal, stress, mu
    if excess < floats.INFINITY:
        out[3, row, design] = mu * (1.0 + excess)
    if y == 0.0:  # at rest, without a depth
        return
    out[4, row, design] = equal_loads_friction * (1.0 + floats.quotient(hydrostatic, 1.0 - missing))
    chamfer, side = pressure_on(guide, factor * weight, depth, False), pressure_on(guide, factor * weight, depth, True)
    centre = factor * weight * depth
    floor = section.floor_width(guide.section_here) if guide.taper else section.floor_width(guide.first)
    if not guide.facets.circle and floor == 0.0:
        centre = side if chamfer != chamfer or side > chamfer else chamfer
    out[5, row, design], out[6, row, design], out[7, row, design] = centre, chamfer, side


def pressure_on(guide: "guide_surface.Guide", weight: float, depth: float, upright: bool) -> float:
    """Return the greatest pressure on the chamfers or on the side walls, Pa: 0 on dry ones, NaN without any."""
    most = floats.NAN
    for k in range(guide.facets.count):
        arc = guide.facets.circle and k == 0
        drawn = arc or (not guide.facets.circle and k < guide.first.walls)
        if drawn == upright or arc or (drawn and guide.facets.sine[k] == 0.0):
            continue
        ratio = 1.0 - (1.0 - guide.vertical_ratio) * guide.facets.sine[k] * guide.facets.sine[k]
        pressure = ratio * weight * max(depth - guide.facets.height[k], 0.0)
        if not most >= pressure:
            most = pressure
    return most
