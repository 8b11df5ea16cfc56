"""`chutecalc check` on 500 designs, compared with solving them plus one start-up.

    python benchmarks/check.py [--quick] [--out FOLDER]

The designs are the standard ones at other rates. Solving means what `chutecalc run` does except printing: read and
check the spec, solve it, work out ends, extremes and findings; the sum is taken in one running process. A start-up is
that of a command that solves nothing. All are measured in turn, round by round, and ratios are to the sum of both in
the same round. The ratio of processor times is meaningful on a busy machine too. Memory is the peak of all processes
together, sampled every 20 ms.
"""

import os
import subprocess
import sys
import tempfile
import time
import tomllib
from collections.abc import Callable
from pathlib import Path
from statistics import median
from typing import NamedTuple

import tomli_w
from measure import Report

ROOT = Path(__file__).parents[1]
SOLVING, START = "solving, the sum", "one start-up"
COMMAND = [sys.executable, "-m", "chutecalc"]
SOLVE = """
import sys, time
from chutecalc.api.load import load
from chutecalc.api.solve import solve
wall, cpu = time.perf_counter(), time.process_time()
for file in sys.argv[1:]:
    solution = solve(load(file))
    solution.trajectory.results, solution.findings(), solution.receiver
print(time.perf_counter() - wall, time.process_time() - cpu)
"""
ALONE = """
import sys
from chutecalc.studies.regression.designs import find_designs
from chutecalc.studies.regression.check import check
from chutecalc.studies.regression.verdict import OK
assert all(item.outcome == OK for item in check(find_designs(sys.argv[1:]).chutes, processes=1))
"""


def write_designs(folder: Path, count: int) -> list[str]:
    """Write the standard designs several times, each at another rate; return the files."""
    standard = [path for path in sorted((ROOT / "specs").rglob("*.toml")) if not path.name.endswith(".baseline.toml")]
    files = []
    for number in range(count):
        spec = tomllib.loads(standard[number % len(standard)].read_text(encoding="utf-8"))
        key = next(key for key in spec["flow"] if key.startswith("rate_"))
        spec["flow"][key] *= 1.0 - 0.02 * (number // len(standard))
        files.append(str(folder / f"design_{number}.toml"))
        Path(files[-1]).write_text(tomli_w.dumps(spec), encoding="utf-8")
    return files


def resident(process: int) -> int:
    """Return the memory of a process and its children, bytes; 0 where the system does not report it."""
    try:
        own = int(Path(f"/proc/{process}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")
        children = Path(f"/proc/{process}/task/{process}/children").read_text().split()
    except OSError:
        return 0
    return own + sum(resident(int(child)) for child in children)


class Cost(NamedTuple):
    """Time and memory of a task."""

    seconds: float
    processor_seconds: float
    megabytes: float = 0.0


def run(arguments: list[str]) -> Cost:
    """Run a process with its children."""
    start, before, most = time.perf_counter(), os.times(), 0
    with subprocess.Popen(arguments, stdout=subprocess.DEVNULL) as process:
        while process.poll() is None:
            most = max(most, resident(process.pid))
            time.sleep(0.02)
    assert process.returncode == 0, arguments[:4]
    seconds, after = time.perf_counter() - start, os.times()
    used = after.children_user + after.children_system - before.children_user - before.children_system
    return Cost(seconds, used, most / 1e6)


def solving(files: list[str]) -> Cost:
    """Solve in a running process."""
    done = subprocess.run([sys.executable, "-c", SOLVE, *files], check=True, capture_output=True, text=True)
    seconds, used = done.stdout.split()
    return Cost(float(seconds), float(used))


def summary(name: str, turns: list[dict[str, Cost]]) -> tuple[str, float, float, float, float, float]:
    """Compute median times, median ratios and peak memory."""
    own = [turn[name] for turn in turns]
    both = [(turn[SOLVING], turn[START]) for turn in turns]
    return (
        name,
        median(cost.seconds for cost in own),
        median(cost.seconds / (a.seconds + b.seconds) for cost, (a, b) in zip(own, both, strict=True)),
        median(cost.processor_seconds for cost in own),
        median(
            cost.processor_seconds / (a.processor_seconds + b.processor_seconds)
            for cost, (a, b) in zip(own, both, strict=True)
        ),
        max(cost.megabytes for cost in own),
    )


def main() -> None:
    """Measure and print."""
    report = Report("check", __doc__)
    count, rounds = (100, 1) if report.quick else (500, 5)
    with tempfile.TemporaryDirectory() as folder:
        files = write_designs(Path(folder), count)
        measured: dict[str, Callable[[], Cost]] = {
            SOLVING: lambda: solving(files),
            START: lambda: run([*COMMAND, "columns"]),
            "chutecalc check": lambda: run([*COMMAND, "check", folder]),
            "in one process": lambda: run([sys.executable, "-c", ALONE, folder]),
        }
        subprocess.run([*COMMAND, "check", "--update", folder], check=True, stdout=subprocess.DEVNULL)
        turns = [{name: measure() for name, measure in measured.items()} for _ in range(rounds)]
    rows = [summary(name, turns) for name in measured]
    header = (f"{count} designs", "time_s", "ratio", "processor_s", "processor_ratio", "memory_mb")
    report.write(header, rows, ("", ".2f", ".2f", ".2f", ".2f", ".0f"))
    report.bars({"check": {row[0]: row[1] for row in rows}}, "time, s")


if __name__ == "__main__":
    main()
