"""The mutation command on a toy of two lines, of which the tests hold one."""

import json
import os
import subprocess
import sys

import pytest

from tests.conftest import ROOT
from tests.mutation.__main__ import accepted
from tests.mutation.mutants import mutants

TOY = b'''"""Text with 3 numbers."""


def larger(a: int | None, b: int) -> int:
    """Not 1 but 2."""
    return a if a > b else b


def lower(a, b):
    return f"{a:.3f} is less than {b} by 2 m" if not a >= b else min(a, b)


def never():
    return 5
'''
TESTS = """from toy.calc import larger, lower


def test_larger():
    assert (larger(1, 2), larger(2, 1)) == (2, 2)


def test_lower():
    lower(1.0, 2.0)
    lower(2.0, 1.0)
"""


def test_the_mutants_of_a_file():
    found = {(mutant.line, mutant.kind, mutant.new) for mutant in mutants("calc.py", TOY)}
    assert found == {
        *((6, "compared", new) for new in (">=", "<")),
        (6, "returned", "None"),
        *((10, "compared", new) for new in (">", "<=")),
        *((10, "text", new) for new in ("a", "b", "4")),
        (10, "sign", ""),
        (10, "name", "max"),
        (10, "returned", "None"),
        *((14, "number", new) for new in ("10", "6", "0")),
        (14, "returned", "None"),
    }
    for mutant in mutants("calc.py", TOY):
        before, after = mutant.difference(TOY)
        assert before != after
        assert TOY.decode().count(before) == 1
        assert mutant.source(TOY).decode().count(after) == 1


@pytest.mark.skipif(not hasattr(os, "fork"), reason="mutants run in forked processes")
def test_a_toy_from_end_to_end(tmp_path):
    for name, text in {"toy/__init__.py": b"", "toy/calc.py": TOY, "tests/test_toy.py": TESTS.encode()}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(text)
    (tmp_path / "tests" / "mutation_accepted.txt").write_text(
        "# comment\n\ntoy/calc.py never\n- return 5\n+ return 6\nas good\n\n"
        "toy/calc.py larger\n- return a if a > b else b\n+ *\nnot used, because it is killed\n",
        encoding="utf-8",
    )

    def outcomes(status, *arguments):
        command = [sys.executable, "-m", "tests.mutation", "--json", str(tmp_path / "out.json")]
        toy = ["--root", str(tmp_path), "--package", "toy", "--rooms", "calc"]
        done = subprocess.run([*command, *toy, *arguments], cwd=ROOT, capture_output=True, text=True)
        assert done.returncode == status, done.stdout + done.stderr
        results = json.loads((tmp_path / "out.json").read_text(encoding="utf-8"))
        return {result["id"]: (result["outcome"], result["test"]) for result in results}, done.stdout

    killed, survived = "toy/calc.py:6:19:compared:<", "toy/calc.py:10:66:name:max"
    missed, fine = "toy/calc.py:14:12:number:0", "toy/calc.py:14:12:number:6"
    found, output = outcomes(1, "--only", killed, survived, missed, fine)
    assert found == {
        killed: ("killed", "tests/test_toy.py::test_larger"),
        survived: ("survived", ""),
        missed: ("not reached", ""),
        fine: ("accepted", ""),
    }
    assert "recording" in output
    assert "+ return 0" in output
    assert (tmp_path / "toy" / "calc.py").read_bytes() == TOY

    first, output = outcomes(1, "--count", "8", "--seed", "3", "--jobs", "2")
    assert "recording" not in output
    assert len(first) == 8
    assert outcomes(1, "--count", "8", "--seed", "3")[0] == first


def test_every_accepted_mutant_exists():
    left = set(accepted(ROOT / "tests" / "mutation_accepted.txt"))
    for file in {head.partition(" ")[0] for head, _, _ in left}:
        source = (ROOT / file).read_bytes()
        for mutant in mutants(file, source):
            head, (before, after) = f"{file} {mutant.function}".strip(), mutant.difference(source)
            left -= {(head, before, after), (head, before, "*")}
    assert not left
