"""A million samples of an uncertain chute, and its sensitivities, as times and as multiples of a run.

    python benchmarks/uncertain.py [--quick] [--out FOLDER]

Whole commands, each a process of its own: the exit of a spoon and of a transfer from belt to belt, five uncertain keys
each; then fewer samples of columns for which the whole trajectory is needed; then run with --sensitivity. 'cpu' is time
of the processor, summed over threads, and 'runs' that over the same of `chutecalc run` on the spec, also a process.
Memory is the peak of the process.
"""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from measure import Report

SPECS = Path(__file__).parents[1] / "specs"
SPOON = (
    (SPECS / "paper" / "r3_d55_chamfered.toml").read_text(encoding="utf-8")
    + """
[uncertainty]
"liners.wall.friction_deg" = 2
"material.internal_friction_deg" = { uniform = [50, 60] }
"flow.rate_t_h" = 100
"material.density_kg_m3" = 40
"segments.spoon.radius_m" = 0.02
"""
)
CHUTES = {"spoon": SPOON, "transfer": (SPECS / "transfer_90.toml").read_text(encoding="utf-8")}
WHOLE = ("--columns", "exit_velocity_m_s,min_velocity_m_s,max_depth_m")


def measured(*arguments: str) -> tuple[float, float, float]:
    """Return the time of a command on the processor and on the clock, s, and its peak memory, MB."""
    start = time.perf_counter()
    with subprocess.Popen([sys.executable, "-m", "chutecalc", *arguments], stdout=subprocess.DEVNULL) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise SystemExit(f"{arguments} failed")
    return usage.ru_utime + usage.ru_stime, time.perf_counter() - start, usage.ru_maxrss / 1024.0


def main() -> None:
    """Measure and print."""
    report = Report("uncertain", __doc__)
    many, some = ("16384", "1024") if report.quick else ("1000000", "16384")
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name, text in CHUTES.items():
            spec = Path(folder) / f"{name}.toml"
            spec.write_text(text, encoding="utf-8")
            run, *_ = min(measured("run", str(spec)) for _ in range(5))
            for what, options in (
                (f"{int(many):,} samples of the exit", ("uncertain", str(spec), "--samples", many)),
                (f"{int(some):,} of the trajectory", ("uncertain", str(spec), "--samples", some, *WHOLE)),
                ("sensitivity", ("run", str(spec), "--sensitivity")),
            ):
                cpu, clock, memory = measured(*options)
                rows.append((name, what, cpu, clock, cpu / run, memory))
    header = ("chute", "what", "cpu_s", "clock_s", "runs", "memory_mb")
    report.write(header, rows, ("", "", ".2f", ".2f", ".1f", ".0f"))


if __name__ == "__main__":
    main()
