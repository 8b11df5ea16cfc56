"""`chutecalc check` on a folder of 500 designs, beside the sum of their solving plus one start-up.

    python benchmarks/check.py [--quick] [--csv FILE]

The designs are the standard ones at other rates. Solving is what `chutecalc run` does to each but print it: read and
check the spec, solve it, work out ends, extremes and findings; the sum is taken in one process that has started. A
start-up is that of a command that solves nothing. All are measured in turn, round by round, and ratios taken within a
round. Memory is that of all processes at once at its highest, as far as looking every 20 ms can tell.
"""

import argparse
import csv
import os
import statistics
import subprocess
import sys
import tempfile
import time
import tomllib
from collections.abc import Callable
from pathlib import Path

import tomli_w
from rich.console import Console
from rich.table import Table

ROOT = Path(__file__).parents[1]
COMMAND = [sys.executable, "-m", "chutecalc"]
SOLVE = """
import sys, time
from chutecalc.chute import load, solve
spent = 0.0
for file in sys.argv[1:]:
    start = time.perf_counter()
    solution = solve(load(file))
    solution.ways, solution.findings(), solution.receiver
    spent += time.perf_counter() - start
print(spent)
"""
ALONE = """
import sys
from chutecalc.studies.designs import find_designs
from chutecalc.studies.regression import OK, check
assert all(item.outcome == OK for item in check(find_designs(sys.argv[1:]).chutes, processes=1))
"""


def write_designs(folder: Path, count: int) -> list[str]:
    """The standard designs again and again, each time with another rate; their files."""
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
    """Bytes that a process and those below it hold; 0 where the system does not tell."""
    try:
        own = int(Path(f"/proc/{process}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")
        children = Path(f"/proc/{process}/task/{process}/children").read_text().split()
    except OSError:
        return 0
    return own + sum(resident(int(child)) for child in children)


def run(arguments: list[str]) -> tuple[float, float]:
    """Wall time of a process in s, and the most that it held in MB."""
    start, most = time.perf_counter(), 0
    with subprocess.Popen(arguments, stdout=subprocess.DEVNULL) as process:
        while process.poll() is None:
            most = max(most, resident(process.pid))
            time.sleep(0.02)
    assert process.returncode == 0, arguments[:4]
    return time.perf_counter() - start, most / 1e6


def solving(files: list[str]) -> tuple[float, float]:
    """Time that solving takes in a process that has started."""
    done = subprocess.run([sys.executable, "-c", SOLVE, *files], check=True, capture_output=True, text=True)
    return float(done.stdout), 0.0


def main() -> None:
    """Measures and prints."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="100 designs, one round: to see that it runs")
    parser.add_argument("--csv")
    options = parser.parse_args()
    count, rounds = (100, 1) if options.quick else (500, 5)
    with tempfile.TemporaryDirectory() as folder:
        files = write_designs(Path(folder), count)
        measured: dict[str, Callable[[], tuple[float, float]]] = {
            "solving, the sum": lambda: solving(files),
            "one start-up": lambda: run([*COMMAND, "columns"]),
            "chutecalc check": lambda: run([*COMMAND, "check", folder]),
            "in one process": lambda: run([sys.executable, "-c", ALONE, folder]),
        }
        subprocess.run([*COMMAND, "check", "--update", folder], check=True, stdout=subprocess.DEVNULL)
        turns = [{name: measure() for name, measure in measured.items()} for _ in range(rounds)]
    rows = []
    for name in measured:
        yardsticks = [turn["solving, the sum"][0] + turn["one start-up"][0] for turn in turns]
        ratio = statistics.median(turn[name][0] / yardstick for turn, yardstick in zip(turns, yardsticks, strict=True))
        rows.append((name, statistics.median(t[name][0] for t in turns), ratio, max(t[name][1] for t in turns)))
    table = Table("", "s", "ratio", "MB", title=f"{count} designs, {rounds} rounds", title_justify="left", box=None)
    for name, spent, ratio, memory in rows:
        table.add_row(name, f"{spent:.2f}", f"{ratio:.2f}", f"{memory:.0f}" if memory else "")
    Console().print(table)
    if options.csv:
        with open(options.csv, "w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(["what", "time_s", "ratio", "memory_mb"])
            writer.writerows(rows)


if __name__ == "__main__":
    main()
