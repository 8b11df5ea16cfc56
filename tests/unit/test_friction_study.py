"""The friction study: its tables to all digits, against formulas written out another way, and what it refuses."""

import csv
import io
import json

import mpmath
import numpy as np
import pytest

from chutecalc.cli.friction import run_friction_study
from chutecalc.cli.outputs import Outputs
from chutecalc.errors import OutputError, UsageError
from chutecalc.output.held import release
from chutecalc.studies.friction.columns import FRICTION_COLUMNS
from chutecalc.studies.friction.study import CHAMFERS, INTERNAL_FRICTIONS, FrictionStudy


def run_study(csv=None, json=None, plot=None, units="metric", **given):
    """Run the study as the command does."""
    try:
        return run_friction_study(Outputs(csv=csv, json=json, plot=plot, units=units), **given)
    finally:
        release()


TABLE = [  # equivalent friction at δ = 30, 40, 50, 55° for B or W = 0.5 m, A = 0.05 m², φ = 25°
    ("base", 45, (0.48509, 0.48346, 0.48226, 0.48180)),
    ("base", 85, (0.49426, 0.48476, 0.47779, 0.47508)),
    ("base", 90, (0.49739, 0.48659, 0.47866, 0.47558)),
    ("width", 90, (0.49739, 0.48659, 0.47866, 0.47558)),
    ("depth", 90, (0.49739, 0.48659, 0.47866, 0.47558)),
    ("width", 40, (0.53285, 0.52846, 0.52523, 0.52398)),
    ("width", 60, (0.50214, 0.49591, 0.49135, 0.48957)),
]


@pytest.mark.parametrize(("keep", "beta", "friction"), TABLE)
def test_all_digits_of_the_tables(keep, beta, friction):
    study = FrictionStudy([beta], [30, 40, 50, 55], keep=keep)
    assert [f"{value:.5f}" for value in study.columns["equivalent_friction"]] == [f"{value:.5f}" for value in friction]


def by_the_paper(keep, beta, delta, width, area, phi):
    """B, C, H and μ_e by the formulas as printed, in 40 digits: C first, then Equation 11."""
    mpmath.mp.dps = 40
    beta, delta, phi = (mpmath.radians(angle) for angle in (beta, delta, phi))
    width, area = mpmath.mpf(width), mpmath.mpf(area)
    s, c = mpmath.sin(beta), mpmath.cos(beta)
    if keep == "base":
        base = width
        wetted = (-base / c + mpmath.sqrt((base / c) ** 2 + 4 * area / (s * c))) / 2
    elif keep == "width":
        wetted = 2 * (area / s) / (width + mpmath.sqrt(width**2 - 4 * (area / s) * c))
        base = width - 2 * wetted * c
    else:
        wetted = area / width / s
        base = width - area / width / mpmath.tan(beta)
    ratio = (1 + mpmath.sin(delta) * mpmath.cos(2 * beta)) / (1 + mpmath.sin(delta))
    share = (base + ratio * wetted + (1 - ratio) * wetted * c) / (base + wetted * c)
    return base, wetted, wetted * s, ratio, mpmath.tan(phi) * share


@pytest.mark.parametrize("keep", ["base", "width", "depth"])
def test_every_row_against_the_printed_formulas_in_40_digits(keep):
    angles = [41.0, 52.5, 67.0, 80.0, 89.9]
    study = FrictionStudy(angles, [20.0, 47.0], keep, wall_friction_deg=18.0, base_m=0.8, area_m2=0.1)
    names = ("base_m", "chamfer_wetted_m", "depth_m", "pressure_ratio", "equivalent_friction")
    for row in range(10):
        beta, delta = (study.columns[name][row] for name in ("chamfer_deg", "internal_friction_deg"))
        exact = by_the_paper(keep, beta, delta, 0.8, 0.1, 18.0)
        for name, value in zip(names, exact, strict=True):
            # at 41° in the width study B² is the small difference of 0.64 and 0.46: a digit goes
            assert study.columns[name][row] == pytest.approx(float(value), rel=2e-15, abs=1e-15), (name, beta, delta)


def test_a_row_for_each_pair_material_by_material():
    study = FrictionStudy()
    assert list(study.columns) == list(FRICTION_COLUMNS)
    assert study.columns["chamfer_deg"].tolist() == list(CHAMFERS) * len(INTERNAL_FRICTIONS)
    assert study.columns["internal_friction_deg"].tolist() == [delta for delta in INTERNAL_FRICTIONS for _ in CHAMFERS]


def test_a_flat_plane_has_no_depth_and_its_chamfer_no_length():
    study = FrictionStudy([0], [30], wall_friction_deg=20)
    row = {name: values[0] for name, values in study.columns.items()}
    assert (row["depth_m"], row["base_m"], row["pressure_ratio"], row["status"]) == (0.0, 0.5, 1.0, "ok")
    assert np.isnan(row["chamfer_wetted_m"])
    assert row["equivalent_friction"] == np.tan(np.radians(20))


def test_sections_that_cannot_be_keep_their_rows():
    study = FrictionStudy([30, 45], [30, 55], keep="width")
    assert study.columns["status"].tolist() == ["impossible", "ok"] * 2
    for name in ("base_m", "chamfer_wetted_m", "depth_m", "pressure_ratio", "equivalent_friction"):
        assert np.isnan(study.columns[name]).tolist() == [True, False] * 2
    assert study.line(55)["chamfer_deg"].tolist() == [45.0]


def test_a_wide_centre_section_that_just_vanishes_is_a_vee():
    for beta in range(20, 80, 2):  # B² = 4 A cot β, rounded at 1e-16 of 2500 m²
        area = 2500.0 / 4 * np.tan(np.radians(beta))
        study = FrictionStudy([beta], [30], keep="width", base_m=50.0, area_m2=area)
        assert (study.columns["status"][0], study.columns["base_m"][0]) == ("ok", 0.0), beta


def test_the_better_end_is_told_where_both_are_nearly_equal():
    def off(beta):
        here, end = (by_the_paper("width", angle, 40.0, 0.5, 0.05, 25.0)[-1] for angle in (beta, 90.0))
        return here - end

    even = float(mpmath.findroot(off, (65.0, 75.0), solver="anderson"))
    assert off(even - 1.0) > 0.0 > off(even + 1.0)
    for shift, end in ((-1e-4, 90.0), (1e-4, even + 1e-4)):  # less than the 0.002° or so between two angles
        (best,) = FrictionStudy([even + shift, 90.0], [40.0], keep="width").best()
        assert best.end_deg == end


@pytest.mark.parametrize("keep", ["width", "depth"])
def test_a_centre_section_that_just_vanishes_is_a_vee(keep):
    area = 0.25 / 4 if keep == "width" else 0.25  # of a width of 0.5 m at 45°
    study = FrictionStudy([45], [30], keep=keep, area_m2=area)
    assert study.columns["status"][0] == "ok"
    assert study.columns["base_m"][0] == 0.0


def test_the_best_angle_is_where_the_slope_of_the_friction_is_zero():
    for best in FrictionStudy(keep="width").best():
        off = 1e-3
        low, here, high = FrictionStudy(
            [best.inside_deg - off, best.inside_deg, best.inside_deg + off], [best.internal_friction_deg], keep="width"
        ).columns["equivalent_friction"]
        # the least of angles 0.009° apart: the slope there is at most curvature times that
        assert abs(high - low) / (2 * off) <= 0.009 * (high - 2 * here + low) / off**2 + 1e-9
        assert best.inside_friction == pytest.approx(here, rel=1e-12)
        assert best.end_deg == 90.0
        assert best.end_friction > here


def test_the_best_angle_of_a_range_without_one_is_its_end():
    (best,) = FrictionStudy([20, 60], [30]).best()
    assert np.isnan(best.inside_deg)
    assert (best.end_deg, best.end_friction) == (20.0, FrictionStudy([20], [30]).columns["equivalent_friction"][0])
    (none,) = FrictionStudy([10], [30], keep="width").best()
    assert np.isnan(none.end_deg)
    (single,) = FrictionStudy([50], [30]).best()
    assert single.end_deg == 50.0


def test_of_two_dips_the_lower_one_is_the_best_angle():
    for delta in (60.0, 30.0):  # the second dip is the lower one, and the first
        angles = np.arange(11.5, 90.0, 0.25)  # B² = 1 - 0.2 cot β: there is a section from 11.3° on
        curve = np.array([float(by_the_paper("width", beta, delta, 1.0, 0.05, 25.0)[-1]) for beta in angles])
        inner = curve[1:-1]
        dips = inner[(inner < curve[:-2]) & (inner < curve[2:])]
        assert len(dips) == 2
        assert abs(dips[0] - dips[1]) > 1e-3
        (best,) = FrictionStudy([11.5, 89.5], [delta], "width", base_m=1.0, area_m2=0.05).best()
        assert best.inside_friction == pytest.approx(dips.min(), abs=1e-5)


def test_weak_materials_are_told():
    assert FrictionStudy(internal_friction_deg=[20, 30]).inadmissible() == [20.0]  # atan(sin 30°) = 26.6°


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"beta": [91.0]}, "beta must be from 0 to 90 degrees, not 91"),
        ({"beta": []}, "beta"),
        ({"delta": [30.0, 90.0]}, "delta must be from 0 to 89 degrees, not 90"),
        ({"delta": [float("nan")]}, "delta"),
        ({"phi": -1.0}, "phi"),
        ({"base": 0.0}, "base must be at least 0.001 and at most 100 m, not 0"),
        ({"area": float("inf")}, "area"),
        ({"area": 100001.0}, "area must be at least 1e-06 and at most 10000 m², not 100001"),
        ({"keep": "height"}, "base, width, depth"),
        ({"csv": "-", "json": "-"}, "only one output"),
        ({"plot": "study.txt"}, ".svg, .png or .pdf"),
        ({"plot": "-"}, ".svg, .png or .pdf"),
    ],
)
def test_what_is_refused_and_leaves_nothing(given, words, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(UsageError, match=words.replace("(", ".")):
        run_study(**{"json": "out.json"} | given)
    assert list(tmp_path.iterdir()) == []
    assert capsys.readouterr().out == ""


def test_all_faults_at_once():
    with pytest.raises(UsageError) as caught:
        FrictionStudy([91], [95], base_m=-1)
    assert len(str(caught.value).splitlines()) == 3


def test_an_output_that_cannot_be_opened(tmp_path):
    with pytest.raises(OutputError):
        run_study(csv=str(tmp_path / "no" / "such.csv"))


def test_the_printed_table_leaves_out_what_cannot_be_and_says_so(capsys):
    assert run_study(keep="width") == 0
    out = capsys.readouterr().out
    assert "left out: β = 0° to 35°, 8 of 19 angles" in out
    assert "0.53285" in out
    assert "as in Figure 7" in out
    assert "δ 55°: minimum inside the range at 88.1° (μ_e 0.47549)\n" in out
    assert run_study(delta=[30]) == 0
    assert "δ 30°: no minimum inside the range; lowest at its end, 0.0°" in capsys.readouterr().out
    assert run_study(delta=[20]) == 0
    assert "more than atan(sin δ) for δ = 20°" in capsys.readouterr().out


def test_us_units_are_for_people_only(capsys):
    assert run_study(units="us") == 0
    assert "19.69 in" in capsys.readouterr().out
    assert run_study(units="us", csv="-") == 0
    american = capsys.readouterr().out
    assert run_study(csv="-") == 0
    assert capsys.readouterr().out == american


def test_csv_and_json_hold_every_row(tmp_path, capsys):
    assert run_study(keep="depth", csv=str(tmp_path / "a.csv"), json=str(tmp_path / "a.json")) == 0
    study = FrictionStudy(keep="depth")
    with open(tmp_path / "a.csv", encoding="utf-8", newline="") as stream:
        text = stream.read()
    assert text.count("\r\n") == 1 + 114
    rows = list(csv.DictReader(io.StringIO(text)))
    assert list(rows[0]) == list(FRICTION_COLUMNS)
    assert rows[0]["equivalent_friction"] == ""
    assert rows[0]["status"] == "impossible"
    written = [float(row["equivalent_friction"] or "nan") for row in rows]
    assert np.array_equal(written, study.columns["equivalent_friction"], equal_nan=True)

    document = json.loads((tmp_path / "a.json").read_text(encoding="utf-8"))
    assert (document["command"], document["keep"], document["area_m2"]) == ("friction_study", "depth", 0.05)
    assert document["rows"][0]["base_m"] is None
    assert [row["equivalent_friction"] or np.nan for row in document["rows"]] == pytest.approx(
        study.columns["equivalent_friction"].tolist(), rel=0, abs=0, nan_ok=True
    )
    assert [best["inside_deg"] for best in document["best"]] == [best.inside_deg for best in study.best()]
