"""Sections and wall friction of the second solver: sums over wall elements, depths by root finding."""

from dataclasses import dataclass
from itertools import pairwise
from math import atan2, cos, inf, pi, radians, sin, sqrt, tan
from typing import Any

import numpy as np

NODES, WEIGHTS = (array.tolist() for array in np.polynomial.legendre.leggauss(24))
TALL = 1e150  # m, a chamfer without a top


@dataclass
class Load:
    """What a section carries at one flow area: depth, area, the sums over its wetted walls, both sides, its surface."""

    depth: float
    area: float
    bent: float  # ∫ K (1 − cos ψ) ζ dl
    missing: float  # A − ∫ K ζ cos ψ dl
    width: float
    moment: float  # ∫ b ζ dζ

    def chi(self, law: str) -> float:
        chi = self.bent / self.area
        return chi / (1 - self.missing / self.area) if law == "equilibrium" else chi

    def factor(self, law: str) -> float:
        """Return all wall pressures by this much over hydrostatic ones, to carry (1 + χ) N."""
        chi, share = self.bent / self.area, self.missing / self.area
        return 1 / (1 - share) if law == "equilibrium" else (1 + chi) / (1 + chi - share)


class Polygon:
    """Facets of one side from the centre outwards, (length, inclination), then vertical walls."""

    def __init__(self, facets: list[tuple[float, float]], ratio: float, wall: float) -> None:
        self.wall = wall
        top = (inf, pi / 2)
        self.flat = sum(length for length, angle in facets if angle == 0)
        self.rising = [(length, angle) for length, angle in facets if angle > 0] + [top]
        self.trig = [
            (sin(angle), cos(angle) if angle < pi / 2 else 0.0, 2 * sin(angle / 2) ** 2) for _, angle in self.rising
        ]
        self.pressure = [1 - (1 - ratio) * sine**2 for sine, _, _ in self.trig]
        self.lifted = [(1 - ratio) * sine**2 for sine, _, _ in self.trig]  # 1 − K
        heights, halves = [0.0], [self.flat]
        for (length, _), (sine, cosine, _) in zip(self.rising[:-1], self.trig, strict=False):
            heights.append(heights[-1] + length * sine)
            halves.append(halves[-1] + length * cosine)
        self.heights, self.halves = heights, halves
        self.pieces = len(heights)
        self.areas = [0.0]
        for k in range(1, self.pieces):
            self.areas.append(self.areas[-1] + (halves[k] + halves[k - 1]) * (heights[k] - heights[k - 1]))

    def piece(self, area: float) -> int:
        return max(k for k in range(self.pieces) if k == 0 or self.areas[k] <= area)

    def bounds(self, piece: int) -> tuple[float, float]:
        """Between which flow areas the level stands on this facet."""
        return self.areas[piece], self.areas[piece + 1] if piece + 1 < self.pieces else inf

    def depth(self, area: float, piece: int) -> float:
        """Newton on the drawn area, which is convex in depth; from above it cannot miss."""
        sine, cosine, _ = self.trig[piece]
        width, slant = 2 * self.halves[piece], cosine / sine
        more = area - self.areas[piece]
        guesses = [more / width] if width > 0 else []
        if slant > 0 and more > 0:
            guesses.append(sqrt(more / slant))
        height = min(guesses)
        for _ in range(60):
            step = ((width + slant * height) * height - more) / (width + 2 * slant * height)
            height -= step
            if abs(step) <= 1e-15 * abs(height):
                break
        return self.heights[piece] + height

    def load(self, area: float, piece: int | None = None) -> Load:
        piece = self.piece(area) if piece is None else piece
        depth = self.depth(area, piece)
        bent = missing = moment = 0.0
        for k in range(piece + 1):
            sine, cosine, versed = self.trig[k]
            above = depth - self.heights[k]
            thick = above if k == piece else self.heights[k + 1] - self.heights[k]
            # a strip as wide as its foot, and the two triangles beside it
            moment += 2 * self.halves[k] * thick * (above - thick / 2)
            moment += 2 * cosine / sine * thick**2 * (above / 2 - thick / 3)
            wetted = above / sine if k == piece else self.rising[k][0]
            weight = 2 * wetted * (above - wetted * sine / 2)  # ∫ ζ dl of both sides
            bent += self.pressure[k] * versed * weight
            missing += self.lifted[k] * cosine * weight
        sine, cosine, _ = self.trig[piece]
        width = 2 * (self.halves[piece] + (depth - self.heights[piece]) * cosine / sine)
        return Load(depth, area, bent, missing, width, moment)

    def area_at(self, depth: float) -> float:
        piece = max(k for k in range(self.pieces) if k == 0 or self.heights[k] <= depth)
        sine, cosine, _ = self.trig[piece]
        height = depth - self.heights[piece]
        return self.areas[piece] + (2 * self.halves[piece] + cosine / sine * height) * height


class Circle:
    """A half pipe with vertical walls above it; its sums by Gauss quadrature over the wetted angle."""

    pieces = 2

    def __init__(self, radius: float, ratio: float, wall: float) -> None:
        self.radius, self.ratio, self.wall = radius, ratio, wall
        self.top = self.sums(pi / 2)[0]

    def sums(self, half: float) -> tuple[float, float, float, float]:
        """Area, bent, missing and moment of the pipe alone, wetted up to this half angle."""
        area = bent = missing = moment = 0.0
        for node, weight in zip(NODES, WEIGHTS, strict=True):
            angle = half * (1 + node) / 2
            depth = 2 * sin((half + angle) / 2) * sin((half - angle) / 2)
            sine, cosine = sin(angle), cos(angle)
            element = weight * half * depth * self.radius**2  # both sides
            lifted = (1 - self.ratio) * sine * sine
            area += element * cosine
            bent += element * (1 - lifted) * 2 * sin(angle / 2) ** 2
            missing += element * lifted * cosine
            moment += element * sine * sine * self.radius
        return area, bent, missing, moment

    def piece(self, area: float) -> int:
        return int(area >= self.top)

    def bounds(self, piece: int) -> tuple[float, float]:
        return (self.top, inf) if piece else (0.0, self.top)

    def load(self, area: float, piece: int | None = None) -> Load:
        piece = self.piece(area) if piece is None else piece
        radius = self.radius
        if piece:
            _, bent, missing, moment = self.sums(pi / 2)
            height = (area - self.top) / (2 * radius)
            # each element of the pipe lies deeper by `height`
            bent += 2 * height * radius * self.arc(lambda angle: self.k(angle) * (1 - cos(angle)))
            missing += 2 * height * radius * self.arc(lambda angle: (1 - self.k(angle)) * cos(angle))
            moment += self.top * height + radius * height**2
            return Load(radius + height, area, bent + self.ratio * height**2, missing, 2 * radius, moment)
        half = self.half_angle(area)
        _, bent, missing, moment = self.sums(half)
        return Load(2 * radius * sin(half / 2) ** 2, area, bent, missing, 2 * radius * sin(half), moment)

    def half_angle(self, area: float) -> float:
        """Newton on the quadrature's own area; its start is the shallow pipe's."""
        half = min((1.5 * area / self.radius**2) ** (1 / 3), pi / 2)
        for _ in range(60):
            got = self.sums(half)[0]
            step = (got - area) / (2 * (self.radius * sin(half)) ** 2)
            half = half - step if half > step else half / 2
            if abs(step) <= 2e-15 * half:
                break
        return half

    def k(self, angle: float) -> float:
        return cos(angle) ** 2 + self.ratio * sin(angle) ** 2

    @staticmethod
    def arc(function: Any) -> float:
        """Integral over a quarter."""
        return sum(w * pi / 4 * function(pi / 4 * (1 + x)) for x, w in zip(NODES, WEIGHTS, strict=True))

    def area_at(self, depth: float) -> float:
        if depth >= self.radius:
            return self.top + 2 * self.radius * (depth - self.radius)
        return self.sums(2 * np.arcsin(sqrt(depth / (2 * self.radius))))[0]


class Pipe(Circle):
    """A whole pipe: the same sums, wetted up to any half angle. Overfull it has the loads of a full one."""

    pieces = 1

    def __init__(self, radius: float, ratio: float) -> None:
        super().__init__(radius, ratio, 2 * radius)
        self.full = pi * radius**2

    def piece(self, area: float) -> int:
        return 0

    def bounds(self, piece: int) -> tuple[float, float]:
        return 0.0, inf

    def load(self, area: float, piece: int | None = None) -> Load:
        half = self.half_angle(min(area, self.full))
        held, bent, missing, moment = self.sums(half)
        over, width = max(area / self.full, 1.0), 2 * self.radius * sin(half)
        return Load(2 * self.radius * sin(half / 2) ** 2, held * over, bent * over, missing * over, width, moment)

    def half_angle(self, area: float) -> float:
        """Bisect; in the upper half for what is dry, ψ - sin ψ cos ψ of the other angle."""
        wetted = area / self.radius**2
        small = min(wetted, pi - wetted)
        low, high = 0.0, pi / 2
        while high - low > 1e-16 * high:
            middle = (low + high) / 2
            if middle in (low, high):
                break
            if _segment(middle) < small:
                low = middle
            else:
                high = middle
        return low if wetted <= pi / 2 else pi - low

    def area_at(self, depth: float) -> float:
        return self.full if depth >= 2 * self.radius else self.sums(2 * np.arcsin(sqrt(depth / (2 * self.radius))))[0]


def _segment(half: float) -> float:
    """Return ψ - sin ψ cos ψ, of a small ψ by its series."""
    if half < 0.02:
        return half**3 * (2 / 3 - 2 / 15 * half**2 + 4 / 315 * half**4)
    return half - sin(half) * cos(half)


Section = Polygon | Circle


def section_of(table: dict[str, Any], ratio: float) -> Section:
    """Return the section that a spec's table describes."""
    wall = table.get("wall_height_m", inf)
    shape = table["shape"]
    if shape == "circular":
        return Circle(table["radius_m"], ratio, wall)
    if shape == "pipe":
        return Pipe(table["radius_m"], ratio)
    if shape == "box":
        return Polygon([(table["width_m"] / 2, 0.0)], ratio, table["height_m"])
    if shape == "rectangular":
        return Polygon([(table["width_m"] / 2, 0.0)], ratio, wall)
    if shape == "facets":
        facets = [(facet["length_m"], radians(facet["slope_deg"])) for facet in table["facets"]]
        return Polygon(facets, ratio, wall)
    angle = radians(table["chamfer_deg"])
    base = table["base_m"] if shape == "chamfered" else 0.0
    return Polygon([(base / 2, 0.0), (table.get("chamfer_m", TALL), angle)], ratio, wall)


def between(one: Any, other: Any, share: float) -> Any:
    """Return a table whose numbers lie linearly between those of two."""
    if isinstance(one, dict):
        return {key: between(value, other[key], share) for key, value in one.items()}
    if isinstance(one, list):
        return [between(a, b, share) for a, b in zip(one, other, strict=True)]
    return one if isinstance(one, str) else one + (other - one) * share


class Friction:
    """μ_w(σ) of a liner: straight pieces of shear stress over normal stress, each (from σ, intercept, slope)."""

    def __init__(self, liner: dict[str, Any], delta: float | None) -> None:
        self.locus = "yield_locus_kpa" in liner
        if not self.locus:
            angle = liner.get("friction_deg")
            self.pieces = [(0.0, 0.0, sin(delta) if angle is None else tan(radians(angle)))]  # type: ignore[arg-type]
            return
        assert delta is not None
        rows = [(1e3 * sigma, 1e3 * tau) for sigma, tau in liner["yield_locus_kpa"]]
        lines = []
        for (s0, t0), (s1, t1) in pairwise(rows):
            slope = (t1 - t0) / (s1 - s0)
            lines.append((s0, t0 - slope * s0, slope))
        first = lines[0]
        if first[1] < 0:
            lines.insert(0, (0.0, 0.0, rows[0][1] / rows[0][0]))
        else:
            lines[0] = (0.0, *first[1:])
        self.pieces = _least(lines, sin(delta))

    def piece(self, stress: float) -> int:
        return max(k for k in range(len(self.pieces)) if k == 0 or self.pieces[k][0] <= stress)

    def bounds(self, piece: int) -> tuple[float, float]:
        return self.pieces[piece][0], self.pieces[piece + 1][0] if piece + 1 < len(self.pieces) else inf

    def coefficient(self, stress: float, piece: int | None = None) -> float:
        _, intercept, slope = self.pieces[self.piece(stress) if piece is None else piece]
        return slope + intercept / stress if intercept else slope

    def secant(self, stress: float, more: float) -> float:
        """Return the shear stress that `more` normal stress adds, over it."""
        low, high = self.piece(stress), self.piece(stress + more)
        if low == high or more == 0:
            return self.pieces[low][2]
        ends = [stress, *(start for start, _, _ in self.pieces[low + 1 : high + 1]), stress + more]
        slopes = [slope for _, _, slope in self.pieces[low : high + 1]]
        return sum(k * (b - a) for k, a, b in zip(slopes, ends, ends[1:], strict=False)) / more


def _least(lines: list[tuple[float, float, float]], strength: float) -> list[tuple[float, float, float]]:
    """Return the lesser of a broken line and of the ray that is the material's own strength, as a broken line."""
    found: list[tuple[float, float, float]] = []
    for k, (start, intercept, slope) in enumerate(lines):
        end = lines[k + 1][0] if k + 1 < len(lines) else inf
        cut = intercept / (strength - slope) if strength != slope else inf
        starts = [start, cut] if start < cut < end else [start]
        for begin, stop in zip(starts, [*starts[1:], end], strict=True):
            middle = begin + 1 if stop == inf else (begin + stop) / 2
            if intercept + slope * middle > strength * middle:
                intercept_here, slope_here = 0.0, strength
            else:
                intercept_here, slope_here = intercept, slope
            if not found or found[-1][1:] != (intercept_here, slope_here):
                found.append((begin, intercept_here, slope_here))
    return found


def atan_slope(x: float, z: float) -> float:
    """Slope below horizontal of a velocity."""
    return atan2(-z, x)
