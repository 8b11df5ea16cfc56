"""Work that several processes share.

Threads would wait for each other: on the small arrays of one design NumPy holds the interpreter nearly all the time.
"""

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from typing import TypeVar

Item = TypeVar("Item")
Result = TypeVar("Result")


def in_processes(work: Callable[[Item], Result], items: Sequence[Item], processes: int) -> Iterator[Result]:
    """The results of some work on each item, in their order.

    Args:
        work: a function that another process can import, or a ``partial`` of one.
        items: to work on; they, and the results, cross between processes.
        processes: how many share it; this one alone does it where that is less than 2.
    """
    if processes < 2:
        yield from map(work, items)
        return
    context = multiprocessing.get_context("spawn")  # the only way that all systems have, and safe beside threads
    pool = ProcessPoolExecutor(processes, context, _begin)
    try:
        with _not_interrupted():
            results = pool.map(work, items)
        yield from results
    finally:
        pool.shutdown(cancel_futures=True)


def cores() -> int:
    """How many this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextmanager
def _not_interrupted() -> Iterator[None]:
    """Ctrl-C goes to all processes of a terminal. Those started here do not heed it: the first one ends them."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _begin() -> None:
    """A process begins: it ends with the one that started it, even where that was killed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    assert parent is not None
    parent.join()
    os._exit(1)
