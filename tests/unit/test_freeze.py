"""The text that ``chutecalc.freeze`` writes: places and slopes where they belong, and all else as it was."""

import pytest

import chutecalc

HEAD = """\
title = "Any"  # and a comment
flow.rate_t_h = 1000
material = {density_kg_m3 = 800, internal_friction_deg = 50}
liners.wall.friction_deg = 25
sections.body = {shape = "rectangular", width_m = 0.8}
"""
INLET = "inlet = {velocity_m_s = 3.0, slope_deg = 0.0}\n"
BELT = "inlet.belt = {velocity_m_s = 1, pulley_radius_m = 0.4, material_depth_m = 0.2, friction_deg = 15}\n"
TABLES = """
[[segments]]   # the first
kind = "fall"
run_m = 1.0    # how far

# the spoon
[[segments]]
kind = "curve"
radius_m = 2.0
to_slope_deg = 20  # rather flat
"""
PLACE = "start_m = [1.0, -0.544813888889]", "from_slope_deg = 47.456010483798"  # 1 m at 3 m/s takes a third of a second
SPOON = '[[segments]]\nkind = "curve"\nradius_m = 2.0\nto_slope_deg = 20\n'


def frozen(text):
    """Return the frozen text, which freezes to itself and has the same exit velocity."""
    chute = chutecalc.parse(text)
    result = chutecalc.freeze(chute)
    again = chutecalc.parse(result)
    assert chutecalc.freeze(again) == result
    assert chutecalc.solve(again).exit_velocity == pytest.approx(chutecalc.solve(chute).exit_velocity, rel=1e-9)
    return result


def test_tables_gain_keys_below_their_own_and_keep_their_comments():
    places = "".join(f"{line}\n" for line in PLACE)
    expected = TABLES.replace("run_m = 1.0    # how far", "onto_next = true    # how far")
    assert frozen(HEAD + INLET + TABLES + "# the end\n") == HEAD + INLET + expected + places + "# the end\n"


def test_inline_tables_stay_inline():
    fall, spoon = '{kind = "fall", run_m = 1.0}', '{kind = "curve", radius_m = 2.0, to_slope_deg = 20}'
    text = f"segments = [\n  {fall},  # a fall\n  {spoon},\n]\n"
    result = frozen(HEAD + INLET + text)
    assert '  {kind = "fall", onto_next = true},  # a fall\n' in result
    assert all(place in result.splitlines()[-2] for place in PLACE)


@pytest.mark.parametrize(
    "case",
    [
        '"segments.1.may_be_passed" = true\n"segments.2.liner" = "wall"\n',
        'segments.1.may_be_passed = true\nsegments.2.liner = "wall"\n',
        '"segments.1".may_be_passed = true\nsegments."2.liner" = "wall"\n',
    ],
)
def test_cases_follow_the_numbers_of_their_segments(case):
    """A fall onto the first segment is added, so that the numbers of all others rise by 1."""
    cases = f'[cases.one]\nflow.rate_t_h = 900  # less\n{case}\n[cases.two]\n"flow.rate_t_h" = 800\n'
    result = chutecalc.parse(frozen(HEAD + BELT + SPOON + SPOON.replace("20", "10") + cases))
    assert result.spec.segments[0].kind == "fall"
    assert result.cases["one"].spec.segments[1].may_be_passed
    assert result.data["cases"]["one"]["segments.3.liner"] == "wall"
    assert result.cases["one"].spec.flow.rate_t_h == 900
    assert result.cases["two"].spec.flow.rate_t_h == 800


@pytest.mark.parametrize(
    "key",
    ['"segments.2.radius_m" = 0.05', "segments.2.radius_m = { normal = 0.05 }", 'segments."2.radius_m" = 0.05'],
)
def test_uncertainty_follows_the_numbers_of_its_segments(key):
    rest = '"flow.rate_t_h" = { uniform = [800, 900] }\ncorrelation = [["segments.2.radius_m", "flow.rate_t_h", 0.2]]\n'
    text = HEAD + BELT + SPOON + SPOON.replace("20", "10") + f"[uncertainty]\n{key}  # as built\n{rest}"
    result = chutecalc.parse(frozen(text))
    assert {each.path for each in result.uncertain.keys} == {"segments.3.radius_m", "flow.rate_t_h"}
    assert result.data["uncertainty"]["correlation"] == [["segments.3.radius_m", "flow.rate_t_h", 0.2]]
