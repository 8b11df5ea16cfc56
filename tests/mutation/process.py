"""Processes that work with a copy of the project, forked from one that has loaded what the project needs."""

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
"""What each process has from the start, where it is installed."""
TO_LOAD = 60.0
"""Seconds for loading the project and finding its tests."""
MEMORY = 6 << 30
PLAIN = ("-q", "-p", "no:cacheprovider")


def load() -> None:
    """Loads what is the same for every mutant."""
    for name in LOADED:
        with contextlib.suppress(ImportError):
            importlib.import_module(name)


def forked(tree: Path, work: Callable[[], int], patience: float = TO_LOAD, writes_bytecode: bool = False) -> int:
    """The number of a process that does some work in a copy of the project, and ends with the status that it gives.

    SIGALRM ends it when its patience does. What it prints goes to a file beside the copy.
    """
    if process := os.fork():
        return process
    status = 99
    try:
        import resource

        os.setsid()
        resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
        signal.setitimer(signal.ITIMER_REAL, patience)
        said = os.open(f"{tree}.out", os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        os.dup2(said, 1)
        os.dup2(said, 2)
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
    """Runs tests of the copy that this process is for; the examples of Hypothesis are the same each time."""
    import pytest

    with contextlib.suppress(ImportError):
        from hypothesis import HealthCheck, settings

        still: dict[str, Any] = {"database": None, "deadline": None, "suppress_health_check": [*HealthCheck]}
        settings.register_profile("mutation", derandomize=True, **still)
        settings.load_profile("mutation")
    places = [f"--rootdir={tree}", f"--basetemp={tree}.tmp"]
    return int(pytest.main([*PLAIN, *places, *arguments], [plugin] if plugin else []))
