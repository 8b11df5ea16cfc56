"""A library of materials and liners: `use` stands for the keys of an entry."""

import json
from pathlib import Path

import jsonschema
import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.spec.parse import parse_text
from chutecalc.spec.schema import json_schema

LIBRARY = """\
[materials."coal, bituminous"]
density_kg_m3 = 850             # report 17
internal_friction_deg = 50
source = "shear test, report 17"

[materials.wet]
density_kg_m3 = 950
internal_friction_deg = 60

[liners."ceramic, new"]
yield_locus_kpa = [[0.5, 0.30], [1.0, 0.52], [2.0, 0.95]]
thickness_mm = 20

[liners.worn]
friction_deg = 30
"""
USING = (
    chutecalc.STARTER.replace('name = "coal"\ndensity_kg_m3 = 800\n', 'use = "coal, bituminous"\n')
    .replace("internal_friction_deg = 55      # effective angle of internal friction\n", "")
    .replace("friction_deg = 25               # wall friction angle\n", 'use = "ceramic, new"  # ours\n')
)
PLAIN = parse_text(USING, "spec")
PLAIN["material"] = {
    "name": "coal, bituminous",
    "density_kg_m3": 850,
    "internal_friction_deg": 50,
    "source": "shear test, report 17",
}
PLAIN["liners"]["ceramic"] = {
    "name": "ceramic, new",
    "yield_locus_kpa": [[0.5, 0.30], [1.0, 0.52], [2.0, 0.95]],
    "thickness_mm": 20,
}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder with a library and a spec that uses it."""
    monkeypatch.chdir(tmp_path)
    Path("chute-library.toml").write_text(LIBRARY, encoding="utf-8")
    Path("chute.toml").write_text(USING, encoding="utf-8")
    return tmp_path


def faults(spec=USING, library="chute-library.toml", changes=None):
    with pytest.raises(chutecalc.SpecError) as raised:
        chutecalc.parse(spec, "chute.toml", changes, library)
    return str(raised.value)


def test_a_spec_that_uses_a_library_is_the_spec_with_its_keys(folder):
    chute, plain = chutecalc.load("chute.toml"), chutecalc.parse(PLAIN)
    assert chute.data == PLAIN
    assert chutecalc.solve(chute).exit_velocity == chutecalc.solve(plain).exit_velocity
    assert chutecalc.parse(chute.data).data == PLAIN, "what is shown needs no library"


def test_keys_of_the_spec_override_those_of_the_entry_in_any_unit(folder):
    text = USING.replace('use = "coal, bituminous"', 'use = "coal, bituminous"\ndensity_t_m3 = 0.7\nname = "ours"')
    text = text.replace('use = "ceramic, new"', 'use = "ceramic, new"\nfriction_rad = 0.5')
    data = chutecalc.parse(text, library="chute-library.toml").data
    assert "density_kg_m3" not in data["material"]
    assert (data["material"]["density_t_m3"], data["material"]["name"]) == (0.7, "ours")
    assert data["liners"]["ceramic"] == {"name": "ceramic, new", "thickness_mm": 20, "friction_rad": 0.5}


def test_a_library_named_is_read_instead_of_the_one_beside(folder):
    Path("mine.toml").write_text(LIBRARY.replace("850", "700"), encoding="utf-8")
    assert chutecalc.load("chute.toml", library="mine.toml").spec.material.density_kg_m3 == 700.0
    assert "mine2.toml: there is no such file" in faults(library="mine2.toml")


def test_a_library_beside_is_read_only_by_specs_that_use_it(folder):
    Path("chute-library.toml").write_text("[materials", encoding="utf-8")
    Path("other.toml").write_text(chutecalc.STARTER, encoding="utf-8")
    chutecalc.load("other.toml")
    with pytest.raises(chutecalc.SpecError, match=r"^chute-library.toml:1: \[materials is not the header of a table"):
        chutecalc.load("chute.toml")


def test_what_is_missing_is_told_with_the_line_of_the_spec(folder):
    line = USING.splitlines().index('use = "coal, bituminous"') + 1
    told = faults(library=None)
    assert told.splitlines()[0] == (
        f'chute.toml:{line}: material.use = "coal, bituminous" needs a library. Name one with --library FILE'
        " (library= in Python), or put chute-library.toml beside the spec."
    )
    told = faults(USING.replace("coal, bit", "Coal, bit"))
    assert told == (
        f'chute.toml:{line}: material.use = "Coal, bituminous" is not among the materials of chute-library.toml.'
        " Did you mean coal, bituminous?"
    )
    assert 'Add [liners."granite"] there.' in faults(USING.replace("ceramic, new", "granite"))


@pytest.mark.parametrize(
    ("before", "after", "told"),
    [
        ("= 850 ", "= -850 ", ":2: materials.coal, bituminous.density_kg_m3 = -850 must be at least 2 kg/m³"),
        ("friction_deg = 30", "friction = 30", ":15: liners.worn.friction = 30 needs its unit at the end"),
        ("[liners.worn]", "[liner.worn]", ":14: liner is not a key of this table. Did you mean liners?"),
        ("[0.5, 0.30]", "[5.0, 0.30]", ":11: liners.ceramic, new.yield_locus_kpa is out of order at row 2"),
        ("friction_deg = 30", 'use = "x"', ':15: liners.worn.use = "x" is for specs'),
    ],
)
def test_faults_of_a_library_are_told_with_its_own_lines(folder, before, after, told):
    Path("chute-library.toml").write_text(LIBRARY.replace(before, after), encoding="utf-8")
    assert faults().startswith(f"chute-library.toml{told}")


def test_faults_of_the_spec_keep_their_lines(folder):
    line = USING.splitlines().index("rate_t_h = 1000") + 1
    assert faults(USING.replace("rate_t_h = 1000", "rate_t_h = -1")).startswith(
        f"chute.toml:{line}: flow.rate_t_h = -1"
    )
    assert faults(changes={"material.density_kg_m3": -1}).startswith("chute.toml")


def test_paths_vary_what_comes_from_the_library(folder):
    chute = chutecalc.load("chute.toml")
    varied = chute.vary({"material.density_kg_m3": [700.0, 850.0]})
    assert varied.spec.material.density_kg_m3.tolist() == [700.0, 850.0]
    assert varied.data["material"]["internal_friction_deg"] == 50
    assert chutecalc.load("chute.toml", {"material.use": "wet"}).spec.material.density_kg_m3 == 950.0
    assert chute.put({"material.density_kg_m3": 1.0e3}).put({"material.use": "wet"}).data["material"] == {
        "name": "wet",
        "density_kg_m3": 950,
        "internal_friction_deg": 60,
    }


def test_cases_and_sweeps_may_use_other_entries(folder, capsys):
    Path("chute.toml").write_text(USING + '\n[cases.wet]\n"material.use" = "wet"\n', encoding="utf-8")
    chute = chutecalc.load("chute.toml")
    assert chute.cases["wet"].spec.material.density_kg_m3 == 950.0
    assert (
        main(["sweep", "liners.ceramic.use=worn,worn", "material.density_kg_m3=800,900", "chute.toml", "--csv", "-"])
        == 0
    )
    Path("chute.toml").write_text(USING + '\n[cases.wet]\n"material.use" = "wett"\n', encoding="utf-8")
    line = len(USING.splitlines()) + 3
    with pytest.raises(chutecalc.SpecError, match=rf'^chute.toml:{line}: cases.wet.material.use = "wett" is not among'):
        chutecalc.load("chute.toml")


def test_a_case_alone_may_use_an_entry(folder):
    Path("chute.toml").write_text(chutecalc.STARTER + '\n[cases.wet]\n"material.use" = "wet"\n', encoding="utf-8")
    assert chutecalc.load("chute.toml").cases["wet"].spec.material.density_kg_m3 == 950.0


def test_what_is_written_keeps_use_and_comments(folder, capsys):
    assert main(["freeze", "chute.toml", "-o", "frozen.toml"]) == 0
    frozen = Path("frozen.toml").read_text(encoding="utf-8")
    assert 'use = "coal, bituminous"' in frozen
    assert 'use = "ceramic, new"  # ours' in frozen
    assert chutecalc.load("frozen.toml").data["material"] == PLAIN["material"]
    assert main(["place", "chute.toml", "spoon", "incidence=10", "z=-2", "--write"]) == 0
    assert 'use = "ceramic, new"  # ours' in Path("chute.toml").read_text(encoding="utf-8")
    assert chutecalc.load("chute.toml").data["liners"] == PLAIN["liners"]
    placed = chutecalc.place(USING, {"spoon": {"incidence": 10, "z": -2}}, library="chute-library.toml")
    assert placed.cases.main_solution.status[0] == "ok"


@pytest.mark.parametrize(
    "command",
    [
        ["run", "chute.toml"],
        ["sweep", "radius=2,3", "chute.toml"],
        ["aim", "chute.toml", "radius=1:4", "--target", "exit_velocity_m_s=5.5"],
        ["optimise", "chute.toml", "radius=1:4", "--minimise", "max_depth_m"],
        ["check", "chute.toml", "--update"],
        ["freeze", "chute.toml"],
        ["place", "chute.toml", "spoon", "incidence=10", "z=-2"],
        ["uncertain", "chute.toml", "--samples", "256"],
    ],
    ids=lambda command: command[0],
)
def test_every_command_takes_a_library(folder, command, capsys):
    Path("chute-library.toml").rename("mine.toml")
    text = Path("chute.toml").read_text(encoding="utf-8") + '\n[uncertainty]\n"flow.rate_t_h" = 10\n'
    Path("chute.toml").write_text(text, encoding="utf-8")
    assert main(command) == 2
    assert "needs a library" in capsys.readouterr().err
    assert main([*command, "--library", "mine.toml"]) in (0, 1), capsys.readouterr().err


def test_a_library_is_not_overwritten(folder, capsys):
    assert main(["freeze", "chute.toml", "--library", "chute-library.toml", "-o", "chute-library.toml"]) == 2
    assert "is an input" in capsys.readouterr().err


def test_json_has_the_numbers_and_the_name(folder, capsys):
    assert main(["run", "chute.toml", "--json", "-"]) == 0
    written = json.loads(capsys.readouterr().out)
    assert '"use"' not in json.dumps(written)
    assert '"coal, bituminous"' in json.dumps(written)


def test_a_baseline_tells_when_the_library_changes_its_numbers(folder, capsys):
    assert main(["check", "chute.toml", "--update"]) == 0
    assert main(["check", "."]) == 0
    Path("chute-library.toml").write_text(LIBRARY.replace("= 850 ", "= 900 "), encoding="utf-8")
    assert main(["check", "."]) == 1
    assert "edited" in capsys.readouterr().out


def test_the_schema_takes_use_in_place_of_required_keys():
    validator = jsonschema.Draft202012Validator(json_schema())
    assert validator.is_valid(parse_text(USING, "spec"))
    assert not validator.is_valid(parse_text(USING.replace('use = "coal, bituminous"', ""), "spec"))
