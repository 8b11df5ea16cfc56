"""Forces, weights and liner lives, each found another way: by the walls' own loads, by shoelace areas, by the work."""

import numpy as np
import pytest

import chutecalc
from chutecalc.design import Status
from tests.conftest import STANDARD_DESIGNS, chute

PANELS, (NODES, WEIGHTS) = 60, np.polynomial.legendre.leggauss(8)
SHARES = ((np.arange(PANELS)[:, None] + 0.5 * (1.0 + NODES)) / PANELS).ravel()
SHARE_WEIGHTS = np.tile(0.5 * WEIGHTS / PANELS, PANELS)


def wall_force(part):
    """Return the force of the stream on the segment of one design as what its walls bear: x and z, N.

    A metre bears the normal load ρ A n, against the surface, and the friction μ_e ρ A n along the stream; an impact
    adds its impulse ṁ v sin i and that of its friction.
    """
    design, arrival, side = part.design, part.contact.arrival, part.contact.surface.side
    at = part.at(SHARES, ["slope_deg", "area_m2", "normal_acceleration_m_s2", "equivalent_friction"])
    slope, area, normal, friction = (values[:, 0] for values in at.values())
    slope = np.radians(slope)
    load = design.density[0] * area * normal * SHARE_WEIGHTS * part.length()[0]
    load = load if part.length()[0] > 0.0 else np.zeros_like(load)
    impulse, impact_friction = design.mass_rate[0] * arrival.velocity[0] * np.sin(arrival.incidence[0]), 0.0
    if impulse > 0.0:
        impact_friction = arrival.impact.friction[0]
    load, friction = np.append(load, impulse), np.append(friction, impact_friction)
    slope = np.append(slope, part.solved.entry.slope[0])
    x = load @ (friction * np.cos(slope) - side * np.sin(slope))
    z = load @ (-friction * np.sin(slope) - side * np.cos(slope))
    return np.array([x, z])


@pytest.mark.parametrize("path", STANDARD_DESIGNS, ids=lambda path: path.stem)
def test_momentum_balance_is_what_the_walls_bear(path):
    """To the error of the quadrature, whose panels do not end at kinks of the friction law: 1e-7 of the force."""
    solution = chutecalc.solve(chutecalc.load(path), rtol=1e-12)
    for part, result in zip(solution.trajectory.parts, solution.trajectory.results, strict=True):
        if not part.guided:
            assert result.loads == {}
            continue
        force = np.array([result.loads["force_x_n"][0], result.loads["force_z_n"][0]])
        if part.solved.status[0] not in (Status.OK, Status.CONTACT_LOST):
            assert np.isnan(force).all()
            continue
        assert np.abs(force - wall_force(part)).max() <= 1e-7 * np.hypot(*force)
        assert result.loads["force_n"][0] == pytest.approx(np.hypot(*force), rel=1e-15)


def test_a_segment_that_is_struck_twice_bears_both_visits():
    """A crest that rises throws the stream, which comes down on it again."""
    crest = {"kind": "curve", "radius_m": 3.0, "from_slope_deg": -30.0, "to_slope_deg": 30.0}
    solution = chutecalc.solve(chute(inlet={"velocity_m_s": 5.2, "slope_deg": -30.0}, segments=[crest]))
    visits = [part for part in solution.trajectory.parts if part.guided]
    assert len(visits) > 1
    (whole,) = solution.segments
    here = [visit for visit in visits if visit.solved.status[0] in (Status.OK, Status.CONTACT_LOST)]
    total = sum(wall_force(part) for part in here)
    assert whole.loads["force_x_n"][0] == pytest.approx(total[0], rel=1e-7)
    assert whole.loads["force_z_n"][0] == pytest.approx(total[1], rel=1e-7)


def shoelace(corners):
    """Area of a polygon."""
    x, z = np.array(corners).T
    return 0.5 * abs(np.dot(x, np.roll(z, -1)) - np.dot(z, np.roll(x, -1)))


def filled_area(base, chamfer, angle, height):
    """Area of a chamfered section below a height, by its outline."""
    angle = np.radians(angle)
    right = [(base / 2, 0.0), (base / 2 + chamfer * np.cos(angle), chamfer * np.sin(angle))]
    right.append((right[-1][0], height))
    return shoelace(right + [(-x, z) for x, z in reversed(right)])


def test_static_weight_is_that_of_the_full_section():
    """Of a taper by the midpoint rule, whose error falls with the square of the step: 1e-8 with 4000 steps."""
    wide, narrow = (
        {"shape": "chamfered", "base_m": base, "chamfer_deg": angle, "chamfer_m": 0.2, "wall_height_m": height}
        for base, angle, height in ((0.8, 50.0, 0.7), (0.4, 35.0, 0.5))
    )
    straight = {"kind": "straight", "slope_deg": 50.0, "length_m": 3.0}
    base = chute(
        inlet={"velocity_m_s": 5.0, "slope_deg": 50.0},
        sections={"wide": wide, "narrow": narrow},
        segments=[straight | {"section": "wide"}, straight | {"name": "taper", "section": ["wide", "narrow"]}],
    )
    segments = chutecalc.solve(base).segments
    weight = 800.0 * 9.80665 * 3.0
    assert segments[0].loads["static_weight_n"][0] == pytest.approx(
        weight * filled_area(0.8, 0.2, 50.0, 0.7), rel=1e-14
    )
    middles = (np.arange(4000) + 0.5) / 4000
    areas = [filled_area(0.8 - 0.4 * c, 0.2, 50.0 - 15.0 * c, 0.7 - 0.2 * c) for c in middles]
    assert segments["taper"].loads["static_weight_n"][0] == pytest.approx(weight * np.mean(areas), rel=1e-8)
    assert np.isnan(chutecalc.solve(chute()).segments[0].loads["static_weight_n"]).all()


def test_liner_life_is_the_time_in_which_the_work_takes_its_thickness():
    """On a rectangular straight all friction on the floor: μ ρ g cos a Q a metre, so the floor's share is known."""
    slope, wall, width, rate = np.radians(40.0), np.radians(25.0), 0.5, 3e-4
    liner = {"friction_deg": 25.0, "thickness_mm": 12.0, "wear_mm3_per_j": rate}
    base = chute(liners={"wall": liner}, sections={"body": {"shape": "rectangular", "width_m": width}})
    solution = chutecalc.solve(base.vary({"liners.wall.thickness_mm": [12.0, 24.0]}))
    (result,) = solution.segments
    # p v = ρ g cos a H v, and H v = Q/B at any station
    power = np.tan(wall) * 9.80665 * np.cos(slope) * (1000.0 / 3.6) / width
    hours = 0.012 / (rate * 1e-9 * power * 3600.0)
    assert result.loads["liner_life_h"] == pytest.approx([hours, 2.0 * hours], rel=1e-12)
    assert result.loads["sliding_life_h"] == pytest.approx([hours, 2.0 * hours], rel=1e-12)
    assert np.isnan(result.loads["impact_life_h"]).all()
    column = solution.stations(points=3, columns=["sliding_life_h"])["sliding_life_h"]
    assert column == pytest.approx(np.outer([hours, 2.0 * hours], np.ones(3)), rel=1e-12)


def test_without_a_wear_rate_wear_is_relative_to_the_first_segment():
    solution = chutecalc.solve(
        chutecalc.load(next(path for path in STANDARD_DESIGNS if path.stem == "belt_hood_spoon"))
    )
    hood, spoon = solution.segments["hood"], solution.segments["spoon"]
    worst = [max(one.maximum["wear_w_m2"][0], one.impact["wear_w_m2"][0]) for one in (hood, spoon)]
    assert hood.loads["relative_wear"][0] == 1.0
    assert spoon.loads["relative_wear"][0] == pytest.approx(worst[1] / worst[0], rel=1e-12)
    assert np.isnan(hood.loads["liner_life_h"][0])


@pytest.mark.parametrize("slope", [60.0, 35.0])
def test_sliding_and_impact_are_told_apart(slope):
    liner = {"friction_deg": 25.0, "thickness_mm": 12.0, "wear_mm3_per_j": 3e-4}
    (result,) = chutecalc.solve(
        chute(
            liners={"wall": liner},
            inlet={"velocity_m_s": 6.0, "slope_deg": 60.0},
            segments=[{"kind": "straight", "slope_deg": slope, "length_m": 2.0}],
        )
    ).segments
    walls = ("wear_w_m2", "chamfer_wear_w_m2", "side_wear_w_m2")
    sliding = np.nanmax([result.maximum[name][0] for name in walls])
    assert result.loads["sliding_life_h"][0] == pytest.approx(0.012 / (3e-13 * sliding * 3600.0), rel=1e-12)
    struck = result.impact.get("wear_w_m2", [np.nan])[0]
    impact = 0.012 / (3e-13 * struck * 3600.0)
    assert result.loads["impact_life_h"][0] == pytest.approx(impact, rel=1e-12, nan_ok=True)
    assert result.loads["liner_life_h"][0] == np.fmin(
        *(result.loads[f"{what}_life_h"][0] for what in ("sliding", "impact"))
    )
