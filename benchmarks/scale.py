"""How time and memory grow: chutes of 10,000 segments, 1,000 specs in `check`, sweeps of 1e7 rows to a pipe.

    python benchmarks/scale.py [--quick] [--out FOLDER]

Each size is four times as large as the one before it. Growth is the exponent of the time between the two: 1 is in
proportion, 2 is with the square, below 1 what is fixed still counts. Times are of the processor, summed over threads,
of whole processes; memory is their peak. What the commands print goes through a pipe and is counted, not kept.
"""

import math
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from measure import Report

SPECS = Path(__file__).parents[1] / "specs"
SPOON = SPECS / "paper" / "r3_d55_chamfered.toml"
STEP = 4
Command = Callable[[Path, int], list[str]]
"""Takes a folder to write to, and a size; returns the arguments of chutecalc."""


def segments(*tables: str) -> Command:
    """Return the command that runs a chute of so many segments, which repeat."""

    def command(folder: Path, count: int) -> list[str]:
        head = (SPECS / "vee.toml").read_text(encoding="utf-8").split("[[segments]]")[0]
        chain = [f"[[segments]]\n{tables[number % len(tables)]}" for number in range(count)]
        spec = folder / "long.toml"
        spec.write_text("\n".join([head, *chain]), encoding="utf-8")
        return ["run", str(spec)]

    return command


def stations(folder: Path, count: int) -> list[str]:
    """Return the command that runs a chute with so many stations on each part."""
    return ["run", str(SPOON), "--points", str(count), "--csv", str(folder / "stations.csv")]


def specs(folder: Path, count: int) -> list[str]:
    """Return the command that checks so many specs."""
    for number in range(count):
        for ending in (".toml", ".baseline.toml"):
            shutil.copy(SPOON.with_suffix(ending), folder / f"spec_{number}{ending}")
    return ["check", str(folder)]


def rows(folder: Path, count: int) -> list[str]:
    """Return the command that sweeps so many rows to standard output."""
    side, columns = math.isqrt(count), "exit_velocity_m_s,exit_depth_m,exit_slope_deg"
    grid = [f"radius=1:4:#{side}", f"phi=20:30:#{side}"]
    return ["sweep", *grid, str(SPOON), "--columns", columns, "--csv", "-", "--yes"]


STRAIGHT = 'kind = "straight"\nslope_deg = 40\nlength_m = '
DROP = 'kind = "fall"\ndrop_m = 0.05'
TASKS: dict[str, tuple[Command, int, int]] = {
    "segments in contact": (segments(f"{STRAIGHT}0.01"), 160, 10_240),
    "segments, flights between": (segments(DROP, f"{STRAIGHT}0.4"), 160, 10_240),
    "stations of a part": (stations, 7_812, 500_000),
    "specs in check": (specs, 64, 1024),
    "rows of a sweep": (rows, 40_000, 10_240_000),
}
"""What grows, the smallest size and the largest."""


def sizes(size: int, largest: int) -> Iterator[int]:
    """Yield sizes up to the largest."""
    while size <= largest:
        yield size
        size *= STEP


def measured(arguments: list[str]) -> tuple[float, float, int]:
    """Return the processor time of a command, s, its memory, MB, and how many lines it prints."""
    command = [sys.executable, "-m", "chutecalc", *arguments]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    assert process.stdout is not None
    with process.stdout as stream, ThreadPoolExecutor(1) as pool:
        lines = pool.submit(lambda: sum(block.count(b"\n") for block in iter(lambda: stream.read(1 << 20), b"")))
        _, status, usage = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"{' '.join(command)}: status {os.waitstatus_to_exitcode(status)}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024.0, lines.result()


def main() -> None:
    """Measure and print."""
    report = Report("scale", __doc__)
    found: list[tuple[str, int, float, float, float, int]] = []
    for name, (command, smallest, largest) in TASKS.items():
        before = math.nan
        for size in sizes(smallest, smallest if report.quick else largest):
            with tempfile.TemporaryDirectory() as folder:
                seconds, megabytes, lines = measured(command(Path(folder), size))
            found.append((name, size, seconds, megabytes, math.log(seconds / before, STEP), lines))
            before = seconds
    report.write(
        ("what", "size", "cpu_s", "memory_mb", "growth", "lines"), found, ("", ",d", ".2f", ".0f", ".2f", ",d")
    )


if __name__ == "__main__":
    main()
