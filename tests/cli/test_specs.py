"""The standard designs run as they stand, and say what their comments say."""

import json

import pytest

from chutecalc.cli import main
from tests.conftest import STANDARD_DESIGNS


@pytest.mark.parametrize("spec", STANDARD_DESIGNS, ids=lambda path: path.stem)
def test_a_standard_design_runs(spec, capsys):
    fails = spec.parent.name == "fails"
    status = main(["run", str(spec), "--json", "-", "--points", "5"])
    (document,) = json.loads(capsys.readouterr().out)["chutes"]
    assert (document["status"] != "ok") == fails
    assert status == (fails or any(case["status"] != "ok" for case in document["cases"].values()))
    assert document["error_estimate"] is None or document["error_estimate"] < 1e-10
    for segment in document["segments"]:
        reached = segment["entry"]["s_m"] is not None
        count = len(segment["stations"])
        assert (count > 0) == reached
        assert count % 5 == 0  # several times 5 where the stream crosses from wall to wall
