"""Work that several processes share: from any thread, and not beyond the process that asked for it."""

import multiprocessing
import signal
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import pytest

from chutecalc.studies.regression import processes


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


WORKING = """
import multiprocessing, threading, time
from chutecalc.studies.regression.processes import in_processes
threading.Thread(target=lambda: list(in_processes(time.sleep, [600.0, 600.0], 2)), daemon=True).start()
while len(multiprocessing.active_children()) < 2:
    time.sleep(0.01)
print("at work", flush=True)
time.sleep(600.0)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals are others there")
def test_processes_end_with_the_one_that_started_them_even_where_that_is_killed():
    first = subprocess.Popen([sys.executable, "-c", WORKING], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert first.stdout.readline() == b"at work\n"
    first.kill()
    first.communicate(timeout=120)  # at its end when no process has the other end of the pipes any more
    assert first.returncode == -signal.SIGKILL
