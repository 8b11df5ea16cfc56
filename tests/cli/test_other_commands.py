"""``new``, ``schema``, ``columns``, ``--version``, ``--help``, ``python -m chutecalc``."""

import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import jsonschema
import pytest

import chutecalc
from chutecalc.cli import COMMANDS, main
from chutecalc.core import compiled
from chutecalc.design import Status
from chutecalc.results.columns import COLUMNS
from chutecalc.sections.registry import SHAPES
from chutecalc.segments.registry import KINDS
from chutecalc.spec.examples import examples
from chutecalc.spec.limits import LIMITS
from tests.conftest import ROOT, STANDARD_DESIGNS


def test_new_writes_a_spec_that_runs_and_never_overwrites(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["new"]) == 0
    assert "chutecalc run chute.toml" in capsys.readouterr().out
    assert main(["run", "chute.toml"]) == 0
    capsys.readouterr()
    (tmp_path / "chute.toml").write_text("mine", encoding="utf-8")
    assert main(["new"]) == 2
    assert "chute.toml already exists" in capsys.readouterr().err
    assert (tmp_path / "chute.toml").read_text(encoding="utf-8") == "mine"
    assert main(["new", "no/such/folder.toml"]) == 2
    assert sorted(path.name for path in tmp_path.iterdir()) == ["chute.schema.json", "chute.toml"]
    assert main(["new", "-"]) == 0
    assert capsys.readouterr().out == chutecalc.STARTER
    Path("chute.schema.json").unlink()
    monkeypatch.setattr("chutecalc.spec.schema.schema_text", lambda schema: 1 / 0)
    assert main(["new", "other.toml"]) == 70
    assert [path.name for path in tmp_path.iterdir()] == ["chute.toml"]


def test_the_first_line_of_a_new_spec_leads_editors_to_a_schema_that_it_satisfies(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "sub").mkdir()
    assert main(["new", "sub/chute.toml"]) == 0
    schema = Path("sub", "chute.schema.json")
    assert capsys.readouterr().out.startswith(f"wrote sub/chute.toml, and {schema} for editors")
    first, _, rest = Path("sub/chute.toml").read_text(encoding="utf-8").partition("\n")
    assert rest == chutecalc.STARTER
    assert Path("sub", first.removeprefix("#:schema ")) == schema
    assert main(["schema"]) == 0
    assert capsys.readouterr().out == schema.read_text(encoding="utf-8")
    jsonschema.validate(tomllib.loads(rest), json.loads(schema.read_text(encoding="utf-8")))
    schema.write_text("mine", encoding="utf-8")
    assert main(["new", "sub/other.toml"]) == 0
    assert capsys.readouterr().out.startswith("wrote sub/other.toml. To run it")
    assert schema.read_text(encoding="utf-8") == "mine"


def test_new_writes_and_lists_every_standard_design(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = {path.relative_to(ROOT / "specs").with_suffix("").as_posix(): path for path in STANDARD_DESIGNS}
    assert set(examples()) == set(names)
    assert main(["new", "--list"]) == 0
    out = capsys.readouterr().out
    for name, path in names.items():
        title = tomllib.loads(path.read_text(encoding="utf-8"))["title"]
        assert re.search(rf"^{name} +{re.escape(title[:30])}", out, re.MULTILINE)
    assert main(["new", "--example", "paper/r1_d30_square"]) == 0
    written = Path("r1_d30_square.toml").read_text(encoding="utf-8")
    assert written.partition("\n")[2] == names["paper/r1_d30_square"].read_text(encoding="utf-8")
    assert main(["new", "--example", "belt_hood_spon"]) == 2
    assert "Did you mean belt_hood_spoon?" in capsys.readouterr().err
    assert main(["new", "--list", "chute.toml"]) == 2


def uncommented(text):
    """Return the blocks of the starter's comments that are TOML, each with its header."""
    blocks = re.findall(r"^# \[(?:.+\n)+", text, re.MULTILINE)
    return [re.sub(r"^# ", "", block, flags=re.MULTILINE) for block in blocks]


def test_the_starter_names_every_shape_and_kind_and_its_comments_are_toml():
    assert " | ".join(SHAPES) in chutecalc.STARTER
    assert " | ".join(KINDS) in chutecalc.STARTER
    spec = tomllib.loads(chutecalc.STARTER)
    blocks = [tomllib.loads(block) for block in uncommented(chutecalc.STARTER)]
    shapes = [section["shape"] for one in (spec, *blocks) for section in one.get("sections", {}).values()]
    assert sorted(shapes) == sorted(SHAPES)
    kinds = [segment["kind"] for one in (spec, *blocks) for segment in one.get("segments", [])]
    assert sorted(kinds) == sorted(KINDS)
    for block in blocks:
        further = {"segments": spec["segments"] + block.get("segments", [])}
        assert chutecalc.solve(chutecalc.parse(spec | block | further)).status[0] in Status.LABELS
    assert {"inlet", "receiver"} <= {key for block in blocks for key in block}


def test_the_starter_runs_and_has_no_findings():
    solution = chutecalc.solve(chutecalc.parse(chutecalc.STARTER))
    assert solution.status.tolist() == ["ok"]
    assert solution.findings() == []


def test_limits_are_listed_with_their_defaults_and_sources(capsys):
    assert main(["limits"]) == 0
    out = capsys.readouterr().out
    for limit in LIMITS.values():
        assert re.search(rf"^{limit.key} +{re.escape(limit.text)} +{limit.finding}", out, re.MULTILINE), limit.key
        assert re.search(rf"^{limit.key} +(.* )?{re.escape(limit.source)}", out, re.MULTILINE), limit.key


def test_schema_accepts_every_standard_design_and_refuses_what_run_refuses(capsys):
    assert main(["schema"]) == 0
    validator = jsonschema.Draft202012Validator(json.loads(capsys.readouterr().out))
    validator.check_schema(validator.schema)
    for path in STANDARD_DESIGNS:
        assert list(validator.iter_errors(tomllib.loads(path.read_text(encoding="utf-8")))) == []
    good = tomllib.loads(chutecalc.STARTER)
    good["segments"][1]["radius_mm"] = good["segments"][1].pop("radius_m") * 1000
    assert validator.is_valid(good)
    for table, key, value in (
        (good["flow"], "rate_kg_s", 1.0),  # given twice
        (good["flow"], "rate", 1.0),
        (good["inlet"], "slope_deg", 91.0),
        (good["segments"][1], "radius_mm", -1.0),
    ):
        kept = table.get(key)
        table[key] = value
        assert not validator.is_valid(good), key
        if kept is None:
            del table[key]
        else:
            table[key] = kept


def test_columns_lists_them_all(capsys):
    assert main(["columns"]) == 0
    out = capsys.readouterr().out
    catalogue, forms = out.split("\n\n")
    names = [line.split()[0] for line in catalogue.splitlines()[1:] if not line.startswith(" ")]
    assert names == list(COLUMNS)
    for form in ("exit_NAME", "receiver_NAME", "segments.SEGMENT.impact_NAME", "segments.SEGMENT.status"):
        assert f"\n{form} " in forms
    assert max(map(len, out.splitlines())) <= 80


def test_version_and_help(capsys):
    assert main(["--version"]) == 0
    form = "" if compiled() else " (core not compiled: slower)"
    assert capsys.readouterr().out == f"chutecalc {chutecalc.__version__}{form}\n"
    assert main(["--help"]) == 0
    listed = capsys.readouterr().out
    commands = listed[listed.index("Commands:") : listed.index("Exit status:")]
    assert re.findall(r"^  ([a-z]+) ", commands, re.MULTILINE) == list(COMMANDS)
    assert main(["run", "-h"]) == 0
    assert "--stations" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("run", "SPEC is missing. For example: chutecalc run chute.toml --plot chute.svg"),
        ("sweep", "PARAMETER is missing. For example: chutecalc sweep radius=2:4:0.5 phi=20:30:5 chute.toml"),
        ("chute.toml", "there is no command chute.toml. To solve a chute: chutecalc run chute.toml\n"),
        ("swep", "there is no command swep. Did you mean sweep?\n"),
        ("xyz", f"there is no command xyz. Use {', '.join(COMMANDS[:-1])} or dem.\n"),
        ("run a.toml --qqq", "there is no option --qqq. chutecalc run --help lists the options.\n"),
        ("run a.toml --plott x", "there is no option --plott. Did you mean --plot"),
        ("run a.toml --plot", "--plot needs a value after it.\n"),
        ("run a.toml --strict=3", "--strict takes no value. Write --strict alone.\n"),
        ("run a.toml --points 1", "--points must be at least 2, not 1.\n"),
        ("run a.toml --points x", "--points must be a whole number, not x.\n"),
        ("run a.toml --stations x", "--stations must be a number, not x.\n"),
        ("run a.toml --stations 2,5", "--stations must be a number, not 2,5. Write a decimal point: 2.5.\n"),
        ("run a.toml --csv=", "--csv needs a value after it, which is empty.\n"),
        ("run a.toml -plot a.svg", "there is no option -plot. Names of options have two minus signs: --plot.\n"),
        ("run a.toml --stations 0", "--stations must be a length greater than 0 m, and finite, not 0\n"),
        ("run a.toml --stations nan", "--stations must be a length greater than 0 m, and finite, not nan\n"),
        ("run a.toml --rtol 2", "--rtol must be from 1e-13 to 0.001, not 2.\n"),
        ("run a.toml --plot a.svg --plot b.png", "--plot is given twice. Give it once.\n"),
        ("sweep beta --keep x", "--keep must be base, width or depth, not x.\n"),
        ("dem --wall-friction 99", "--wall-friction must be from 0 to 89, not 99.\n"),
        ("run a.baseline.toml", "a.baseline.toml is a baseline, not a chute. Run a.toml.\n"),
        (
            "run a.toml --set flow.rate_t_h=2,5",
            "--set flow.rate_t_h=2,5 is not a number: the decimal mark is a point. Write --set flow.rate_t_h=2.5.\n",
        ),
        ("new no/such/a.toml", "no/such/a.toml cannot be written: there is no folder no/such. Create it first.\n"),
        ("new .", ". is a folder: name a file in it\n"),
        ("new a b", "b is more than the command takes. For example: chutecalc new\n"),
    ],
)
def test_a_wrong_command_line_is_explained(arguments, message, capsys):
    assert main(arguments.split()) == 2
    assert capsys.readouterr().err.startswith(f"chutecalc: {message}")


@pytest.mark.parametrize(
    ("command", "usage"),
    [("run", "SPEC..."), ("sweep", "PARAMETER... [SPEC]"), ("check", "[PATH...]"), ("new", "[FILE]")],
)
def test_help_writes_arguments_as_a_user_does(command, usage, capsys):
    assert main([command, "--help"]) == 0
    out = capsys.readouterr().out
    assert out.startswith(f"Usage: chutecalc {command} [OPTIONS] {usage}\n")
    assert "str>" not in out


def test_no_command_shows_the_help_and_is_a_wrong_command(capsys):
    assert main([]) == 2
    assert "Usage: chutecalc" in capsys.readouterr().err


@pytest.mark.parametrize("arguments", [["-m", "chutecalc"], ["-c", "from chutecalc.__main__ import entry; entry()"]])
def test_as_a_process(arguments):
    run = subprocess.run([sys.executable, *arguments, "--version"], capture_output=True, text=True, check=True)
    assert run.stdout.startswith("chutecalc ")


def test_a_traceback_is_shown_of_any_command(capsys, monkeypatch):
    monkeypatch.setattr("chutecalc.spec.schema.json_schema", lambda: 1 / 0)
    assert main(["schema", "--debug"]) == 70
    assert "Traceback (most recent call last)" in capsys.readouterr().err
    assert main(["schema"]) == 70
    assert "Traceback" not in capsys.readouterr().err
