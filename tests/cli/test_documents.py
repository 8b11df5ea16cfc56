"""The JSON of every command: one shape for each, which the published schema describes."""

import copy
import json
import sys

import jsonschema
import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.cli.schema import results_schema
from chutecalc.output.dataset import DOCUMENT_FORMAT
from chutecalc.output.shape import TEXT, maybe, record
from chutecalc.results.edges import EDGE_NUMBERS
from chutecalc.results.inlet import INLET_NUMBERS
from tests.cli.test_place import SKETCH, WISHES
from tests.conftest import ROOT, STANDARD_DESIGNS

SPECS = ROOT / "specs"
SPOON, HOOD, BELT, ALL = (
    str(SPECS / name)
    for name in ("paper/r3_d55_chamfered.toml", "coal_hood_spoon.toml", "belt_hood_spoon.toml", "transfer_90.toml")
)
STALLS = str(SPECS / "fails/stall.toml")
FAKE = ROOT / "tests" / "dem" / "fake_lmp.py"
VALIDATOR = jsonschema.Draft202012Validator(results_schema())
AIM = ["aim", SPOON, "radius=1:4", "--target"]
COMMANDS = {
    "run": ["run", *map(str, STANDARD_DESIGNS)],
    "one": ["run", SPOON],
    "stations": ["run", BELT, SPOON, "--points", "3", "--columns", "x_m,depth_m,segment"],
    "studies": ["run", HOOD, STALLS, "--band", "--sensitivity"],
    "case": ["run", ALL, "--case", "wet"],
    "sweep": ["sweep", SPOON, "phi=20,44", "--columns", "status,exit_velocity_m_s,warnings"],
    "names": ["sweep", HOOD, "model.friction_law=paper,equilibrium"],
    "profiles": ["sweep", SPOON, "phi=20,44", "--points", "3"],
    "friction_study": ["sweep", "beta=0,45,90", "delta=30", "--keep", "width"],
    "uncertain": ["uncertain", ALL, "--samples", "256", "--warnings", "--limit", "max_depth_m<=0.3"],
    "place": ["place", "sketch.toml", *WISHES],
    "aim": [*AIM, "exit_velocity_m_s=3.7"],
    "no aim": [*AIM, "exit_velocity_m_s=99"],
    "optimise": ["optimise", SPOON, "beta=20:89", "--minimise", "exit_velocity_m_s", "--subject", "max_depth_m<=0.15"],
    "no optimum": ["optimise", SPOON, "beta=20:89", "--minimise", "exit_velocity_m_s", "--subject", "max_depth_m<=0"],
    "check": ["check", str(SPECS / "fails")],
}


@pytest.fixture
def written(tmp_path, capsys, monkeypatch):
    """Return the document of a command."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "sketch.toml").write_text(SKETCH, encoding="utf-8")

    def document(command):
        main([*command, "--json", "a.json"])
        capsys.readouterr()
        return json.loads((tmp_path / "a.json").read_text(encoding="utf-8"), parse_constant=pytest.fail)

    return document


@pytest.mark.parametrize("name", COMMANDS)
def test_the_schema_describes_every_document(name, written):
    document = written(COMMANDS[name])
    kind = "friction_study" if name == "friction_study" else COMMANDS[name][0]
    assert [*document.items()][:3] == [
        ("chutecalc", chutecalc.__version__),
        ("format", DOCUMENT_FORMAT),
        ("command", kind),
    ]
    VALIDATOR.validate(document)
    kept = copy.deepcopy(document)
    for key in document:  # none may be left out, nor take another name or be of another kind
        less = {name: value for name, value in kept.items() if name != key}
        for wrong in (
            less,
            less | {f"{key}_": kept[key]},
            less | {key: True if kept[key] is None or isinstance(kept[key], dict) else {}},
        ):
            assert not VALIDATOR.is_valid(wrong), key


def test_one_chute_and_several_are_of_one_shape(written):
    one, many = written(COMMANDS["one"]), written(COMMANDS["run"])
    (chute,) = one["chutes"]
    assert len(many["chutes"]) == len(STANDARD_DESIGNS)
    assert all(list(chute) == list(other) for other in many["chutes"])
    assert chute["cases"] == {}
    assert chute["worst_cases"] is chute["band"] is chute["sensitivity"] is chute["receiver"] is None


@pytest.mark.parametrize(
    "change",
    [
        lambda chute: chute.pop("band"),
        lambda chute: chute.update(status="fine"),
        lambda chute: chute["exit"].pop("velocity_m_s"),
        lambda chute: chute["exit"].update(velocity_m_s="4"),
        lambda chute: chute["exit"].update(velocity_km_h=4.0),
        lambda chute: chute["segments"][1].pop("impact"),
        lambda chute: chute["segments"][1]["maximum"].update(depth_m=[0.1]),
        lambda chute: chute["inlet"].pop("belt_fill"),
        lambda chute: chute["findings"][0].update(code="no_such_code"),
        lambda chute: chute["findings"][0].update(severity="error"),
        lambda chute: chute.update(cases=[]),
    ],
)
def test_an_altered_document_is_refused(change, written):
    document = written(COMMANDS["one"])
    change(document["chutes"][0])
    assert not VALIDATOR.is_valid(document)


def test_the_schema_is_published_and_valid(capsys):
    assert main(["schema", "results"]) == 0
    published = json.loads(capsys.readouterr().out)
    jsonschema.Draft202012Validator.check_schema(published)
    assert published == json.loads(json.dumps(results_schema()))
    ends = published["$defs"]["ends"]["properties"]
    assert ends["velocity_m_s"]["x-unit"] == "m/s"
    assert main(["schema", "result"]) == 2
    assert "must be spec or results, not result." in capsys.readouterr().err


def test_every_number_of_inlets_and_edges_has_a_meaning():
    for design in STANDARD_DESIGNS:
        solution = chutecalc.solve(chutecalc.load(design))
        assert {*solution.inlet} <= {*INLET_NUMBERS}
        assert all({*edge.numbers} <= {*EDGE_NUMBERS} for edge in solution.edges)


@pytest.mark.skipif(sys.platform == "win32", reason="the program in place of LAMMPS is a script")
def test_the_schema_describes_beds_of_particles(written, tmp_path, monkeypatch):
    program = tmp_path / "lmp"
    program.write_text(f"#!/bin/sh\nexec {sys.executable} {FAKE}\n", encoding="utf-8")
    program.chmod(0o755)
    monkeypatch.setenv("FAKE_LMP", "")
    size = ["--base", "0.2", "--area", "0.01", "--particle-friction", "0.75", "--beta", "30:90:30"]
    document = written(["dem", "--lmp", str(program), *size])
    VALIDATOR.validate(document)
    assert document["command"] == "dem"
    assert document["cases"]


def test_a_record_has_all_its_keys():
    shape = record("", name=TEXT, note=maybe(TEXT))
    assert jsonschema.Draft202012Validator(shape).is_valid({"name": "a", "note": None})
    assert not jsonschema.Draft202012Validator(shape).is_valid({"name": "a"})
