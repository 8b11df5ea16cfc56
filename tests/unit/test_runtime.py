"""Work that several processes share: from any thread, and not beyond the process that asked for it."""

import gc
import multiprocessing
import os
import signal
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import pytest

import chutecalc
from chutecalc import runtime


def test_a_thread_may_share_its_work_too():
    with ThreadPoolExecutor(1) as pool:  # signals are set in the main thread alone
        assert pool.submit(lambda: list(runtime.in_processes(abs, [-1, -2, 3], 2))).result() == [1, 2, 3]


def test_no_process_is_left_when_the_results_are_not_wanted_any_more():
    results = runtime.in_processes(abs, [*range(-50, 0)], 2)
    assert next(results) == 50
    assert multiprocessing.active_children()
    results.close()
    assert multiprocessing.active_children() == []


def test_processes_begin_deaf_to_ctrl_c_and_the_first_one_is_not_afterwards():
    before = signal.getsignal(signal.SIGINT)
    heard = list(runtime.in_processes(signal.getsignal, [signal.SIGINT] * 2, 2))
    assert heard == [signal.SIG_IGN] * 2
    assert signal.getsignal(signal.SIGINT) is before


WORKING = """
import multiprocessing, threading, time
from chutecalc.runtime import in_processes
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


@pytest.mark.skipif(not hasattr(os, "sched_setaffinity"), reason="no affinity on this system")
def test_cores_are_those_that_the_process_may_use():
    allowed = os.sched_getaffinity(0)
    try:
        os.sched_setaffinity(0, {min(allowed)})
        assert runtime.cores() == 1
    finally:
        os.sched_setaffinity(0, allowed)
    assert runtime.cores() == len(allowed)


def test_importing_the_package_changes_nothing_in_the_host_process():
    code = (
        "import gc, os\nbefore = gc.get_threshold(), dict(os.environ)\n"
        "import chutecalc\nchutecalc.load, chutecalc.exits\n"
        "print((gc.get_threshold(), dict(os.environ)) == before)\n"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout == "True\n"


def test_variants_are_no_circles():
    """Commands hardly ever collect garbage, so that what refers to itself would stay until the end."""
    base = chutecalc.parse(chutecalc.STARTER)

    def solved():
        variants = base.vary({"flow.rate_t_h": [500.0, 800.0], "segments.spoon.radius_m": [2.0, 3.0]})
        return chutecalc.exits(variants).ok.all() and chutecalc.solve(variants).ok.all()

    assert solved()  # what is made once, and kept
    gc.collect()
    gc.disable()
    try:
        assert solved()
        assert gc.collect() == 0
    finally:
        gc.enable()
