"""Tables fit 80 columns, on a terminal and in a pipe, and say the same there."""

import io
import re
from pathlib import Path

import pytest

from chutecalc.cli import main
from chutecalc.output.grid import width
from tests.conftest import ROOT

DESIGNS = sorted(path for path in (ROOT / "specs").rglob("*.toml") if not path.name.endswith(".baseline.toml"))
BELT = str(ROOT / "specs/belt_hood_spoon.toml")


class Terminal(io.StringIO):
    encoding = "utf-8"

    def isatty(self) -> bool:
        return True


@pytest.fixture
def shown(monkeypatch, capsys):
    """Return what a command prints to a terminal of some width; to a pipe for none."""

    def run(columns: int | None, *arguments: str) -> str:
        if columns is None:
            main(list(arguments))
            return capsys.readouterr().out
        terminal = Terminal()
        with monkeypatch.context() as patch:
            patch.setattr("sys.stdout", terminal)
            patch.setenv("COLUMNS", str(columns))
            patch.setenv("TERM", "xterm")
            patch.setenv("NO_COLOR", "1")
            main(list(arguments))
        return terminal.getvalue()

    return run


def tables(text: str) -> list[str]:
    """Return the lines of what is printed that are no text: in a pipe, text is not wrapped."""
    return [
        line
        for line in text.splitlines()
        if not re.match(r"\S+: |status|impact|inlet|receiver|failure|warn|note", line)
    ]


@pytest.mark.parametrize("units", ["metric", "us"])
@pytest.mark.parametrize("design", DESIGNS, ids=lambda path: path.stem)
def test_a_design_fits_80_columns_and_says_the_same_everywhere(design: Path, units, shown, monkeypatch):
    monkeypatch.chdir(ROOT)
    command = ["run", str(design.relative_to(ROOT)), "--points", "3", "--units", units]
    terminal, pipe = shown(80, *command), shown(None, *command)
    assert max(map(width, terminal.splitlines())) <= 80
    assert max(map(width, tables(pipe))) <= 80
    assert terminal.split() == pipe.split()
    assert not re.search(r"(?<![\w.])-0(\.0*)?(?![\w.])", pipe)


@pytest.mark.parametrize("design", DESIGNS, ids=lambda path: path.stem)
def test_a_sweep_fits_80_columns_too(design: Path, shown, monkeypatch):
    monkeypatch.chdir(ROOT)
    command = ["sweep", "rate=100,1000", str(design.relative_to(ROOT))]
    terminal, pipe = shown(80, *command), shown(None, *command)
    assert max(map(width, terminal.splitlines())) <= 80
    assert max(map(width, tables(pipe))) <= 80
    assert terminal.split() == pipe.split()


def test_a_comparison_of_all_designs_fits_80_columns(shown, monkeypatch):
    monkeypatch.chdir(ROOT)
    pipe = shown(None, "run", *(str(path.relative_to(ROOT)) for path in DESIGNS))
    comparison = pipe[pipe.index("\ncomparison\n") :]
    assert max(map(width, comparison.splitlines())) <= 80
    for path in DESIGNS:
        assert comparison.count(str(path.relative_to(ROOT))) >= 1
