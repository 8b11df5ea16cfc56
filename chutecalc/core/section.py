"""Compute a cross-section at one share, and the stream in it.

A section is a stack of facets from the centre outwards (see :mod:`chutecalc.physics.section`): flat walls, or the arc
of a half circle, and vertical walls above the drawn top; or the one arc of a pipe, which closes.
"""

import math
from array import array

from chutecalc.core import circle, floats, matrix


class Section:
    """The numbers that define a section."""

    def __init__(self, walls: int, circle: bool, closed: bool = False) -> None:
        self.circle = circle
        self.closed = closed
        """Whether it has a roof at its wall height: a pipe or a box."""
        self.walls = walls
        """Number of drawn facets of a polygon, on one side."""
        self.base = self.radius = self.wall_height = 0.0
        self.lengths = floats.zeros(max(walls, 1))
        self.inclinations = floats.zeros(max(walls, 1))


class Loads:
    """Loads on the walls at a panel's nodes, or at one position; :mod:`chutecalc.core.friction` computes them."""

    def __init__(self) -> None:
        self.area = floats.zeros(matrix.ROOM)
        """Flow areas, m²; all else follows from them."""
        self.bend = floats.numbers([1.0] * matrix.ROOM)
        """Bound on what χ and depth, by the area, bend more than on a flat facet: A_full/(A_full - A) in a pipe."""
        self.excess, self.excess_sensitivity = floats.zeros(matrix.ROOM), floats.zeros(matrix.ROOM)
        """χ, hydrostatic or of the friction law, and half its logarithmic derivative by the area."""
        self.missing, self.missing_sensitivity = floats.zeros(matrix.ROOM), floats.zeros(matrix.ROOM)
        """The missing load m, and likewise."""
        self.adhesion, self.adhesion_fall, self.adhesion_rise = (floats.zeros(matrix.ROOM) for _ in range(3))
        """What adhesion adds to friction, over g, and half of its fall and of its rise with the area's logarithm."""


class Facets:
    """Constants of each facet at its foot, from which all else follows for any flow area."""

    def __init__(self, count: int, circle: bool, series: "array[float]") -> None:
        """Make room; ``series`` are the circle's, seven times 26 numbers, empty without one."""
        self.count = count
        self.circle = circle
        """Whether the innermost facet is an arc, of a half circle or of a pipe."""
        self.radius = self.deficit = 0.0
        self.full = floats.INFINITY
        """Area at which the arc of a pipe closes, m²; infinite in any other section."""
        self.series = series
        self.loads = Loads()
        self.sine, self.cosine, self.area, self.width, self.height = (floats.zeros(count) for _ in range(5))
        self.excess, self.excess_rise, self.own_excess = (floats.zeros(count) for _ in range(3))
        self.shortfall, self.shortfall_rise, self.own_shortfall = (floats.zeros(count) for _ in range(3))
        self.two_over_sine, self.four_cot, self.apex_width_squared = (floats.zeros(count) for _ in range(3))
        """2/sin ψ; 4 cos ψ/sin ψ; width² of the free surface where the facet's flanks would meet."""
        self.sine_own_excess, self.sine_own_shortfall = (floats.zeros(count) for _ in range(2))
        """sin ψ times ``own_excess`` and ``own_shortfall``."""


def interpolate_sections(first: Section, last: Section, share: float, target: Section) -> None:
    """Write the section at a share of a taper: each of its numbers varies linearly from first to last."""
    # A panel far too long must not make a taper infinitely wide.
    share = min(max(share, -1.0), 2.0)
    target.base = first.base + share * (last.base - first.base)
    target.radius = first.radius + share * (last.radius - first.radius)
    target.wall_height = interpolate_number(first.wall_height, last.wall_height, share)
    for k in range(first.walls):
        target.lengths[k] = interpolate_number(first.lengths[k], last.lengths[k], share)
        target.inclinations[k] = first.inclinations[k] + share * (last.inclinations[k] - first.inclinations[k])


def interpolate_number(first: float, last: float, share: float) -> float:
    """Return the number at a share from first to last; infinite where both are."""
    return first if first == floats.INFINITY else first + share * (last - first)


def stack_facets(section: Section, vertical_ratio: float, facets: Facets) -> None:
    """Compute the constants of each facet from the centre outwards."""
    if section.circle:
        stack_circle(section, vertical_ratio, facets)
        return
    area, width, height = 0.0, section.base, 0.0
    excess, excess_rise, shortfall, shortfall_rise = 0.0, 0.0, 0.0, 0.0
    for k in range(facets.count):
        if k < section.walls:
            length, psi = section.lengths[k], section.inclinations[k]
        else:
            length, psi = floats.INFINITY, 0.5 * math.pi
        sine, cosine, one_minus_cosine = 1.0, 0.0, 1.0  # a vertical wall's: a cosine of 6e-17 would open a deep stream
        if psi != 0.5 * math.pi:
            half = math.sin(0.5 * psi)
            sine, cosine = math.sin(psi), math.cos(psi)
            one_minus_cosine = 2.0 * half * half  # without cancellation
        lacking = (1.0 - vertical_ratio) * sine * sine
        own_excess = (1.0 - lacking) * one_minus_cosine
        own_shortfall = lacking * cosine
        facets.sine[k], facets.cosine[k] = sine, cosine
        facets.area[k], facets.width[k], facets.height[k] = area, width, height
        facets.excess[k], facets.excess_rise[k], facets.own_excess[k] = excess, excess_rise, own_excess
        facets.shortfall[k], facets.shortfall_rise[k] = shortfall, shortfall_rise
        facets.own_shortfall[k] = own_shortfall
        if k + 1 < facets.count:
            rise = length * sine
            excess += rise * (excess_rise + own_excess * length)
            excess_rise += 2.0 * own_excess * length
            shortfall += rise * (shortfall_rise + own_shortfall * length)
            shortfall_rise += 2.0 * own_shortfall * length
            area += (width + length * cosine) * rise
            width += 2.0 * length * cosine
            height += rise
        set_derived(facets, k)


def stack_circle(section: Section, vertical_ratio: float, facets: Facets) -> None:
    """Compute the constants of a pipe, or of the half circle and of the vertical walls above it."""
    r, deficit = section.radius, 1.0 - vertical_ratio
    facets.radius, facets.deficit = r, deficit
    if section.closed:
        facets.full = math.pi * (r * r)
    facets.area[0] = facets.height[0] = facets.excess[0] = facets.excess_rise[0] = facets.own_excess[0] = 0.0
    facets.shortfall[0] = facets.shortfall_rise[0] = facets.own_shortfall[0] = 0.0
    facets.sine[0], facets.cosine[0], facets.width[0] = 1.0, 0.0, 2.0 * r
    set_derived(facets, 0)
    if section.closed:
        return
    half = 0.5 * math.pi
    _, excess, _, missing, _ = arc(facets, half * r * r)
    facets.sine[1], facets.cosine[1], facets.width[1] = 1.0, 0.0, 2.0 * r
    facets.area[1], facets.height[1] = half * r * r, r
    facets.excess[1] = facets.area[1] * excess
    facets.excess_rise[1] = 2.0 * r * (half - 1.0 - deficit * (0.25 * math.pi - 1.0 / 3.0))  # 2 r ∫ K (1 - cos ψ) dψ
    facets.own_excess[1] = 1.0 - deficit
    facets.shortfall[1] = facets.area[1] * missing
    facets.shortfall_rise[1] = 2.0 * r * deficit / 3.0  # 2 r ∫ (1 - K) cos ψ dψ
    facets.own_shortfall[1] = 0.0
    set_derived(facets, 1)


def set_derived(facets: Facets, k: int) -> None:
    """Compute what does not depend on the area."""
    facets.two_over_sine[k] = floats.quotient(2.0, facets.sine[k])
    facets.four_cot[k] = 2.0 * facets.cosine[k] * facets.two_over_sine[k]
    facets.apex_width_squared[k] = facets.width[k] * facets.width[k] - facets.four_cot[k] * facets.area[k]
    facets.sine_own_excess[k] = facets.sine[k] * facets.own_excess[k]
    facets.sine_own_shortfall[k] = facets.sine[k] * facets.own_shortfall[k]


def facet_of(facets: Facets, area: float) -> int:
    """Return the facet on which the free surface of a flow area lies; a corner belongs to the facet above."""
    k = facets.count - 1
    while k > 0 and area < facets.area[k]:
        k -= 1
    return k


def depth_and_width(facets: Facets, k: int, area: float) -> tuple[float, float]:
    """Return depth and width of the free surface, m."""
    if facets.circle and k == 0:
        angle, _, _, _, _ = arc(facets, area)
        if not (angle > -4.0 and angle < 4.0):
            return floats.NAN, floats.NAN
        half = math.sin(0.5 * angle)
        sine = math.sin(angle) if angle < math.pi else 0.0  # a full pipe has no free surface
        return 2.0 * facets.radius * half * half, 2.0 * facets.radius * sine
    width = floats.root(facets.four_cot[k] * area + facets.apex_width_squared[k])
    wetted = floats.quotient(facets.two_over_sine[k], width + facets.width[k]) * (area - facets.area[k])
    return facets.height[k] + wetted * facets.sine[k], width


def wetted_below(section: Section, facets: Facets, k: int, area: float) -> float:
    """Return the wetted length of the sloping drawn facets on one side, m, without the walls above the drawn top."""
    if facets.circle:
        angle = 0.5 * math.pi
        if k == 0:
            angle, _, _, _, _ = arc(facets, area)
        return facets.radius * angle
    total = 0.0
    for below in range(min(k, section.walls)):
        if section.inclinations[below] != 0.0:
            total += section.lengths[below]
    if k < section.walls:
        width = floats.root(facets.four_cot[k] * area + facets.apex_width_squared[k])
        total += floats.quotient(facets.two_over_sine[k], width + facets.width[k]) * (area - facets.area[k])
    return total


def floor_width(section: Section) -> float:
    """Return the width of a polygon's centre section with its level facets, m."""
    width = section.base
    for k in range(section.walls):
        if section.inclinations[k] == 0.0:
            width += 2.0 * section.lengths[k]
    return width


def area_at_depth(facets: Facets, depth: float) -> float:
    """Return the flow area below a depth, m²."""
    if depth == floats.INFINITY:
        return floats.INFINITY
    k = facets.count - 1
    while k > 0 and depth < facets.height[k]:
        k -= 1
    if facets.circle and k == 0:
        r, dry = facets.radius, 2.0 * facets.radius - depth
        if depth > r:  # in the upper half of a pipe, what is left above the stream
            return facets.full - r * r * circle.area_of_angle(half_angle(dry, r))
        return r * r * circle.area_of_angle(half_angle(depth, r))
    wetted = floats.quotient(depth - facets.height[k], facets.sine[k])
    return facets.area[k] + (facets.width[k] + wetted * facets.cosine[k]) * wetted * facets.sine[k]


def half_angle(depth: float, radius: float) -> float:
    """Return the half-angle of a circle's segment of a depth up to its radius, from ψ0 = 2 asin √(depth/2 r)."""
    return 2.0 * math.asin(math.sqrt(min(max(floats.quotient(0.5 * depth, radius), 0.0), 0.5)))


def arc(facets: Facets, area: float) -> tuple[float, float, float, float, float]:
    """Return angle, χ and A dχ/dA, m and A dm/dA of a stream on the arc, by :mod:`chutecalc.core.circle`."""
    scaled_area = floats.quotient(area, facets.radius * facets.radius)
    if area > 0.5 * facets.full:
        return circle.upper_arc(facets.series, facets.deficit, scaled_area)
    return circle.lower_arc(facets.series, facets.deficit, scaled_area)


def widest(facets: Facets, depth: float, width: float) -> float:
    """Return the greatest width of a stream, m: of its free surface, but in a pipe fuller than half the diameter."""
    return 2.0 * facets.radius if facets.full < floats.INFINITY and depth > facets.radius else width
