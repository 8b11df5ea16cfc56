"""LAMMPS as a separate program: a crash loses one case only, and no GPL code enters our process."""

import os
import shutil
import signal
import subprocess
import sys
import threading
from contextlib import suppress
from pathlib import Path

from chutecalc.dem import script
from chutecalc.errors import ExtraMissingError
from chutecalc.extras import DEM

OUTPUT = "output.txt"
"""File of the output of LAMMPS, in the folder of a case."""


class RunError(Exception):
    """The run of a case failed."""


class Engine:
    """Runs cases, several at once if several threads call it.

    Args:
        processes: number of processes of each run. More than one are started by mpirun.
        program: name or path of the executable of LAMMPS.

    Raises:
        ExtraMissingError: the program is not installed.
    """

    def __init__(self, processes: int = 1, program: str = "lmp") -> None:
        lmp = _find(program)
        if lmp is None:
            raise ExtraMissingError(f"there is no program {program} of LAMMPS. Install it: {DEM.install}")
        self.command = [lmp]
        if processes > 1:
            mpirun = _find("mpirun") or _find("mpiexec")
            if mpirun is None:
                raise ExtraMissingError(f"--mpi needs mpirun, which is not installed. Install it: {DEM.install}")
            self.command = [mpirun, "-np", str(processes), lmp]
        self._running: set[subprocess.Popen[bytes]] = set()
        self._lock = threading.Lock()
        self._stopped = False

    def __getstate__(self) -> dict[str, object]:
        """Return the command alone, for another process: what runs belongs to this one."""
        return {"command": self.command}

    def __setstate__(self, state: dict[str, list[str]]) -> None:
        self.command, self._running, self._lock, self._stopped = state["command"], set(), threading.Lock(), False

    def run(self, folder: Path) -> None:
        """Run a case to its end.

        Args:
            folder: the folder of the case.

        Raises:
            RunError: it crashed, was killed, or the disk was full. The message names its log.
        """
        for old in (script.WALLS, script.BED):
            (folder / old).unlink(missing_ok=True)
        environment = os.environ | {"OMP_NUM_THREADS": "1"}
        arguments = ["-in", script.SCRIPT, "-log", script.LOG]
        try:
            with open(folder / OUTPUT, "wb") as output:
                with self._lock:
                    if self._stopped:
                        raise RunError("stopped")
                    process = subprocess.Popen(
                        [*self.command, *arguments],
                        cwd=folder,
                        env=environment,
                        stdin=subprocess.DEVNULL,
                        stdout=output,
                        stderr=subprocess.STDOUT,
                        start_new_session=True,
                    )
                    self._running.add(process)
                status = process.wait()
        except OSError as error:
            raise RunError(f"could not be run: {error.strerror}; see {folder}") from None
        with self._lock:
            self._running.discard(process)
        if status != 0 or not (folder / script.WALLS).is_file():
            raise RunError(f"{_cause(status, folder)}; see {folder / OUTPUT}")

    def stop(self) -> None:
        """Stop all running cases, and start no others."""
        with self._lock:
            self._stopped = True
            for process in self._running:
                _end(process)


def _end(process: "subprocess.Popen[bytes]") -> None:
    """Stop a program and the programs that it has started."""
    with suppress(ProcessLookupError):
        if hasattr(os, "killpg"):
            os.killpg(process.pid, signal.SIGTERM)
        else:
            process.terminate()


def _find(program: str) -> str | None:
    """Return the path of a program: beside the interpreter, as in a virtual environment, or else on the search path."""
    return shutil.which(program, path=str(Path(sys.executable).parent)) or shutil.which(program)


def _cause(status: int, folder: Path) -> str:
    """Return why a run failed, in the words of LAMMPS if there are any."""
    with suppress(OSError):
        output = (folder / OUTPUT).read_text(encoding="utf-8", errors="replace").splitlines()
        for line in reversed(output):
            if "ERROR" in line:
                return line.strip()
    return f"LAMMPS was killed by signal {-status}" if status < 0 else f"LAMMPS ended with status {status}"
