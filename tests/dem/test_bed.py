"""What is measured of beds whose density, surface and wall forces are known."""

import math

import numpy as np
import pytest

from chutecalc.dem.bed import BALANCE, Bed
from tests.dem.beds import bed, case

DENSE = {"diameter": 0.005, "slice": 0.05}
"""Small particles: 18,000 points, whose counts scatter less."""
SHAPES = {
    "chamfered": case(**DENSE),
    "with a top": case(base=0.3, lengths=(0.1,), **DENSE),
    "vee": case(base=0.0, area=0.03, **DENSE),
    "rectangular": case(lengths=(), inclinations=(), **DENSE),
    "facets": case(base=0.2, lengths=(0.1, math.inf), inclinations=(0.2, 1.0), **DENSE),
}
ALL = pytest.mark.parametrize("one", SHAPES.values(), ids=SHAPES)


@ALL
def test_area_and_solid_fraction_of_an_even_bed(one):
    """The slope of a line through half of n points, evenly placed, is right within about 2/√n; so is the area."""
    made = bed(one)
    tolerance = 3.0 * 2.0 / math.sqrt(one.count)
    assert made.area == pytest.approx(one.area, rel=tolerance)
    filled = one.count * one.particle_volume / one.slice / one.area
    assert made.solid_fraction == pytest.approx(filled, rel=tolerance)


@ALL
def test_pressure_ratios_are_those_that_made_the_forces(one):
    """Exactly: the forces were made for the area that the bed shows. Here by the law without its missing load."""
    made = bed(one, vertical_ratio=0.25)
    missing_load = one.trough.load(made.area, 0.25, "equilibrium").missing_load
    for wall in one.trough.walls:
        ratio = math.cos(wall.inclination) ** 2 + 0.25 * math.sin(wall.inclination) ** 2
        assert made.pressure_ratios[wall.name] == pytest.approx(ratio / (1.0 - missing_load), rel=1e-12)
    assert not {check.name for check in made.failed} - {"level"}


def test_pressure_ratio_of_a_chamfer_is_that_of_the_field():
    """K = (2 N_c/W)(B + C cos β)/C."""
    made = bed(SHAPES["chamfered"])
    beta = math.pi / 4
    wetted = made.depth / math.sin(beta)
    expected = 2.0 * made.by_name["chamfer"] * (0.5 + wetted * math.cos(beta)) / wetted
    assert made.pressure_ratios["chamfer"] == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("tilt", [-0.2, 0.0, 0.2])
def test_unevenness_is_how_much_the_surface_rises_outwards(tilt):
    """The highest of some points in a cell lie a little below the surface, everywhere alike within a particle."""
    one = case(lengths=(), inclinations=(), **DENSE)
    made = bed(one, tilt=tilt)
    assert made.unevenness == pytest.approx(tilt, abs=one.diameter / made.depth)
    assert ("level" in {check.name for check in made.failed}) == (tilt != 0.0)


def test_each_check_fails_where_it_should():
    one = case()
    good = bed(one)
    assert good.failed == ()
    lifted = Bed(one, good.forces * (1.0 + 2.0 * BALANCE), kinetic_energy=0.0, positions=good.positions)
    assert [check.name for check in lifted.failed] == ["balance"]
    assert "sides" in {check.name for check in bed(one, noise=0.02).failed}
    moving = Bed(one, good.forces, 2e-7 * one.mass * one.acceleration * one.diameter, positions=good.positions)
    assert [check.name for check in moving.failed] == ["rest"]
    broken = Bed(one, good.forces * np.nan, kinetic_energy=0.0, positions=good.positions)
    assert {"balance", "sides"} <= {check.name for check in broken.failed}


def test_a_raised_bed_is_measured_against_its_raised_weight():
    assert bed(case(raised_to=3.0)).weight == pytest.approx(3.0 * bed(case()).weight)
