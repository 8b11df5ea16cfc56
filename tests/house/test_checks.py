"""What the checks themselves rest on: seeds that all follow, skips that fail, README's test command."""

import os
import re
import subprocess
import sys

import pytest

from tests import seeds, skips
from tests.conftest import ROOT

TESTS = """
import numpy as np
import pytest
from hypothesis import given, strategies as st

from tests import seeds, skips

numbers = []


@pytest.mark.parametrize("case", range(seeds.times(5)))
def test_numpy(case):
    assert False, f"<numpy {seeds.generator(case).integers(10**9)}>"


@seeds.fuzzed(10)
@given(st.integers(10**6, 10**12))
def test_hypothesis(number):
    numbers.append(number)
    print(f"<hypothesis {numbers[:5]}>")
    assert len(numbers) < 5
"""
SKIPS = """
import pytest


def test_somewhere_else():
    pytest.skip("signals are others there")


def test_never():
    pytest.skip("no mood")


@pytest.fixture
def nothing():
    pytest.importorskip("nothing_of_that_name")


def test_without(nothing):
    pass


def test_well():
    pass


@pytest.mark.xfail(reason="known", strict=True)
def test_known_to_fail():
    assert False
"""


def pytest_run(folder, text, *arguments, **variables):
    """Status and output of tests in a folder of their own, with this project's conftest."""
    (folder / "test_inner.py").write_text(text, encoding="utf-8")
    (folder / "empty.ini").write_text("[pytest]\n", encoding="utf-8")
    names = ("CHUTECALC_SEED", "CHUTECALC_STRESS", "CHUTECALC_NO_SKIPS", "PYTEST_ADDOPTS")
    kept = {
        name: value
        for name, value in os.environ.items()
        if name not in names and not name.startswith(("PYTEST_XDIST", "PYTEST_CURRENT"))
    }
    options = ["-q", "-p", "tests.conftest", "-p", "no:cacheprovider", "-c", "empty.ini"]
    done = subprocess.run(
        [sys.executable, "-m", "pytest", *options, "test_inner.py", *arguments],
        cwd=folder,
        env=kept | {"PYTHONPATH": str(ROOT)} | variables,
        capture_output=True,
        text=True,
    )
    return done.returncode, done.stdout + done.stderr


def cases(output):
    """Return the random cases that were reported, each once."""
    return sorted(set(re.findall(r"<(?:numpy|hypothesis) [^>{]+>", output)))


def test_without_a_seed_the_cases_are_the_same_every_time(tmp_path):
    (status, first), (_, again) = (pytest_run(tmp_path, TESTS) for _ in range(2))
    assert status == 1
    assert len(cases(first)) > 5
    assert cases(first) == cases(again)
    assert "CHUTECALC_SEED=" not in first


def test_a_random_seed_is_told_and_gives_the_same_again(tmp_path):
    """All workers have the same one, and the cases of a run without workers."""
    status, output = pytest_run(tmp_path, TESTS, "-n", "2", CHUTECALC_SEED="random", CHUTECALC_STRESS="4")
    assert status == 1
    (top, *failures) = re.findall(r"CHUTECALC_SEED=(\d+) CHUTECALC_STRESS=4", output)
    assert failures == [top] * 5  # one for each of 4 and 1
    assert f"the same again: CHUTECALC_SEED={top} CHUTECALC_STRESS=4 pytest 'test_inner.py::test_numpy[3]'" in output
    _, again = pytest_run(tmp_path, TESTS, CHUTECALC_SEED=top, CHUTECALC_STRESS="4")
    assert cases(output) == cases(again)
    _, other = pytest_run(tmp_path, TESTS, CHUTECALC_SEED=str(int(top) + 1), CHUTECALC_STRESS="4")
    assert not {case for case in cases(other) if "numpy" in case} & set(cases(output))
    assert cases(other)[0] != cases(output)[0]  # what Hypothesis drew


@pytest.mark.parametrize(
    ("variable", "text"),
    [("CHUTECALC_SEED", "lucky"), ("CHUTECALC_SEED", "-1"), ("CHUTECALC_STRESS", "0"), ("CHUTECALC_STRESS", "1.5")],
)
def test_what_is_no_number_is_refused(variable, text, monkeypatch):
    monkeypatch.setenv(variable, text)
    with pytest.raises(pytest.UsageError, match=f"{variable}={text}: must be a whole number from "):
        seeds.settle()


def test_a_skip_that_nobody_expects_fails(tmp_path):
    status, output = pytest_run(tmp_path, SKIPS, "-n", "2", "-rA", CHUTECALC_NO_SKIPS="1")
    assert status == 1
    assert re.search("1 failed, 1 passed, 1 skipped, 1 xfailed, 1 error in", output)
    assert "test_inner.py::test_never\nskipped, and CHUTECALC_NO_SKIPS is set: no mood\n" in output
    assert "is set: could not import 'nothing_of_that_name'" in output
    status, output = pytest_run(tmp_path, SKIPS)
    assert status == 0
    assert re.search("1 passed, 3 skipped, 1 xfailed in", output)


def test_a_file_skipped_as_a_whole_fails_too(tmp_path):
    text = "import pytest\n\npytest.importorskip('nothing_of_that_name')\n"
    status, output = pytest_run(tmp_path, text, CHUTECALC_NO_SKIPS="1")
    assert status == 2
    assert "is set: could not import 'nothing_of_that_name'" in output


def command_in(readme):
    """Return what CI takes for the command that runs the tests: status, output, message."""
    done = subprocess.run(
        [sys.executable, str(ROOT / ".ci" / "test_command.py"), str(readme)], capture_output=True, text=True
    )
    return done.returncode, done.stdout, done.stderr


def test_readmes_test_command_is_found():
    status, command, message = command_in(ROOT / "README.md")
    assert (status, message) == (0, "")
    assert command.count("\n") == 1
    assert command.endswith("pytest -n auto\n")
    sessions = (ROOT / "noxfile.py").read_text(encoding="utf-8")
    assert '"python3", ".ci/test_command.py", "README.md"' in sessions
    assert re.search(r"/bin/nox\"", (ROOT / ".ci" / "run").read_text(encoding="utf-8"))


def test_ci_runs_every_session():
    sessions = (ROOT / "noxfile.py").read_text(encoding="utf-8")
    named = set(re.findall(r"^@nox\.session(?!\(default=False).*\ndef (\w+)", sessions, re.MULTILINE))
    called = re.findall(r"^nox -s ([a-z ]+)", (ROOT / ".ci" / "run").read_text(encoding="utf-8"), re.MULTILINE)
    assert sorted(" ".join(called).split()) == sorted(named)


@pytest.mark.parametrize("copies", [0, 2])
def test_a_readme_without_one_test_command_is_refused(copies, tmp_path):
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    line = command_in(ROOT / "README.md")[1]
    readme = tmp_path / "README.md"
    readme.write_text(text.replace(line, line * copies), encoding="utf-8")
    status, command, message = command_in(readme)
    assert (status, command) == (1, "")
    assert message.endswith(f"needs exactly one test command, a line with '.[test,dem]', and has {copies}\n")


def test_the_page_tells_of_every_folder_and_links_lead_somewhere():
    page = (ROOT / "docs" / "verification.md").read_text(encoding="utf-8")
    folders = {f"tests/{path.parent.name}" for path in (ROOT / "tests").glob("*/__init__.py")} | {"chutecalc"}
    assert set(re.findall(r"^\| `([a-z/]+)` \|", page, re.MULTILINE)) == folders
    for name in re.findall(r"`((?:tests|\.ci)/[a-z_/.]+)`", page):
        assert (ROOT / name).exists(), name
    for target in re.findall(r"\]\((?!http)([^)#]+)", page):
        assert (ROOT / "docs" / target).exists(), target
    assert {seeds.SEED, seeds.STRESS, skips.NO_SKIPS} == set(re.findall(r"CHUTECALC_[A-Z_]+", page))
