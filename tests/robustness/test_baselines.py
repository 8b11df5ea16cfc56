"""Whatever stands in a baseline: a verdict, or faults that can be corrected."""

import io
import json
from contextlib import suppress

import pytest
from hypothesis import HealthCheck, given
from hypothesis import strategies as st

import chutecalc
from chutecalc.errors import SpecError
from chutecalc.output.printer import Printer
from chutecalc.studies.regression.compare import compare
from chutecalc.studies.regression.record import baseline_of, baseline_path, read_baseline
from chutecalc.studies.regression.report import check_dataset, print_verdicts, write_junit
from chutecalc.studies.regression.verdict import DRIFTED, Verdict
from chutecalc.studies.regression.write import write_baseline
from tests.conftest import ROOT
from tests.seeds import fuzzed

LINES = st.sampled_from(
    [
        "",
        "x = 1",
        "[a]",
        "velocity_m_s = 5",
        "velocity_m_s = -1e300",
        f"velocity_m_s = 1{'0' * 400}",
        "velocity_m_s = true",
        "velocity_m_s = nan",
        "name = 3",
        'name = "hood"',
        'status = "stall"',
        "segments = 3",
        "[[segments]]",
        "[[segments.stations]]",
        "findings = []",
        "findings = [1]",
        "tolerance = 1",
        "tolerance = 1e-13",
        "spec_sha256 = 1979-05-27",
        "é = 2",
        "\x00",
    ]
)


@pytest.fixture(scope="module")
def solved(tmp_path_factory):
    """Return what comes out of a standard design, the lines of its baseline, and a file to write them to."""
    chute = chutecalc.load(ROOT / "specs" / "belt_hood_spoon.toml")
    solution = chutecalc.solve(chute)
    now = baseline_of(chute, solution, solution.findings())
    file = baseline_path(tmp_path_factory.mktemp("baselines") / "spoon.toml")
    write_baseline(str(file.with_name("spoon.toml")), now.document())
    return now, file.read_text(encoding="utf-8").split("\n"), file


@fuzzed(suppress=(HealthCheck.function_scoped_fixture,))
@given(changes=st.lists(st.tuples(st.integers(0, 1000), LINES), min_size=1, max_size=3))
def test_any_line_changed(solved, changes):
    now, lines, file = solved
    changed = list(lines)
    for number, line in changes:
        changed[number % len(lines)] = line
    file.write_text("\n".join(changed), encoding="utf-8")
    with suppress(SpecError):
        was = read_baseline(file)
        differences, drifts = compare(was, now)
        verdict = Verdict("spoon.toml", DRIFTED, tuple(differences), tuple(drifts))
        if drifts:
            print_verdicts(Printer(stream=io.StringIO()), [verdict], [])
            write_junit(io.StringIO(), [verdict])
            json.dumps(check_dataset([verdict], 1e-10).document(), allow_nan=False)
        was.document()
