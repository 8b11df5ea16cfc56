"""A slow solver that shares nothing with chutecalc but the model: scipy's DOP853 on v² along the segment, the section's
depth by root finding on its drawn width, its friction by adding up the wall's elements."""

from math import cos, radians, sin, sqrt, tan
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

G = 9.80665


class Section:
    """A base, one chamfer a side of a length, vertical walls above."""

    def __init__(self, base: float, angle: float, length: float, delta: float) -> None:
        self.base, self.angle, self.length = base, radians(angle), length
        self.k_v = (1 - sin(radians(delta))) / (1 + sin(radians(delta)))

    def ratio(self, psi: float) -> float:
        """Paper Eq 4 as printed, with sin δ from K_v."""
        sine = (1 - self.k_v) / (1 + self.k_v)
        return (1 + sine * cos(2 * psi)) / (1 + sine)

    def area(self, depth: float) -> float:
        """Trapezoid and rectangle."""
        low = min(depth, self.length * sin(self.angle))
        wide = self.base + 2 * low / tan(self.angle)
        return (self.base + wide) / 2 * low + wide * (depth - low)

    def depth(self, area: float) -> float:
        return brentq(lambda depth: self.area(depth) - area, 0.0, 10.0 + area / 0.01, xtol=1e-16, rtol=1e-15)

    def friction_factor(self, area: float) -> float:
        """N_t/N: weight, and what the walls add, each wall element's mean depth times its length."""
        depth = self.depth(area)
        low = min(depth, self.length * sin(self.angle))
        chamfer = low / sin(self.angle) * (depth - low / 2)
        wall = (depth - low) ** 2 / 2
        walls = self.ratio(self.angle) * (1 - cos(self.angle)) * chamfer + self.ratio(radians(90)) * wall
        return 1 + 2 * walls / area


def travel(case: dict[str, Any]) -> tuple[str, float, float]:
    """Return how a stream ends on one segment: status, distance travelled, velocity there.

    Args:
        case: kind, velocity, start and end slopes, radius or length, and what the section and the flow need.
    """
    section = Section(case["base"], case["chamfer"], case["chamfer_length"], case["delta"])
    flow, mu = case["rate"] / 3.6 / case["density"], tan(radians(case["wall"]))
    start, end = radians(case["start"]), radians(case["end"])
    length = case["length"] if case["kind"] == "straight" else case["radius"] * abs(end - start)
    side = -1.0 if case["kind"] == "hood" else 1.0
    turn = (end - start) / length

    def normal(s: float, y: float) -> float:
        return side * (G * cos(start + turn * s) - turn * y)

    def slope(s: float, y: np.ndarray) -> list[float]:
        y0 = max(y[0], 1e-300)
        pressed = normal(s, y0)
        return [2 * (G * sin(start + turn * s) - mu * section.friction_factor(flow / sqrt(y0)) * pressed)]

    def leaves(s: float, y: np.ndarray) -> float:
        return normal(s, y[0])

    leaves.terminal, leaves.direction = True, -1.0
    if case["kind"] in {"crest", "hood"} and normal(0.0, case["velocity"] ** 2) < 0:
        return "contact_lost", 0.0, case["velocity"]
    watch = [leaves] if case["kind"] in {"crest", "hood"} else []
    slow = 1e-3 * case["velocity"] ** 2

    def crawls(s: float, y: np.ndarray) -> float:
        return y[0] - slow

    crawls.terminal, crawls.direction = True, -1.0
    found = solve_ivp(
        slope, (0.0, length), [case["velocity"] ** 2], method="DOP853", rtol=3e-14, atol=1e-16, events=[*watch, crawls]
    )
    if watch and found.t_events[0].size:
        (left, *_), ((square, *_), *_) = found.t_events[0], found.y_events[0]
        return "contact_lost", float(left), float(sqrt(square))
    if not found.t_events[-1].size:
        return "ok", length, float(sqrt(found.y[0, -1]))
    # near a stop the root of v is the better variable: ds/dr = 4 r³/(dy/ds)
    s, root = float(found.t_events[-1][0]), slow**0.25
    stop = solve_ivp(
        lambda r, s: [4 * r**3 / slope(s[0], np.array([r**4]))[0]], (root, root * 1e-3), [s],
        method="DOP853", rtol=3e-14, atol=1e-16,
    )  # fmt: skip
    if not stop.success or stop.y[0, -1] > length or (np.diff(stop.y[0]) < 0).any():
        return "unclear", length, 0.0
    return "stall", float(stop.y[0, -1]), 0.0
