"""Tables fit 80 columns, on a terminal and in a pipe, and say the same there."""

import io
import itertools
import re
from pathlib import Path

import numpy as np
import pytest

from chutecalc.cli import main
from chutecalc.cli.outputs import Outputs
from chutecalc.output.cells import width
from chutecalc.output.dataset import Dataset
from chutecalc.results.column import quantity_text
from chutecalc.results.columns import COLUMNS
from chutecalc.results.described import number
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
        if not re.match(r"\S+: |status|impact|inlet|belt  |band  |against|edge  |receiver|failure|warn|note", line)
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


def test_text_hangs_on_a_terminal_and_is_one_line_in_a_pipe(shown):
    terminal, pipe = shown(60, "run", BELT), shown(None, "run", BELT)
    (line,) = (line for line in pipe.splitlines() if line.startswith("warning thick_stream"))
    lines = terminal.splitlines()
    first = next(k for k, line in enumerate(lines) if line.startswith("warning thick_stream"))
    block = [lines[first], *itertools.takewhile(lambda line: line.startswith("    "), lines[first + 1 :])]
    assert len(block) > 1
    assert " ".join(" ".join(block).split()) == " ".join(line.split())
    assert max(map(width, lines)) <= 60


def test_a_wide_terminal_has_one_table(shown):
    wide = shown(200, "run", BELT)
    (heading,) = (line.split() for line in wide.splitlines() if line.startswith("segment"))
    names = [name for name, column in COLUMNS.items() if column.in_tables]
    assert len(heading) == 2 + sum(bool(COLUMNS[name].unit) for name in names)  # headings stand above units
    narrow = shown(80, "run", BELT)
    assert sum(line.startswith("segment") for line in narrow.splitlines()) == 2
    assert {word for word in wide.split() if re.fullmatch(r"-?[\d.]+", word)} == {
        word for word in narrow.split() if re.fullmatch(r"-?[\d.]+", word)
    }


def test_a_narrow_terminal_splits_no_number(shown):
    narrow, wide = shown(30, "run", BELT), shown(200, "run", BELT)
    numbers = re.compile(r"(?<![\w.])-?\d+\.\d+(?![\w.])")
    assert {*numbers.findall(narrow)} == {*numbers.findall(wide)}


@pytest.mark.parametrize("units", ["metric", "us"])
@pytest.mark.parametrize("name", [name for name in COLUMNS if COLUMNS[name].formula])
def test_no_column_shows_a_negative_zero(name, units):
    for value in (-0.0, -1e-9, -1e-300):
        assert not COLUMNS[name].shown(value, units).startswith("-")


def test_no_message_shows_a_negative_zero():
    assert quantity_text("slope_deg", -0.0, "metric") == "0°"
    assert quantity_text("depth_m", -0.0, "us", "in") == "0 in"
    assert number([-0.0, -0.0], "m") == "0 m"


def test_no_file_holds_a_negative_zero(tmp_path):
    block = {"x_m": np.array([-0.0, 1.0]), "name": np.array(["-0.0", ""])}
    for kind in ("csv", "json"):
        Outputs(**{kind: str(tmp_path / f"rows.{kind}")}).write(Dataset("run", {"x_m": float, "name": str}, [block]))
    assert (tmp_path / "rows.csv").read_text().splitlines() == ["x_m,name", "0.0,-0.0", "1.0,"]
    assert '{"x_m": 0.0, "name": "-0.0"}' in (tmp_path / "rows.json").read_text()
