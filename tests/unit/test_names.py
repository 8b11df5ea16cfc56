"""Names of cases, segments, sections and liners: what they may be, and tables of the longest ones."""

import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.fields.quantities import LONGEST_NAME
from chutecalc.output.printer import PIPE_WIDTH, Printer
from tests.conftest import spec

TEXT = """\
flow.rate_t_h = 1000
material = {{density_kg_m3 = 800, internal_friction_deg = 50}}
inlet = {{velocity_m_s = 3.0, slope_deg = 40}}
[liners.{liner}]
friction_deg = 25
[sections.{section}]
shape = "rectangular"
width_m = 0.8
[[segments]]
name = {segment}
kind = "curve"
radius_m = 2.0
to_slope_deg = 20
[cases.{case}]
"flow.rate_t_h" = 1200
[cases.{case}b]
"liners.{liner}.friction_deg" = 60
"""
KINDS = ("liner", "section", "segment", "case")
SHORT = dict(zip(KINDS, ("wall", "body", '"spoon"', "wet"), strict=True))


def text(**names):
    return TEXT.format(**SHORT | names)


@pytest.mark.parametrize("kind", ["liner", "section", "segment"])
def test_names_have_a_greatest_length(kind):
    name = "n" * LONGEST_NAME
    quoted = '"{}"' if kind == "segment" else "{}"
    chutecalc.parse(text(**{kind: quoted.format(name)}))
    with pytest.raises(chutecalc.SpecError) as caught:
        chutecalc.parse(text(**{kind: quoted.format(f"{name}n")}))
    (fault,) = caught.value.faults
    assert (fault.problem, fault.remedy) == (f"has more than {LONGEST_NAME} characters", "use a shorter name")
    assert fault.line is not None
    assert f"{kind}s." in fault.path


def test_names_of_cases_have_a_greatest_length():
    cases = {name: {"flow.rate_t_h": 900.0} for name in ("n" * LONGEST_NAME, "n" * (LONGEST_NAME + 1))}
    with pytest.raises(chutecalc.SpecError) as caught:
        chutecalc.parse(spec(cases=cases))
    (fault,) = caught.value.faults
    assert fault.path == f"cases.{'n' * (LONGEST_NAME + 1)}"
    assert fault.problem == f"has more than {LONGEST_NAME} characters"


@pytest.mark.parametrize("character", [r"\u0007", r"\n", r"\u001b[31m", r"\u200b", r"\""])
def test_a_name_of_a_case_with_a_control_character_is_refused_at_its_line_and_shown_as_it_is_written(character):
    with pytest.raises(chutecalc.SpecError) as caught:
        chutecalc.parse(text(case="wet") + f'[cases."a{character}"]\n"flow.rate_t_h" = 900\n')
    (fault,) = caught.value.faults
    assert "is not a valid name. Use letters, digits" in str(caught.value)
    assert str(caught.value).isprintable()
    if character != r"\"":  # which looks like the end of the key
        assert fault.line == TEXT.count("\n") + 1


@pytest.mark.parametrize("units", ["metric", "us"])
def test_tables_of_the_longest_names_fit(units, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(Printer, "text", lambda *_, **__: None)  # lines beside tables, which are not broken in a pipe
    name, folder = "s" * LONGEST_NAME, tmp_path / ("folder" * 12)
    folder.mkdir()
    for file in (tmp_path / "chute.toml", folder / "chute.toml"):
        longest = {"segment": f'"{name}"', "case": "c" * (LONGEST_NAME - 1), "liner": "l" * LONGEST_NAME}
        file.write_text(text(**longest), encoding="utf-8")
    settings = f"segments.{name}.liner={'l' * LONGEST_NAME}", f"segments.{name}.radius_m=1,2"
    for command in (
        ["run", str(file), str(tmp_path / "chute.toml"), "--stations", "0.3"],
        ["sweep", str(file), "case", *settings],
        ["sweep", str(file), *settings, "--columns", f"segments.{name}.exit_velocity_m_s,findings"],
    ):
        assert main([*command, "--units", units]) in (0, 1)
        lines = capsys.readouterr().out.splitlines()
        assert len(lines) > 10
        assert max(map(len, lines)) <= PIPE_WIDTH
        assert command[0] != "run" or any(line.startswith(f"{name}  curve") for line in lines)
