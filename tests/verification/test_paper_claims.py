"""What the paper says of its worked example (section 8), with the assumed radii."""

import numpy as np
import pytest

import chutecalc
from tests.conftest import ROOT

PAPER = ROOT / "specs" / "paper"


def exit_velocity(radius, delta, shape):
    return chutecalc.solve(chutecalc.load(PAPER / f"r{radius}_d{delta}_{shape}.toml")).exit_velocity[0]


def test_there_are_sixteen_cases():
    assert len(list(PAPER.glob("*.toml"))) == 16


@pytest.mark.parametrize("radius", [1, 2, 3, 4])
def test_the_chamfer_is_faster_for_the_material_of_low_friction_and_slower_for_that_of_high(radius):
    # "relatively higher velocities for the flow in the chamfered transfer chute" at 30°, lower at 55°
    assert exit_velocity(radius, 30, "chamfered") > exit_velocity(radius, 30, "square")
    assert exit_velocity(radius, 55, "chamfered") < exit_velocity(radius, 55, "square")


@pytest.mark.parametrize("radius", [1, 2, 3, 4])
def test_the_differences_are_small(radius):
    # "chamfers have a limited effect on flow velocity": a tenth at most at the exit, less for high friction
    off = {
        delta: abs(exit_velocity(radius, delta, "chamfered") / exit_velocity(radius, delta, "square") - 1)
        for delta in (30, 55)
    }
    assert off[55] < off[30] < 0.1


@pytest.mark.parametrize("radius", [2, 3, 4])
def test_the_flow_is_about_a_fifth_of_the_chutes_width_deep(radius):
    # "material flow depths approximately 20% of the transfer chute width"
    for delta in (30, 55):
        solution = chutecalc.solve(chutecalc.load(PAPER / f"r{radius}_d{delta}_square.toml"))
        depth = solution.stations()["depth_m"][0]
        assert 0.1 < np.nanmean(depth) / 0.5 < 0.4
