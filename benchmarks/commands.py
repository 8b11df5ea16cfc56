"""Every command as a process from start to end, as a multiple of one `chutecalc run` on the same spec.

    python benchmarks/commands.py [--quick] [--out FOLDER]

Three scenes: a transfer from belt to belt with four cases, the spoon of the paper, and a grain spout, a pipe. Right
before each command stands a `run`, and the two make one ratio; the median of the rounds is told, of the time of the
processor, summed over threads, and of the clock. The first is meaningful on a busy machine too. `run`, `optimise` and
its neighbours solve all cases of a spec, the others its design point.
"""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median
from typing import NamedTuple

from measure import Report

SPECS = Path(__file__).parents[1] / "specs"
UNCERTAIN = """
[uncertainty]
"{liner}.friction_deg" = 2
"flow.rate_t_h" = 20
"material.density_kg_m3" = 40
"""


class Scene(NamedTuple):
    """A spec, and what is asked of it."""

    spec: str
    liner: str
    """Path of a liner, where the spec has no uncertain numbers yet; else empty."""
    place: str
    """Arguments of ``place``; empty for a scene whose segments hang together."""
    keys: tuple[str, str]
    targets: tuple[str, str]
    minimise: str
    sweep: str
    """A key with its bounds, of which a sweep takes a thousand values."""


SCENES = {
    "transfer": Scene(
        "transfer_90.toml",
        "",
        "hood incidence=8 x=0.9 share=0.2",
        ("segments.spoon.radius_m=2:6", "segments.spoon.to_slope_deg=10:60"),
        ("receiver_velocity_along_m_s=5.4", "receiver_velocity_into_m_s=2"),
        "receiver_velocity_into_m_s",
        "segments.spoon.radius_m=2:6",
    ),
    "spoon": Scene(
        "paper/r3_d55_chamfered.toml",
        "liners.wall",
        "",
        ("radius=1:4", "beta=20:80"),
        ("exit_velocity_m_s=3.7", "exit_depth_m=0.15"),
        "max_depth_m",
        "radius=1:4",
    ),
    "pipe": Scene(
        "grain_spout.toml",
        "liners.galvanized",
        "",
        ("segments.elbow.radius_m=0.6:3", "segments.elbow.to_slope_deg=15:45"),
        ("exit_velocity_m_s=6.9", "exit_z_m=-4.5"),
        "exit_velocity_m_s",
        "segments.elbow.radius_m=0.6:3",
    ),
}


def commands(scene: Scene, spec: str, quick: bool) -> dict[str, list[str]]:
    """Return the commands by name, without ``run`` itself."""
    samples, rows = (1024, 100) if quick else (16_384, 1000)
    (one, other), (target, second) = scene.keys, scene.targets
    found = {
        "run --band": ["run", spec, "--band"],
        "run --sensitivity": ["run", spec, "--sensitivity"],
        "place": ["place", spec, *scene.place.split()],
        "aim, one key": ["aim", spec, one, "--target", target],
        "aim, two keys": ["aim", spec, one, other, "--target", target, "--target", second],
        "optimise, two keys": ["optimise", spec, one, other, "--minimise", scene.minimise],
        f"uncertain, {samples:,} samples": ["uncertain", spec, "--samples", str(samples)],
        f"sweep, {rows:,} designs": ["sweep", spec, f"{scene.sweep}:#{rows}", "--csv", os.devnull],
    }
    return {name: given for name, given in found.items() if name != "place" or scene.place}


def measured(arguments: list[str]) -> tuple[float, float]:
    """Return the time of a command on the processor and on the clock, s."""
    start = time.perf_counter()
    with subprocess.Popen(
        [sys.executable, "-m", "chutecalc", *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    ) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise SystemExit(f"chutecalc {' '.join(arguments)} ended with {process.returncode}")
    return usage.ru_utime + usage.ru_stime, time.perf_counter() - start


def main() -> None:
    """Measure and print."""
    report = Report("commands", __doc__)
    rounds = 1 if report.quick else 5
    rows: list[tuple[str, str, float, float, float, float]] = []
    with tempfile.TemporaryDirectory() as folder:
        for name, scene in list(SCENES.items())[1:2] if report.quick else SCENES.items():
            spec = Path(folder) / f"{name}.toml"
            text = (SPECS / scene.spec).read_text(encoding="utf-8")
            spec.write_text(text + (UNCERTAIN.format(liner=scene.liner) if scene.liner else ""), encoding="utf-8")
            tasks = commands(scene, str(spec), report.quick)
            run = ["run", str(spec)]
            measured(run)  # whose files are read from the disk the first time
            pairs = [{task: (measured(run), measured(given)) for task, given in tasks.items()} for _ in range(rounds)]
            alone = [before for turn in pairs for before, _ in turn.values()]
            rows.append((name, "run", *map(median, zip(*alone, strict=True)), 1.0, 1.0))
            for task in tasks:
                own = [turn[task] for turn in pairs]
                times = map(median, zip(*(after for _, after in own), strict=True))
                over = (median(after[k] / before[k] for before, after in own) for k in (0, 1))
                rows.append((name, task, *times, *over))
    header = ("scene", "command", "cpu_s", "clock_s", "cpu_over_run", "clock_over_run")
    report.write(header, rows, ("", "", ".2f", ".2f", ".1f", ".1f"))


if __name__ == "__main__":
    main()
