"""Ctrl-C at the moments that a random one seldom meets; tests/robustness/kills.py presses it at any."""

import os
import sys

import pytest

from tests.conftest import ROOT
from tests.robustness.processes import run

PROGRAM = """
import atexit, signal
from chutecalc.__main__ import entry
import chutecalc.cli

def press():
    signal.raise_signal(signal.SIGINT)

class Removed:
    def __del__(self):
        press()

def work():
    {work}
    return 0

chutecalc.cli._app = lambda given: lambda **options: work()
{moment}
entry()
"""
LOST = "try: press()\n    except BaseException: "
MOMENTS = {
    "while it works": ("press()", "", 130),
    "a library makes it an error of its own": (f"{LOST}raise RuntimeError", "", 130),
    "a library loses it": (f"{LOST}pass", "", 0),
    "a library loses it, and it is pressed again": (f"{LOST}pass\n    press()", "", 130),
    "an object is removed": ("Removed()", "", 130),
    "after the last output": ("pass", "chutecalc.cli.finish_streams = press", 130),
    "twice": ("press()", "chutecalc.cli.finish_streams = press", 130),
    "while Python ends": ("pass", "atexit.register(press)", 0),
}


@pytest.mark.skipif(sys.platform == "win32", reason="signals are others there")
@pytest.mark.parametrize("moment", MOMENTS)
def test_ctrl_c_is_no_traceback_and_no_fault_of_the_program(moment, tmp_path):
    work, more, status = MOMENTS[moment]
    ended = run(folder=tmp_path, code=PROGRAM.format(work=work, moment=more))
    assert ended.status == status, ended
    assert set(ended.err.splitlines()) == ({"chutecalc: interrupted"} if status else set()), ended


WRITTEN = """
import signal
from chutecalc.__main__ import entry
from chutecalc.output.formats.{name} import {name_of_class} as rows

rows.close = lambda self: signal.raise_signal(signal.SIGINT)
entry()
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals are others there")
@pytest.mark.parametrize(("name", "library"), [("parquet", "pyarrow"), ("xlsx", "xlsxwriter")])
def test_ctrl_c_while_a_file_is_written_leaves_nothing_there_or_among_temporary_files(
    name, library, tmp_path, monkeypatch
):
    pytest.importorskip(library)
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    code = WRITTEN.format(name=name, name_of_class=f"{name.capitalize()}Rows")
    ended = run("run", str(ROOT / "specs/vee.toml"), f"--{name}", f"x.{name}", folder=tmp_path, code=code)
    assert (ended.status, ended.err) == (130, "chutecalc: interrupted\n"), ended
    assert os.listdir(tmp_path) == []
