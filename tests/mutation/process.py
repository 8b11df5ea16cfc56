"""Run code in a copy of the project, in processes forked from one that has loaded what the project needs."""

import contextlib
import importlib
import os
import signal
import sys
import traceback
import types
from collections.abc import Callable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
LOADED = (
    *("numpy.polynomial", "scipy.integrate", "scipy.optimize", "mpmath", "matplotlib.figure", "jsonschema", "tomli_w"),
    *("matplotlib.backends.backend_agg", "pydantic", "typer.testing", "rich.table", "concurrent.futures", "pyarrow"),
    *("pytest", "_pytest.pytester", "hypothesis.strategies", "xml.etree.ElementTree"),
)
"""Modules that each process has loaded from the start, where they are installed."""
TO_LOAD = 60.0
"""Seconds for loading the project and finding its tests."""
MEMORY = 6 << 30
PLAIN = ("-q", "-p", "no:cacheprovider")


def load() -> None:
    """Load the modules that are the same for every mutant."""
    for name in LOADED:
        with contextlib.suppress(ImportError):
            importlib.import_module(name)


def forked(tree: Path, work: Callable[[], int], limit: float = TO_LOAD, writes_bytecode: bool = False) -> int:
    """Fork a process that calls a function in a copy of the project; return its number.

    It ends with the status that the function returns. SIGALRM ends it after a time limit, s. Its output goes to a file
    beside the copy.
    """
    if process := os.fork():
        return process
    status = 99
    try:
        import resource

        os.setsid()
        resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
        signal.setitimer(signal.ITIMER_REAL, limit)
        output = os.open(f"{tree}.out", os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        os.dup2(output, 1)
        os.dup2(output, 2)
        sys.path[:] = [str(tree), *(path for path in sys.path if path and Path(path) not in (ROOT, Path.cwd()))]
        os.chdir(tree)
        for name in [name for name in sys.modules if name.partition(".")[0] == "tests"]:
            del sys.modules[name]
        sys.modules["__main__"] = types.ModuleType("__main__")
        sys.dont_write_bytecode = not writes_bytecode
        os.environ |= {"PYTHONPATH": str(tree), "PYTHONDONTWRITEBYTECODE": "1", "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}
        status = work()
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)


def run_pytest(tree: Path, plugin: Any = None, *arguments: str) -> int:
    """Run tests of the copy that this process works in; the examples of Hypothesis are the same each time."""
    import pytest

    with contextlib.suppress(ImportError):
        from hypothesis import HealthCheck, settings

        still: dict[str, Any] = {"database": None, "deadline": None, "suppress_health_check": [*HealthCheck]}
        settings.register_profile("mutation", derandomize=True, **still)
        settings.load_profile("mutation")
    folders = [f"--rootdir={tree}", f"--basetemp={tree}.tmp"]
    return int(pytest.main([*PLAIN, *folders, *arguments], [plugin] if plugin else []))
