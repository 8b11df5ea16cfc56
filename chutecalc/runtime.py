"""What chutecalc asks of the process it runs in, and what it changes there: processors, processes, start-up settings.

Nothing else in the package touches the state of the host program but, in a command, ``interrupt`` and ``cli.streams``.
Importing this module changes nothing.
"""

import gc
import os
import signal
import sys
import threading
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import chdir, contextmanager
from importlib import import_module
from typing import TypeVar

Item = TypeVar("Item")
Result = TypeVar("Result")
COLLECTOR_THRESHOLD = 1_000_000
"""Objects allocated between two runs of Python's garbage collector in a command."""
SETTINGS = {
    "MPLBACKEND": "agg",  # a command shows no window, and Jupyter names a backend that only its own kernels have
    "MATPLOTLIBRC": os.devnull,
    "SOURCE_DATE_EPOCH": "946684800",  # 2000-01-01: what is written holds no date of today
}
"""What libraries read from the environment of a command, in place of what its user has set for other programs."""


def cores() -> int:
    """Return the number of processors that this process may use, which an affinity mask can limit.

    >>> cores() >= 1
    True
    """
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def prepare_command() -> None:
    """Speed up the start of a command. Call it before pydantic is imported, and only in a process that is ours.

    Modules and classes loaded at the start live until the end. Searching them for garbage takes a few per cent of a
    short run, and solving creates no reference cycles that need collecting. Looking for pydantic plugins reads
    the metadata of every installed package. Warnings of libraries are for programmers: python -W shows them.
    What a command writes is the same everywhere, whatever the settings of the libraries that it uses.
    """
    os.environ.update(SETTINGS)
    gc.set_threshold(COLLECTOR_THRESHOLD)
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
    if not sys.warnoptions:
        warnings.simplefilter("ignore")


def import_matplotlib() -> None:
    """Import Matplotlib elsewhere if the working folder has settings for it, which would go before all others."""
    if os.path.exists("matplotlibrc"):
        with chdir(os.sep):
            import_module("matplotlib")


def finish_command() -> None:
    """Speed up the end of a command: what has lived until now is not searched for garbage once more."""
    gc.freeze()


def in_processes(work: Callable[[Item], Result], items: Sequence[Item], processes: int) -> Iterator[Result]:
    """Return the results of a function for each item, in the order of the items.

    Use processes where a function spends its time in many short NumPy calls: these hold the interpreter lock, so
    threads would wait for each other.

    Args:
        work: function that another process can import, or a ``partial`` of one.
        items: arguments of ``work``. They and the results are pickled.
        processes: number of processes. With fewer than 2, this process does the work itself.
    """
    if processes < 2:
        yield from map(work, items)
        return
    import multiprocessing
    from concurrent.futures import ProcessPoolExecutor

    context = multiprocessing.get_context("spawn")  # available on all systems, and safe beside threads
    pool = ProcessPoolExecutor(processes, context, _begin)
    try:
        with _interrupts_ignored():
            results = pool.map(work, items)
        yield from results
    finally:
        pool.shutdown(cancel_futures=True)


@contextmanager
def _interrupts_ignored() -> Iterator[None]:
    """Ignore Ctrl-C while processes start. They inherit that, and the first process ends them."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _begin() -> None:
    """Tie a new process to the one that started it, even where that one is killed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    import multiprocessing

    parent = multiprocessing.parent_process()
    assert parent is not None
    parent.join()
    os._exit(1)
