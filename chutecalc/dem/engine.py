"""LAMMPS as a program of its own: what crashes or is killed there is one case lost, and none of its code is ours."""

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

INSTALL = "pip install 'chutecalc[dem]'"
OUTPUT = "output.txt"
"""What LAMMPS says, in the folder of the case."""


class RunError(Exception):
    """A case whose run did not end well."""


class Engine:
    """Runs cases, several at once where threads call it.

    Args:
        processes: of each run; more than one go through mpirun.
        program: name or path of LAMMPS' executable.

    Raises:
        ExtraMissingError: there is no such program.
    """

    def __init__(self, processes: int = 1, program: str = "lmp") -> None:
        lmp = _find(program)
        if lmp is None:
            raise ExtraMissingError(f"LAMMPS is not installed: there is no program {program}. Install it: {INSTALL}")
        self.command = [lmp]
        if processes > 1:
            mpirun = _find("mpirun") or _find("mpiexec")
            if mpirun is None:
                raise ExtraMissingError(f"--mpi needs mpirun, which is not installed. Install it: {INSTALL}")
            self.command = [mpirun, "-np", str(processes), lmp]
        self._running: set[subprocess.Popen[bytes]] = set()
        self._lock = threading.Lock()
        self._stopped = False

    def run(self, place: Path) -> None:
        """Runs the case in a folder to its end.

        Raises:
            RunError: it crashed, was killed, or found the disk full; with where its log is.
        """
        for old in (script.WALLS, script.BED):
            (place / old).unlink(missing_ok=True)
        environment = os.environ | {"OMP_NUM_THREADS": "1"}
        arguments = ["-in", script.SCRIPT, "-log", script.LOG]
        try:
            with open(place / OUTPUT, "wb") as output:
                with self._lock:
                    if self._stopped:
                        raise RunError("stopped")
                    process = subprocess.Popen(
                        [*self.command, *arguments],
                        cwd=place,
                        env=environment,
                        stdin=subprocess.DEVNULL,
                        stdout=output,
                        stderr=subprocess.STDOUT,
                        start_new_session=True,
                    )
                    self._running.add(process)
                status = process.wait()
        except OSError as error:
            raise RunError(f"could not be run: {error.strerror}; see {place}") from None
        with self._lock:
            self._running.discard(process)
        if status != 0 or not (place / script.WALLS).is_file():
            raise RunError(f"{_cause(status, place)}; see {place / OUTPUT}")

    def stop(self) -> None:
        """Ends all that runs, and lets nothing new begin."""
        with self._lock:
            self._stopped = True
            for process in self._running:
                _end(process)


def _end(process: "subprocess.Popen[bytes]") -> None:
    """Ends a program with what it has started."""
    with suppress(ProcessLookupError):
        if hasattr(os, "killpg"):
            os.killpg(process.pid, signal.SIGTERM)
        else:
            process.terminate()


def _find(program: str) -> str | None:
    """A program beside the interpreter, as in a virtual environment that is not activated, or else on the path."""
    return shutil.which(program, path=str(Path(sys.executable).parent)) or shutil.which(program)


def _cause(status: int, place: Path) -> str:
    """Why a run ended badly, as LAMMPS says it itself where it does."""
    with suppress(OSError):
        said = (place / OUTPUT).read_text(encoding="utf-8", errors="replace").splitlines()
        for line in reversed(said):
            if "ERROR" in line:
                return line.strip()
    return f"LAMMPS was killed by signal {-status}" if status < 0 else f"LAMMPS ended with status {status}"
