"""The friction law of a section: against direct integration over its walls, the paper's formulas, and its tables."""

import numpy as np
import pytest
from scipy.integrate import quad

from chutecalc.physics.friction import equilibrium_friction, equivalent_friction
from chutecalc.physics.pressure import greatest_wall_friction, pressure_ratio, vertical_pressure_ratio
from chutecalc.physics.section import Circle, Polygon
from chutecalc.physics.wetting import area_at_depth, wetting

OPEN = np.array([np.inf])


def polygon(base, *sides):
    """Return a section of facets, each with its length and its inclination in degrees."""
    return Polygon(
        base=np.array([base]),
        lengths=tuple(np.array([length]) for length, _ in sides),
        inclinations=tuple(np.radians([angle]) for _, angle in sides),
        wall_height=OPEN,
    )


def pipe(radius):
    return Circle(radius=np.array([radius]), wall_height=OPEN)


def integral(function, start, end):
    value, _ = quad(function, start, end)
    return value


SECTIONS = {
    "rectangle": polygon(0.5),
    "chamfer": polygon(0.5, (np.inf, 45.0)),
    "chamfer with a top": polygon(0.3, (0.1, 60.0)),
    "vee": polygon(0.0, (np.inf, 50.0)),
    "vee with a top": polygon(0.0, (0.2, 35.0)),
    "three facets": polygon(0.2, (0.08, 20.0), (0.1, 45.0), (0.05, 75.0)),
    "steep": polygon(0.4, (0.3, 89.999999)),
    "shallow": polygon(0.4, (0.5, 0.5)),
}


def walls(section, depth):
    """Wetted wall elements of one side: (height of foot, height of top, inclination)."""
    height = 0.0
    for length, psi in zip(section.lengths, section.inclinations, strict=True):
        top = height + float(length[0] * np.sin(psi[0]))
        yield height, min(top, depth), float(psi[0])
        height = top
        if top >= depth:
            return
    yield height, depth, np.pi / 2


def width_at(section, z):
    """Drawn width at a height."""
    width = float(section.base[0])
    for foot, top, psi in walls(section, z):
        width += 2 * (top - foot) / np.tan(psi) if psi < np.pi / 2 else 0.0
    return width


@pytest.mark.parametrize("depth", [0.001, 0.03, 0.0866, 0.15, 0.6])
@pytest.mark.parametrize("name", SECTIONS)
def test_area_depth_friction_and_missing_load_by_integration(name, depth):
    section, ratio = SECTIONS[name], np.array([0.3])
    area = area_at_depth(section, np.array([depth]))
    breaks = sorted({top for _, top, _ in walls(section, depth)})
    drawn = sum(
        integral(lambda z: width_at(section, z), low, high) for low, high in zip([0.0, *breaks], breaks, strict=False)
    )
    load = hold = 0.0
    for foot, top, psi in walls(section, depth):
        k = 1 - 0.7 * np.sin(psi) ** 2
        moment = integral(lambda z: depth - z, foot, top) / np.sin(psi)
        load += 2 * k * (1 - np.cos(psi)) * moment
        hold += 2 * k * np.cos(psi) * moment
    hold += float(section.base[0]) * depth

    wet = wetting(section, ratio, area)

    assert area[0] == pytest.approx(drawn, rel=1e-11)
    assert wet.depth[0] == pytest.approx(depth, rel=1e-12)
    assert wet.width[0] == pytest.approx(width_at(section, depth), rel=1e-12)
    assert wet.excess[0] == pytest.approx(load / drawn, rel=1e-10)
    assert wet.missing_load[0] == pytest.approx(1 - hold / drawn, abs=1e-11)


@pytest.mark.parametrize("equilibrium", [False, True])
@pytest.mark.parametrize("name", [*SECTIONS, "circle"])
def test_growth_of_friction_with_area_by_central_differences(name, equilibrium):
    section = pipe(0.3) if name == "circle" else SECTIONS[name]  # half full at 0.1414 m²
    for area in (0.003, 0.02, 0.12, 0.2):
        h = 1e-6 * area
        found = wetting(section, np.array([0.3]), np.array([area - h, area, area + h]), equilibrium)
        low, _, high = found.excess
        # rounding in the difference: 1e-16/1e-6
        assert found.excess_sensitivity[1] == pytest.approx(area * (high - low) / (2 * h), rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("lack", [0.0, 0.4, 1.0])
def test_growth_of_both_loads_on_an_arc_by_differentiating_their_integrals(lack):
    """X = χ A and its shortfall grow with the half-angle by what one more layer of stream, sin ψ0 dψ0, weighs."""
    for angle in (0.2, 0.9, 1.5):
        area = angle - np.sin(angle) * np.cos(angle)
        found = wetting(pipe(1.0), np.array([1.0 - lack]), np.array([area]))

        def loads(weight, angle=angle, area=area):
            load = 2 * integral(lambda psi: weight(psi) * (np.cos(psi) - np.cos(angle)), 0, angle)
            layer = 2 * np.sin(angle) * integral(weight, 0, angle)  # d/dψ0; dA/dψ0 = 2 sin²ψ0
            return load / area, layer / (2 * np.sin(angle) ** 2) - load / area

        excess, excess_sensitivity = loads(lambda psi: (1 - lack * np.sin(psi) ** 2) * 2 * np.sin(psi / 2) ** 2)
        missing, _ = loads(lambda psi: lack * np.sin(psi) ** 2 * np.cos(psi))
        assert found.chamfer[0] == pytest.approx(angle, rel=1e-14)
        assert found.excess[0] == pytest.approx(excess, rel=1e-12)
        assert found.excess_sensitivity[0] == pytest.approx(excess_sensitivity, rel=1e-11)
        assert found.missing_load[0] == pytest.approx(missing, rel=1e-12, abs=1e-15)


@pytest.mark.parametrize("area", [0.001, 0.05, 0.4])
def test_the_papers_equation_11(area):
    beta, base, delta = np.radians(40.0), 0.5, np.radians(50.0)
    ratio = (1 + np.sin(delta) * np.cos(2 * beta)) / (1 + np.sin(delta))
    b = base / np.cos(beta)
    wetted = (-b + np.sqrt(b**2 + 4 * area / (np.sin(beta) * np.cos(beta)))) / 2
    printed = (base + ratio * wetted + (1 - ratio) * wetted * np.cos(beta)) / (base + wetted * np.cos(beta))

    wet = wetting(polygon(base, (np.inf, 40.0)), vertical_pressure_ratio(np.array([delta])), np.array([area]))

    assert wet.chamfer[0] == pytest.approx(wetted, rel=1e-12)
    assert 1 + wet.excess[0] == pytest.approx(printed, rel=1e-13)


def test_no_digits_are_lost_near_90_degrees_and_at_thin_flow():
    # χ = K C (1 - cos β)/(B + C cos β), in exact arithmetic with mpmath
    import mpmath

    mpmath.mp.dps = 40
    for angle, area in ((89.999999, 1e-6), (1e-6, 1e-3), (90.0, 1e-9), (45.0, 1e-12)):
        beta = mpmath.mpf(float(np.radians(angle)))
        s, c, base = mpmath.sin(beta), mpmath.cos(beta), mpmath.mpf("0.5")
        q = mpmath.mpf(area) / s
        wetted = 2 * q / (base + mpmath.sqrt(base**2 + 4 * q * c))
        ratio = c**2 + mpmath.mpf(0.25) * s**2
        exact = ratio * wetted * (1 - c) / (base + wetted * c)
        found = wetting(polygon(0.5, (np.inf, angle)), np.array([0.25]), np.array([area]))
        assert found.excess[0] == pytest.approx(float(exact), rel=1e-15)


def test_pressure_ratio_is_the_papers_equation_4():
    beta, delta = np.radians(np.linspace(0, 90, 19)), np.radians(47.0)
    printed = (1 + np.sin(delta) * np.cos(2 * beta)) / (1 + np.sin(delta))
    assert np.allclose(pressure_ratio(beta, vertical_pressure_ratio(delta)), printed, rtol=1e-14)


def test_greatest_wall_friction_of_the_papers_section_6_and_its_misprint():
    assert np.degrees(greatest_wall_friction(np.radians(30.0))) == pytest.approx(26.6, abs=0.05)
    # section 7 prints "25.1° calculated from δ = 26°": it belongs to 28°, the angle of that material
    assert np.degrees(greatest_wall_friction(np.radians(28.0))) == pytest.approx(25.1, abs=0.05)
    assert np.degrees(greatest_wall_friction(np.radians(26.0))) == pytest.approx(23.7, abs=0.05)


def test_both_laws_in_a_vee_and_in_a_rectangle():
    ratio = np.array([vertical_pressure_ratio(np.radians(50.0))])
    wet = wetting(polygon(0.0, (np.inf, 45.0)), ratio, np.array([0.1]))
    assert equivalent_friction(1.0, wet.excess)[0] == pytest.approx(1.235, abs=5e-4)  # Eq 11 at B = 0
    assert equilibrium_friction(1.0, wet.excess, wet.missing_load)[0] == pytest.approx(1 / np.cos(np.pi / 4), rel=1e-14)

    wet = wetting(polygon(0.5), ratio, np.array([0.1]))
    assert wet.missing_load[0] == pytest.approx(0.0, abs=1e-15)
    assert wet.excess[0] == pytest.approx(ratio[0] * 0.2 / 0.5, rel=1e-14)  # Eq 2


TABLE = {  # equivalent friction at δ = 30, 40, 50, 55° for B = 0.5 m, A = 0.05 m², φ = 25°
    45.0: (0.48509, 0.48346, 0.48226, 0.48180),
    85.0: (0.49426, 0.48476, 0.47779, 0.47508),
    90.0: (0.49739, 0.48659, 0.47866, 0.47558),
}


@pytest.mark.parametrize("angle", TABLE)
def test_five_digits_of_figure_5(angle):
    delta = np.radians([30.0, 40.0, 50.0, 55.0])
    wet = wetting(polygon(0.5, (np.inf, angle)), vertical_pressure_ratio(delta), np.full(4, 0.05))
    friction = equivalent_friction(np.tan(np.radians(25.0)), wet.excess)
    assert np.abs(friction - TABLE[angle]).max() <= 5e-6
