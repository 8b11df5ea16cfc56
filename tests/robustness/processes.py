"""Commands in processes of their own, to kill and to starve."""

import os
import subprocess
import sys
from pathlib import Path
from typing import Any, NamedTuple

from tests.conftest import ROOT

MARKED = "import os, sys; sys.path[0] = {!r}; from chutecalc.__main__ import entry; os.write(1, b'.'); entry()"
"""What a console script does, with a sign that Python has started: before, Ctrl-C is its own affair."""


SPOON = ROOT / "specs/paper/r3_d55_chamfered.toml"


class Outcome(NamedTuple):
    """What came of one attempt."""

    how: str
    """What happened, in a few words."""
    faults: tuple[str, ...] = ()
    """What is wrong."""


class Ended(NamedTuple):
    """A process that has ended."""

    status: int
    out: str
    err: str


def start(*arguments: str, folder: Path, code: str = "", **more: Any) -> subprocess.Popen[str]:
    """Start a command in a folder; ``code`` instead of the module, and more arguments of a process, such as streams."""
    command = [sys.executable, *(["-c", code] if code else ["-m", "chutecalc"]), *arguments]
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    streams = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **more}
    return subprocess.Popen(command, cwd=folder, env=environment, text=True, **streams)


def end(process: subprocess.Popen[str]) -> Ended:
    """Wait for the end of a process."""
    out, err = process.communicate(timeout=300)
    return Ended(process.returncode, out or "", err or "")


def run(*arguments: str, folder: Path, **more: Any) -> Ended:
    """Run a command in a folder."""
    return end(start(*arguments, folder=folder, **more))
