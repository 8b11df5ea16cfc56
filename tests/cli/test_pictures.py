"""``run --plot`` and ``run --chart`` through ``main``: files, statuses, messages where something is missing."""

import io
import subprocess
import sys

import pytest
import tomli_w

from chutecalc.cli import main
from chutecalc.cli.friction import run_friction_study
from chutecalc.cli.outputs import Outputs
from chutecalc.errors import ExtraMissingError
from tests.conftest import ROOT, spec
from tests.robustness.processes import run

SPOON = str(ROOT / "specs/paper/r3_d55_chamfered.toml")
SQUARE = str(ROOT / "specs/paper/r3_d55_square.toml")
MAGIC = {"svg": b"<?xml", "png": b"\x89PNG", "pdf": b"%PDF"}


@pytest.fixture
def nothing_solved(monkeypatch):
    """Solving is a fault of the program."""
    monkeypatch.setattr("chutecalc.api.solve.run_chain", lambda *_: 1 / 0)


@pytest.mark.parametrize("ending", [*MAGIC, "PNG"])
def test_formats_go_by_the_ending(ending, tmp_path, capsys):
    file = tmp_path / f"picture.{ending}"
    assert main(["run", SPOON, "--plot", str(file)]) == 0
    assert file.read_bytes().startswith(MAGIC[ending.lower()])
    assert "exit velocity 3.878" in capsys.readouterr().out
    assert list(tmp_path.iterdir()) == [file]


def test_several_chutes_make_one_picture(tmp_path, capsys):
    file = tmp_path / "both.svg"
    assert main(["run", SPOON, SQUARE, "--plot", str(file), "--units", "us"]) == 0
    assert file.stat().st_size > 10_000


def test_a_failing_chute_is_drawn_and_fails(tmp_path, capsys):
    file = tmp_path / "stall.svg"
    arguments = ["--set", "liners.wall.friction_deg=42", "--set", "segments.1.drop_m=0.2"]
    assert main(["run", SPOON, *arguments, "--plot", str(file)]) == 1
    assert file.is_file()


@pytest.mark.parametrize(
    ("target", "words"),
    [
        ("picture", ".svg, .png or .pdf"),
        ("picture.jpg", ".svg, .png or .pdf"),
        ("-", ".svg, .png or .pdf"),
        ("no/such/folder/picture.svg", "cannot be written"),
        ("folder.svg", "is a folder"),
    ],
)
def test_what_cannot_be_written_is_told_before_solving(target, words, tmp_path, monkeypatch, capsys, nothing_solved):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder.svg").mkdir()
    assert main(["run", SPOON, "--plot", target]) == 2
    shown = capsys.readouterr()
    assert words in shown.err
    assert shown.out == ""
    assert [path.name for path in tmp_path.iterdir()] == ["folder.svg"]


def test_a_drawing_is_written_whole(tmp_path, capsys):
    pytest.importorskip("ezdxf")
    file = tmp_path / "chute.dxf"
    assert main(["run", SPOON, "--dxf", str(file)]) == 0
    assert file.read_bytes().endswith(b"EOF\n")
    assert "exit velocity 3.878" in capsys.readouterr().out
    assert list(tmp_path.iterdir()) == [file]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([SPOON, "--dxf", "chute.dwg"], "--dxf cannot draw chute.dwg: the name must end in .dxf"),
        ([SPOON, "--dxf", "-"], "the name must end in .dxf"),
        ([SPOON, SQUARE, "--dxf", "chute.dxf"], "--dxf draws one chute, not 2: give one spec"),
        ([SPOON, "--dxf", "no/such/chute.dxf"], "cannot be written"),
    ],
)
def test_what_cannot_be_drawn_for_cad_is_told_before_solving(
    arguments, words, tmp_path, monkeypatch, capsys, nothing_solved
):
    monkeypatch.chdir(tmp_path)
    assert main(["run", *arguments]) == 2
    assert words in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_two_outputs_to_one_file(tmp_path, capsys):
    file = str(tmp_path / "same.svg")
    assert main(["run", SPOON, "--plot", file, "--csv", file]) == 2
    assert f"--csv and --plot both write to {file}." in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "module", "line"),
    [
        (["--plot", "picture.svg"], "matplotlib", "pip install matplotlib"),
        (["--chart"], "plotille", "pip install plotille"),
        (["--dxf", "chute.dxf"], "ezdxf", "pip install ezdxf"),
    ],
)
def test_a_missing_extra_ends_with_3_before_solving(
    arguments, module, line, tmp_path, monkeypatch, capsys, nothing_solved
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(sys.modules, module, None)
    assert main(["run", SPOON, *arguments]) == 3
    shown = capsys.readouterr()
    assert line in shown.err
    assert shown.out == ""
    assert list(tmp_path.iterdir()) == []


def test_the_study_needs_the_extra_too(tmp_path, monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(ExtraMissingError, match="pip install matplotlib"):
        run_friction_study(Outputs(plot=str(tmp_path / "study.svg")))
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize("ending", MAGIC)
def test_the_study_is_drawn(ending, tmp_path, capsys):
    file = tmp_path / f"study.{ending}"
    assert run_friction_study(Outputs(plot=str(file)), keep="width") == 0
    assert file.read_bytes().startswith(MAGIC[ending])


def charts(text):
    """Return the lines of the charts in a report."""
    lines = text.splitlines()
    return lines[next(k for k, line in enumerate(lines) if line.strip() == "velocity v, m/s") :]


def test_a_chart_in_a_pipe_is_plain_and_80_columns_wide_at_most(capsys):
    assert main(["run", SPOON, "--chart"]) == 0
    out = capsys.readouterr().out
    lines = charts(out)
    assert "\x1b" not in out
    assert max(map(len, lines)) <= 80
    assert [line.strip() for line in lines if line.strip() in {"velocity v, m/s", "depth H, m"}] == [
        "velocity v, m/s",
        "depth H, m",
    ]
    assert all(line == line.rstrip() for line in lines)
    ticks = [float(line.split("|")[0]) for line in lines[1:12]]
    assert ticks == sorted(ticks, reverse=True)
    assert ticks[-1] == 0.0
    assert ticks[0] >= 6.607 > ticks[2]  # the largest velocity


def test_a_chart_has_dots_where_the_stream_is(capsys):
    # the fall has no depth: its third of the length is empty, and then the line begins
    assert main(["run", SPOON, "--chart"]) == 0
    lines = charts(capsys.readouterr().out)
    depth = lines[next(k for k, line in enumerate(lines) if "depth H" in line) + 1 :][:10]
    first = min(k for line in depth for k, dot in enumerate(line.split("|", 1)[1]) if ord(dot) > 0x2800 and k > 1)
    width = 80 - 23
    assert first / width == pytest.approx(2.0 / 6.712, abs=2 / width)


class Terminal(io.StringIO):
    encoding = "utf-8"

    def isatty(self):
        return True


@pytest.mark.parametrize(("columns", "shown"), [(59, False), (60, True), (300, True)])
def test_a_chart_takes_a_terminal_wide_enough(columns, shown, monkeypatch):
    terminal = Terminal()
    monkeypatch.setattr("sys.stdout", terminal)
    monkeypatch.setenv("COLUMNS", str(columns))
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("NO_COLOR", "1")
    assert main(["run", SPOON, "--chart"]) == 0
    out = terminal.getvalue()
    assert ("velocity v, m/s" in out) == shown
    assert (f"no chart: it needs 60 columns, and the terminal has {columns}" in out) == (not shown)
    if shown:
        assert max(map(len, charts(out))) <= min(columns, 120)


FAILING = {
    "stall": [{"kind": "straight", "slope_deg": 5.0, "length_m": 9.0}],
    "missed": [
        {"kind": "fall", "onto_next": True},
        {"kind": "straight", "slope_deg": 40.0, "length_m": 1.0, "start_m": [9.0, -1.0]},
    ],
}


@pytest.mark.parametrize("status", FAILING)
def test_charts_and_pictures_of_failing_chutes(status, tmp_path, capsys):
    path = tmp_path / "fails.toml"
    data = spec(inlet={"velocity_m_s": 2.0, "slope_deg": 5.0}, segments=FAILING[status])
    path.write_text(tomli_w.dumps(data), encoding="utf-8")
    assert main(["run", str(path), "--chart", "--plot", str(tmp_path / "fails.svg")]) == 1
    assert f"status {status}" in capsys.readouterr().out


def test_where_data_go_to_standard_output_there_is_no_chart(capsys):
    assert main(["run", SPOON, "--chart", "--csv", "-"]) == 0
    assert "velocity v" not in capsys.readouterr().out


@pytest.mark.parametrize("settings", [b"\xff\xfe", b"no_such_key: 1\nno colon\n"])
def test_pictures_know_no_settings_of_other_programs(settings, tmp_path, monkeypatch):
    pictures = []
    for folder, content in (("plain", None), ("set", settings)):
        (tmp_path / folder).mkdir()
        if content:
            (tmp_path / folder / "matplotlibrc").write_bytes(content)
            monkeypatch.setenv("MPLBACKEND", "module://matplotlib_inline.backend_inline")
            monkeypatch.setenv("SOURCE_DATE_EPOCH", "x")
        ended = run("run", SPOON, "--plot", "a.svg", "--report", "a.html", folder=tmp_path / folder)
        assert ended.status == 0, ended
        assert "matplotlib" not in ended.err
        pictures.append([(tmp_path / folder / name).read_bytes() for name in ("a.svg", "a.html")])
    assert pictures[0] == pictures[1]


def test_pyplot_and_its_windows_are_never_loaded(tmp_path):
    code = (
        "import sys\nfrom chutecalc.cli import main\n"
        f"assert main(['run', {SPOON!r}, '--plot', {str(tmp_path / 'a.png')!r}]) == 0\n"
        "print('matplotlib.pyplot' in sys.modules)\n"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.splitlines()[-1] == "False"
