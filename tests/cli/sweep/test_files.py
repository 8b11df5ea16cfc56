"""Rows in files, in pictures and in charts."""

import csv
import io
import json
import re
import sys

import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.studies.sweep import sweep as rows_of
from chutecalc.studies.sweep.parameters import read_parameters
from chutecalc.studies.sweep.plot import draw_sweep
from chutecalc.studies.sweep.solved_blocks import solve_block
from tests.cli.sweep.commands import HOOD, LINERS, SPOON, refused


def test_every_format_has_the_same_rows(capsys, tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    files = [str(tmp_path / f"rows.{kind}") for kind in ("csv", "parquet", "json")]
    outputs = [
        word for kind, file in zip(("csv", "parquet", "json"), files, strict=True) for word in (f"--{kind}", file)
    ]
    assert main(["sweep", "phi=20,44", "beta=45,90", SPOON, *outputs]) == 0
    assert "stall" in capsys.readouterr().out
    assert sorted(path.name for path in tmp_path.iterdir()) == ["rows.csv", "rows.json", "rows.parquet"]
    rows = list(csv.DictReader(io.StringIO((tmp_path / "rows.csv").read_bytes().decode())))
    document = json.loads((tmp_path / "rows.json").read_text(encoding="utf-8"))
    assert document["chutecalc"] == chutecalc.__version__
    assert document["rows"] == parquet.read_table(files[1]).to_pylist()
    for one, other in zip(rows, document["rows"], strict=True):
        assert list(one) == list(other)
        assert one == {name: "" if value is None else str(value) for name, value in other.items()}


def test_parquet_needs_its_extra(capsys, monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    message = refused(capsys, "beta", SPOON, "--parquet", str(tmp_path / "a.parquet"), status=3)
    assert "pip install pyarrow" in message


@pytest.mark.parametrize(
    "arguments", [["phi=20:40:5"], ["radius=1:4:1", "phi=20:40:5"], ["radius=1:4:#9", "phi=20:40:#9"]]
)
def test_pictures(arguments, tmp_path, capsys):
    files = [tmp_path / name for name in ("one.svg", "two.svg")]
    for file in files:
        assert main(["sweep", *arguments, SPOON, "--plot", str(file), "--units", "us"]) == 0
    assert files[0].read_bytes() == files[1].read_bytes()
    assert len(files[0].read_bytes()) > 10_000
    text = files[0].read_text(encoding="utf-8")  # letters are paths; what they say stands beside them in comments
    assert re.search(r"<!-- exit velocity \S+ fpm -->", text)
    assert "m/s" not in text


def test_a_chart(capsys):
    assert main(["sweep", "beta", SPOON, "--chart"]) == 0
    out = capsys.readouterr().out
    assert "exit velocity v, m/s" in out
    assert "(β, °)" in out


def drawn(*arguments):
    """Return the picture of a sweep."""
    chute = chutecalc.load(HOOD)
    sweep = rows_of.Sweep(chute, read_parameters(list(arguments), chute))
    return draw_sweep(sweep, solve_block(sweep, 0)), solve_block(sweep, 0)


def test_names_in_pictures_and_charts(capsys):
    figure, block = drawn(LINERS[0])
    axes = figure.axes[0]
    (line,) = (line for line in axes.lines if line.get_gid() == "line")
    assert [label.get_text() for label in axes.get_xticklabels()] == ["steel", "ceramic"]
    assert (line.get_xdata().tolist(), line.get_ydata().tolist()) == ([0, 1], block["exit_velocity_m_s"].tolist())
    figure, block = drawn(LINERS[0], "rate=1000:1500:#3")
    lines = [line for line in figure.axes[0].lines if line.get_gid() == "line"]
    assert [line.get_label() for line in lines] == ["spoon liner = steel", "spoon liner = ceramic"]
    for line, name in zip(lines, ("steel", "ceramic"), strict=True):
        own = block["segments.spoon.liner"] == name
        assert line.get_ydata().tolist() == block["exit_velocity_m_s"][own].tolist()
    assert main(["sweep", LINERS[0], HOOD, "--chart"]) == 0
    assert "(spoon liner: 0 steel, 1 ceramic)" in capsys.readouterr().out
