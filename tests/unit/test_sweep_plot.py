"""Pictures of sweeps: titles, lines, contours, and how designs that fail are shown."""

import io

import numpy as np
import pytest

import chutecalc
from chutecalc.output.plots.save import save
from chutecalc.studies.sweep.parameters import read_parameters
from chutecalc.studies.sweep.plot import draw_sweep, picture_title
from chutecalc.studies.sweep.solved_blocks import solve_block
from chutecalc.studies.sweep.sweep import Sweep
from tests.conftest import ROOT

SPOON = "paper/r3_d55_chamfered"


def sweep_of(name, *arguments, **options):
    loaded = chutecalc.load(ROOT / "specs" / f"{name}.toml")
    return Sweep(loaded, read_parameters(list(arguments), loaded), **options)


def drawn(sweep, units="metric"):
    block = solve_block(sweep, 0)
    figure = draw_sweep(sweep, block, units)
    return figure, {axes.get_gid(): axes for axes in figure.axes if axes.get_gid()}, block


def legend(figure):
    return [text.get_text() for each in figure.legends for text in each.get_texts()]


@pytest.mark.parametrize(
    ("arguments", "title"),
    [
        (["radius=1,2"], "Paper, worked example, δ = 55°, 45° chamfers — varied: radius"),
        (["beta=30,60"], "Paper, worked example, R = 3 m, δ = 55° — varied: chamfer angle β"),
        (["rate=500,900"], "Paper, worked example: R = 3 m, δ = 55°, 45° chamfers — varied: rate"),
        (["radius=2", "delta=30,40"], "Paper, worked example, 45° chamfers — varied: internal friction δ"),
    ],
)
def test_a_title_states_no_value_that_is_not_that_of_the_designs(arguments, title):
    assert picture_title(sweep_of(SPOON, *arguments)) == title
    assert drawn(sweep_of(SPOON, *arguments))[0].get_suptitle() == title


def test_a_value_of_one_is_told_below():
    figure, *_ = drawn(sweep_of(SPOON, "radius=2", "rate=500,900"))
    assert figure.get_supxlabel() == "2 designs: 2 ok; radius = 2 m"


def test_a_varied_quantity_stays_in_its_unit_and_all_else_is_in_us_units():
    sweep = sweep_of(SPOON, "segments.spoon.radius_ft=6:12:#4", columns=["exit_velocity_m_s", "max_pressure_kpa"])
    _, axes, block = drawn(sweep, "us")
    assert {name: each.get_ylabel() for name, each in axes.items()} == {
        "exit_velocity_m_s": "exit velocity v, fpm",
        "max_pressure_kpa": "max pressure p, psf",
    }
    for name, to_us in (("exit_velocity_m_s", 60.0 / 0.3048), ("max_pressure_kpa", 1000.0 / 47.88025898)):
        (line,) = [each for each in axes[name].lines if each.get_gid() == "line"]
        assert axes[name].get_xlabel() == "spoon radius, ft"
        assert np.array_equal(line.get_xdata(), [6.0, 8.0, 10.0, 12.0])
        assert np.allclose(line.get_ydata(), block[name] * to_us, rtol=1e-9)


def test_designs_that_fail_are_marked_by_status_above_the_lines():
    sweep = sweep_of("fails/choke", "phi=20,25,30,40", "rate=500,3000", columns=["exit_velocity_m_s"])
    figure, axes, block = drawn(sweep)
    marks = {line.get_gid(): line for line in axes["exit_velocity_m_s"].lines if line.get_gid() != "line"}
    found = set(block["status"]) - {"ok"}
    assert found
    assert set(marks) == found
    assert [text for text in legend(figure) if "=" not in text] == sorted(found)
    assert len({line.get_marker() for line in marks.values()}) == len(found)


def test_contours_are_hatched_by_status_with_a_legend():
    sweep = sweep_of(SPOON, "phi=20:60:#12", "rate=200:4000:#12", columns=["exit_velocity_m_s"])
    figure, axes, block = drawn(sweep)
    hatches = [each.hatches for each in axes["exit_velocity_m_s"].collections if getattr(each, "hatches", [None])[0]]
    found = [status for status in ("stall", "choke") if status in block["status"]]
    assert found
    assert len(hatches) == len(found)
    assert len({tuple(each) for each in hatches}) == len(found)
    assert legend(figure) == found
    save(figure, io.BytesIO(), "svg")


def test_hatching_begins_where_the_contours_end():
    sweep = sweep_of(SPOON, "phi=20:60:#9", "rate=500:1500:#9", columns=["exit_velocity_m_s"])
    _, axes, block = drawn(sweep)
    failing = block["phi" if "phi" in block else "friction_deg"][block["status"] != "ok"].min()
    last = block["friction_deg"][block["status"] == "ok"].max()
    filled = [each for each in axes["exit_velocity_m_s"].collections if getattr(each, "filled", False)]
    hatched = [each for each in filled if each.hatches[0]]
    ends = [path.vertices[:, 0] for each in hatched for path in each.get_paths() if len(path.vertices)]
    assert last < failing
    assert min(each.min() for each in ends) == pytest.approx(last, abs=1e-3)


def test_more_columns_than_panels_are_told():
    columns = [f"{end}_{name}" for end in ("max", "min") for name in ("depth_m", "pressure_kpa", "wear_w_m2", "froude")]
    figure, axes, _ = drawn(sweep_of(SPOON, "rate=500,900", columns=columns))
    assert len(axes) == 6
    assert "drawn are 6 of 8 columns that vary: choose with --columns" in figure.get_supxlabel().replace("\n", " ")


def test_the_same_picture_is_the_same_file():
    def file():
        stream = io.BytesIO()
        save(drawn(sweep_of(SPOON, "phi=20:60:#9", "rate=500:1500:#9"))[0], stream, "svg")
        return stream.getvalue()

    assert file() == file()


def test_cases_stand_side_by_side_under_their_names_and_lines_beside_each_other():
    sweep = sweep_of("transfer_90", "case", "model.friction_law=paper,equilibrium", columns=["exit_velocity_m_s"])
    _, axes, block = drawn(sweep)
    panel = axes["exit_velocity_m_s"]
    assert [text.get_text() for text in panel.get_xticklabels()] == ["design", "dry", "wet", "surge", "slow_belt"]
    assert panel.get_xlim() == (-0.5, 4.5)
    first, second = (line for line in panel.lines if line.get_gid() == "line")
    assert np.allclose(second.get_xdata() - first.get_xdata(), 0.25)  # a quarter of the distance of names
    assert np.allclose(0.5 * (first.get_xdata() + second.get_xdata()), range(5))
    assert np.array_equal(first.get_ydata(), block["exit_velocity_m_s"][block["model.friction_law"] == "paper"])


def test_long_names_slant():
    long = ["ceramic_tiles_of_the_hood", "hardened_steel_of_the_hood", "chromium_carbide_of_the_hood"]
    loaded = chutecalc.load(ROOT / "specs" / "transfer_90.toml")
    liners = loaded.data["liners"] | {name: {"friction_deg": 20.0 + k} for k, name in enumerate(long)}
    named = chutecalc.parse(loaded.data | {"liners": liners})
    parameters = read_parameters([f"segments.hood.liner={','.join(long)}"], named)
    _, axes, _ = drawn(Sweep(named, parameters, columns=["exit_velocity_m_s", "max_depth_m"]))
    assert {text.get_rotation() for text in axes["exit_velocity_m_s"].get_xticklabels()} == {30.0}
