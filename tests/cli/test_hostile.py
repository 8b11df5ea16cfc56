"""Text of users that means something to a terminal, a spreadsheet, an XML parser or a drawing; impossible wishes."""

import csv
import io
import json
import os
import subprocess
import sys
import warnings
from pathlib import Path
from xml.etree import ElementTree

import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.dem.pour import MOST as MOST_PARTICLES
from chutecalc.printable import printable
from tests.robustness.written import READERS

TITLE = "=\x1b]0;x\x07 $5% or $6 </text> ]]> 石炭 \u202e\n42 designs: 42 ok"
SHOWN = "=\\x1b]0;x\\x07 $5% or $6 </text> ]]> 石炭 \\u202e\\n42 designs: 42 ok"
BAD_NAME = "a\udcff\n42 ok\x1b[2J.toml"


@pytest.fixture
def hostile(tmp_path, monkeypatch):
    """Enter a folder with a spec whose title and name are hostile, and return its name."""
    monkeypatch.chdir(tmp_path)
    text = chutecalc.STARTER.replace('title = "Fall and spoon, coal"', f"title = {json.dumps(TITLE)}")
    assert text != chutecalc.STARTER
    try:
        Path(BAD_NAME).write_text(text, encoding="utf-8")
    except (OSError, UnicodeError):
        pytest.skip("no file can have such a name here")
    return BAD_NAME


def printed(capsys):
    found = capsys.readouterr()
    for line in (found.out + found.err).replace("\r\n", "\n").split("\n"):
        assert printable(line) == line
        assert not line.startswith("42")
    return found


def test_titles_and_names_are_shown_as_they_are_in_no_terminal(capsys, hostile):
    assert main(["run", hostile]) == 0
    out = printed(capsys).out
    assert SHOWN in out
    assert printable(BAD_NAME) in out
    assert main(["run", hostile, hostile]) == 0
    assert main(["sweep", hostile, "rate=500,1000"]) == 0
    assert main(["check", hostile]) == 1
    assert main(["freeze", hostile, "--output", f"{hostile}.toml"]) == 0
    printed(capsys)
    assert main(["run", hostile, "--set", "x\n42=1"]) == 2
    assert main(["run", "no" + hostile]) == 2
    assert main(["run", hostile, "--columns", "x\n42"]) == 2
    assert main(["explain", "x\n42\x9b"]) == 2
    assert main(["run\n42"]) == 2
    assert main(["run", hostile, "--csv", "no\n42/x.csv"]) == 2
    assert printed(capsys).err.count("\n") == 6


def test_every_format_is_well_formed(hostile, capsys):
    files = [f"x.{ending}" for ending in ("csv", "json", "parquet", "xlsx", "svg", "dxf", "html")]
    options = {"svg": "plot", "html": "report"}
    arguments = [each for file in files for each in (f"--{options.get(file[2:], file[2:])}", file)]
    assert main(["run", hostile, "--points", "3", *arguments]) == 0
    for file in files:
        READERS[file[2:]](Path(file).read_bytes())
    page = Path("x.html").read_text(encoding="utf-8")
    assert "</text>" not in page.partition("<svg")[0]
    assert "$5% or $6" in page
    assert "$5% or $6" in Path("x.svg").read_text(encoding="utf-8").replace("\n", " ")
    capsys.readouterr()


def test_json_gives_text_back_as_it_was(hostile, capsys):
    assert main(["run", hostile, "--json", "-"]) == 0
    text = printed(capsys).out
    found = [*strings(json.loads(text))]
    assert TITLE in found
    assert BAD_NAME in found


def strings(data):
    """Yield the text in nested tables."""
    if isinstance(data, str):
        yield data
    elif isinstance(data, dict | list):
        for item in data.values() if isinstance(data, dict) else data:
            yield from strings(item)


def test_no_cell_of_csv_is_a_formula(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for name in ("=cmd().toml", "+1.toml", "-1.toml", "@a.toml", "'=a.toml"):
        Path(name).write_text(chutecalc.STARTER, encoding="utf-8")
        assert main(["check", f"./{name}", "--csv", "-"]) == 1
    capsys.readouterr()
    assert main(["check", "--csv", "x.csv"]) == 1
    rows = csv.reader(io.StringIO(Path("x.csv").read_text(encoding="utf-8")))
    cells = {row[0] for row in rows}
    assert cells == {"spec", "'=cmd().toml", "'+1.toml", "'-1.toml", "'@a.toml", "''=a.toml"}


def test_junit_is_xml_whatever_names_say(hostile, capsys):
    assert main(["check", hostile, "--junit", "x.xml"]) == 1
    (case,) = ElementTree.parse("x.xml").getroot().iter("testcase")
    assert case.get("name") == printable(BAD_NAME)
    assert main(["check", "--update", hostile]) == 0
    assert main(["check", hostile]) == 0  # the name in the first line of the baseline is a comment
    printed(capsys)


def test_pictures_take_dollars_and_letters_without_a_glyph_in_silence(hostile, tmp_path, capsys):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert main(["run", hostile, hostile, "--plot", "x.pdf"]) == 0
    capsys.readouterr()


def test_fonts_of_other_scripts_are_used_where_there_are_any(monkeypatch):
    from matplotlib import font_manager

    from chutecalc.output.plots.letters import wide_fonts

    names = ["DejaVu Sans", "Noto Sans CJK SC", "Comic Sans"]
    monkeypatch.setattr(font_manager.fontManager, "get_font_names", lambda: names)
    assert wide_fonts.__wrapped__() == ["Noto Sans CJK SC"]


def test_no_warning_of_a_library_reaches_a_user(tmp_path):
    program = "import warnings; from chutecalc.__main__ import entry; warnings.warn('mine'); print('done')"
    for options, words in (([], ""), (["-W", "default"], "mine")):
        ran = subprocess.run([sys.executable, *options, "-c", program], capture_output=True, text=True, check=True)
        assert words in ran.stderr
        assert bool(ran.stderr) == bool(words)


def test_an_option_that_is_no_pattern(capsys):
    assert main(["run", "-("]) == 2
    assert capsys.readouterr().err.startswith("chutecalc: there is no option -(")


def test_standard_input_that_is_closed(capsys, monkeypatch):
    monkeypatch.setattr(sys, "stdin", None)
    assert main(["run", "-"]) == 2
    assert capsys.readouterr().err == "standard input: is closed. Pipe the text in, or name a file.\n"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no named pipes")
def test_a_pipe_in_a_checked_folder_is_refused(tmp_path, capsys):
    os.mkfifo(tmp_path / "x.toml")
    assert main(["check", str(tmp_path)]) == 2
    assert "is a named pipe, not a file" in capsys.readouterr().err
    assert main(["check", str(tmp_path / ("x" * 3000))]) == 2


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ("run x.toml --set flow.rate_t_h=1 --set flow.rate_t_h=2", "are of the same key"),
        ("sweep x.toml rate=1:1e299:1e-299", "more than 1e+300 values"),
        (f"sweep x.toml rate={'9' * 5000}", "is not a number"),
        (f"run x.toml --set segments.{'9' * 5000}.drop_m=1", "segments has no item"),
        ("dem --area 1000 --diameter 1e-4", f"4.49e+13 particles of 0.1 mm, and at most {MOST_PARTICLES:,} are poured"),
    ],
)
def test_impossible_wishes(arguments, words, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    Path("x.toml").write_text(chutecalc.STARTER, encoding="utf-8")
    assert main(arguments.split()) == 2
    err = capsys.readouterr().err
    assert words in err
    assert max(map(len, err.split("\n"))) <= 2100


def test_a_thousand_faults_are_shown_of_more(tmp_path, capsys):
    file = tmp_path / "x.toml"
    file.write_text("".join(f"k{number} = 1\n" for number in range(1100)), encoding="utf-8")
    assert main(["run", str(file)]) == 2
    *shown, last = capsys.readouterr().err.splitlines()
    assert len(shown) == 1000
    assert last == "106 more faults are not shown"


def test_a_fault_within_what_set_puts_there_says_which_key_it_is(hostile, capsys):
    assert main(["run", hostile, "--set", "receiver={velocity_m_s=1}"]) == 2
    assert "--set receiver={velocity_m_s=1}: receiver.friction_deg is missing. Add friction_deg" in printed(capsys).err
    assert main(["run", hostile, "--set", "receiver={velocity_m_s=-1}"]) == 2
    assert "}: receiver.velocity_m_s = -1 must be at least" in printed(capsys).err
    assert main(["run", hostile, "--set", "segments.spoon.liner="]) == 2
    assert "--set segments.spoon.liner= names nothing, which is not defined in [liners]" in printed(capsys).err


def test_a_front_has_no_more_points_than_can_be_drawn(hostile, capsys):
    wishes = ["--minimise", "exit_velocity_m_s", "--maximise", "max_depth_m"]
    assert main(["optimise", hostile, "radius=1:4", *wishes, "--points", "99999999999"]) == 2
    assert "a front has at most 1000 points, not 99999999999. Use fewer." in printed(capsys).err


def test_a_link_to_nowhere_names_the_folder_that_is_not_there(hostile, capsys):
    os.symlink("nowhere/x.csv", "link.csv")
    assert main(["run", hostile, "--csv", "link.csv"]) == 2
    assert f"there is no folder {Path('nowhere').absolute()}. Create it first." in printed(capsys).err


@pytest.mark.parametrize("kind", ["pipe", "link"])
def test_update_writes_into_nothing_but_baselines(tmp_path, monkeypatch, capsys, kind):
    monkeypatch.chdir(tmp_path)
    for name in ("one.toml", "other.toml"):
        Path(name).write_text(chutecalc.STARTER, encoding="utf-8")
    if kind == "pipe":
        if not hasattr(os, "mkfifo"):
            pytest.skip("there are no pipes with names here")
        os.mkfifo("one.baseline.toml")
    else:
        os.symlink("other.toml", "one.baseline.toml")
    assert main(["check", "one.toml", "--update"]) == 2
    assert "one.baseline.toml " + {"pipe": "is no file", "link": "leads to"}[kind] in printed(capsys).err
    assert Path("other.toml").read_text(encoding="utf-8") == chutecalc.STARTER
    Path("one.baseline.toml").unlink()
    os.symlink("kept.baseline.toml", "one.baseline.toml")
    assert main(["check", "one.toml", "--update"]) == 0
    assert Path("kept.baseline.toml").exists()


def test_too_little_memory_is_no_fault_of_the_program(hostile, capsys, monkeypatch):
    def full(*_args, **_more):
        raise MemoryError

    monkeypatch.setattr("chutecalc.api.solve.run_chain", full)
    assert main(["run", hostile]) == 2
    assert "there is not enough memory for that. Take fewer designs" in printed(capsys).err
