"""What a sweep refuses before anything is solved."""

import io

import numpy as np
import pytest
import typer

import chutecalc
from chutecalc.cli import main
from chutecalc.errors import UsageError
from chutecalc.studies.friction.study import FrictionStudy
from chutecalc.studies.sweep import sweep as rows_of
from chutecalc.studies.sweep.parameters import read_parameters
from tests.cli.sweep.commands import BOTH, HOOD, SPOON, VEE, refused, written

CURVES = {
    "segments": [
        {"kind": "curve", "radius_m": 2.0, "to_slope_deg": 30.0},
        {"name": "last", "kind": "curve", "radius_m": 3.0, "to_slope_deg": 20.0},
    ]
}


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["radius", SPOON], "has no values"),
        (["xyz=1", SPOON], "xyz: it is neither a short name (beta, delta, phi, rate, radius, base) nor a path"),
        (["radius_kg=1", SPOON], "radius_kg: _kg is not a unit of length. Use radius_m or radius_mm or radius_in or"),
        (["drop_m=1,2", SPOON], "drop_m: name the whole path, segments.fall.drop_m."),
        (["rad=1", SPOON], "rad: did you mean radius?"),
        (["base=1", VEE], "base: the spec has no base_m in its sections. Use the path of another number"),
        (
            ["delta=30,40", BOTH],
            "delta: material.pressure_ratio sets K_v, whatever δ is. Vary that, or remove",
        ),
        (["delta_rad=0.5,0.6", BOTH], "material.pressure_ratio sets K_v"),
        (["radius=1,2", CURVES], "the spec has several. Use segments.curve.radius_m or segments.last.radius_m"),
        (["radius=a:b", SPOON], "is not a range"),
        (["radius=1:2:0", SPOON], "radius: the step must not be 0."),
        (["radius=1:2:-1", SPOON], "does not lead from 1 to 2. Use a step of 1."),
        (["radius=2:1:0.5", SPOON], "does not lead from 2 to 1. Use a step of -0.5."),
        (["radius=1:2:#0", SPOON], "is not a count"),
        (["radius=nan", SPOON], "is not a number"),
        (["radius=0:1e9:1e-9", SPOON], "the limit is 10,000,000"),
        (["radius=1", "radius=2", SPOON], "given twice"),
        (["radius=1", "segments.spoon.radius_m=2", SPOON], "given twice, as radius_m and as segments.spoon.radius_m"),
        (["radius=1", "segments.spoon.radius_mm=2", SPOON], "given twice"),
        (["segments.spoon.kind=1,2", SPOON], "segments.2.kind"),
        (["segments.1.onto_next=1,2", SPOON], "segments.1.onto_next"),
        (["title=1,2", SPOON], "neither a short name"),
        (["material.name=1,2", SPOON], "material.name = 1 to 2 cannot be varied"),
        (["model.friction_law=1,2", SPOON], "model.friction_law"),
        ([SPOON], "nothing is varied"),
        (["beta", SPOON, HOOD], "one spec"),
        (["phi=20"], "without a spec"),
        (["beta", "--zip"], "--zip"),
        (["beta", "--stations", "0"], "--stations"),
        (["beta", SPOON, "--area", "0.1"], "--area"),
        (["beta", SPOON, "--phi", "0"], "--phi belongs to the friction study"),
        (["beta", SPOON, "--base", "0"], "--base belongs to the friction study"),
        (["beta", SPOON, "--keep", "width"], "--keep width needs sections.spoon.chamfer_m. Add it to the spec"),
        (["beta", VEE, "--keep", "depth"], "--keep depth cannot be used with sections.flanks: its shape is vee"),
        (["radius=1,2", SPOON, "--keep", "width"], "while a chamfer angle varies. Add one, such as beta=15:90:5"),
        (["base=0.3,0.4", SPOON, "--keep", "width"], "while a chamfer angle varies. Add one, such as beta=15:90:5"),
        (["rate=1,2", VEE, "--keep", "width"], "--keep width needs a section of shape chamfered, and the spec has"),
        (["beta", SPOON, "--columns", "exit_velocity"], "Did you mean exit_velocity_m_s?"),
        (["beta", SPOON, "--columns", "receiver_velocity_ratio"], "no [receiver]"),
        (["beta", SPOON, "--top", "3"], "--top needs --by, such as --by exit_velocity_m_s:max."),
        (["beta", SPOON, "--by", "exit_depth_m:max"], "--by needs --top, such as --top 10."),
        (["beta", SPOON, "--top", "3", "--by", "exit_depth_m"], "--by takes COLUMN:max or COLUMN:min"),
        (["beta", SPOON, "--csv", "a.csv", "--csv=b.csv"], "--csv is given twice. Give it once."),
        (["beta", SPOON, "--top", "3", "--by", "status:max"], "numbers"),
        (["beta", SPOON, "--top", "3", "--by", "depth_m:max", "--points", "3"], "--top selects designs"),
        (["beta", SPOON, "--points", "3", "--columns", "exit_depth_m"], "Use the columns of a station"),
        (["beta", SPOON, "--points", "3", "--stations", "1"], "one of them"),
        (["beta", SPOON, "--resume"], "--resume needs --csv, --json or --parquet"),
        (["beta", SPOON, "--csv", "no/such/folder/a.csv"], "no folder"),
        (
            ["beta", SPOON, "--csv", "o", "--json", "./o"],
            "--csv and --json both write to ./o. Give one of them",
        ),
        (["beta", SPOON, "--csv", "-", "--json", "-"], "standard output"),
        (["beta", SPOON, "--parquet", "-"], "standard output"),
        (["beta", "radius=1,2", "rate=1,2", SPOON, "--plot", "a.svg"], "one or two parameters"),
        (["beta", "nowhere.toml"], "no such file"),
    ],
)
def test_what_is_refused_before_anything_is_solved(arguments, words, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("chutecalc.api.solve.run_chain", lambda *_: 1 / 0)
    with_tables = [written(tmp_path, **word) if isinstance(word, dict) else word for word in arguments]
    before = list(tmp_path.iterdir())
    assert words in refused(capsys, *with_tables)
    assert list(tmp_path.iterdir()) == before


def test_all_values_out_of_bounds_are_told_at_once(capsys, monkeypatch):
    monkeypatch.setattr("chutecalc.api.solve.run_chain", lambda *_: 1 / 0)
    message = refused(capsys, "radius=-1:3:1", "phi=20:95:5", "flow.rate_t=1", "segments.spool.radius_m=1", SPOON)
    for words in ("radius_m = -1 to 3", "at most 85", "not end in a unit that fits", "segments has no item 'spool'"):
        assert words in message


def test_a_tolerance_that_cannot_be_is_refused_at_once():
    chute = chutecalc.load(SPOON)
    with pytest.raises(chutecalc.UsageError, match="rtol must be from"):
        rows_of.Sweep(chute, read_parameters(["phi=20,25"], chute), rtol=0.5)


def test_a_key_that_a_chosen_case_sets_is_refused() -> None:
    """A row with the rate of the sweep in its column, and solved at the rate of the case, would state what is not."""
    cases = '[cases.surge]\n"flow.rate_t_h" = 1500\n[cases.slow]\n"inlet.velocity_m_s" = 2'
    chute = chutecalc.parse(chutecalc.STARTER + cases)
    (rate,) = read_parameters(["flow.rate_kg_s=100,200"], chute)
    for names, clash in ("surge,slow", True), ("design,slow", False):
        (case,) = read_parameters([f"case={names}"], chute)
        if clash:
            with pytest.raises(UsageError, match=r"flow\.rate_kg_s: case surge sets it too"):
                rows_of.Sweep(chute, [case, rate])
        else:
            assert rows_of.Sweep(chute, [case, rate]).count == 4


def no_answer(*_args, **_more):
    raise typer.Abort


def test_a_huge_grid_is_asked_for(capsys, monkeypatch):
    asked = []
    monkeypatch.setattr("sys.stdin.isatty", lambda: True, raising=False)
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    monkeypatch.setattr("chutecalc.cli.sweep.CONFIRMED_ABOVE", 3)
    monkeypatch.setattr("typer.confirm", lambda text, **_: asked.append(text))
    assert main(["sweep", "phi=20:30:1", SPOON]) == 2
    assert "11 designs" in asked[0]
    monkeypatch.setattr("typer.confirm", no_answer)
    assert main(["sweep", "phi=20:30:1", SPOON]) == 2
    assert "nothing was solved" in capsys.readouterr().err
    assert main(["sweep", "phi=20:30:1", SPOON, "--yes"]) == 0
    assert len(asked) == 1


def test_a_huge_grid_needs_a_yes_where_nobody_can_be_asked(capsys, monkeypatch):
    monkeypatch.setattr("chutecalc.cli.sweep.CONFIRMED_ABOVE", 3)
    for stdin in (io.StringIO(), None):
        monkeypatch.setattr("sys.stdin", stdin)
        assert main(["sweep", "phi=20:30:1", SPOON]) == 2
        assert "11 designs. Add --yes if so many are meant." in capsys.readouterr().err


def test_a_friction_study_has_as_many_rows_as_fit_into_memory():
    with pytest.raises(UsageError, match="make 10,000,000 rows, and at most 1,000,000 are allowed"):
        FrictionStudy(np.linspace(1.0, 90.0, 100_000), np.linspace(30.0, 55.0, 100))
