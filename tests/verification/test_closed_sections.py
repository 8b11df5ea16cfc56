"""The friction law in pipes and boxes: against quadrature in many digits, and the half pipe below half."""

import mpmath
import numpy as np
import pytest
from scipy.integrate import quad

import chutecalc
from chutecalc.physics.section import Circle, Polygon
from chutecalc.physics.wetting import area_at_depth, wetting
from tests.conftest import chute

RADIUS = 0.3
FULL = np.pi * RADIUS**2
EPS = 2.3e-16
FILLS = [1e-9, 1e-5, 0.02, 0.3, 0.4999999, 0.5000001, 0.7, 0.9, 0.99, 0.999, 1 - 1e-5, 1 - 1e-8]
RATIOS = [1.0, 0.4, 0.05, 1e-6]


def pipe(radius=RADIUS):
    return Circle(radius=np.array([radius]), wall_height=np.array([2 * radius]), closed=True)


def exact(area, ratio):
    """ψ0, χ, m, depth and width by quadrature with 40 digits, of these doubles; ψ0 by its dry or wetted segment."""
    with mpmath.workdps(40):
        radius, scaled = mpmath.mpf(RADIUS), mpmath.mpf(area) / mpmath.mpf(RADIUS) ** 2
        small = min(scaled, mpmath.pi - scaled)
        guess = mpmath.cbrt(1.5 * small)
        angle = mpmath.findroot(
            lambda at: at - mpmath.sin(at) * mpmath.cos(at) - small, (0.9 * guess, 1.1 * guess), solver="secant"
        )
        angle = angle if scaled < mpmath.pi / 2 else mpmath.pi - angle

        def load(weight):
            def element(psi):
                head = mpmath.cos(psi) - mpmath.cos(angle)
                return 2 * (1 - (1 - mpmath.mpf(ratio)) * mpmath.sin(psi) ** 2) * weight(psi) * head

            return mpmath.quad(element, mpmath.linspace(0, angle, 4)) / scaled

        excess, carried = load(lambda psi: 1 - mpmath.cos(psi)), load(mpmath.cos)
        depth, width = radius * (1 - mpmath.cos(angle)), 2 * radius * mpmath.sin(angle)
        return tuple(float(number) for number in (angle, excess, 1 - carried, depth, width))


@pytest.mark.parametrize("ratio", RATIOS)
@pytest.mark.parametrize("fill", FILLS)
def test_a_pipe_by_quadrature(fill, ratio):
    area = fill * FULL
    found = wetting(pipe(), np.array([ratio]), np.array([area]))
    angle, excess, missing, depth, width = exact(area, ratio)
    # The area has the rounding EPS A, which moves ψ0 by EPS A/(2 sin²ψ0) and χ A by that times 2 sin ψ0 W, W < 2 π.
    moved = 4 * EPS * (angle - np.sin(angle) * np.cos(angle)) / np.sin(angle) ** 2 if fill > 0.5 else 4 * EPS * angle
    few = 16 * EPS
    assert found.depth[0] == pytest.approx(depth, rel=few, abs=RADIUS * np.sin(angle) * moved)
    assert found.width[0] == pytest.approx(width, rel=few, abs=2 * RADIUS * moved)
    assert found.chamfer[0] == pytest.approx(RADIUS * angle, rel=few, abs=RADIUS * moved)
    assert found.excess[0] == pytest.approx(excess, rel=few, abs=8 * np.sin(angle) * moved * (fill > 0.5))
    assert found.missing_load[0] == pytest.approx(missing, rel=few, abs=4 * EPS)
    assert area_at_depth(pipe(), found.depth)[0] == pytest.approx(area, rel=8 * EPS)


@pytest.mark.parametrize("ratio", RATIOS)
@pytest.mark.parametrize("fill", [1e-6, 0.1, 0.49, 0.51, 0.8, 0.99])
def test_the_sensitivity_is_the_slope(fill, ratio):
    """By differences of χ over a step h of the area: h² from its bend, EPS/h from rounding."""
    area, step = fill * FULL, 1e-5 * (1 - fill)
    found = wetting(pipe(), np.array([ratio]), area * np.array([1 - step, 1.0, 1 + step]))
    slope = (found.excess[2] - found.excess[0]) / (2 * step)
    assert found.excess_sensitivity[1] == pytest.approx(slope, rel=1e-8, abs=4 * EPS * found.excess[1] / step)


def test_below_half_a_pipe_has_the_digits_of_a_half_pipe():
    half = Circle(radius=np.array([RADIUS]), wall_height=np.array([np.inf]))
    areas = FULL * np.geomspace(1e-9, 0.499, 50)
    for equilibrium in (False, True):
        for one, other in zip(
            *(wetting(drawn, np.array([0.3]), areas, equilibrium) for drawn in (pipe(), half)), strict=True
        ):
            assert np.array_equal(one, other)


def test_a_full_pipe_and_a_fuller_one():
    """ψ0 = π: χ = 1 + (1 - K_v)(1/4 - 1), by ∫ sin²ψ (1 - cos ψ)(1 + cos ψ) dψ = 3 π/8, and m = (1 - K_v)/4."""
    for ratio in RATIOS:
        full = wetting(pipe(), np.array([ratio]), FULL * np.array([1.0, 1.2]))
        assert full.excess == pytest.approx(1 - 0.75 * (1 - ratio), rel=1e-14)
        assert full.missing_load == pytest.approx((1 - ratio) / 4, rel=1e-14, abs=1e-16)
        assert full.depth == pytest.approx(2 * RADIUS, rel=1e-15)
        assert full.width.tolist() == [0.0, 0.0]
    assert area_at_depth(pipe(), np.array([2 * RADIUS]))[0] == pytest.approx(FULL, rel=1e-15)


def test_a_box_is_a_rectangle_with_walls():
    rectangle, box = (Polygon(np.array([0.4]), (), (), np.array([0.3]), closed=closed) for closed in (False, True))
    areas = np.linspace(0.001, 0.15, 20)
    for one, other in zip(*(wetting(drawn, np.array([0.3]), areas) for drawn in (box, rectangle)), strict=True):
        assert np.array_equal(one, other)


def entry(section, rate, law="paper"):
    solution = chutecalc.solve(
        chute(
            flow={"rate_t_h": rate},
            material={"density_kg_m3": 1000.0, "pressure_ratio": 0.3},
            model={"friction_law": law},
            sections={"body": section},
            inlet={"velocity_m_s": 2.0, "slope_deg": 60.0},
            segments=[{"kind": "straight", "slope_deg": 60.0, "length_m": 0.5}],
        )
    )
    return {name: column[0] for name, column in solution.segments[0].entry.items()}


@pytest.mark.parametrize("law", ["paper", "equilibrium"])
@pytest.mark.parametrize("fill", [0.2, 0.6, 0.95])
def test_the_pressures_of_a_pipe_close_the_books(fill, law):
    """∫ p dl over the wetted arc is (1 + χ) ρ n A, with the greatest pressure at the bottom as the column has it."""
    at = entry({"shape": "pipe", "radius_m": RADIUS}, 3600.0 * fill * FULL * 2.0, law)
    depth, top = at["depth_m"], np.arccos(1 - at["depth_m"] / RADIUS)

    def share(psi):
        return (1 - 0.7 * np.sin(psi) ** 2) * RADIUS * (np.cos(psi) - np.cos(top)) / depth

    borne = 2 * RADIUS * at["pressure_kpa"] * quad(share, 0, top, epsabs=0, epsrel=1e-12)[0]
    friction = at["equivalent_friction"] / np.tan(np.radians(25.0))
    assert borne == pytest.approx(friction * at["normal_acceleration_m_s2"] * at["area_m2"], rel=1e-10)
    assert np.isnan(at["side_pressure_kpa"])
    assert max(share(psi) for psi in np.linspace(0, top, 200)) == share(0.0)


def test_fill_is_the_share_of_a_closed_area_or_of_the_walls():
    assert entry({"shape": "pipe", "radius_m": RADIUS}, 3600.0 * 0.7 * FULL * 2.0)["fill"] == pytest.approx(0.7)
    assert entry({"shape": "box", "width_m": 0.5, "height_m": 0.4}, 3600.0 * 0.1)["fill"] == pytest.approx(0.25)
    open_ = {"shape": "chamfered", "base_m": 0.5, "chamfer_deg": 45.0}
    walled = entry(open_ | {"wall_height_m": 0.4}, 300.0)
    assert walled["fill"] == pytest.approx(walled["depth_m"] / 0.4)
    assert np.isnan(entry(open_, 300.0)["fill"])
