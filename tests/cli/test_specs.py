"""The standard designs run as they stand, and say what their comments say."""

import json

import pytest

from chutecalc.cli import main
from tests.conftest import ROOT

SPECS = sorted((ROOT / "specs").rglob("*.toml"))


@pytest.mark.parametrize("spec", SPECS, ids=lambda path: path.stem)
def test_a_standard_design_runs(spec, capsys):
    assert main(["run", str(spec), "--json", "-", "--points", "5"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["status"] == "ok"
    assert document["error_estimate"] < 1e-10
    for segment in document["segments"]:
        assert len(segment["stations"]) == 5
