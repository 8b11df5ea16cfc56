"""Every output format is an option of every command with results, and means the same in each of them."""

import csv
import io
import json
import math

import numpy as np
import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.errors import ExitStatus, UsageError
from chutecalc.output.dataset import Dataset, block_of
from chutecalc.output.formats import output_formats
from chutecalc.results.columns import COLUMNS
from tests.conftest import ROOT

SPOON = str(ROOT / "specs/paper/r3_d55_chamfered.toml")
STALL = str(ROOT / "specs/fails/stall.toml")
COMMANDS = {
    "run": ["run", SPOON, "--points", "4"],
    "sweep": ["sweep", "phi=20,25,44", SPOON],
    "profiles": ["sweep", "phi=20,44", SPOON, "--points", "3"],
    "friction study": ["sweep", "beta=0,45,90", "delta=30,50", "--keep", "width"],
    "check": ["check", str(ROOT / "specs/fails")],
}


@pytest.mark.parametrize("command", ["run", "sweep", "check", "dem"])
def test_help_lists_every_format(command, capsys):
    assert main([command, "--help"]) == 0
    shown = capsys.readouterr().out
    for name, form in output_formats().items():
        assert f"--{name} FILE" in shown
        assert form.help.split(";")[0].split(" (")[0] in shown


@pytest.mark.parametrize("command", COMMANDS.values(), ids=COMMANDS)
def test_csv_and_parquet_have_the_same_rows(command, tmp_path, capsys):
    parquet = pytest.importorskip("pyarrow.parquet")
    files = [str(tmp_path / f"rows.{name}") for name in ("csv", "parquet")]
    assert main([*command, "--csv", files[0], "--parquet", files[1]]) == 0
    assert capsys.readouterr().out
    with open(files[0], encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    typed = parquet.read_table(files[1]).to_pylist()
    assert len(rows) == len(typed) > 0
    for row, values in zip(rows, typed, strict=True):
        assert row == {name: "" if value is None else str(value) for name, value in values.items()}


@pytest.mark.parametrize("command", COMMANDS.values(), ids=COMMANDS)
def test_csv_and_excel_have_the_same_rows(command, tmp_path, capsys):
    openpyxl = pytest.importorskip("openpyxl")
    files = [str(tmp_path / f"rows.{name}") for name in ("csv", "xlsx")]
    assert main([*command, "--csv", files[0], "--xlsx", files[1]]) == 0
    with open(files[0], encoding="utf-8", newline="") as stream:
        names, *rows = csv.reader(stream)
    sheet = openpyxl.load_workbook(files[1]).worksheets[-1]
    heading, *typed = sheet.iter_rows(values_only=True)
    assert list(heading) == names
    assert len(rows) == len(typed) > 0
    for row, values in zip(rows, typed, strict=True):
        for text, value in zip(row, values, strict=True):
            same = math.isclose(float(text), value, rel_tol=1e-15) if isinstance(value, int | float) else text == value
            assert same or (not text and value is None), (text, value)


def test_excel_files_are_the_same_bytes_each_time_and_keep_text_text(tmp_path):
    formula = '=HYPERLINK("x")'
    dataset = Dataset("run", {"name": str, "x_m": float}, [{"name": np.array([formula]), "x_m": np.array([np.inf])}])
    written = []
    for _ in range(2):
        stream = io.BytesIO()
        rows = output_formats()["xlsx"].rows(stream, dataset)
        for block in dataset.blocks:
            rows.write(block)
        rows.close()
        written.append(stream.getvalue())
    assert written[0] == written[1]
    openpyxl = pytest.importorskip("openpyxl")
    cells = list(openpyxl.load_workbook(io.BytesIO(written[0])).active.iter_rows())[1]
    assert [(cell.value, cell.data_type) for cell in cells] == [(formula, "s"), ("inf", "s")]


def workbook(arguments, tmp_path):
    """Return the sheets of a run by name, each as a list of rows."""
    openpyxl = pytest.importorskip("openpyxl")
    file = tmp_path / "run.xlsx"
    assert main(["run", *arguments, "--xlsx", str(file)]) in (0, 1)
    return {sheet.title: list(sheet.iter_rows(values_only=True)) for sheet in openpyxl.load_workbook(file).worksheets}


def records(rows):
    heading, *below = rows
    return [dict(zip(heading, row, strict=True)) for row in below]


def test_a_run_is_a_workbook(tmp_path, capsys):
    sheets = workbook([SPOON, "--columns", "s_m,velocity_m_s,depth_m"], tmp_path)
    assert list(sheets) == ["inputs", "segments", "findings", "stations"]
    given = {row["key"]: row for row in records(sheets["inputs"])}
    assert given["segments.spoon.radius_m"]["value"] == 3
    assert given["segments.spoon.radius_m"]["unit"] == "m"
    assert given["segments.fall.kind"]["value"] == "fall"
    assert all(row["meaning"] for row in given.values())
    assert sheets["segments"][0] == ("segment", "kind", "at", "s, m", "velocity, m/s", "depth, m")
    spoon = [row for row in records(sheets["segments"]) if row["segment"] == "spoon"]
    assert [row["at"] for row in spoon] == ["in", "out", "min", "max"]
    solution = chutecalc.solve(chutecalc.load(SPOON))
    result = solution.segments["spoon"]
    for row, numbers in zip(spoon, (result.entry, result.exit, result.minimum, result.maximum), strict=True):
        assert row["velocity, m/s"] == pytest.approx(numbers["velocity_m_s"][0], rel=1e-15)
    found = records(sheets["findings"])
    assert [row["message"] for row in found] == [finding.message() for finding in solution.findings()]
    (cut_off,) = (row for row in found if row["code"] == "below_cut_off")
    assert (cut_off["severity"], cut_off["segment"], cut_off["case"]) == ("warning", "spoon", "design")
    assert cut_off["s, m"] == pytest.approx(result.exit["s_m"][0])
    numbers = next(finding.numbers for finding in solution.findings() if finding.code == "below_cut_off")
    assert {name: cut_off[name] for name in numbers} == {name: pytest.approx(numbers[name][0]) for name in numbers}
    assert len(sheets["stations"]) == 1 + 2 * 101


def test_cases_have_a_sheet_and_tell_their_findings(tmp_path, capsys):
    sheets = workbook([str(ROOT / "specs/transfer_90.toml")], tmp_path)
    cases = records(sheets["cases"])
    assert [row["case"] for row in cases] == ["design", "dry", "wet", "surge", "slow_belt", "worst"]
    states = chutecalc.solve_cases(chutecalc.load(ROOT / "specs/transfer_90.toml"))
    assert [row["max depth, m"] for row in cases[:-1]] == pytest.approx(list(states.numbers["max_depth_m"][:, 0]))
    assert cases[-1]["max depth, m"] == states.worst["max_depth_m"][0]
    assert {row["case"] for row in records(sheets["findings"])} > {"design", "surge"}
    given = {row["key"]: row["value"] for row in records(sheets["inputs"])}
    assert given["cases.surge.flow.rate_t_h"] == 2200
    assert given["inlet.belt.velocity_m_s"] == 3.5
    assert given["segments.hood.start_m"] == "0.22, 0.69"
    assert given["segments.drop.onto_next"] is True
    alone = workbook([str(ROOT / "specs/transfer_90.toml"), "--case", "surge"], tmp_path)
    assert {row["key"]: row["value"] for row in records(alone["inputs"])}["flow.rate_t_h"] == 2200


def test_rows_of_several_specs_say_which(tmp_path, capsys):
    sheets = workbook([SPOON, STALL, str(ROOT / "specs/transfer_90.toml")], tmp_path)
    for name in ("inputs", "segments", "findings"):
        assert list(dict.fromkeys(row[0] for row in sheets[name]))[:3] == ["spec", SPOON, STALL]
    assert {row["spec"] for row in records(sheets["cases"])} == {str(ROOT / "specs/transfer_90.toml")}
    for name, rows in sheets.items():
        assert len(set(rows[0])) == len(rows[0]), name


def test_other_commands_have_one_sheet(tmp_path, capsys):
    openpyxl = pytest.importorskip("openpyxl")
    file = tmp_path / "sweep.xlsx"
    assert main(["sweep", "phi=20,25", SPOON, "--xlsx", str(file)]) == 0
    assert openpyxl.load_workbook(file).sheetnames == ["rows"]


def test_a_sheet_has_an_end(monkeypatch):
    monkeypatch.setattr("chutecalc.output.formats.xlsx.ROWS_OF_A_SHEET", 3)
    rows = output_formats()["xlsx"].rows(io.BytesIO(), Dataset("run", {"x_m": float}, []))
    rows.write({"x_m": np.zeros(2)})
    with pytest.raises(UsageError, match="use --csv or --parquet"):
        rows.write({"x_m": np.zeros(1)})


@pytest.mark.parametrize("command", COMMANDS.values(), ids=COMMANDS)
@pytest.mark.parametrize("name", [name for name, form in output_formats().items() if form.standard_output])
def test_data_on_standard_output_stand_there_alone(command, name, tmp_path, capsys):
    target = tmp_path / f"data.{name}"
    assert main([*command, f"--{name}", str(target)]) == 0
    capsys.readouterr()
    assert main([*command, f"--{name}", "-"]) == 0
    assert capsys.readouterr().out == target.read_bytes().decode()


@pytest.mark.parametrize("command", COMMANDS.values(), ids=COMMANDS)
def test_what_cannot_go_to_standard_output_is_refused(command, capsys):
    assert main([*command, "--parquet", "-"]) == ExitStatus.USAGE
    shown = capsys.readouterr()
    assert "cannot go to standard output: name a file, or use --csv or --json" in shown.err
    assert shown.out == ""


def test_each_drift_of_a_check_is_a_row(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "spoon.toml").write_text(chutecalc.STARTER, encoding="utf-8")
    assert main(["check", "--update"]) == 0
    text = (tmp_path / "spoon.baseline.toml").read_text(encoding="utf-8")
    (tmp_path / "spoon.baseline.toml").write_text(text.replace("velocity_m_s = 6.", "velocity_m_s = 6.1", 1))
    assert main(["check", "--json", "check.json", "--csv", "check.csv"]) == 1
    (design,) = json.loads((tmp_path / "check.json").read_text(encoding="utf-8"))["designs"]
    rows = list(csv.DictReader(io.StringIO((tmp_path / "check.csv").read_bytes().decode())))
    assert len(rows) == len(design["drifts"]) > 0
    for row, drift in zip(rows, design["drifts"], strict=True):
        assert (row["spec"], row["outcome"]) == ("spoon.toml", "drifted")
        assert {name: row[name] for name in drift} == {
            name: "" if value is None else str(value) for name, value in drift.items()
        }


@pytest.mark.parametrize("name", COMMANDS)
def test_parquet_says_what_was_asked_and_the_unit_of_each_column(name, tmp_path, capsys):
    parquet = pytest.importorskip("pyarrow.parquet")
    file, document = tmp_path / "rows.parquet", tmp_path / "rows.json"
    main([*COMMANDS[name], "--parquet", str(file), "--json", str(document)])
    schema = parquet.read_schema(file)
    told = json.loads(schema.metadata[b"chutecalc"])
    written = json.loads(document.read_text(encoding="utf-8"))
    assert {key: told[key] for key in told if key != "specs"} == {key: written[key] for key in told if key != "specs"}
    assert told["chutecalc"] == chutecalc.__version__
    if name == "run":
        assert told["specs"] == [{"source": SPOON, "spec": chutecalc.load(SPOON).data}]
    units = {field.name: (field.metadata or {}).get(b"unit", b"").decode() for field in schema}
    for column in {*units} & {*COLUMNS}:
        assert units[column] == COLUMNS[column].unit_text("metric")
    assert units.get("phi_deg", "°") == units.get("friction_deg", "°") == "°"
    assert units.get("status", "") == units.get("equivalent_friction", "") == ""
    assert parquet.read_table(file).num_rows


TYPES = {"name": str, "count": int, "x_m": float}


@pytest.mark.parametrize("form", output_formats().values(), ids=output_formats())
@pytest.mark.parametrize("rows", [[], [{}], [{"name": 'μ, "e"\n', "count": 2, "x_m": math.inf}, {"x_m": 0.1}]])
def test_every_format_takes_every_kind_of_column_and_no_rows_too(form, rows):
    if form.extra:
        pytest.importorskip(form.extra.library.lower())
    stream = io.BytesIO() if form.binary else io.StringIO()
    writer = form.rows(stream, Dataset("run", TYPES, []))
    for row in rows:
        writer.write(block_of([row], TYPES))
    writer.close()
    assert stream.getvalue()


def test_missing_values_of_a_block():
    block = block_of([{"x_m": None}, {"name": "a", "count": 3, "x_m": 2.5}], TYPES)
    assert [values.dtype.kind for values in block.values()] == ["U", "i", "f"]
    assert block["name"].tolist() == ["", "a"]
    assert block["count"].tolist() == [0, 3]
    assert np.array_equal(block["x_m"], [math.nan, 2.5], equal_nan=True)


def test_help_says_what_each_exit_status_means(capsys):
    assert main(["--help"]) == 0
    shown = capsys.readouterr().out
    for status in ExitStatus:
        assert f"{status.value}  {status.meaning}\n" in shown
    assert all(len(line) <= 80 for line in shown.splitlines())


def test_a_name_too_long_for_the_file_that_is_written_first_is_found_before_the_work(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("chutecalc.api.solve.solve", lambda *_: pytest.fail("solved"))
    assert main(["run", SPOON, "--csv", str(tmp_path / ("x" * 250))]) == ExitStatus.USAGE
    assert "cannot be written: File name too long" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
