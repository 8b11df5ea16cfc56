"""Cases as folders on disk: written for LAMMPS, run here or elsewhere, and read back."""

import json
import math
from dataclasses import asdict
from pathlib import Path

import numpy as np

from chutecalc.dem import script
from chutecalc.dem.bed import Bed
from chutecalc.dem.case import Case
from chutecalc.dem.pour import column
from chutecalc.errors import SpecError
from chutecalc.output.files import open_whole
from chutecalc.output.held import make_folder
from chutecalc.spec.reader import read_bytes

LONGEST = 200
"""Bytes of a line of a dump, at most."""
DUMP_HEADER = 9
"""Lines before the particles in a dump of one time step."""


class Store:
    """A folder with a folder for each case.

    Args:
        folder: Its path. It is created when the first case is written.

    >>> case = Case(base=0.2, lengths=(), inclinations=(), area=0.01, friction=0.75, pour="rain", seed=1)
    >>> store = Store("no-such-folder")
    >>> store.case_folder(case) == Path("no-such-folder", case.name), store.read(case)
    (True, None)
    """

    def __init__(self, folder: str | Path) -> None:
        self.folder = Path(folder)

    def case_folder(self, case: Case) -> Path:
        """Return the folder of a case.

        Args:
            case: The case.
        """
        return self.folder / case.name

    def write(self, case: Case) -> Path:
        """Write the input of LAMMPS unless it is there; the script last, so that a folder with a script is complete.

        Args:
            case: The case.

        Returns:
            The folder of the case.

        Raises:
            OutputError: it cannot be written.
            WriteError: writing failed.
        """
        folder = self.case_folder(case)
        if not (folder / script.SCRIPT).is_file():
            positions = column(case)
            make_folder(folder)
            known = asdict(case) | {"lengths": [None if length == math.inf else length for length in case.lengths]}
            _write(folder / "case.json", json.dumps(known, indent=1, allow_nan=False) + "\n")
            _write(folder / script.PARTICLES, script.particles_text(case, positions))
            _write(folder / script.SCRIPT, script.script_text(case, float(positions[-1, 2])))
        return folder

    def read(self, case: Case) -> Bed | None:
        """Read the bed of a case.

        Args:
            case: The case.

        Returns:
            The bed; None where the case has not been run to its end, or its files are damaged.
        """
        folder = self.case_folder(case)
        try:
            walls, bed = read_bytes(folder / script.WALLS), read_bytes(folder / script.BED, most=case.count * LONGEST)
            numbers = np.array([float(word) for word in walls.decode().split()])
            rows = np.array([line.split() for line in bed.decode().splitlines()[DUMP_HEADER:]], dtype=float)
        except (SpecError, ValueError):
            return None
        if numbers.size != 1 + 2 * len(case.trough.walls) or rows.shape != (case.count, 4):
            return None
        if not (np.isfinite(numbers).all() and np.isfinite(rows).all()):
            return None
        found = Bed(case, numbers[1:].reshape(-1, 2), kinetic_energy=float(numbers[0]), positions=rows[:, 1:])
        return found if found.is_possible else None


def _write(path: Path, text: str) -> None:
    with open_whole(str(path)) as stream:
        stream.write(text)
