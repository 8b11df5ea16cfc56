"""A case's particles and contacts, their positions before the pour, and the script for LAMMPS."""

from dataclasses import replace

import numpy as np
import pytest

from chutecalc.dem import script
from chutecalc.dem.case import DENSITY, GRAVITY, RESTITUTION, STEPS_A_COLLISION
from chutecalc.dem.pour import _across, check_room, column
from chutecalc.errors import UsageError
from tests.dem.beds import case

SMALL = case(base=0.2, area=0.01)
TOPPED = case(base=0.1, lengths=(0.05,), area=0.01)
VEE = case(base=0.0, area=0.01)


def test_particles_fill_the_area_as_expected():
    """0.47 at friction 0.75 without rotation."""
    one = case()
    assert one.count * one.particle_volume / one.slice / one.area == pytest.approx(0.47, abs=0.5 / one.count)


def test_a_collision_has_its_restitution_and_its_steps():
    """Two particles that meet, integrated in time: they part after 20 steps with 0.3 of their speed."""
    one = case()
    mass = 0.5 * one.mass
    step = one.time_step / 2000.0
    overlap, speed, time = 0.0, 1.0, 0.0
    while overlap >= 0.0:
        speed -= step * (one.stiffness * overlap / mass + one.damping(mass) * speed)  # semi-implicit Euler
        overlap += step * speed
        time += step
    assert time / one.time_step == pytest.approx(STEPS_A_COLLISION, rel=1e-3)  # first order in 1/40000 steps, times π
    assert -speed == pytest.approx(RESTITUTION, rel=1e-3)


def test_particles_are_as_hard_whatever_pulls_at_them():
    """Overlap under the own weight over the diameter."""
    overlaps = [
        one.mass * GRAVITY * one.body_force / one.stiffness / one.diameter
        for one in (case(), case(body_force=10.0), case(diameter=0.02, slice=0.1))
    ]
    assert overlaps == pytest.approx([overlaps[0]] * 3)
    assert overlaps[0] < 1e-3


def test_every_change_is_another_folder():
    one = case()
    others = [
        replace(one, **{name: value})
        for name, value in {"seed": 2, "spread": 0.1, "slice": 0.06, "raised_to": 3.0, "area": 0.051}.items()
    ]
    assert len({one.name, *(other.name for other in others)}) == 6
    assert one.name == case().name


@pytest.mark.parametrize("one", [SMALL, TOPPED, VEE, case(base=0.2, lengths=(), inclinations=(), area=0.01)])
def test_no_particle_hangs_in_another_or_in_a_wall(one):
    positions = column(one)
    assert positions.shape == (one.count, 3)
    apart = np.abs(positions[:, None] - positions[None])
    apart[..., 1] = np.minimum(apart[..., 1], one.slice - apart[..., 1])
    distance = np.sqrt(np.square(apart).sum(axis=-1)) + np.eye(one.count)
    assert distance.min() >= one.diameter * (1 - 1e-12)
    for wall in one.trough.walls:
        clearance = (positions[:, [0, 2]] - wall.foot) @ np.array(wall.normal)
        assert clearance.min() >= 0.5 * one.diameter * (1 - 1e-12)
    assert (np.diff(positions[:, 2]) > 0.0).all()


def test_the_same_seed_pours_the_same():
    assert np.array_equal(column(SMALL), column(SMALL))
    assert not np.array_equal(column(SMALL), column(replace(SMALL, seed=2)))


@pytest.mark.parametrize("spread", [-0.8, 0.0, 0.8])
def test_spread_moves_the_rain_outwards(spread):
    """The mean of |ξ| under the density 1 + e (2 |ξ| - 1) is 1/2 + e/6."""
    random = np.random.default_rng(2)
    across = np.array([_across(random, spread) for _ in range(10_000)])
    assert np.abs(across).mean() == pytest.approx(0.5 + spread / 6.0, abs=4.0 * 0.3 / 100.0)  # deviation below 0.3
    assert across.mean() == pytest.approx(0.0, abs=4.0 * 0.6 / 100.0)


def test_a_column_with_spread_is_denser_outside():
    """Less than its density says: where it is crowded more positions are taken."""
    means = [
        np.abs(column(case(lengths=(), inclinations=(), spread=spread))[:, 0]).mean() for spread in (-0.5, 0.0, 0.5)
    ]
    assert means == sorted(means)
    assert means[2] - means[0] > 0.25 * 0.5 / 6.0


def test_rain_falls_on_the_bed_that_is_there():
    """The first tenth of the particles stays over the narrow bed that they make."""
    one = case()
    width = float(one.trough.wetting(0.1 * one.area).width[0])
    assert np.abs(column(one)[: one.count // 10, 0]).max() < 0.5 * width


@pytest.mark.parametrize("changes", [{"area": 0.0002}, {"slice": 0.02}, {"diameter": 0.2, "slice": 1.0}])
def test_a_bed_of_a_few_particles_is_refused(changes):
    with pytest.raises(UsageError, match="too small"):
        check_room(case(**changes))


def test_particles_are_written_as_lammps_reads_them():
    positions = column(SMALL)
    head, _, rows = script.particles_text(SMALL, positions).partition("Atoms # sphere\n\n")
    assert f"{SMALL.count} atoms\n1 atom types\n" in head
    read = np.array([row.split() for row in rows.splitlines()], dtype=float)
    assert np.allclose(read[:, 4:], positions, rtol=1e-8, atol=1e-9)
    assert (read[:, 2] == SMALL.diameter).all()
    assert (read[:, 3] == DENSITY).all()
    bounds = {
        line.split()[2]: [float(word) for word in line.split()[:2]] for line in head.splitlines() if "lo " in line
    }
    assert bounds["ylo"] == [0.0, SMALL.slice]
    assert bounds["zlo"][0] < 0.0 < positions[-1, 2] < bounds["zlo"][1]


def test_each_wall_is_a_plane_of_its_own_without_friction():
    text = script.script_text(TOPPED, 1.0)
    lines = text.splitlines()
    for number, wall in enumerate(TOPPED.trough.walls):
        plane = next(line for line in lines if line.startswith(f"region wall{number} plane"))
        x, y, z, *normal = (float(word) for word in plane.split()[3:])
        assert (x, y, z) == pytest.approx((wall.foot[0], 0.0, wall.foot[1]), abs=1e-9)
        assert normal == pytest.approx([wall.normal[0], 0.0, wall.normal[1]], abs=1e-12)
        contact = next(line for line in lines if line.startswith(f"fix wall{number} all wall/gran/region"))
        assert contact.endswith(f"0 1 limit_damping region wall{number} contacts")
    assert sum(line.startswith("region") for line in lines) == len(TOPPED.trough.walls)
    assert "fix move all nve" in lines  # no rotation
    assert lines[-1].endswith(f"file {script.WALLS}")  # the mark of a finished case


def test_pours_differ_in_drag_alone():
    texts = {pour: script.script_text(case(pour=pour), 1.0) for pour in ("gentle", "rain", "freefall")}
    assert "velocity all set 0 0 -0.3\n" in texts["gentle"]
    assert "velocity all set 0 0 -1\n" in texts["rain"]
    assert "velocity" not in texts["freefall"]
    drag = next(line for line in texts["rain"].splitlines() if line.startswith("fix drag"))
    one = case()
    assert float(drag.split()[-1]) * 1.0 == pytest.approx(one.mass * GRAVITY)  # at 1 m/s drag is the weight


def test_raising_comes_after_rest_and_before_the_forces_are_written():
    text = script.script_text(case(raised_to=3.0), 1.0)
    assert text.index("fix rest") < text.index("ramp(9.80665,29.41995)") < text.rindex("fix rest") < text.index("print")
    assert "ramp" not in script.script_text(case(), 1.0)
