"""Values written into the text of a spec: they are there, and nothing else has changed."""

import tomllib

import pytest

import chutecalc
from chutecalc.api.written import text_of
from chutecalc.fields.units import same_quantity
from chutecalc.spec.edited import edited_text
from chutecalc.spec.paths import value_at, with_values
from tests.conftest import STANDARD_DESIGNS

CASES = {
    "a value": ("[flow]\nrate_t_h = 1  # peak\n", {"flow.rate_t_h": 5.0}, "[flow]\nrate_t_h = 5.0  # peak\n"),
    "another unit": ("[flow]\nrate_t_h =  1 # peak\n", {"flow.rate_kg_s": 5.0}, "[flow]\nrate_kg_s =  5.0 # peak\n"),
    "a new key": (
        "[flow]\n  rate_t_h = 1 # peak\n\n# what flows\n[material]\n",
        {"flow.gravity_m_s2": 9.8},
        "[flow]\n  rate_t_h = 1 # peak\n  gravity_m_s2 = 9.8\n\n# what flows\n[material]\n",
    ),
    "above a table below": (
        "[inlet]\nslope_deg = 3\n[inlet.belt]\nvelocity_m_s = 3\n",
        {"inlet.velocity_m_s": 1.0},
        "[inlet]\nslope_deg = 3\nvelocity_m_s = 1.0\n[inlet.belt]\nvelocity_m_s = 3\n",
    ),
    "a file without an end of line": ("[flow]\nrate_t_h = 1", {"flow.x": 2}, "[flow]\nrate_t_h = 1\nx = 2\n"),
    "ends of line of Windows": ("[flow]\r\na = 1\r\n[b]\r\n", {"flow.x": 2}, "[flow]\r\na = 1\r\nx = 2\r\n[b]\r\n"),
    "inline tables": (
        'segments = [\n {kind = "fall", drop_m = 1}, # one\n {kind = "curve", radius_m = 3}, # two\n]\n',
        {"segments.curve.radius_mm": 5.0, "segments.1.drop_m": 3.0},
        'segments = [\n {kind = "fall", drop_m = 3.0}, # one\n {kind = "curve", radius_mm = 5.0}, # two\n]\n',
    ),
    "items of lists": (
        "[[segments]]\nstart_m = [1, 2] # here\n",
        {"segments.1.start_m.2": 7.0},
        "[[segments]]\nstart_m = [1, 7.0] # here\n",
    ),
    "dotted keys": ("flow.rate_t_h = 1 # peak\n", {"flow.rate_kg_s": 5.0}, "flow.rate_kg_s = 5.0 # peak\n"),
    "a table in parts": (
        "[liners.a]\nx = 3 # a\n[sections.x]\nb = 1\n[liners.b] # here\nfriction_deg = 4 # b\n",
        {"liners.b.friction_rad": 0.5},
        "[liners.a]\nx = 3 # a\n[sections.x]\nb = 1\n[liners.b] # here\nfriction_rad = 0.5 # b\n",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_a_value_is_put_where_it_belongs(name):
    text, values, expected = CASES[name]
    assert edited_text(text, values) == expected


def test_a_table_that_may_be_left_out_is_made():
    found = tomllib.loads(edited_text("[flow]\nrate_t_h = 1\n", {"model.friction_law": "equilibrium"}))
    assert found == {"flow": {"rate_t_h": 1}, "model": {"friction_law": "equilibrium"}}


def paths_of(here, above=""):
    for key, value in here.items() if isinstance(here, dict) else enumerate(here, 1):
        if isinstance(value, dict | list):
            yield from paths_of(value, f"{above}{key}.")
        else:
            yield f"{above}{key}"


@pytest.mark.parametrize("path", STANDARD_DESIGNS, ids=lambda path: path.stem)
def test_all_numbers_of_the_standard_designs_in_all_units_keep_every_comment(path):
    text = path.read_text(encoding="utf-8")
    data = tomllib.loads(text)
    for key in paths_of({name: table for name, table in data.items() if name != "cases"}):
        above, dot, last = key.rpartition(".")
        if isinstance(value_at(data, key), int | float):
            for unit in same_quantity(last):
                changes = {f"{above}{dot}{unit}": 1.25}
                edited = edited_text(text, changes)
                assert tomllib.loads(edited) == with_values(data, changes, "spec")
                assert edited.count("\n") == text.count("\n")
                assert edited.count("#") == text.count("#")


def test_the_text_of_a_chute_that_was_changed_is_that_of_its_numbers():
    chute = chutecalc.parse(chutecalc.STARTER).put({"segments.spoon.radius_m": 2.0})
    assert tomllib.loads(text_of(chute)) == chute.data
