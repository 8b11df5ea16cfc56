"""Record which tests reach which line, by running them once."""

import contextlib
import hashlib
import importlib
import json
import os
import pkgutil
import signal
import sys
import threading
import time
import types
from collections.abc import Callable, Generator, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.mutation.process import forked, run_pytest

Lines = dict[str, set[int]]
"""Numbers of lines by the file of the package."""


class Recorder:
    """A pytest plugin that notes which lines of the package each test reaches, and how long it takes."""

    def __init__(self, tree: Path, package: str, terminal: int) -> None:
        """Import the whole package first: lines that this reaches belong to no single test."""
        self.tree, self.package, self.terminal = tree, package, terminal
        self.prefix = f"{tree / package}{os.sep}"
        self.left: dict[types.CodeType, set[int]] = {}
        self.lines: dict[str, Lines] = {}
        self.seconds: dict[str, float] = {}
        self.failed: set[str] = set()
        threading.settrace(self.enter)
        with self.counted_for("import"):
            for module in pkgutil.walk_packages([str(tree / package)], f"{package}."):
                with contextlib.suppress(ImportError):
                    importlib.import_module(module.name.removesuffix(".__main__"))

    def enter(self, frame: types.FrameType, event: str, arg: Any) -> Callable[..., Any] | None:
        code = frame.f_code
        if not code.co_filename.startswith(self.prefix):
            return None
        if code not in self.left:
            self.left[code] = {line for _, _, line in code.co_lines() if line and line != code.co_firstlineno}
        return self.step if self.left[code] else None

    def step(self, frame: types.FrameType, event: str, arg: Any) -> Callable[..., Any]:
        self.left.get(frame.f_code, set()).discard(frame.f_lineno)
        return self.step

    @contextlib.contextmanager
    def counted_for(self, owner: str) -> Iterator[None]:
        """Count the lines reached inside for a test, or for all tests of a file."""
        before, self.left = self.left, {}
        sys.settrace(self.enter)  # anew, for an exception in it, as where a test recurses too deeply, ends it
        try:
            yield
        finally:
            reached = self.lines.setdefault(owner, {})
            for code, left in self.left.items():
                lines = {line for _, _, line in code.co_lines() if line} - left
                reached.setdefault(Path(code.co_filename).relative_to(self.tree).as_posix(), set()).update(lines)
            self.left = before

    @pytest.hookimpl(wrapper=True)
    def pytest_make_collect_report(self, collector: Any) -> Generator[None, Any, Any]:
        with self.counted_for(collector.nodeid.partition("::")[0]):
            return (yield)

    @pytest.hookimpl(wrapper=True)
    def pytest_fixture_setup(self, fixturedef: Any, request: Any) -> Generator[None, Any, Any]:
        if fixturedef.scope == "function":
            return (yield)
        with self.counted_for(request.node.nodeid.partition("::")[0]):
            return (yield)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: Any) -> Generator[None, Any, Any]:
        for name, module in [*sys.modules.items()]:  # else lines whose result is cached would not be reached
            if name.partition(".")[0] == self.package:
                for value in [*vars(module).values()]:
                    getattr(value, "cache_clear", int)()
        start = time.perf_counter()
        with self.counted_for(item.nodeid):
            result = yield
        self.seconds[item.nodeid] = round(time.perf_counter() - start, 4)
        return result

    def pytest_runtest_logreport(self, report: Any) -> None:
        if report.outcome != "passed":
            self.failed.add(report.nodeid)
            os.write(self.terminal, f"{report.outcome}, and left out: {report.nodeid}\n".encode())


class Reach:
    """The lines that each test reaches."""

    def known(self, file: str, lines: range) -> bool:
        """Return whether any test is known to reach one of the lines."""
        return not lines or any((file, line) in self.by_line for line in lines)

    def __init__(self, record: dict[str, Any]) -> None:
        tests = {test: entry for file in record["files"].values() for test, entry in file.items()}
        self.seconds: dict[str, float] = {test: seconds for test, (seconds, _) in tests.items()}
        self.imported = {file: {*lines} for file, lines in record["import"].items()}
        self.by_line: dict[tuple[str, int], set[str]] = {}
        self.by_file: dict[str, set[str]] = {}
        for test, (_, reached) in tests.items():
            for file, lines in reached.items():
                self.by_file.setdefault(file, set()).add(test)
                for line in lines:
                    self.by_line.setdefault((file, line), set()).add(test)

    def tests(self, file: str, lines: range) -> dict[str, float]:
        """Return the tests that reach any of the lines, with their times, s, fastest first.

        A line that runs when the package is imported, such as a constant, counts as reached by all tests that reach its
        file, or by all tests where a file has no other lines. So does a line that no test reaches in its own process.
        """
        found = set[str]().union(*(self.by_line.get((file, line), set()) for line in lines))
        if not found or self.imported.get(file, set()) & {*lines}:
            found = self.by_file.get(file) or set[str]().union(*self.by_file.values())
        return {test: self.seconds[test] for test in sorted(found, key=lambda test: (self.seconds[test], test))}


def recorded(stored: Path, tree: Path, package: str) -> Reach:
    """Return what the tests of a copy of the project reach, from the stored record where tests have not changed."""
    hashes: dict[str, str] = {}
    rest = hashlib.sha256(sys.version.encode())
    for path in sorted([*tree.rglob("*.py"), *tree.rglob("*.toml")]):
        if path.name.startswith("test_"):
            hashes[path.relative_to(tree).as_posix()] = hashlib.sha256(path.read_bytes()).hexdigest()
        elif path.parent.name != "mutation":
            rest.update(path.read_bytes())
    record = json.loads(stored.read_text(encoding="utf-8")) if stored.exists() else {}
    whole = record.get("rest") != rest.hexdigest()
    if whole:
        record = {"rest": rest.hexdigest(), "hashes": {}, "files": {}}
    changed = [file for file, now in hashes.items() if record["hashes"].get(file) != now]

    terminal = os.dup(1)

    def work() -> int:
        if not changed:
            return run_pytest(tree, None, "--collect-only")  # so that its bytecode is there
        recorder = Recorder(tree, package, terminal)
        run_pytest(tree, recorder, *([] if whole else changed))
        sys.settrace(None)
        files: dict[str, Any] = {file: known for file, known in record["files"].items() if file not in changed}
        for test in recorder.seconds.keys() - recorder.failed:
            reached = recorder.lines[test]
            for file, lines in recorder.lines.get(test.partition("::")[0], {}).items():
                reached.setdefault(file, set()).update(lines - recorder.lines["import"].get(file, set()))
            files.setdefault(test.partition("::")[0], {})[test] = [recorder.seconds[test], _listed(reached)]
        stored.parent.mkdir(exist_ok=True)
        whole_record = record | {"hashes": hashes, "files": files, "import": _listed(recorder.lines["import"])}
        stored.write_text(json.dumps(whole_record), encoding="utf-8")
        return 0

    if changed:
        print(f"recording which lines are reached by the tests of {len(changed)} files", flush=True)
    _, status = os.waitpid(forked(tree, work, limit=7200.0, writes_bytecode=True), 0)
    os.close(terminal)
    if status:
        output = Path(f"{tree}.out").read_text(encoding="utf-8")
        sys.exit(f"recording ended with status {status}:\n{output[-3000:]}")
    return Reach(json.loads(stored.read_text(encoding="utf-8")))


def _listed(lines: Lines) -> dict[str, list[int]]:
    return {file: sorted(numbers) for file, numbers in sorted(lines.items()) if numbers}


def limit_time(seconds: float, least: float = 20.0, times: float = 10.0) -> None:
    """Let SIGALRM end this process if a test takes far longer than when it was recorded."""
    signal.setitimer(signal.ITIMER_REAL, least + times * seconds)
