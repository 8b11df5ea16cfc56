"""The command: draw mutants, run their tests, report those that survive. See the docstring of the package."""

import argparse
import contextlib
import json
import os
import random
import shutil
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from tests.mutation.mutants import Mutant, mutants
from tests.mutation.process import ROOT, forked, load, run_pytest
from tests.mutation.reach import Reach, limit_time, recorded

ROOMS = ("physics", "core", "sections", "segments", "solver", "results", "api", "studies")
KILLED, SURVIVED, NOT_REACHED, TIMEOUT, ACCEPTED = "killed", "survived", "not reached", "timeout", "accepted"
OUTCOMES = (KILLED, TIMEOUT, SURVIVED, NOT_REACHED, ACCEPTED)
LEFT_OUT = shutil.ignore_patterns(".*", "build", "dist", "out", "*.egg-info", "*.so", "*.pyd")  # mutants run uncompiled
FIRST = 1.0
"""Seconds of tests that are run first, from few files: collecting tests takes longer than most of them."""


class Chosen:
    """A pytest plugin that runs selected tests in order, each with a time limit, and notes the current one."""

    def __init__(self, tests: dict[str, float], note: Path) -> None:
        self.tests, self.note = tests, note

    def pytest_collection_modifyitems(self, items: list[Any]) -> None:
        order = {test: number for number, test in enumerate(self.tests)}
        items[:] = sorted((item for item in items if item.nodeid in order), key=lambda item: order[item.nodeid])

    def pytest_runtest_setup(self, item: Any) -> None:
        limit_time(self.tests[item.nodeid])
        self.note.write_text(item.nodeid, encoding="utf-8")


def drawn(sources: dict[str, bytes], count: int, seed: int) -> list[Mutant]:
    """Draw a number of mutants, each at another position."""
    positions: dict[Any, list[Mutant]] = {}
    for file, source in sources.items():
        for mutant in mutants(file, source):
            positions.setdefault((file, mutant.span[0], mutant.kind), []).append(mutant)
    chance = random.Random(seed)
    several = chance.sample([*positions.values()], min(count, len(positions)))
    return [chance.choice(found) for found in several]


def in_parts(tests: dict[str, float]) -> list[dict[str, float]]:
    """Split tests in two parts: the fastest of the files that have most of them, and the rest."""
    files = Counter(test.partition("::")[0] for test in [*tests][:40]).most_common(3)
    first: dict[str, float] = {}
    for test, seconds in tests.items():
        if any(test.startswith(f"{file}::") for file, _ in files) and sum(first.values()) < FIRST:
            first[test] = seconds
    return [part for part in (first, {test: tests[test] for test in tests if test not in first}) if part]


def started(tree: Path, mutant: Mutant, source: bytes, tests: dict[str, float]) -> int:
    """Start the tests of a mutant and return the number of their process."""

    def work() -> int:
        for part in in_parts(tests):
            files = [*dict.fromkeys(test.partition("::")[0] for test in part)]
            if status := run_pytest(tree, Chosen(part, Path(f"{tree}.note")), "-x", *files):
                return status
        return 0

    target, stat = tree / mutant.file, (tree / mutant.file).stat()
    target.write_bytes(mutant.source(source))
    os.utime(target, (stat.st_atime, stat.st_mtime + 10))  # so that the bytecode of the unchanged file is not used
    Path(f"{tree}.note").write_text("when loaded", encoding="utf-8")
    return forked(tree, work)


def outcomes(
    trees: list[Path], sources: dict[str, bytes], chosen: list[Mutant], reach: Reach
) -> Iterator[tuple[Mutant, str, str, float]]:
    """Yield each mutant when it is done: its outcome, the test that failed, and the time, s."""
    waiting, free = chosen[::-1], [*trees]
    running: dict[int, tuple[Path, Mutant, float, float]] = {}
    while waiting or running:
        while waiting and free:
            mutant, tree = waiting.pop(), free.pop()
            modified = (tree / mutant.file).stat().st_mtime
            tests = reach.tests(mutant.file, mutant.lines)
            process = started(tree, mutant, sources[mutant.file], tests)
            running[process] = tree, mutant, time.perf_counter(), modified
        process, status = os.wait()
        tree, mutant, start, modified = running.pop(process)
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process, signal.SIGKILL)  # the processes that it has started
        (tree / mutant.file).write_bytes(sources[mutant.file])
        os.utime(tree / mutant.file, (modified, modified))
        free.append(tree)
        late = os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGALRM
        alive = SURVIVED if reach.known(mutant.file, mutant.lines) else NOT_REACHED
        outcome = TIMEOUT if late else KILLED if status else alive
        note = "" if outcome == alive else Path(f"{tree}.note").read_text(encoding="utf-8")
        yield mutant, outcome, note, time.perf_counter() - start


def accepted(file: Path) -> dict[tuple[str, ...], str]:
    """Read why some mutants may survive, by file and function, line before and line after; * for any line after."""
    text = file.read_text(encoding="utf-8") if file.exists() else ""
    blocks = [block.splitlines() for block in text.split("\n\n") if not block.startswith("#")]
    return {(head, before[2:], after[2:]): why for head, before, after, why in (block for block in blocks if block)}


def main() -> int:
    """Run the command and return its status."""
    parser = argparse.ArgumentParser(prog="python -m tests.mutation", description=__doc__)
    parser.add_argument("--count", type=int, default=350, help="how many mutants")
    parser.add_argument("--seed", type=int, default=0, help="of the draw")
    parser.add_argument("--rooms", nargs="+", default=ROOMS, help="folders and modules of the package")
    parser.add_argument("--only", nargs="+", metavar="ID", help="these mutants instead of a draw")
    parser.add_argument("--jobs", type=int, default=1, help="processes")
    parser.add_argument("--json", type=Path, help="a file for all outcomes")
    parser.add_argument("--root", type=Path, default=ROOT, help="the project, with its tests in `tests`")
    parser.add_argument("--package", default="chutecalc", help="its package")
    given = parser.parse_args()
    root = given.root.resolve()
    rooms = {given.package if given.only else f"{given.package}/{room}" for room in given.rooms}
    if missing := sorted(room for room in rooms if not ((root / room).is_dir() or (root / f"{room}.py").is_file())):
        parser.error(f"there is no room {', '.join(missing)}")
    files = sorted(file for room in rooms for file in [*(root / room).rglob("*.py"), root / f"{room}.py"])
    sources = {file.relative_to(root).as_posix(): file.read_bytes() for file in files if file.exists()}
    if given.only:
        chosen = [mutant for file, source in sources.items() for mutant in mutants(file, source)]
        chosen = [mutant for mutant in chosen if mutant.id in given.only]
    else:
        chosen = drawn(sources, given.count, given.seed)
    whys = accepted(root / "tests" / "mutation_accepted.txt")
    results: list[dict[str, Any]] = []
    load()
    with tempfile.TemporaryDirectory() as folder:
        trees = [Path(folder).resolve() / f"tree{number}" for number in range(given.jobs)]
        shutil.copytree(root, trees[0], ignore=LEFT_OUT)
        reach = recorded(root / ".mutation" / "record.json", trees[0], given.package)
        for tree in trees[1:]:
            shutil.copytree(trees[0], tree)
        start = time.perf_counter()
        for mutant, outcome, killer, seconds in outcomes(trees, sources, chosen, reach):
            before, after = mutant.difference(sources[mutant.file])
            key = (f"{mutant.file} {mutant.function}".strip(), before, after)
            why = whys.get(key) or whys.get((*key[:2], "*"), "") if outcome in (SURVIVED, NOT_REACHED) else ""
            if why:
                outcome = ACCEPTED
            room = Path(mutant.file).relative_to(given.package).parts[0].removesuffix(".py")
            result = {"id": mutant.id, "room": room, "outcome": outcome, "test": killer, "why": why}
            results.append(result | {"seconds": round(seconds, 2), "where": key[0], "before": before, "after": after})
            if outcome in (SURVIVED, NOT_REACHED):
                print(f"{outcome}: {mutant.id}\n{key[0]}\n- {before}\n+ {after}\n", flush=True)
        spent = time.perf_counter() - start
    if given.json:
        given.json.write_text(json.dumps(results, indent=1, ensure_ascii=False), encoding="utf-8")
    counts = Counter((result["room"], result["outcome"]) for result in results)
    rows = sorted({room for room, _ in counts})
    print(f"{'room':12}" + "".join(f"{outcome:>13}" for outcome in OUTCOMES))
    for room in [*rows, *(["all"] if len(rows) > 1 else [])]:
        numbers = [
            sum(n for (at, what), n in counts.items() if what == word and room in (at, "all")) for word in OUTCOMES
        ]
        print(f"{room:12}" + "".join(f"{number:13}" for number in numbers))
    print(f"{len(results)} mutants in {spent:.0f} s, {60 * len(results) / max(spent, 1e-9):.0f} a minute")
    return int(any(result["outcome"] in (SURVIVED, NOT_REACHED) for result in results))


if __name__ == "__main__":
    sys.exit(main())
