"""Parameters whose values are names: of liners, sections, laws, kinds and cases."""

import json

import numpy as np
import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.studies.sweep import sweep as rows_of
from chutecalc.studies.sweep.parameters import read_parameters
from chutecalc.studies.sweep.solved_blocks import solve_block
from chutecalc.studies.sweep.table import column_of
from chutecalc.studies.sweep.text_parameter import TextParameter
from tests.cli.sweep.commands import HOOD, LINERS, refused, swept
from tests.conftest import ROOT


def test_a_grid_of_names_and_numbers_is_its_rows_one_by_one(capsys):
    rows = swept(capsys, LINERS[0], "rate=1000,1500", LINERS[1], HOOD)
    assert [tuple(row.values())[:3] for row in rows] == [
        (spoon, rate, hood)
        for spoon in ("steel", "ceramic")
        for rate in ("1000.0", "1500.0")
        for hood in ("ceramic", "steel")
    ]
    for row in rows:
        changes = {path: float(row[path]) if path == "rate_t_h" else row[path] for path in list(row)[:3]}
        changes["flow.rate_t_h"] = changes.pop("rate_t_h")
        alone = chutecalc.solve(chutecalc.load(HOOD).vary(changes))
        assert float(row["exit_velocity_m_s"]) == alone.exit_velocity[0]
    assert len({row["exit_velocity_m_s"] for row in rows}) == 8


def test_names_side_by_side(capsys):
    grid = {tuple(row.values())[:3]: row for row in swept(capsys, *LINERS, "rate=1000,1500", HOOD)}
    rows = swept(capsys, "--zip", *LINERS, "rate=1500", HOOD)
    assert [tuple(row.values())[:3] for row in rows] == [("steel", "ceramic", "1500.0"), ("ceramic", "steel", "1500.0")]
    assert all(row == grid[tuple(row.values())[:3]] for row in rows)
    assert "equal length" in refused(capsys, "--zip", LINERS[0], "rate=1,2,3", HOOD)


def test_names_of_laws_sections_and_kinds(capsys):
    for argument in ("model.friction_law=paper,equilibrium", "segments.spoon.section=hood,spoon"):
        rows = swept(capsys, argument, HOOD)
        path, names = argument.split("=")
        for row, name in zip(rows, names.split(","), strict=True):
            alone = chutecalc.solve(chutecalc.load(HOOD, {path: name}))
            assert (row[path], float(row["exit_velocity_m_s"])) == (name, alone.exit_velocity[0])
    kinds = swept(capsys, "segments.spoon.kind=curve,hood", HOOD)  # it flattens, which a hood cannot
    assert [row["status"] for row in kinds] == ["ok", "impossible"]


def test_true_and_false_are_swept_like_names(capsys):
    ledge, path = str(ROOT / "specs" / "short_ledge.toml"), "segments.ledge.may_be_passed"
    rows = swept(capsys, f"{path}=true,false", ledge)
    assert [(row[path], row["status"]) for row in rows] == [("true", "ok"), ("false", "missed")]
    assert chutecalc.solve(chutecalc.load(ledge).vary({path: False})).status[0] == "missed"
    assert "must be true or false" in refused(capsys, f"{path}=yes,no", ledge)
    assert "is not a number" in refused(capsys, "segments.hood.radius_m=true,false", HOOD)


def test_headings_of_points_name_the_axis():
    chute = chutecalc.load(HOOD)
    sweep = rows_of.Sweep(chute, read_parameters(["rate=1000,1500"], chute))
    headings = {
        "segments.spoon.start_m.2": "spoon start z, m",
        "receiver.at_mm.1": "at x, mm",
        "liners.wall.yield_locus_kpa.1.2": "wall yield locus 1 2, kPa",
        "segments.2.radius_m": "2 radius, m",
    }
    assert {name: column_of(sweep, name).label("metric") for name in headings} == headings


def test_wrong_names_stop_a_sweep_before_it_starts(capsys, monkeypatch):
    monkeypatch.setattr("chutecalc.api.solve.run_chain", lambda *_: 1 / 0)
    message = refused(capsys, "segments.spoon.liner=steel,cermic", "model.friction_law=papr", "rate=-1,2", HOOD)
    assert 'segments.3.liner = "cermic" names cermic, which is not defined' in message
    assert "model.friction_law" in message
    message = refused(capsys, "segments.spoon.liner=steel,cermic", "rate=-1,2", HOOD)
    for words in ("cermic", "flow.rate_t_h = -1 to 2 must be at least 0.001 t/h"):
        assert words in message
    assert "is not a number" in refused(capsys, "segments.spoon.radius_m=two", HOOD)
    assert "is not a number" in refused(capsys, "segments.spoon.radius_m=1,steel", HOOD)
    assert "has no item" in refused(capsys, "segments.spon.liner=steel", HOOD)
    twice = refused(capsys, "segments.spoon.liner=steel,ceramic", "segments.3.liner=steel", HOOD)
    assert "is given twice, also as segments.spoon.liner" in twice
    assert "width_m = 1.0 is not a key of this table" in refused(capsys, "sections.hood.shape=rectangular,vee", HOOD)


def test_names_with_a_chamfer_that_is_adjusted(capsys):
    arguments = ("beta=30,45", "--keep", "width", HOOD)
    rows = swept(capsys, "segments.hood.liner=steel,ceramic", *arguments)
    for liner in ("steel", "ceramic"):
        own = [row for row in rows if row["segments.hood.liner"] == liner]
        alone = swept(capsys, f"segments.hood.liner={liner}", *arguments)
        assert own == alone
    assert len({row["exit_velocity_m_s"] for row in rows}) == 4


def test_names_in_every_format_and_resumed(capsys, tmp_path, monkeypatch):
    parquet = pytest.importorskip("pyarrow.parquet")
    arguments = [LINERS[0], "rate=1000,1500", HOOD]
    files = {kind: tmp_path / f"rows.{kind}" for kind in ("csv", "parquet", "json")}
    outputs = [word for kind, file in files.items() for word in (f"--{kind}", str(file))]
    monkeypatch.setattr("chutecalc.studies.sweep.block_store.BlockStore.remove", lambda self: None)
    assert main(["sweep", *arguments, *outputs]) == 0
    document = json.loads(files["json"].read_text(encoding="utf-8"))
    assert [row["segments.spoon.liner"] for row in document["rows"]] == ["steel", "steel", "ceramic", "ceramic"]
    assert document["parameters"][0] == {"name": "segments.spoon.liner", "paths": ["segments.spoon.liner"], "values": 2}
    assert document["rows"] == parquet.read_table(files["parquet"]).to_pylist()
    first = files["csv"].read_bytes()
    capsys.readouterr()
    other = ["segments.spoon.liner=ceramic,steel", *arguments[1:]]
    assert "differs in the parameters" in refused(capsys, *other, "--csv", str(files["csv"]), "--resume")
    monkeypatch.setattr("chutecalc.api.solve.run_chain", lambda *_: 1 / 0)  # all blocks are there
    assert main(["sweep", *arguments, "--csv", str(files["csv"]), "--resume"]) == 0
    assert files["csv"].read_bytes() == first


def test_names_may_stand_for_several_keys_at_once():
    states = {"dry": {"flow.rate_t_h": 1000.0}, "wet": {"flow.rate_t_h": 1200.0, "liners.steel.friction_deg": 30.0}}
    case = TextParameter("case", np.array(list(states)), lambda chute, name: chute.put(states[name]))
    (radius,) = read_parameters(["segments.spoon.radius_m=2,3"], chute := chutecalc.load(HOOD))
    sweep = rows_of.Sweep(chute, [radius, case])
    block = solve_block(sweep, 0)
    assert block["case"].tolist() == ["dry", "wet", "dry", "wet"]
    for k, name in enumerate(block["case"].tolist()):
        alone = chutecalc.solve(chute.put(states[name] | {"segments.spoon.radius_m": [2.0, 3.0][k // 2]}))
        assert block["exit_velocity_m_s"][k] == alone.exit_velocity[0]
    assert column_of(sweep, "case").heading == "case"
