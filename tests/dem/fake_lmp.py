"""Stands in for LAMMPS: a bed of points whose walls carry what the equilibrium law says with K_v = 0.2, or a crash.

``FAKE_LMP`` in the environment says what is wrong: ``crash``, ``kill``, ``silent`` or ``short`` for seed 2; ``tilt``
for beds that are level with a spread of 0.2 only; ``hang`` for one that never ends.
"""

import json
import math
import os
import signal
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))

from chutecalc.dem.case import Case
from tests.dem.beds import bed

HEADER = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n0\nITEM: BOX BOUNDS\n0 0\n0 0\n0 0\nITEM: ATOMS id x y z\n"


def main():
    known = json.loads(Path("case.json").read_text(encoding="utf-8"))
    known["lengths"] = tuple(math.inf if length is None else length for length in known["lengths"])
    case = Case(**(known | {"inclinations": tuple(known["inclinations"])}))
    wrong = os.environ.get("FAKE_LMP", "")
    if wrong == "hang":
        Path("hangs.txt").write_text(str(os.getpid()), encoding="utf-8")
        time.sleep(60)
    if case.seed == 2:
        if wrong == "crash":
            sys.exit("ERROR: Lost atoms: original 100 current 99")
        if wrong == "kill":
            os.kill(os.getpid(), signal.SIGKILL)
        if wrong == "silent":
            sys.exit(0)
        if wrong == "short":
            Path("walls.txt").write_text("0.0 0.0", encoding="utf-8")
            sys.exit(0)
    made = bed(case, tilt=case.spread - 0.2 if wrong == "tilt" else 0.0)
    rows = "".join(f"{number} {x} {y} {z}\n" for number, (x, y, z) in enumerate(made.positions, 1))
    Path("bed.dump").write_text(HEADER + rows, encoding="utf-8")
    Path("walls.txt").write_text(" ".join(map(str, [0.0, *made.forces.ravel()])) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
