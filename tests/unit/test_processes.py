"""Work that several processes share: from any thread, and not beyond the process that asked for it."""

import multiprocessing
import os
import signal
import threading
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace

from chutecalc.studies import processes


def test_a_thread_may_share_its_work_too():
    with ThreadPoolExecutor(1) as pool:  # signals are set in the main thread alone
        assert pool.submit(lambda: list(processes.in_processes(abs, [-1, -2, 3], 2))).result() == [1, 2, 3]


def test_no_process_is_left_when_the_results_are_not_wanted_any_more():
    results = processes.in_processes(abs, [*range(-50, 0)], 2)
    assert next(results) == 50
    assert multiprocessing.active_children()
    results.close()
    assert multiprocessing.active_children() == []


def test_processes_begin_deaf_to_ctrl_c_and_the_first_one_is_not_afterwards():
    before = signal.getsignal(signal.SIGINT)
    heard = list(processes.in_processes(signal.getsignal, [signal.SIGINT] * 2, 2))
    assert heard == [signal.SIG_IGN] * 2
    assert signal.getsignal(signal.SIGINT) is before


def test_a_process_ends_with_the_one_that_started_it(monkeypatch):
    ended = threading.Event()
    parent = SimpleNamespace(join=lambda: None)
    monkeypatch.setattr(multiprocessing, "parent_process", lambda: parent)
    monkeypatch.setattr(os, "_exit", lambda status: ended.set() if status == 1 else None)
    processes._end_with_parent()
    assert ended.is_set()
