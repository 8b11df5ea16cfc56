"""What docs/paper.md shows is what comes out: its commands, its pictures and the numbers of its tables."""

import re
import shlex
from pathlib import Path

import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.studies.friction.study import FrictionStudy
from tests.conftest import ROOT

PAGE = (ROOT / "docs" / "paper.md").read_text(encoding="utf-8")
COMMANDS = re.findall(r"^\$ chutecalc (.*)$", PAGE, re.MULTILINE)


def rows(heading):
    """Return the rows of the table whose header begins so, as lists of cells."""
    table = PAGE[PAGE.index(f"| {heading} |") :].split("\n\n")[0]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines()[2:]]


def expanded(word):
    """Return what a shell makes of a word."""
    return sorted(path.as_posix() for path in Path().glob(word)) if "?" in word or "*" in word else [word]


@pytest.mark.parametrize("command", COMMANDS)
def test_each_command_draws_its_picture(command, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(ROOT)
    *words, picture = [file for word in shlex.split(command) for file in expanded(word)]
    assert (ROOT / picture).is_file()
    assert main([*words, str(tmp_path / "picture.svg")]) == 0
    assert (tmp_path / "picture.svg").stat().st_size > 10_000


def test_pictures_stand_there_and_are_small():
    shown = re.findall(r"!\[[^]]+\]\((\S+)\)", PAGE)
    assert len(shown) == len(COMMANDS) == len(set(shown))
    for file in shown:
        assert 10_000 < (ROOT / "docs" / file).stat().st_size < 250_000


def test_friction_table():
    table = rows("study")
    assert len(table) == 8
    for keep, beta, *frictions in table:
        study = FrictionStudy([float(beta[:-1])], [30, 40, 50, 55], keep=keep)
        assert [f"{value:.5f}" for value in study.columns["equivalent_friction"]] == frictions


def test_exit_velocities():
    table = rows("δ")
    assert len(table) == 4
    for delta, corners, *velocities in table:
        paths = [ROOT / "specs" / "paper" / f"r{radius}_d{delta[:-1]}_{corners}.toml" for radius in (1, 2, 3, 4)]
        assert [f"{chutecalc.solve(chutecalc.load(path)).exit_velocity[0]:.3f}" for path in paths] == velocities


def test_the_square_chute_of_the_full_width():
    # B + 2 C cos 45° in the mean along the spoon, and what comes out of a square chute that wide
    paper = ROOT / "specs" / "paper"
    wetted = chutecalc.solve(chutecalc.load(paper / "r3_d55_chamfered.toml")).stations()["chamfer_wetted_m"][0]
    width = 0.5 + 2.0 * wetted[wetted == wetted].mean() * 0.5**0.5
    assert f"the {width:.2f} m of its mean width" in PAGE
    square = chutecalc.load(paper / "r3_d55_square.toml").put({"sections.spoon.width_m": round(width, 2)})
    assert f"({chutecalc.solve(square).exit_velocity[0]:.3f} m/s" in PAGE


def test_sections_are_linked():
    anchors = {
        re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in re.findall(r"^#+ (.*)$", PAGE, re.M)
    }
    links = re.findall(r"\]\(#([^)]+)\)", PAGE)
    assert links
    assert set(links) <= anchors
