"""The compiled core has the digits of the plain Python that it was compiled from."""

import subprocess
import sys

from chutecalc.core import compiled
from tests import seeds

COUNT = seeds.times(60)
PROGRAM = """
import sys
from importlib.util import spec_from_file_location
from pathlib import Path

class Plain:
    @staticmethod
    def find_spec(name, path, target=None):
        if name.startswith("chutecalc.core."):
            return spec_from_file_location(name, Path(path[0], name.rpartition(".")[2]).with_suffix(".py"))

if sys.argv[1] == "plain":
    sys.meta_path.insert(0, Plain)
import chutecalc
from chutecalc.core import compiled
from chutecalc.solver.chain import run_chain
from tests import seeds
from tests.robustness.chutes import random_specs
print(compiled())
narrowing = {  # to half: drawn on, it ends in a point, where iterates may lead
    "flow": {"rate_t_h": 1000.0},
    "material": {"density_kg_m3": 800.0, "internal_friction_deg": 45.0},
    "liners": {"wall": {"friction_deg": 20.0}},
    "sections": {"body": {"shape": "circular", "radius_m": 0.6}, "end": {"shape": "circular", "radius_m": 0.3}},
    "inlet": {"velocity_m_s": 1.0, "slope_deg": 10.0},
    "segments": [{"kind": "straight", "slope_deg": 10.0, "length_m": 3.0, "section": ["body", "end"]}],
}
drawn = [random_specs(77), random_specs(78)]
specs = [narrowing, *(data for some in drawn for _, data in zip(range(int(sys.argv[2])), some))]
for number, data in enumerate(specs):
    for rtol, complete in ((1e-12, True), (1e-6, False)):
        try:
            solutions, _ = run_chain(chutecalc.parse(data).design, rtol, complete)
        except chutecalc.SpecError:
            continue
        for solved in solutions:
            print(number, solved.status[0], *(float(numbers[0]).hex() for numbers in solved.exit[:8]))
"""


def digits(form):
    """Return what the core found of each design, and whether it was compiled."""
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, form, str(COUNT)], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    first, *rest = done.stdout.splitlines()
    return first == "True", rest


def test_compiled_and_plain_python_have_the_same_digits():
    usual, expected = digits("usual")
    plain, found = digits("plain")
    assert usual == compiled()
    assert not plain
    assert len(expected) > COUNT
    assert found == expected
