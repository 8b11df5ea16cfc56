"""Sweeps through ``main``, for all tests of them: specs, what a sweep returns, and what it refuses."""

import csv
import io

import tomli_w

from chutecalc.cli import main
from tests.conftest import ROOT, spec

SPOON = str(ROOT / "specs/paper/r3_d55_chamfered.toml")
VEE = str(ROOT / "specs/vee.toml")
HOOD = str(ROOT / "specs/coal_hood_spoon.toml")
BELT = str(ROOT / "specs/belt_hood_spoon.toml")
BOTH = {"material": {"density_kg_m3": 800.0, "internal_friction_deg": 50.0, "pressure_ratio": 0.3}}
DRAWN = {"body": {"shape": "chamfered", "base_m": 0.3, "chamfer_deg": 45.0, "chamfer_m": 0.2}}
LINERS = ("segments.spoon.liner=steel,ceramic", "segments.hood.liner=ceramic,steel")


def written(tmp_path, **tables):
    """Write a spec to a file and return its path."""
    path = tmp_path / "chute.toml"
    path.write_text(tomli_w.dumps(spec(**tables)), encoding="utf-8")
    return str(path)


def swept(capsys, *arguments):
    """Run a sweep and return its rows as dictionaries of text."""
    assert main(["sweep", *arguments, "--csv", "-"]) == 0
    return list(csv.DictReader(io.StringIO(capsys.readouterr().out)))


def refused(capsys, *arguments, status=2):
    """Return the message about a wrong sweep."""
    assert main(["sweep", *arguments]) == status
    shown = capsys.readouterr()
    assert shown.out == ""
    assert "Traceback" not in shown.err
    return shown.err
