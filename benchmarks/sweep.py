"""A sweep of a million designs to Parquet, compared with solving them: time and memory.

    python benchmarks/sweep.py [--quick] [--out FOLDER]

The worked example over 1000 radii and 1000 wall friction angles, none of which stalls. 'solving' is `exits` (for exit
columns) or `solve` (for columns that need the whole trajectory) on the same blocks with as many threads; 'sweep' is the
command with its Parquet file. Times are of the processor, summed over threads, and of the clock; memory is the peak of
the sweep.
"""

import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
from measure import Report

import chutecalc
from chutecalc.studies.sweep.grid import Grid
from chutecalc.studies.sweep.parameters import read_parameters

SPEC = Path(__file__).parents[1] / "specs" / "paper" / "r3_d55_chamfered.toml"
BLOCK = 16384
KINDS: dict[str, tuple[str, Callable[[chutecalc.Chute], Any]]] = {
    "exit columns": (
        "exit_velocity_m_s,exit_depth_m,exit_slope_deg",
        lambda chute: chutecalc.exits(chute, jobs=1).status,
    ),
    "usual columns": ("", lambda chute: chutecalc.solve(chute).exit_velocity),
}


def solving(arguments: list[str], solve: Callable[[chutecalc.Chute], Any]) -> tuple[float, float]:
    """Return processor and clock time, s."""
    chute = chutecalc.load(SPEC)
    grid = Grid(read_parameters(arguments, chute))

    def block(first: int) -> None:
        rows = np.arange(first, min(first + BLOCK, grid.count))
        solve(chute.vary({path: values for parameter, values in grid.at(rows) for path in parameter.paths}))

    start, spent = time.perf_counter(), time.process_time()
    with ThreadPoolExecutor() as pool:
        list(pool.map(block, range(0, grid.count, BLOCK)))
    return time.process_time() - spent, time.perf_counter() - start


def sweeping(arguments: list[str], columns: str) -> tuple[float, float]:
    """Measure processor and clock time of the command, s, with its start."""
    with tempfile.TemporaryDirectory() as folder:
        command = [
            sys.executable,
            "-m",
            "chutecalc",
            "sweep",
            *arguments,
            str(SPEC),
            "--parquet",
            f"{folder}/rows.parquet",
        ]
        start, before = time.perf_counter(), resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([*command, *(["--columns", columns] if columns else [])], check=True, stdout=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, time.perf_counter() - start


def main() -> None:
    """Measure and print."""
    report = Report("sweep", __doc__)
    rows = []
    for side in (100,) if report.quick else (300, 1000):
        arguments = [f"radius=1:4:#{side}", f"phi=20:30:#{side}"]
        for name, (columns, solve) in KINDS.items():
            solved, swept = solving(arguments, solve), sweeping(arguments, columns)
            memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024.0
            rows.append((name, side**2, *solved, *swept, swept[0] / solved[0], memory))
    header = ("columns", "designs", "solving_cpu_s", "solving_s", "sweep_cpu_s", "sweep_s", "ratio_cpu", "memory_mb")
    report.write(header, rows, ("", ",d", ".2f", ".2f", ".2f", ".2f", ".2f", ".0f"))


if __name__ == "__main__":
    main()
