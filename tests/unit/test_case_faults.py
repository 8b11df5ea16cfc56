"""What is wrong in the tables of [cases]: with the key as written, its own line, and what to do."""

import pytest

import chutecalc

HEAD = """\
flow.rate_t_h = 1000
material = {density_kg_m3 = 800, internal_friction_deg = 50}
liners.wall.friction_deg = 25
liners.worn.yield_locus_kpa = [[1, 0.5], [2, 1]]
sections.body = {shape = "rectangular", width_m = 0.8}
inlet = {velocity_m_s = 3.0, slope_deg = 40}

[[segments]]
name = "spoon"
liner = "wall"
kind = "curve"
radius_m = 2.0
to_slope_deg = 20

"""
FIRST = HEAD.count("\n") + 1


def fault(cases):
    """Return path, line from that of the first line of the cases, and text of their only fault."""
    with pytest.raises(chutecalc.SpecError) as caught:
        chutecalc.parse(HEAD + cases)
    (found,) = caught.value.faults
    return found.path, found.line - FIRST, found.text("spec")


@pytest.mark.parametrize(
    ("quoted", "dotted"),
    [
        ('"segments.spoon.radius_m"', "segments.spoon.radius_m"),
        ('"flow.rate_t_h"', "flow.rate_t_h"),
        ('liners."wall.friction_deg"', "liners.wall.friction_deg"),
    ],
)
def test_a_key_with_and_without_quotes_is_given_twice(quoted, dotted):
    for one, other in ((quoted, dotted), (dotted, quoted)):
        path, line, text = fault(f"[cases.wet]\n{one} = 1\n{other} = 2\n")
        assert path == f"cases.wet.{dotted}"
        assert f"= 2 is given twice, as {one} and as {other}. Keep one of them." in text
        assert line == 2


def test_a_segment_by_name_and_by_number_is_given_twice():
    path, line, text = fault('[cases.wet]\nsegments.1.liner = "worn"\n"segments.spoon.liner" = "wall"\n')
    assert (path, line) == ("cases.wet.segments.spoon.liner", 2)
    assert "also as segments.1.liner" in text


@pytest.mark.parametrize("title", ["", 'title = "Chute"\n'])
@pytest.mark.parametrize("given", ['"title" = "Wet"', 'title = "Wet"', "format = 1"])
def test_what_holds_for_all_cases_stands_at_the_top(title, given):
    with pytest.raises(chutecalc.SpecError) as caught:
        chutecalc.parse(f"{title}{HEAD}[cases.wet]\n{given}\n")
    (found,) = caught.value.faults
    assert found.problem == "holds for all cases"
    assert found.remedy.startswith("put it at the top of the spec; a case sets keys of flow, material, liners")
    assert "id you mean" not in found.remedy


@pytest.mark.parametrize("given", ["foo = 1", '"foo.rate_t_h" = 1', "rate_t_h = 3", "cases.dry.flow.rate_t_h = 1"])
def test_what_is_no_key_of_a_spec_is_not_said_to_belong_to_the_drawing(given):
    _, line, text = fault(f"[cases.wet]\n{given}\n")
    assert "is not a key that a case may set. Use keys of flow, material" in text
    assert line == 1


@pytest.mark.parametrize(
    ("cases", "path", "line"),
    [
        ('[cases.wet]\n# hot\n"liners.wall.friction_deg" = 100', "liners.wall.friction_deg", 2),
        ("[cases.wet]\n# hot\nliners.wall.friction_deg = 100", "liners.wall.friction_deg", 2),
        ("[cases.wet]\n# hot\nliners.wall = {friction_deg = 100}", "liners.wall.friction_deg", 2),
        ("[cases.wet]\n[cases.wet.liners.wall]\nfriction_deg = 100", "liners.wall.friction_deg", 2),
        ('[cases.wet]\nflow.rate_t_h = 1\nsegments.spoon.liner = "none"', "segments.spoon.liner", 2),
        ('[cases.wet]\nflow.rate_t_h = 1\nsegments.1.liner = "none"', "segments.1.liner", 2),
        # of keys that stand elsewhere, at the line of what they do not go together with
        ('[cases.wet]\nflow.rate_t_h = 1\n"liners.worn.friction_deg" = 20', "liners.worn.yield_locus_kpa", 2),
        ("[cases.wet]\nflow.rate_t_h = 1\nreceiver.velocity_m_s = 2", "receiver.friction_deg", 2),
    ],
)
def test_faults_stand_at_the_line_of_the_key(cases, path, line):
    assert fault(cases)[:2] == (f"cases.wet.{path}", line)
