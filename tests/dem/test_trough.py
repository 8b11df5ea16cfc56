"""Troughs as planes, and what the law says of each wall, against integrals and the paper's own cases."""

import math

import numpy as np
import pytest

from chutecalc.dem.trough import Trough

BETA = math.radians(40.0)
TROUGHS = {
    "rectangular": Trough(0.5, (), ()),
    "chamfered": Trough(0.5, (math.inf,), (BETA,)),
    "with a top": Trough(0.3, (0.1,), (math.pi / 4,)),
    "vee": Trough(0.0, (math.inf,), (math.radians(50.0),)),
    "vee with a top": Trough(0.0, (0.2,), (math.radians(30.0),)),
    "facets": Trough(0.2, (0.1, 0.15), (math.radians(10.0), math.radians(55.0))),
}
ALL = pytest.mark.parametrize("trough", TROUGHS.values(), ids=TROUGHS)


def names(trough):
    return [(wall.name, wall.side) for wall in trough.walls]


def test_walls_of_each_shape():
    sides = [("side wall", -1), ("side wall", 1)]
    chamfers = [("chamfer", -1), ("chamfer", 1)]
    assert names(TROUGHS["rectangular"]) == [("floor", 0), *sides]
    assert names(TROUGHS["chamfered"]) == [("floor", 0), *chamfers]
    assert names(TROUGHS["with a top"]) == [("floor", 0), *chamfers, *sides]
    assert names(TROUGHS["vee"]) == chamfers
    assert [name for name, side in names(TROUGHS["facets"]) if side == 1] == ["facet 1", "facet 2", "side wall"]


def test_no_plane_stands_twice():
    """Two planes in one place would push twice: an upright chamfer is its own side wall, a wall drawn in parts one."""
    assert names(Trough(0.5, (0.1,), (math.pi / 2,))) == names(TROUGHS["rectangular"])
    assert Trough(0.5, (0.1, 0.2), (BETA, BETA)).lengths == pytest.approx((0.3,))


@ALL
def test_planes_bound_the_section(trough):
    """A point is inside all planes where it is above the section's own outline, worked out from its corners."""
    walls = [wall for wall in trough.walls if wall.side == 1]
    corners = [(0.0, 0.0), *(wall.foot for wall in walls)]
    end = walls[-1]
    corners.append((end.foot[0] + 9.0 * math.cos(end.inclination), end.foot[1] + 9.0 * math.sin(end.inclination)))
    x_corner, z_corner = np.array(corners).T
    random = np.random.default_rng(3)
    x, z = random.uniform(0.0, 0.6, 4000), random.uniform(0.0, 0.6, 4000)
    inside = np.ones(4000, bool)
    for wall in trough.walls:
        across, up = wall.normal
        assert across**2 + up**2 == pytest.approx(1.0, abs=1e-15)
        inside &= (x - wall.foot[0]) * across + (z - wall.foot[1]) * up >= 0.0
    outline = np.interp(x, x_corner + 1e-12 * np.arange(len(corners)), z_corner)
    beyond = x > x_corner[-1] - 1e-9
    assert np.array_equal(inside, (z >= outline) & ~beyond)


@ALL
@pytest.mark.parametrize("depth", [0.02, 0.12, 0.3])
def test_thrust_is_the_integral_of_depth(trough, depth):
    for wall in trough.walls:
        length = min(wall.length, 5.0)
        along = (np.arange(200_000) + 0.5) / 200_000 * length
        below = np.maximum(depth - wall.foot[1] - along * math.sin(wall.inclination), 0.0)
        # the midpoint rule is exact on each linear piece but in the cell with the kink, of width h: off by h²/8 at most
        assert wall.thrust(depth) == pytest.approx(below.sum() * length / 200_000, abs=1e-9)


@pytest.mark.parametrize(
    ("law", "trough"),
    [
        pytest.param(law, trough, id=f"{law}-{name}")
        for law in ("paper", "equilibrium")
        for name, trough in TROUGHS.items()
        if law == "equilibrium" or trough.base > 0.0  # in a vee the paper's law has nowhere to lay the missing load
    ],
)
def test_walls_carry_the_weight(trough, law):
    """Vertical forces of frictionless walls add up to the weight, where there is a floor for what is missing."""
    load = trough.load(0.04, 0.2, law)
    up = sum(load.walls[wall.name] * math.cos(wall.inclination) for wall in trough.walls)
    assert up == pytest.approx(1.0, abs=1e-12)
    assert load.ratio == pytest.approx(sum(load.walls[wall.name] for wall in trough.walls), abs=1e-12)


def test_load_ratio_follows_from_the_chamfers_load():
    """N_t/N = 1 + (2 N_c/W)(1 - cos β), which statics alone gives."""
    for law in ("paper", "equilibrium"):
        load = TROUGHS["chamfered"].load(0.05, 0.3, law)
        assert load.ratio == pytest.approx(1.0 + 2.0 * load.walls["chamfer"] * (1.0 - math.cos(BETA)), abs=1e-12)


@pytest.mark.parametrize(("delta", "ratio"), [(42.5, 1.0948), (51.5, 1.0806)])
def test_overtopped_chamfer_as_worked_out_elsewhere(delta, ratio):
    """B 0.3, L 0.1, 45°, 0.1 above the chamfer's top."""
    area = 0.3 * 0.1707107 + 0.0707107 * (0.2 + 0.0707107)
    strength = math.sin(math.radians(delta))
    load = TROUGHS["with a top"].load(area, (1 - strength) / (1 + strength), "paper")
    assert load.ratio == pytest.approx(ratio, abs=5e-5)  # four decimals are known


def test_vee_is_statics():
    for vertical_ratio in (0.1, 0.9):
        assert TROUGHS["vee"].load(0.02, vertical_ratio, "equilibrium").ratio == pytest.approx(
            1.0 / math.cos(math.radians(50.0)), abs=1e-12
        )
