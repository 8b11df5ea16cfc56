"""Means over seeds and fits, on beds that were made by a law."""

import math

import numpy as np
import pytest

from chutecalc.dem.bed import Bed
from chutecalc.dem.campaign import Group, Outcome
from chutecalc.dem.fit import fit
from chutecalc.dem.point import measured
from chutecalc.dem.request import PourPlan, groups, numbers, paper_beds, pours
from chutecalc.dem.store import Store
from chutecalc.dem.study import Study
from chutecalc.errors import UsageError
from chutecalc.physics.pressure import vertical_pressure_ratio
from tests.dem.beds import bed, case

KNOWN = math.radians(38.0)
RATIO = float(vertical_pressure_ratio(KNOWN))


class Beds:
    """In place of a campaign: beds at hand."""

    def __init__(self, *outcomes):
        self.groups = [Group(beds[0].case, len(beds)) for beds in outcomes]
        self.store = Store("nowhere")
        self._known = dict(zip(self.groups, outcomes, strict=True))

    def outcome(self, group):
        return Outcome(tuple(self._known[group]), (), ())


def slope(degrees, seed=1, law="equilibrium"):
    return bed(case(inclinations=(math.radians(degrees),), seed=seed), RATIO, law)


@pytest.mark.parametrize("law", ["paper", "equilibrium"])
def test_the_law_that_made_the_beds_fits_with_its_own_internal_friction(law):
    """To the tolerance of the search, 1e-7 rad, and the other law does not fit so well."""
    study = Study(Beds([slope(30, law=law)], [slope(60, law=law)], [slope(90, law=law)]), 0.4)
    (series,) = study.series
    assert series.fits[law].internal_friction == pytest.approx(KNOWN, abs=1e-5)
    assert series.fits[law].residual < 1e-6
    other = "paper" if law == "equilibrium" else "equilibrium"
    assert series.fits[other].residual > 1e-4


def test_scatter_of_the_fit_is_that_of_fits_to_each_seed():
    """Both seeds' beds carry what δ = 38° says; they differ in their areas, which the law knows, and so by nothing."""
    study = Study(Beds([slope(30, 1), slope(30, 2)], [slope(60, 1), slope(60, 2)]), 0.4)
    (series,) = study.series
    assert series.fits["equilibrium"].scatter == pytest.approx(0.0, abs=1e-5)
    assert math.isnan(fit(Study(Beds([slope(30)]), 0.4).points, "paper").scatter)


def test_a_vee_tells_nothing_of_internal_friction():
    vee = case(base=0.0, area=0.02)
    (series,) = Study(Beds([bed(vee, RATIO)]), 0.4).series
    assert math.isnan(series.fits["equilibrium"].internal_friction)
    assert series.fits["equilibrium"].residual < 1e-9
    assert series.fits["paper"].internal_friction < 1e-3  # K (1 - cos β)/cos β is what statics demands with K = 1 alone


def test_what_fails_is_never_averaged_in():
    good, bad = slope(45, 1), slope(45, 2)
    bad = Bed(bad.case, 1.01 * bad.forces, bad.kinetic_energy, bad.positions)
    study = Study(Beds([good, bad]), 0.4)
    (point,) = study.points
    assert point.ratio.mean == good.ratio
    assert [bed.case.seed for bed in point.failed] == [2]
    assert not study.sound
    (nothing,) = Study(Beds([bad]), 0.4).series
    assert nothing.points == ()
    assert nothing.fits == {}


def test_scatter_is_the_standard_deviation_of_a_sample():
    assert measured([1.0, 2.0, 4.0]).scatter == pytest.approx(np.std([1, 2, 4]) * math.sqrt(1.5))
    assert math.isnan(measured([1.0]).scatter)


def test_lists_of_numbers():
    assert numbers("15:90:15", "--beta", 0, 90) == [15.0, 30.0, 45.0, 60.0, 75.0, 90.0]
    assert numbers("15:80:15", "--beta", 0, 90)[-1] == 75.0
    assert numbers("30:90:#3, 10", "--beta", 0, 90) == [30.0, 60.0, 90.0, 10.0]
    assert numbers("0.75,0.9,0.75", "--x", 0, 1) == [0.75, 0.9]
    for text in ("", "a", "1:2", "2:1:1", "1:2:0", "1:2:-1", "nan", "0:1:1e-9", "0:1:0.001", "91", "1,,2"):
        with pytest.raises(UsageError, match="--beta"):
            numbers(text, "--beta", 0, 90)


def test_pours_and_troughs_that_cannot_be():
    assert pours("all") == ["gentle", "rain", "freefall"]
    with pytest.raises(UsageError, match="gentle, rain, freefall or all"):
        pours("drizzle")
    with pytest.raises(UsageError, match="no width"):
        paper_beds("90", 0.0, None, None, None, 25.0)


def test_every_combination_is_a_group():
    plan = PourPlan(
        frictions=[0.75, 0.9],
        pours=["rain", "gentle"],
        seeds=3,
        body_forces=[1.0, 3.0],
        raised_to=0.0,
        diameter=0.01,
        slice=0.05,
    )
    made = groups(paper_beds(beta="30,60", base=None, chamfer=None, area="0.04,0.05", delta=None, phi=25.0), plan)
    assert len({group.case.name for group in made}) == 2 * 2 * 2 * 2 * 2
    assert {group.seeds for group in made} == {3}
