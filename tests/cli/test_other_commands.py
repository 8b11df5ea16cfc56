"""``new``, ``schema``, ``columns``, ``--version``, ``--help``, ``python -m chutecalc``."""

import json
import re
import subprocess
import sys
import tomllib

import jsonschema
import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.core import compiled
from chutecalc.design import Status
from chutecalc.results.columns import COLUMNS
from chutecalc.sections.registry import SHAPES
from chutecalc.segments.registry import KINDS
from tests.conftest import STANDARD_DESIGNS


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
    assert main(["new", "-"]) == 0
    assert capsys.readouterr().out == chutecalc.STARTER


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


def test_the_starter_runs_and_draws_the_warning_of_its_level_end_alone(capsys, tmp_path):
    solution = chutecalc.solve(chutecalc.parse(chutecalc.STARTER))
    assert solution.status.tolist() == ["ok"]
    assert [finding.code for finding in solution.findings()] == ["below_cut_off"]


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
    assert [line.split()[0] for line in out.splitlines()[1:]] == list(COLUMNS)


def test_version_and_help(capsys):
    assert main(["--version"]) == 0
    form = "" if compiled() else " (its core uncompiled: slower)"
    assert capsys.readouterr().out == f"chutecalc {chutecalc.__version__}{form}\n"
    assert main(["--help"]) == 0
    listed = capsys.readouterr().out
    for command in ("run", "sweep", "check", "dem", "new", "schema", "columns"):
        assert command in listed
    for later in ("optimise", "uncertainty", "explain"):
        assert later not in listed
    assert main(["run", "-h"]) == 0
    assert "--stations" in capsys.readouterr().out


def test_no_command_shows_the_help_and_is_a_wrong_command(capsys):
    assert main([]) == 2
    assert "Usage: chutecalc" in capsys.readouterr().err


@pytest.mark.parametrize("arguments", [["-m", "chutecalc"], ["-c", "from chutecalc.__main__ import entry; entry()"]])
def test_as_a_process(arguments):
    run = subprocess.run([sys.executable, *arguments, "--version"], capture_output=True, text=True, check=True)
    assert run.stdout.startswith("chutecalc ")
