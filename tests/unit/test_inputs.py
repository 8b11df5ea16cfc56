"""What a spec gives: every key once, as written, with its unit and its meaning."""

import pytest

import chutecalc
from chutecalc.spec.inputs import Input, inputs
from tests.conftest import STANDARD_DESIGNS, chute


def given(data):
    """Return the inputs of a chute by path."""
    made = chutecalc.parse(data) if isinstance(data, str) else data
    found = list(inputs(made.spec, made.data))
    assert len({one.path for one in found}) == len(found)
    return {one.path: one for one in found}


def leaves(here):
    """Count the values in nested tables; a list of numbers or names is one value."""
    below = here.values() if isinstance(here, dict) else here if isinstance(here, list) else ()
    tables = isinstance(here, dict) or any(isinstance(item, dict) for item in below)
    return sum(map(leaves, below)) if tables else 1


@pytest.mark.parametrize("path", STANDARD_DESIGNS, ids=lambda path: path.stem)
def test_every_key_of_a_standard_design_has_a_meaning(path):
    made = chutecalc.load(path)
    found = given(made)
    assert len(found) == leaves(made.data)
    assert all(one.meaning and one.text for one in found.values())


def test_keys_are_as_written():
    made = chutecalc.parse(chutecalc.STARTER).put({"segments.spoon.radius_mm": 3000})
    found = given(made)
    assert found["segments.spoon.radius_mm"] == Input(
        "segments.spoon.radius_mm", "radius of the guiding surface", 3000, "mm"
    )
    assert "segments.spoon.radius_m" not in found
    assert "flow.gravity_m_s2" not in found


def test_a_case_and_what_is_uncertain_say_what_their_paths_mean():
    friction, rate = "liners.wall.friction_deg", "flow.rate_kg_s"
    case = {"segments.1.liner": "wall", "receiver": {"velocity_m_s": 2.0, "friction_deg": 30}}  # the spec has none
    points = [[2, 0.89], [4, 1.9]]
    scatter = {friction: {"shear_test": points}, rate: 5, "correlation": [[rate, friction, 0.5]]}
    found = given(chute(cases={"wet": case}, uncertainty=scatter))
    assert found["cases.wet.receiver.velocity_m_s"][1:] == ("velocity of the belt", 2.0, "m/s")
    assert found["cases.wet.segments.1.liner"].meaning.startswith("name of its liner")
    assert found[f"uncertainty.{rate}"][1:] == ("mass rate of the stream", 5, "kg/s")
    assert found[f"uncertainty.{friction}.shear_test"][1:] == ("wall friction angle", points, "kPa")
    assert found["uncertainty.correlation"].meaning.startswith("how uncertain numbers are")


def test_items_without_a_name_are_counted_from_1():
    section = {"shape": "facets", "facets": [{"length_m": 0.3, "slope_deg": 0}, {"length_m": 0.2, "slope_rad": 0.7}]}
    found = given(chute(sections={"body": section}))
    assert found["sections.body.facets.2.slope_rad"].unit == "rad"
