"""``chutecalc place``: the spec that it writes does what was asked."""

import json
import re
from pathlib import Path

import pytest

import chutecalc
from chutecalc.cli import main

SKETCH = """\
# A sketch of a transfer: where its hood and its spoon stand is not known yet.
[flow]
rate_t_h = 1000
[material]
density_kg_m3 = 850
internal_friction_deg = 45
[liners.steel]
friction_deg = 24
[sections.body]
shape = "rectangular"
width_m = 0.9
[inlet]
velocity_m_s = 3.0
slope_deg = 0

[[segments]]
kind = "fall"
onto_next = true

[[segments]]
name = "hood"
kind = "hood"
radius_m = 2.0     # as the shop has it
to_slope_deg = 80

[[segments]]
kind = "fall"
drop_m = 1.0

[[segments]]
name = "spoon"
kind = "curve"
radius_m = 2.5
to_slope_deg = 30
"""


@pytest.fixture
def sketch(tmp_path):
    path = tmp_path / "sketch.toml"
    path.write_text(SKETCH, encoding="utf-8")
    return path


WISHES = ("hood", "incidence=8", "x=0.9", "share=0.1", "spoon", "incidence=6", "z=-4")


def test_a_sketch_becomes_a_chute(sketch, capsys):
    assert main(["run", str(sketch)]) == 2  # it has no places
    assert main(["place", str(sketch), *WISHES, "--write"]) == 0
    solution = chutecalc.solve(chutecalc.load(sketch))
    for name, incidence in (("hood", 8.0), ("spoon", 6.0)):
        assert solution.segments[name].impact["incidence_deg"][0] == pytest.approx(incidence, abs=1e-9)
    assert solution.segments["hood"].entry["x_m"][0] == pytest.approx(0.9, abs=1e-9)
    assert solution.segments["spoon"].entry["z_m"][0] == pytest.approx(-4.0, abs=1e-9)
    assert "# as the shop has it" in sketch.read_text(encoding="utf-8")
    assert "incidence" in capsys.readouterr().out


def test_cases_and_findings_are_told(sketch, capsys):
    sketch.write_text(SKETCH + '[cases.wet]\n"liners.steel.friction_deg" = 50\n', encoding="utf-8")
    steep = ("hood", "incidence=8", "x=0.9", "share=0.1", "spoon", "incidence=30", "z=-4", "share=0.3")
    assert main(["place", str(sketch), *steep]) == 0
    printed = capsys.readouterr().out
    assert re.search(r"status: design ok, wet \w+", printed)
    assert re.search(r"^warning steep_impact  spoon", printed, re.MULTILINE)
    assert re.search(r"^spoon +wet ", printed, re.MULTILINE)
    assert all(len(line) <= 80 for line in printed.splitlines())


def test_wrong_cases_are_said_and_nothing_is_written(sketch, capsys):
    wrong = SKETCH + '[cases.wet]\n"liners.rubber.friction_deg" = 28\n'
    sketch.write_text(wrong, encoding="utf-8")
    assert main(["place", str(sketch), *WISHES, "--write"]) == 2
    assert "liners.rubber" in capsys.readouterr().err
    assert sketch.read_text(encoding="utf-8") == wrong


def test_line_ends_stay(sketch):
    sketch.write_bytes(SKETCH.replace("\n", "\r\n").encode())
    assert main(["place", str(sketch), *WISHES, "--write"]) == 0
    content = sketch.read_bytes()
    assert content.count(b"\n") == content.count(b"\r\n") > SKETCH.count("\n")


def test_without_write_it_says_what_to_write(sketch, capsys):
    assert main(["place", str(sketch), "hood", "incidence=8", "x=0.9"]) == 0
    printed = capsys.readouterr().out
    assert re.search(r"^hood: hood from \S+° to 80.00°$\s+start_m = \[0\.9, ", printed, re.MULTILINE)
    assert "status: design ok\n" in printed
    assert "--write puts this into the spec." in printed
    assert all(len(line) <= 80 for line in printed.splitlines())
    assert sketch.read_text(encoding="utf-8") == SKETCH


def test_the_document_has_what_to_write_and_the_outcome(sketch, capsys):
    assert main(["place", str(sketch), *WISHES, "--json", "-"]) == 0
    document = json.loads(capsys.readouterr().out)
    (solution,), (outcome,) = document["solutions"], document["outcome"]
    written = [f"segments.{name}.{key}" for name in ("hood", "spoon") for key in ("start_m", "from_slope_deg")]
    assert [*solution] == written
    assert outcome["design"]["segments.spoon.impact_incidence_deg"] == pytest.approx(6.0, abs=1e-9)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["x=1"], "name the segment first, such as hood x=1"),
        (["hood", "x=a"], "x=a is not one number: give x one, such as x=0.2"),
        (["hood", "x=1", "2", "incidence=3"], "hood is given twice, also as 2"),
        (["hood", "x=1", "x=2"], "x is given twice"),
        (["hood", "incidence=1,3"], "incidence=1,3 is not one number"),
        (["hood", "x=-2", "incidence=3"], "its flight begins at x 0 m: that is the nearest"),
        (["hood", "x=1", "incidence=3", "--write", "-o", "other.toml"], "--write changes the file of the spec"),
    ],
)
def test_what_is_wrong_is_said_and_nothing_is_written(sketch, capsys, arguments, message):
    assert main(["place", str(sketch), *arguments]) == 2
    assert message in capsys.readouterr().err
    assert sketch.read_text(encoding="utf-8") == SKETCH
    assert [path.name for path in Path(sketch).parent.iterdir()] == ["sketch.toml"]
