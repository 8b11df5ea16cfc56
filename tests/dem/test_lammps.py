"""With LAMMPS itself: the balance of forces and symmetry of a small bed, never a value of K."""

import math
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from chutecalc.dem.engine import Engine
from chutecalc.dem.store import Store
from chutecalc.errors import ExtraMissingError
from tests.dem.beds import case

SMALL = case(base=0.15, lengths=(0.04,), area=0.012, slice=0.03)


@pytest.fixture(scope="module")
def beds(tmp_path_factory):
    """Return the same bed twice, and one under a raised body force."""
    try:
        engine = Engine()
    except ExtraMissingError as error:
        pytest.skip(str(error))
    raised = case(base=0.1, area=0.005, slice=0.03, raised_to=2.0)

    def run(one):
        store = Store(tmp_path_factory.mktemp("cases"))
        engine.run(store.write(one))
        return store.read(one)

    with ThreadPoolExecutor(2) as pool:
        return list(pool.map(run, (SMALL, SMALL, raised)))


def test_walls_carry_the_weight_and_push_alike_at_rest(beds):
    for bed in beds:
        checks = {check.name: check for check in bed.checks}
        for name in ("balance", "sides", "rest"):
            assert checks[name].passed, checks[name]
        loads = dict(zip([(wall.name, wall.side) for wall in bed.case.trough.walls], bed.loads, strict=True))
        assert all(load > 0.0 for load in loads.values())


def test_statics_hold_wall_by_wall(beds):
    """Without wall friction N_t/N - 1 is the sum of (1 - cos ψ) N_w/W, within what the balance leaves."""
    for bed in beds:
        lever = sum(
            load * (1.0 - math.cos(wall.inclination))
            for load, wall in zip(bed.loads, bed.case.trough.walls, strict=True)
        )
        assert bed.ratio == pytest.approx(1.0 + lever, abs=2e-3)


def test_the_bed_lies_in_its_trough(beds):
    for bed in beds:
        for wall in bed.case.trough.walls:
            clearance = (bed.positions[:, [0, 2]] - wall.foot) @ np.array(wall.normal)
            assert clearance.min() > 0.4 * bed.case.diameter


def test_the_same_seed_gives_the_same_bed(beds):
    first, again, _ = beds
    assert np.array_equal(first.forces, again.forces)
    assert np.array_equal(first.positions, again.positions)
