"""The recipes of CONTRIBUTING.md, carried out as they are printed there, on a copy of the package."""

import csv
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import tomli_w

import chutecalc
from tests.conftest import ROOT, spec

PAGE = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
RECIPE = re.compile(r"^### Add an? [^\n]*\n(?:(?!^#).)*?`(chutecalc/\S+\.py)`[^`]*^```python\n(.*?)^```$", re.S | re.M)
BEFORE = '    StreamColumn("velocity_m_s"'
"""The entry of the catalogue before which the new one is put."""
CHUTE = spec(
    sections={"body": {"shape": "trapezoid_stepped", "base_m": 0.4, "flank_deg": 35, "flank_m": 0.2, "step_m": 0.1}},
    segments=[{"kind": "ramp", "run_m": 6.0, "gradient": 1.0}],
    inlet={"velocity_m_s": 11.0, "slope_deg": 45.0},
)
WORK = """
import contextlib, io, json, subprocess, sys

import chutecalc
from chutecalc.cli import main
from tests.house.test_docstrings import faults, module_of
from pathlib import Path


def printed(*arguments):
    with contextlib.redirect_stdout(io.StringIO()) as out, contextlib.redirect_stderr(out):
        return main(list(arguments)), out.getvalue()


files = sys.argv[1:]
ruff = [[sys.executable, "-m", "ruff", *options, *files] for options in (["check"], ["format", "--check"])]
done = [subprocess.run(command, capture_output=True, text=True) for command in ruff]
json.dump(
    {
        "package": chutecalc.__file__,
        "run": printed("run", "chute.toml", "--csv", "chute.csv", "--tsv", "chute.tsv"),
        "us": printed("run", "chute.toml", "--units", "us"),
        "steep": printed("run", "chute.toml", "--set", "sections.body.flank_deg=85"),
        "starter": chutecalc.STARTER,
        "docstrings": [fault for file in files for fault in faults(module_of(Path(file).resolve()))],
        "ruff": [(one.returncode, one.stdout + one.stderr) for one in done],
    },
    sys.stdout,
)
"""


@pytest.fixture(scope="module")
def recipes():
    return dict(RECIPE.findall(PAGE))


@pytest.fixture(scope="module")
def place(recipes, tmp_path_factory):
    """A folder with the package and all recipes in it, and a chute that uses them."""
    folder = tmp_path_factory.mktemp("recipes")
    shutil.copytree(Path(chutecalc.__file__).parent, folder / "chutecalc")
    shutil.copy(ROOT / "pyproject.toml", folder)
    for name, text in recipes.items():
        file = folder / name
        if file.exists():
            catalogue = file.read_text(encoding="utf-8")
            assert catalogue.count(BEFORE) == 1
            entry = "\n".join(f"    {line}" for line in text.splitlines())
            text = catalogue.replace(BEFORE, f"{entry},\n{BEFORE}")
        file.write_text(text, encoding="utf-8")
    (folder / "chute.toml").write_text(tomli_w.dumps(CHUTE), encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def done(recipes, place):
    """What one process makes of them."""
    path = os.pathsep.join([str(place), str(ROOT)])
    run = subprocess.run(
        [sys.executable, "-c", WORK, *recipes],
        cwd=place,
        env=os.environ | {"PYTHONPATH": path},
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stderr
    result = json.loads(run.stdout)
    assert result["package"] == str(place / "chutecalc" / "__init__.py")
    return result


def test_there_are_five(recipes):
    assert PAGE.count("\n### Add a") == len(recipes) == 5
    assert {name.split("/")[1] for name in recipes} == {"sections", "segments", "results", "output"}


def test_they_run(done):
    status, out = done["run"]
    assert status == 0, out
    assert "fast_stream" in out
    assert "(limit 12 m/s)" in out
    assert "(limit 2362 fpm)" in done["us"][1]
    status, out = done["steep"]
    assert status == 2
    assert "sections.body.flank_deg=85 is steeper than the step" in out
    for example in ('shape = "trapezoid_stepped"', 'kind = "ramp"'):
        assert example in done["starter"]


def test_the_data_files_hold_the_column(done, place):
    tables = []
    for name, options in (("chute.csv", {}), ("chute.tsv", {"delimiter": "\t"})):
        with open(place / name, encoding="utf-8", newline="") as stream:
            tables.append(list(csv.DictReader(stream, **options)))
    rows, tabbed = tables
    assert rows == tabbed
    assert len(rows) == 101
    for row in rows:
        power = 0.5 * 1000 / 3.6 * float(row["velocity_m_s"]) ** 2 / 1000
        assert float(row["kinetic_power_kw"]) == pytest.approx(power, rel=1e-12)


def test_they_pass_what_the_package_has_to_pass(done):
    assert done["docstrings"] == []
    for status, out in done["ruff"]:
        assert status == 0, out
