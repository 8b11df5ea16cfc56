"""Kills, two processes at once, and Ctrl-C, at random moments: whatever happens, a file is whole or there is none.

``python -m tests.robustness.kills 100 --seed 7`` tries each of them a hundred times, and tells what came of it.
"""

import argparse
import re
import shutil
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from functools import cache, partial
from pathlib import Path

import numpy as np

from tests.conftest import ROOT, STANDARD_DESIGNS
from tests.robustness.killed_writers import killed_writer
from tests.robustness.processes import MARKED, SPOON, Ended, Outcome, end, run, start

SWEEP = ["sweep", "radius=2:4:#60", "phi=15:24:#80", str(SPOON), "--jobs", "1"]
SWEEP += ["--columns", "exit_velocity_m_s,segments.spoon.status"]  # with these a block has 1024 rows, not 16,384
FORMATS = ("csv", "parquet", "json")
DESIGNS = STANDARD_DESIGNS[:4]


@cache
def whole(form: str) -> tuple[bytes, float]:
    """Return the file that nobody disturbs, and how long it takes, s."""
    with tempfile.TemporaryDirectory() as folder:
        began = time.monotonic()
        assert run(*SWEEP, f"--{form}", "rows", folder=Path(folder)).status == 0
        return Path(folder, "rows").read_bytes(), time.monotonic() - began


@cache
def baselines() -> tuple[dict[str, bytes], float]:
    """Return the baselines that nobody disturbs, and how long they take, s."""
    with tempfile.TemporaryDirectory() as folder:
        copy_designs(Path(folder))
        began = time.monotonic()
        assert run("check", "--update", folder=Path(folder)).status == 0
        taken = time.monotonic() - began
        return {path.name: path.read_bytes() for path in Path(folder).glob("*.baseline.toml")}, taken


def copy_designs(folder: Path) -> None:
    """Put some designs without baselines into a folder."""
    for path in DESIGNS:
        shutil.copy(path, folder / f"{path.parent.name}_{path.name}")


def faults_of(folder: Path, form: str, *ends: Ended) -> Iterator[str]:
    """Yield what is wrong with the folder of a sweep once all is over, and with how its processes ended."""
    for ended in ends:
        if ended.status not in (0, 2, 130, -signal.SIGKILL) or "Traceback" in ended.err:
            yield f"status {ended.status}: {ended.err.strip()[-300:]}"
    content = (folder / "rows").read_bytes() if (folder / "rows").exists() else None
    if content != whole(form)[0]:
        yield "no file" if content is None else f"a file of {len(content)} bytes instead of {len(whole(form)[0])}"
    left = sorted(path.name for path in folder.iterdir() if path.name != "rows")
    if left:
        yield f"left: {', '.join(left)}"


def killed_sweep(form: str, draw: np.random.Generator, folder: Path) -> Outcome:
    """Kill a sweep once or twice, and resume it."""
    times = 0
    for _ in range(draw.integers(1, 3)):
        process = start(*SWEEP, f"--{form}", "rows", *resuming(folder), folder=folder)
        time.sleep(draw.uniform(0.0, 1.2 * whole(form)[1]))
        process.kill()
        times += end(process).status != 0
        if (folder / "rows").exists() and (folder / "rows").read_bytes() != whole(form)[0]:
            return Outcome("killed", ("a file that is not whole",))
    last = run(*SWEEP, f"--{form}", "rows", *resuming(folder), folder=folder)
    return Outcome(f"killed {times} times, then resumed", tuple(faults_of(folder, form, last)))


def resuming(folder: Path) -> list[str]:
    """Return --resume where there is something to resume."""
    return ["--resume"] if (folder / "rows.part/sweep.json").exists() else []


def two_sweeps(form: str, draw: np.random.Generator, folder: Path) -> Outcome:
    """Start a sweep twice, the second a little later, half of them where a killed one has left its blocks."""
    if draw.random() < 0.5:
        process = start(*SWEEP, f"--{form}", "rows", folder=folder)
        time.sleep(draw.uniform(0.3, 0.9) * whole(form)[1])
        process.kill()
        end(process)
    command = [*SWEEP, f"--{form}", "rows", *resuming(folder)]
    first = start(*command, folder=folder)
    time.sleep(draw.uniform(0.0, 0.6))
    more = ["--resume"] if "--resume" not in command and draw.random() < 0.5 else []
    second = start(*command, *more, folder=folder)
    ends = end(first), end(second)
    faults = list(faults_of(folder, form, *ends))
    refused = sum(ended.status == 2 for ended in ends)
    if refused == 2:
        faults.append(f"both refused: {ends}")
    faults += [
        each.err for each in ends if each.status == 2 and not re.search("another process|leave out --resume", each.err)
    ]
    return Outcome("one refused" if refused else "one after the other", tuple(faults))


def killed_check(draw: np.random.Generator, folder: Path) -> Outcome:
    """Kill check --update, and run it again, twice at once."""
    expected, taken = baselines()
    copy_designs(folder)
    process = start("check", "--update", folder=folder)
    time.sleep(draw.uniform(0.3, 1.2) * taken)
    process.kill()
    end(process)
    found = {path.name: path.read_bytes() for path in folder.glob("*.baseline.toml")}
    faults = [f"{name} is not whole" for name, content in found.items() if content != expected[name]]
    first = start("check", "--update", folder=folder)
    time.sleep(draw.uniform(0.0, 0.6))
    second = start("check", "--update", folder=folder)
    ends = end(first), end(second)
    if not any(ended.status == 0 for ended in ends):
        faults.append(f"none passed: {ends}")
    faults += [each.err for each in ends if each.status not in (0, 2) or (each.status and "another" not in each.err)]
    faults += [f"{name} is another" for name, content in expected.items() if (folder / name).read_bytes() != content]
    faults += [f"left: {path.name}" for path in folder.glob(".*")]
    refused = any(ended.status == 2 for ended in ends)
    return Outcome("one refused" if refused else "one after the other", tuple(faults))


def interrupted(draw: np.random.Generator, folder: Path) -> Outcome:
    """Press Ctrl-C at a random moment after Python itself has started."""
    command = SWEEP if draw.random() < 0.5 else ["run", str(SPOON), "--plot", "rows.svg"]
    command = [*command, "--csv", "rows"] if command is SWEEP else command
    process = start(*command, folder=folder, code=MARKED.format(str(ROOT)))
    assert process.stdout is not None
    process.stdout.read(1)
    time.sleep(draw.uniform(0.0, 1.5))
    process.send_signal(signal.SIGINT)
    ended = end(process)
    faults = [] if ended.status in (0, 130) else [f"status {ended.status}: {ended.err.strip()[-300:]}"]
    if "Traceback" in ended.err or (ended.status == 130 and "interrupted" not in ended.err):
        faults.append(ended.err[-300:])
    left = sorted(path.name for path in folder.glob(".*"))
    return Outcome(f"status {ended.status}", tuple(faults + [f"left: {name}" for name in left]))


ATTACKS: dict[str, Callable[[np.random.Generator, Path], Outcome]] = {
    **{f"kill a sweep to {form}": lambda draw, folder, form=form: killed_sweep(form, draw, folder) for form in FORMATS},
    **{f"two sweeps to {form}": lambda draw, folder, form=form: two_sweeps(form, draw, folder) for form in FORMATS},
    "kill check --update, then two": killed_check,
    "kill what writes a file, then two": killed_writer,
    "Ctrl-C": interrupted,
}


def attack(name: str, seed: tuple[int, ...]) -> Outcome:
    """Make one attempt in a folder of its own."""
    with tempfile.TemporaryDirectory() as folder:
        return ATTACKS[name](np.random.default_rng(seed), Path(folder))


def main() -> int:
    """Make many attempts of each kind, and print what came of them; the status is 1 if there is a fault."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("count", type=int, help="attempts of each kind")
    tell = partial(print, flush=True)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", default="", help="part of the names of what to try")
    given = parser.parse_args()
    found = 0
    for name in (name for name in ATTACKS if given.only in name):
        hows: Counter[str] = Counter()
        for number in range(given.count):
            outcome = attack(name, (given.seed, number))
            hows[outcome.how] += 1
            found += bool(outcome.faults)
            for fault in outcome.faults:
                tell(f"FAULT  {name}, --seed {given.seed}, attempt {number}: {fault}")
        tell(f"{name}: {given.count} tried ({', '.join(f'{count} {how}' for how, count in sorted(hows.items()))})")
    tell(f"{found} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
