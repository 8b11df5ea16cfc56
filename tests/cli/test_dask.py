"""``--dask``: workers of a scheduler solve the same rows, to the byte, also where one of them is lost."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.studies.sweep.parameters import read_parameters
from chutecalc.studies.sweep.solved_blocks import solve_blocks
from chutecalc.studies.sweep.sweep import Sweep
from chutecalc.workers import Dask, Threads, pool_of
from tests.dem.test_campaign import SMALL

ROOT = Path(__file__).parents[2]
TRANSFER = str(ROOT / "specs" / "transfer_90.toml")
VARIED = ("segments.spoon.radius_m=1:4:#200", "rate=500:2000:#20", "case=dry,wet")
COLUMNS = ("exit_velocity_m_s", "max_wear_w_m2")  # what is found along the stream has small blocks: there are 8 of them
SWEEP = ["sweep", TRANSFER, *VARIED, "--columns", ",".join(COLUMNS)]


@pytest.fixture(scope="module")
def cluster():
    from distributed import LocalCluster

    settings = {"dashboard_address": None, "processes": True, "threads_per_worker": 1}
    with LocalCluster(n_workers=2, **settings) as running:
        yield running


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    file = tmp_path_factory.mktemp("whole") / "whole.csv"
    assert main([*SWEEP, "--csv", str(file)]) == 0
    return file.read_bytes()


def test_the_files_are_the_same_to_the_byte(cluster, whole, tmp_path):
    there = tmp_path / "there.csv"
    assert main([*SWEEP, "--csv", str(there), "--dask", cluster.scheduler_address]) == 0
    assert there.read_bytes() == whole
    for name, more in (("here.json", []), ("there.json", ["--dask", cluster.scheduler_address])):
        assert main(["uncertain", TRANSFER, "--samples", "4096", "--json", str(tmp_path / name), *more]) == 0
    assert (tmp_path / "there.json").read_bytes() == (tmp_path / "here.json").read_bytes()


def test_a_lost_worker_loses_only_its_block(cluster):
    chute = chutecalc.load(TRANSFER)
    sweep = Sweep(chute, read_parameters(list(VARIED), chute), columns=COLUMNS)
    pool, solved = Dask(cluster.scheduler_address), {}
    lost = next(iter(pool.client.run(os.getpid).values()))
    for number, block in solve_blocks(sweep, range(sweep.block_count), pool):
        solved[number] = block
        if number == 2:
            os.kill(lost, signal.SIGKILL)
    pool.close()
    for number, block in solve_blocks(sweep, range(sweep.block_count), Threads(1)):
        assert all((block[name] == solved[number][name]).all() or name != "status" for name in block)
        assert {name: values.tobytes() for name, values in block.items() if values.dtype.kind == "f"} == {
            name: values.tobytes() for name, values in solved[number].items() if values.dtype.kind == "f"
        }


def test_an_interrupted_sweep_is_resumed_elsewhere(cluster, whole, tmp_path):
    file = tmp_path / "part.csv"
    command = [sys.executable, "-m", "chutecalc", *SWEEP, "--csv", str(file), "--jobs", "1"]
    process = subprocess.Popen(command, cwd=ROOT)
    part = Path(f"{file}.part")
    while process.poll() is None and not any(part.glob("**/*.npz")) and not part.is_file():
        pass
    process.kill()
    process.wait()
    if not file.exists():
        assert main([*SWEEP, "--csv", str(file), "--resume", "--dask", cluster.scheduler_address]) == 0
    assert file.read_bytes() == whole


def test_cases_of_particles_run_on_workers(cluster, tmp_path):
    from chutecalc.dem.campaign import run_case
    from chutecalc.dem.engine import RunError
    from chutecalc.dem.store import Store

    engine, pool = _engine(), Dask(cluster.scheduler_address)
    with pool.workers() as workers:
        run = workers.executor.submit(run_case, Store(str(tmp_path)), engine, SMALL)
        with pytest.raises(RunError, match="see"):  # the program ends without results, in the folder of the case
            run.result()
    pool.close()
    assert (Store(str(tmp_path)).case_folder(SMALL) / "output.txt").is_file()


def _engine():
    from chutecalc.dem.engine import Engine

    return Engine(1, sys.executable)


def test_what_is_wrong_is_said(capsys, monkeypatch):
    monkeypatch.setattr("chutecalc.workers.CONNECT_TIMEOUT", 0.2)
    assert main(["sweep", TRANSFER, "rate=1,2", "--dask", "tcp://127.0.0.1:9"]) == 2
    assert "there is no Dask scheduler" in capsys.readouterr().err
    with pytest.raises(chutecalc.UsageError, match="give one of them"):
        pool_of(2, "tcp://127.0.0.1:9")
