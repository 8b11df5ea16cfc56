"""A sweep on 1, 2 and 4 workers of a Dask cluster of this machine, compared with threads of one process.

    python benchmarks/workers.py [--quick] [--out FOLDER]

The worked example over a grid of radii and wall friction angles, columns of the exit, no file: blocks are solved and
brought together. More workers than processors gain nothing. Workers are processes of one thread each, and run already.
"""

import os
import time
from pathlib import Path

from distributed import LocalCluster
from measure import Report

import chutecalc
from chutecalc.studies.sweep.parameters import read_parameters
from chutecalc.studies.sweep.solved_blocks import solve_blocks
from chutecalc.studies.sweep.sweep import Sweep
from chutecalc.workers import Dask, Pool, Threads

SPEC = Path(__file__).parents[1] / "specs" / "paper" / "r3_d55_chamfered.toml"
ROUNDS = 3


def seconds(sweep: Sweep, pool: Pool) -> float:
    """Return the least clock time of a few rounds, s."""
    times = []
    for _ in range(ROUNDS):
        begun = time.perf_counter()
        for _ in solve_blocks(sweep, range(sweep.block_count), pool):
            pass
        times.append(time.perf_counter() - begun)
    return min(times)


def main() -> None:
    """Measure and print."""
    report = Report("workers", __doc__)
    side, chute = 200 if report.quick else 1000, chutecalc.load(SPEC)
    sweep = Sweep(chute, read_parameters([f"radius=1:4:#{side}", f"phi=20:30:#{side}"], chute))
    rows = []
    for count in (1, 2, 4):
        threads = seconds(sweep, Threads(count))
        settings = {"processes": True, "threads_per_worker": 1, "dashboard_address": None}
        with LocalCluster(n_workers=count, **settings) as cluster:
            pool = Dask(cluster.scheduler_address)
            workers = seconds(sweep, pool)
            pool.close()
        rows.append((count, os.cpu_count(), side**2, threads, workers, workers / threads, 1e6 * workers / side**2))
    header = ("at_once", "processors", "designs", "threads_s", "dask_s", "ratio", "dask_us_a_design")
    report.write(header, rows, ("d", "d", ",d", ".2f", ".2f", ".2f", ".2f"))


if __name__ == "__main__":
    main()
