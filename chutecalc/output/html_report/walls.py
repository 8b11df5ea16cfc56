"""Depth and excess friction of a stream in its section, wall by wall, with the numbers put in."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from chutecalc.output.html_report.worked import Number, Worked, stated, worked
from chutecalc.physics.pressure import pressure_ratio
from chutecalc.physics.section import Circle, Polygon, interpolate_sections

DRY = 1e-9
"""Share of the depth below which what is wet of a wall is rounding."""
GEOMETRY = "geometry of the section"
EXCESS = "physics, equivalent friction: χ = (1/A) ∫ K(ψ) (1 − cos ψ) ζ dl"
MISSING = "physics, friction law: m = 1 − (1/A) ∫ K(ψ) cos ψ ζ dl"


class WetWall(NamedTuple):
    """What a stream wets of a wall beside the floor; there is one on each side."""

    inclination: float
    """ψ, to the plane of the floor, rad."""
    length: float
    """l, m."""
    mean_depth: float
    """ζ, of its middle below the free surface, m."""


def floor_width(section: Polygon) -> float:
    """Return the width of the floor, m: that of the centre section and of level facets beside it.

    Args:
        section: of one design.
    """
    drawn = zip(section.lengths, section.inclinations, strict=True)
    return float(section.base[0]) + sum(2.0 * float(length[0]) for length, psi in drawn if psi[0] == 0.0)


def wet_walls(section: Polygon, depth: float) -> list[WetWall]:
    """Return the walls beside the floor that a stream wets, from the centre outwards.

    Args:
        section: of one design.
        depth: of the stream, m.
    """
    foot, found = 0.0, []
    drawn = zip(section.lengths, section.inclinations, strict=True)
    walls = [(float(length[0]), float(psi[0])) for length, psi in drawn if psi[0] > 0.0]
    for length, psi in [*walls, (np.inf, np.pi / 2)]:
        wet = min(length * np.sin(psi), depth - foot)
        if wet > DRY * depth:
            found.append(WetWall(psi, float(wet / np.sin(psi)), depth - foot - 0.5 * wet))
        foot += length * np.sin(psi)
    return found


def depth_formulas(at: Any, area: Number, depth: Number) -> Iterator[Worked]:
    """Yield how the depth follows from the flow area.

    Args:
        at: the stream at one station, a profile of its contact.
        area: flow area A.
        depth: H.
    """
    section, meaning = section_at(at), "depth, at which the section holds the flow area"
    if isinstance(section, Circle):
        yield from _depth_in_circle(section, depth, meaning)
        return
    height = 0.0
    foot_area, width = 0.0, floor_width(section)
    for wall in wet_walls(section, depth.value)[:-1]:
        rise, wider = wall.length * np.sin(wall.inclination), width + 2.0 * wall.length * np.cos(wall.inclination)
        height, foot_area, width = height + rise, foot_area + 0.5 * (width + wider) * rise, wider
    free = Number("b_s", float(np.ravel(at.width)[0]), "m")
    if not height:
        floor = Number("B", width, "m")
        same = abs(free.value - width) < DRY * width
        template = "{area}/{floor}" if same else "2 · {area}/({floor} + {free})"
        words = meaning if same else f"{meaning}; B and b_s the widths of floor and free surface"
        yield worked(depth, words, template, GEOMETRY, area=area, floor=floor, free=free)
        return
    yield worked(
        depth,
        f"{meaning}; b_s the width of the free surface, A_k, B_k and H_k flow area, width and height at the foot of the"
        " wall that it meets",
        "{foot} + 2 · ({area} − {below})/({width} + {free})",
        GEOMETRY,
        area=area,
        foot=Number("H_k", height, "m"),
        below=Number("A_k", foot_area, "m²"),
        width=Number("B_k", width, "m"),
        free=free,
    )


def _depth_in_circle(section: Circle, depth: Number, meaning: str) -> Iterator[Worked]:
    """Yield how the depth in an arc follows from the flow area; above a half circle it is stated."""
    radius = Number("r", float(section.radius[0]), "m")
    if depth.value > radius.value and not section.closed:
        yield stated(depth, meaning, "A(H) = A", GEOMETRY)
        return
    angle = Number("ψ_0", float(np.degrees(np.arccos(1.0 - depth.value / radius.value))), "°")
    words = "angle of the wetted arc, from its lowest point to the free surface, in rad where it stands alone"
    yield stated(angle, words, "root of r² (ψ_0 − sin ψ_0 cos ψ_0) = A", GEOMETRY)
    yield worked(depth, meaning, "{r} · (1 − cos {angle})", GEOMETRY, r=radius, angle=angle)


def friction_formulas(
    at: Any, area: Number, depth: Number, ratio: Number, excess: Number, missing: Number
) -> Iterator[Worked]:
    """Yield how the excess friction and the missing load of hydrostatic wall pressures follow from the section.

    Args:
        at: the stream at one station, a profile of its contact.
        area: flow area A.
        depth: H.
        ratio: K_v.
        excess: χ, hydrostatic.
        missing: m.
    """
    section = section_at(at)
    of_excess, of_missing = "excess friction of the walls beside the floor", "share of the weight left uncarried"
    if isinstance(section, Circle):
        yield stated(excess, of_excess, "(1/A) ∫ K(ψ) (1 − cos ψ) ζ dl", EXCESS)
        yield stated(missing, of_missing, "1 − (1/A) ∫ K(ψ) cos ψ ζ dl", MISSING)
        return
    walls = wet_walls(section, depth.value)
    numbers = {"A": area, "H": depth, "B": Number("B", floor_width(section), "m")}
    friction, carried = [], ["{B} · {H}"]
    for k, wall in enumerate(walls, 1):
        psi, upright = Number(f"ψ_{k}", float(np.degrees(wall.inclination)), "°"), wall.inclination == np.pi / 2
        share = ratio if upright else Number(f"K_{k}", float(pressure_ratio(wall.inclination, ratio.value)))
        numbers |= {f"K{k}": share, f"psi{k}": psi, f"zeta{k}": Number(f"ζ_{k}", wall.mean_depth, "m")}
        numbers[f"l{k}"] = Number(f"l_{k}", wall.length, "m")
        friction.append(f"2 · {{K{k}}} · (1 − cos {{psi{k}}}) · {{zeta{k}}} · {{l{k}}}")
        if not upright:
            carried.append(f"2 · {{K{k}}} · cos {{psi{k}}} · {{zeta{k}}} · {{l{k}}}")
            meaning = "pressure on an inclined wall over that on the floor at the same depth"
            template = "cos² {psi} + {ratio} · sin² {psi}"
            yield worked(share, meaning, template, "paper, equation 4", psi=psi, ratio=ratio)
    of_excess += "; ψ the inclination of each, l its wetted length, ζ the mean depth of that below the free surface"
    yield worked(excess, of_excess, f"({' + '.join(friction)})/{{A}}", EXCESS, **numbers)
    if len(carried) > 1 or not numbers["B"].value:
        yield worked(missing, of_missing, f"1 − ({' + '.join(carried)})/{{A}}", MISSING, **numbers)


def section_at(at: Any) -> Polygon | Circle:
    """Return the section at a station.

    Args:
        at: the stream there, a profile of its contact.
    """
    segment = at.contact.segment
    if segment.end_section is None:
        section: Polygon | Circle = segment.section
        return section
    between: Polygon | Circle = interpolate_sections(segment.section, segment.end_section, float(np.ravel(at.share)[0]))
    return between
