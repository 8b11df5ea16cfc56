"""Circles, facets and tapers along whole segments, against DOP853 on a friction law by quadrature."""

from typing import NamedTuple

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import chutecalc
from tests.conftest import chute

G = 9.80665
GAUSS, WEIGHTS = np.polynomial.legendre.leggauss(40)


class Section(NamedTuple):
    """A section filled to a depth: its area, and ∫ K (1 - cos ψ) ζ dl with K = 1 - k sin²ψ."""

    area: float
    level: float
    """The integral at k = 0."""
    lack: float
    """What the integral loses for each k."""


def circle(radius):
    def of(depth):
        top = min(depth, radius)
        angle, above = np.arccos(1 - top / radius), depth - top
        psi = angle * (1 + GAUSS) / 2
        zeta = radius * (np.cos(psi) - np.cos(angle)) + above
        area = radius**2 * (angle - np.sin(angle) * np.cos(angle)) + 2 * radius * above
        element = 2 * radius * (1 - np.cos(psi)) * zeta * WEIGHTS * angle / 2
        return Section(area, element.sum() + above**2, (element * np.sin(psi) ** 2).sum() + above**2)

    return of


def polygon(base, sides):
    def of(depth):
        area, width, foot, level, lack = 0.0, base, 0.0, 0.0, 0.0
        for length, slope in (*sides, (np.inf, np.pi / 2)):
            rise = min(length * np.sin(slope), depth - foot)
            if rise <= 0:
                break
            spread = rise / np.tan(slope)
            area += (width + spread) * rise
            moment = (2 * (depth - foot) - rise) * rise / np.sin(slope)
            level += (1 - np.cos(slope)) * moment
            lack += (1 - np.cos(slope)) * np.sin(slope) ** 2 * moment
            width, foot = width + 2 * spread, foot + rise
        return Section(area, level, lack)

    return of


def end_velocity(section_at, segment, velocity, flow, mu, k):
    """DOP853 along the segment; the section at a share of its length."""

    def rate(s, y):
        v = y[0]
        of = section_at(s / segment["length"])
        depth = brentq(lambda h: of(h).area - flow / v, 1e-9, 50.0, xtol=1e-15, rtol=1e-14)
        area, level, lack = of(depth)
        slope = segment["slope"] - segment["curvature"] * s
        n = G * np.cos(slope) + segment["curvature"] * v * v
        return [(G * np.sin(slope) - mu * (1 + (level - k * lack) / area) * n) / v]

    # over a kink of the section a step is off by its square times the jump of the slope: many small ones
    run = solve_ivp(
        rate, (0, segment["length"]), [velocity], "DOP853", rtol=1e-9, atol=1e-12, max_step=segment["length"] / 60
    )
    return run.y[0, -1]


def between(one, other, share):
    return one + share * (other - one)


CASES = {
    "half pipe": ({"a": {"shape": "circular", "radius_m": 0.4}}, lambda c: circle(0.4), 800.0),
    "half pipe, overtopped": ({"a": {"shape": "circular", "radius_m": 0.15}}, lambda c: circle(0.15), 900.0),
    "facets": (
        {"a": {"shape": "facets", "facets": [{"length_m": 0.1, "slope_deg": 15}, {"length_m": 0.2, "slope_deg": 50}]}},
        lambda c: polygon(0.0, [(0.1, np.radians(15.0)), (0.2, np.radians(50.0))]),
        1000.0,
    ),
    "taper of circles": (
        {"a": {"shape": "circular", "radius_m": 0.5}, "b": {"shape": "circular", "radius_m": 0.2}},
        lambda c: circle(between(0.5, 0.2, c)),
        1200.0,
    ),
    "taper of chamfers": (
        {
            "a": {"shape": "chamfered", "base_m": 0.8, "chamfer_deg": 30, "chamfer_m": 0.1},
            "b": {"shape": "chamfered", "base_m": 0.3, "chamfer_deg": 70, "chamfer_m": 0.25},
        },
        lambda c: polygon(between(0.8, 0.3, c), [(between(0.1, 0.25, c), np.radians(between(30.0, 70.0, c)))]),
        1500.0,
    ),
}


@pytest.mark.parametrize("curved", [False, True])
@pytest.mark.parametrize("name", CASES)
def test_a_segment(name, curved):
    sections, section_at, rate = CASES[name]
    delta, mu = np.radians(45.0), np.tan(np.radians(22.0))
    slope = np.radians(52.0)
    radius, turn = 2.5, np.radians(45.0)
    shape = {"section": ["a", "b"]} if len(sections) > 1 else {"section": "a"}
    if curved:
        segment = {"kind": "curve", "radius_m": radius, "to_slope_deg": 7.0} | shape
        independent = {"length": radius * turn, "slope": slope, "curvature": 1 / radius}
    else:
        segment = {"kind": "straight", "slope_deg": 52.0, "length_m": 4.0} | shape
        independent = {"length": 4.0, "slope": slope, "curvature": 0.0}
    solution = chutecalc.solve(
        chute(
            flow={"rate_t_h": rate},
            material={"density_kg_m3": 900.0, "internal_friction_deg": 45.0},
            liners={"wall": {"friction_deg": 22.0}},
            sections=sections,
            inlet={"velocity_m_s": 4.0, "slope_deg": 52.0},
            segments=[segment],
        )
    )
    k = 1 - (1 - np.sin(delta)) / (1 + np.sin(delta))
    exact = end_velocity(section_at, independent, 4.0, rate / 3.6 / 900.0, mu, k)
    assert solution.exit_velocity[0] == pytest.approx(exact, rel=2e-8)
