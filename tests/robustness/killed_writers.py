"""Kills of commands that write one file: it is whole, or as it was before."""

import re
import signal
import tempfile
import time
from functools import cache
from pathlib import Path

import numpy as np

import chutecalc
from tests.conftest import ROOT
from tests.robustness.processes import SPOON, Outcome, end, run, start

WRITERS = {
    "new": ["new", "x.toml"],
    "aim --write": ["aim", "x.toml", "radius=1:4", "--target", "exit_velocity_m_s=6", "--write"],
    "place --write": ["place", "x.toml", "spoon", "incidence=10", "z=-2", "--write"],
    "run --report": ["run", str(SPOON), "--report", "x.html"],
    "run --plot": ["run", str(SPOON), "--plot", "x.svg"],
    "uncertain --csv": ["uncertain", str(ROOT / "specs/transfer_90.toml"), "--samples", "4096", "--csv", "x.csv"],
}
"""Commands that write one file, its name is x; those with --write into the spec that they read."""


@cache
def written(name: str) -> tuple[bytes, float]:
    """Return the file that nobody disturbs, and how long it takes, s."""
    with tempfile.TemporaryDirectory() as folder:
        put_spec(name, Path(folder))
        began = time.monotonic()
        ended = run(*WRITERS[name], folder=Path(folder))
        assert ended.status == 0, ended
        taken = time.monotonic() - began
        return file_of(Path(folder)), taken


def put_spec(name: str, folder: Path) -> None:
    """Put the spec into a folder that a command reads there."""
    if "--write" in WRITERS[name]:
        (folder / "x.toml").write_text(chutecalc.STARTER, encoding="utf-8")


def file_of(folder: Path) -> bytes:
    """Return the content of the file that a command writes; empty if there is none."""
    return b"".join(path.read_bytes() for path in folder.glob("x.*"))


def killed_writer(draw: np.random.Generator, folder: Path) -> Outcome:
    """Kill or interrupt a command that writes one file, and run it again, twice at once."""
    name = list(WRITERS)[draw.integers(len(WRITERS))]
    expected, taken = written(name)
    put_spec(name, folder)
    before = file_of(folder)
    process = start(*WRITERS[name], folder=folder)
    time.sleep(draw.uniform(0.2, 1.1) * taken)
    process.send_signal(signal.SIGKILL if draw.random() < 0.5 else signal.SIGTERM)
    end(process)
    faults = [] if file_of(folder) in (before, expected) else [f"{name}: killed, its file is not whole"]
    first = start(*WRITERS[name], folder=folder)
    time.sleep(draw.uniform(0.0, 0.6))
    second = start(*WRITERS[name], folder=folder)
    ends = end(first), end(second)
    refused = [each for each in ends if each.status == 2 and re.search("another process|already exists", each.err)]
    faults += [f"{name}: {each}" for each in ends if each.status and each not in refused]
    if file_of(folder) != expected:
        faults.append(f"{name}: another file")
    faults += [f"{name}: left {path.name}" for path in folder.glob(".*")]
    return Outcome(name, tuple(faults))
