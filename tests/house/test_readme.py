"""What README.md shows is what happens."""

import contextlib
import io
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.results.findings import CRITERIA

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def blocks(language):
    return re.findall(rf"^```{language}\n(.*?)^```$", README, re.DOTALL | re.MULTILINE)


@pytest.mark.parametrize("block", blocks("console"))
def test_commands_print_what_is_shown(block, capsys, monkeypatch):
    monkeypatch.chdir(ROOT)
    command, _, shown = block.partition("\n")
    assert command.startswith("$ chutecalc ")
    assert main(shlex.split(command)[2:]) == 0
    printed = capsys.readouterr().out
    assert shown
    assert printed.startswith(shown.rstrip("\n")) if "--csv -" in command else printed.rstrip() == shown.rstrip()


def test_specs_are_specs():
    assert blocks("toml")
    for block in blocks("toml"):
        assert chutecalc.solve(chutecalc.parse(block)).status[0] == "ok"


def test_python_prints_what_is_shown(monkeypatch):
    monkeypatch.chdir(ROOT)
    first, *further = blocks("python")
    (shown,) = blocks("text")
    names = {}
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(first, "README.md", "exec"), names)
    assert printed.getvalue() == shown
    for program in further:
        exec(compile(program, "README.md", "exec"), names)


def test_start_commands_name_files_that_exist():
    for block in blocks("sh"):
        for name in re.findall(r"specs/\S+\.toml", block):
            assert (ROOT / name).is_file()


@pytest.mark.skipif(sys.platform == "win32", reason="programs are elsewhere in a venv there")
def test_the_lines_for_a_ci_job_pass_and_fail(tmp_path):
    (lines,) = (block for block in blocks("sh") if "chutecalc check" in block)
    assert lines.count("\n") == 3
    for name in ("vee.toml", "vee.baseline.toml", "fails/stall.toml", "fails/stall.baseline.toml"):
        target = tmp_path / "specs" / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes((ROOT / "specs" / name).read_bytes())

    def job(script):
        options = {"cwd": tmp_path, "env": os.environ | {"CHUTECALC": str(ROOT)}}
        return subprocess.run(["bash", "-euo", "pipefail", "-c", script], capture_output=True, text=True, **options)

    first = job(lines)
    assert (first.returncode, first.stdout) == (0, "2 designs: 2 ok\n"), first.stderr
    assert (tmp_path / "check.xml").is_file()
    spec = tmp_path / "specs" / "vee.toml"
    spec.write_text(
        spec.read_text(encoding="utf-8").replace("friction_deg = 18", "friction_deg = 18.1"), encoding="utf-8"
    )
    again = job(lines.splitlines()[-1])
    assert again.returncode == 1
    assert again.stdout.startswith("specs/vee.toml: edited (tolerance 1e-09)\n")


def test_links_lead_somewhere():
    for target in re.findall(r"\]\((?!http)([^)#]+)\)", README):
        assert (ROOT / target).exists(), target


def test_every_finding_is_told_of():
    table = re.findall(r"^\| `([a-z_]+)` \| (?:failure|warning|note)", README, re.MULTILINE)
    assert len(table) == len(set(table))
    assert {criterion.code for criterion in CRITERIA} == set(table)


def test_every_version_is_the_same():
    assert f"version: {chutecalc.__version__}\n" in (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert f"## {chutecalc.__version__}" in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
