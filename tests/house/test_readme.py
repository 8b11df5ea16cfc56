"""What README.md shows is what happens."""

import contextlib
import inspect
import io
import re
import shlex
from pathlib import Path

import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.findings import failures, warnings

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


def test_links_lead_somewhere():
    for target in re.findall(r"\]\((?!http)([^)#]+)\)", README):
        assert (ROOT / target).exists(), target


def test_every_finding_is_told_of():
    codes = {
        name
        for module in (failures, warnings)
        for name, value in vars(module).items()
        if inspect.isfunction(value) and value.__module__ == module.__name__ and not name.startswith("_")
    }
    table = re.findall(r"^\| `([a-z_]+)` \| (?:failure|warning|note)", README, re.MULTILINE)
    assert len(table) == len(set(table))
    assert (codes - {"fallen_short"}) | {"not_accelerated"} == set(table)


def test_every_version_is_the_same():
    assert f"version: {chutecalc.__version__}\n" in (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert f"## {chutecalc.__version__}" in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
