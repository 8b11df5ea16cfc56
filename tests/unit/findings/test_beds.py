"""Beds of the material itself, as in a rock box: meant to be struck, and as steep as the material lies."""

import pytest

from tests.unit.findings.chutes import all_of, codes, found, rectangular, solved

BED, LINER = {"own_material": True}, {"friction_deg": 33.0}


def struck(liner, slope=38.0, **more):
    """Return a stream that falls on a floor at 70°."""
    return solved(
        inlet={"velocity_m_s": 5.0, "slope_deg": 70.0},
        liners={"wall": liner},
        sections=rectangular(1.0),
        segments=[{"kind": "straight", "name": "floor", "slope_deg": slope, "length_m": 1.0} | more],
    )


def test_a_steep_impact_on_a_bed_is_a_note_without_advice_to_align_it():
    wears, bed = (found(struck(liner), "steep_impact") for liner in (LINER, BED))
    assert (wears.severity, bed.severity) == ("warning", "note")
    assert "align the surface" in wears.message()
    assert "align" not in bed.message()
    assert "takes that in place of a liner" in bed.message()


def test_a_bed_that_is_too_flat_is_to_be_drawn_as_it_settles():
    wears, bed = (found(struck(liner, slope=25.0), "decelerating") for liner in (LINER, BED))
    assert wears.severity == bed.severity == "warning"
    assert "make the slope steeper" in wears.message()
    assert "make" not in bed.message()
    assert "draw the bed as steep as it will settle" in bed.message()


def test_a_bed_is_meant_to_stay_after_a_stop():
    slow = {"slope": 30.0}
    assert "will_not_clear" in codes(struck(LINER, **slow))
    assert "will_not_clear" not in codes(struck(BED, **slow))


@pytest.mark.parametrize(("roof", "word"), [(True, "the roof"), (False, "the floor")])
def test_the_wall_of_a_pipe_that_is_struck_is_named(roof, word):
    slope = 75.0 if roof else 20.0
    solution = solved(
        inlet={"velocity_m_s": 6.0, "slope_deg": 48.0},
        limits={"max_impact_angle_deg": 5.0},
        sections={"body": {"shape": "pipe", "radius_m": 0.3}},
        segments=[
            {"kind": "straight", "name": "head", "slope_deg": 48.0, "length_m": 1.0},
            {"kind": "straight", "name": "leg", "slope_deg": slope, "length_m": 3.0},
        ],
    )
    (told,) = all_of(solution, "steep_impact")
    assert told.message().startswith(f"the stream strikes {word} at ")
    assert solution.segments["leg"].strikes_roof[0] == roof
