"""A study of uncertainty: the same samples for the same seed, failures, states, what is refused."""

import matplotlib
import numpy as np
import pytest

import chutecalc
from chutecalc.errors import SpecError, UsageError
from chutecalc.studies.uncertain import solved_rows
from chutecalc.studies.uncertain.quantiles import quantiles_of
from chutecalc.studies.uncertain.sampling import error_of
from chutecalc.studies.uncertain.state import state_and_keys
from chutecalc.studies.uncertain.statistics import chance_to_end, summary
from tests.conftest import ROOT, chute

KEYS = {"liners.wall.friction_deg": 2, "flow.rate_t_h": {"uniform": [900, 1100]}}
FEW = 256
LUMPS = {"density_kg_m3": 800.0, "internal_friction_deg": 50.0, "lump_mm": 20.0}


def study(uncertainty=KEYS, samples=FEW, seed=1, **tables):
    return chutecalc.uncertain(chute(uncertainty=uncertainty, **tables), samples, seed)


def test_the_same_seed_gives_the_same_numbers_whatever_the_jobs_and_blocks(monkeypatch):
    case = chute(uncertainty=KEYS)
    found = chutecalc.uncertain(case, FEW, seed=3, jobs=1)
    monkeypatch.setattr(solved_rows, "BLOCK", 100)
    again = chutecalc.uncertain(case, FEW, seed=3, jobs=2)
    other = chutecalc.uncertain(case, FEW, seed=4)
    for name, values in (found.values | found.columns).items():
        assert values.tobytes() == (again.values | again.columns)[name].tobytes()
        assert not np.array_equal(values, (other.values | other.columns)[name])
    assert found.indices["exit_depth_m"].total.tobytes() == again.indices["exit_depth_m"].total.tobytes()


def test_samples_are_those_of_vary():
    found = study()
    variants = chute().vary(found.values)
    assert np.array_equal(found.columns["exit_velocity_m_s"], chutecalc.exits(variants).exit["velocity_m_s"])
    assert found.count == FEW
    assert found.ok.all()
    assert set(found.status) == {"ok"}


def test_geometry_is_drawn_anew_for_each_sample():
    spoon = chutecalc.parse(chutecalc.STARTER + '[uncertainty]\n"segments.spoon.radius_m" = 0.3')
    found = chutecalc.uncertain(spoon, FEW)
    exact = chutecalc.solve(spoon.vary(found.values)).exit_velocity
    assert found.columns["exit_velocity_m_s"] == pytest.approx(exact, rel=1e-9)


def test_samples_that_cannot_be_built_are_impossible():
    """Facets go from the centre outwards, none flatter than the one before."""
    facets = [{"slope_deg": 40.0, "length_m": 0.2}, {"slope_deg": 45.0, "length_m": 0.2}]
    keys = {"sections.body.facets.2.slope_deg": {"uniform": [30, 50]}, "flow.rate_t_h": 10}
    found = study(keys, sections={"body": {"shape": "facets", "facets": facets}})
    assert found.chances["impossible"].share == pytest.approx(0.5, abs=1 / 16)
    assert set(found.status) == {"ok", "impossible"}
    assert (found.values["sections.body.facets.2.slope_deg"][found.ok] >= 40.0).all()
    assert found.bands(points=3).samples == found.ok.sum()


def test_a_case_scatters_about_its_own_values():
    tables = {"cases": {"slow": {"inlet.velocity_m_s": 3.0}, "wet": {"liners.wall.friction_deg": 28.0}}}
    case = chute(uncertainty=KEYS, **tables)
    wet = chutecalc.uncertain(case, FEW, case="wet")
    assert np.median(wet.values["liners.wall.friction_deg"]) == pytest.approx(28.0, abs=0.02)
    slow = chutecalc.uncertain(case, FEW, case="slow").summaries["exit_velocity_m_s"]
    assert slow.mean < chutecalc.uncertain(case, FEW).summaries["exit_velocity_m_s"].mean - 0.3


POINTS = [[2, 0.89], [4, 1.55], [8, 3.30]]


@pytest.mark.parametrize(
    "scatter", [{"uniform": [24, 27]}, {"triangular": [22, 25, 29]}, {"shear_test": POINTS}, {"normal": 2}, 3]
)
def test_in_a_case_with_another_value_the_scatter_moves_with_it(scatter):
    path, shares = "liners.wall.friction_deg", np.linspace(0.01, 0.99, 9)
    case = chute(uncertainty={path: scatter}, cases={"wet": {path: 31.0}, "surge": {"flow.rate_t_h": 1200.0}})
    keys = {name: state_and_keys(case, name)[1].keys[0] for name in ("design", "wet", "surge")}
    dry, wet, surge = (quantiles_of(key)(shares) for key in keys.values())
    assert wet == pytest.approx(dry + 6.0, rel=1e-4)  # what a shear test leaves above 90° is cut off in either
    assert np.array_equal(surge, dry)
    assert keys["wet"].parameter.value == 31.0


def test_what_leaves_the_bounds_in_a_case_is_refused_there():
    path = "liners.wall.friction_deg"
    for scatter in ({"uniform": [20, 27]}, 6):
        case = chute(uncertainty={path: scatter}, cases={"slick": {path: 3.0}})
        with pytest.raises(SpecError, match="at least 0° and at most 85°, about the value of case slick"):
            chutecalc.uncertain(case, FEW, case="slick")
        assert case.uncertain.keys


def test_columns_asked_for():
    case = chute(uncertainty=KEYS)
    names = ["min_velocity_m_s", "segments.straight.max_depth_m"]
    found = chutecalc.uncertain(case, FEW, columns=names)
    assert list(found.columns) == names
    assert (found.columns["min_velocity_m_s"] > 0.0).all()


def test_margins_tell_how_near_each_failure_is():
    spoon = {
        "inlet": {"velocity_m_s": 1.0, "slope_deg": 90.0},
        "sections": {"body": {"shape": "rectangular", "width_m": 0.6, "wall_height_m": 0.5}},
        "segments": [
            {"kind": "fall", "onto_next": True},
            {"kind": "straight", "start_m": [-0.5, -2.0], "slope_deg": 60.0, "length_m": 3.0},
        ],
    }
    case = chute(uncertainty=KEYS, **spoon)
    found = chutecalc.uncertain(case, FEW, margins=True)
    margins = [name for name in found.columns if not name.startswith("exit_")]
    landing = "segments.straight.landing_margin_m"
    assert margins == ["min_velocity_m_s", "max_fill", "min_normal_acceleration_m_s2", landing]
    assert found.columns[landing] == pytest.approx(np.full(FEW, 1.0), rel=1e-9)  # 0.5 m at 60 degrees
    assert found.columns["max_fill"] == pytest.approx(
        chutecalc.uncertain(case, FEW, columns=["max_depth_m"]).columns["max_depth_m"] / 0.5
    )
    assert (found.columns["min_velocity_m_s"] > 0.0).all()


def test_warnings_have_the_chance_of_their_findings():
    bounds = {"min_velocity_margin": 3.0, "min_froude": 4.6}
    case = chute(uncertainty=KEYS | {"flow.rate_t_h": {"uniform": [600, 1400]}}, limits=bounds)
    found = chutecalc.uncertain(case, FEW, warnings=True)
    variants = chutecalc.solve(chute(limits=bounds).vary(found.values))
    counts = {finding.code: finding.mask.sum() for finding in variants.findings() if finding.severity == "warning"}
    assert {code: own.share * FEW for code, own in found.warned.items()} == pytest.approx(counts)
    assert any(0 < count < FEW for count in counts.values())
    assert list(found.warned) == sorted(found.warned, key=lambda code: (-counts[code], code))
    assert chutecalc.uncertain(case, FEW).warned is None


def test_a_limit_of_a_column_that_no_sample_has_is_refused():
    with pytest.raises(UsageError, match="has no max_fill in any design that was tried: leave out the limit"):
        chutecalc.uncertain(chute(uncertainty=KEYS), FEW, limits=["max_fill<=0.4"])
    with pytest.raises(UsageError, match="a limit is COLUMN<=VALUE or COLUMN>=VALUE"):
        chutecalc.uncertain(chute(uncertainty=KEYS), FEW, limits=["max_fill<0.4"])
    with pytest.raises(UsageError, match="warnings is no number"):
        chutecalc.uncertain(chute(uncertainty=KEYS), FEW, limits=["warnings<=0"])


def test_where_all_samples_fail_a_limit_has_no_chance_but_all_together_are_sure():
    stalls = chute(uncertainty={"liners.wall.friction_deg": 1}, liners={"wall": {"friction_deg": 70.0}})
    found = chutecalc.uncertain(stalls, FEW, limits=["max_depth_m<=0.3"], warnings=True)
    assert np.isnan(found.exceeded["max_depth_m<=0.3"].share)
    assert found.exceeded["any"].share == found.chances["fails"].share == 1.0
    assert found.warned == {}


def test_keys_that_change_nothing_explain_nothing():
    found = chutecalc.uncertain(
        chute(uncertainty={"limits.max_fill": 0.01, "material.lump_mm": 1}, material=LUMPS), FEW
    )
    assert found.summaries["exit_velocity_m_s"].deviation < 1e-14
    assert not found.indices
    assert "varies" in found.no_indices


def test_indices_are_left_out_where_they_mean_nothing():
    assert "one key alone" in study({"flow.rate_t_h": 10}).no_indices
    pairs = {"correlation": [[*KEYS, 0.5]]}
    correlated = study(KEYS | pairs)
    assert "correlated" in correlated.no_indices
    assert not correlated.indices
    few = chutecalc.uncertain(chute(uncertainty={"liners.wall.friction_deg": 14, "flow.rate_t_h": 1}), 1024)
    assert (few.ends > 0).sum() > 0
    assert "too few" in few.no_indices
    assert not study().no_indices
    missing = chutecalc.uncertain(chute(uncertainty=KEYS), FEW, columns=["max_fill"])
    assert "no column exists" in missing.no_indices
    assert repr(missing) == "<Uncertainty of 256 samples: 0 % fail>"
    assert "max_fill" not in missing._repr_html_()


def test_a_tornado_has_each_key_alone():
    found = study()
    for k, path in enumerate(found.keys.paths):
        for end in (0, 1):
            alone = chute().vary({path: found.tornado.values[k, end]})
            exact = chutecalc.exits(alone).exit["velocity_m_s"][0]
            assert found.tornado.columns["exit_velocity_m_s"][k, end] == exact
    assert found.tornado.order("exit_velocity_m_s") == [0, 1]
    assert found.tornado.spec["exit_velocity_m_s"] == chutecalc.exits(chute()).exit["velocity_m_s"][0]


def test_a_chance_that_no_sample_has_is_limited():
    ends = np.zeros(1024, dtype=np.int8)
    assert chance_to_end(ends, "stall") == (0.0, 0.0, 3.0 / 1024)
    ends[::4] = 1
    ends[1::4] = 2
    assert chance_to_end(ends, "stall") == (0.25, 0.0, 0.25)
    assert chance_to_end(ends, "fails") == (0.5, 0.0, 0.5)


def test_errors_leave_out_replicates_without_a_number():
    assert error_of(np.array([1.0, 3.0, np.nan])) == pytest.approx(1.0)
    assert np.isnan(error_of(np.array([1.0, np.nan])))
    assert np.isnan(summary(np.full(256, np.nan)).mean)


def test_bands_are_quantiles_at_stations():
    found = study()
    bands = found.bands(points=5)
    low, middle, high = bands.quantiles["velocity_m_s"]
    assert bands.segment == ("straight",) * 5
    assert bands.samples == FEW
    assert low[0] == middle[0] == high[0] == 4.0
    assert (low[1:] < middle[1:]).all()
    assert [low[-1], middle[-1], high[-1]] == pytest.approx(found.summaries["exit_velocity_m_s"].quantiles, rel=1e-9)


def test_bands_are_of_those_that_do_not_fail():
    found = study({"liners.wall.friction_deg": {"uniform": [10, 60]}, "flow.rate_t_h": 1}, inlet={"velocity_m_s": 1.0})
    bands = found.bands(points=11)
    assert 0 < bands.samples == found.ok.sum() < FEW
    assert np.isfinite(bands.quantiles["velocity_m_s"]).all()
    none = study({"liners.wall.friction_deg": 1}, liners={"wall": {"friction_deg": 70.0}})
    assert none.bands().samples == 0
    assert np.isnan(none.summaries["exit_velocity_m_s"].mean)
    assert len(none.plot().axes) == 3


def crest(velocity):
    """Return a pipe over a crest, at whose inlet a slow stream follows the floor and a fast one leaves it."""
    over = {"kind": "curve", "name": "bend", "radius_m": 2.0, "to_slope_deg": 80.0}
    down = {"kind": "straight", "name": "down", "slope_deg": 80.0, "length_m": 3.0}
    return study(
        {"inlet.velocity_m_s": {"uniform": velocity}},
        samples=1024,
        sections={"body": {"shape": "pipe", "radius_m": 0.3}},
        inlet={"velocity_m_s": 3.0, "slope_deg": 20.0},
        segments=[over, down],
    )


def test_samples_that_leave_a_surface_have_bands_of_their_own():
    found = crest([2.0, 8.0])
    bands = found.bands()
    assert len(bands.shares) == 3
    assert sum(bands.shares) == pytest.approx(1.0)
    assert bands.shares[0] == max(bands.shares)
    exits = []
    for way in range(3):
        own = np.array(bands.way) == way
        assert (np.diff(bands.s_m[own]) >= 0.0).all()  # the bands of a way go on along the chute
        low, _, high = bands.quantiles["velocity_m_s"][:, own]
        exits.append((low[-1], high[-1]))
    drawn = found.columns["exit_velocity_m_s"]
    assert min(low for low, _ in exits) >= drawn.min()
    assert max(high for _, high in exits) <= drawn.max()
    axes = {each.get_label(): each for each in found.plot().axes}
    assert len(axes["velocity"].get_legend().get_texts()) == 3
    for line in axes["velocity"].lines:
        assert (np.diff(line.get_xdata()) >= 0.0).all()


def test_bands_end_at_the_exit_with_the_quantiles_of_the_report():
    """Also where the stream flies to the mouth from the last surface, and for more samples than the bands once took."""
    found = crest([7.0, 8.0])
    bands = found.bands()
    assert bands.samples == found.count == 1024
    assert bands.shares == (1.0,)
    for name in ("velocity_m_s",):
        expected = found.summaries[f"exit_{name}"].quantiles
        assert bands.quantiles[name][:, -1] == pytest.approx(expected, rel=1e-9)
    assert "bands from all that do not fail" in found.plot().get_supxlabel()


def test_a_picture_says_where_bands_are_of_some_samples_only(monkeypatch):
    monkeypatch.setattr("chutecalc.studies.uncertain.bands.SAMPLES", 4)
    text = study().plot().get_supxlabel()
    assert "bands from the first 64 that do not fail, so that last digits differ" in text


def test_a_picture_has_a_bar_for_each_end_and_the_bands():
    figure = study().plot("us")
    axes = {each.get_label(): each for each in figure.axes}
    assert [bar.get_gid() for bar in axes["tornado"].patches] == ["bar 0", "bar 1"] * 2
    widths = [bar.get_width() for bar in axes["tornado"].patches]
    assert widths[0] > 0.0 > widths[1]  # less friction is faster
    assert axes["tornado"].get_xlabel().endswith("fpm")
    assert [line.get_gid() for line in axes["depth"].lines] == ["median straight"]
    assert isinstance(figure, matplotlib.figure.Figure)


def test_text_and_html():
    found = study()
    assert repr(found).startswith("<Uncertainty of 256 samples: exit_velocity_m_s ")
    assert "<td>exit_depth_m</td>" in found._repr_html_()


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        ({"samples": 100}, "samples must be 256 to"),
        ({"case": "wet"}, "has no case wet"),
        ({"columns": ["findings"]}, "is no number"),
        ({"columns": ["segments.straight.status"]}, "is no number"),
        ({"columns": ["exit_speed"]}, "unknown column"),
        ({"rtol": 1.0}, "rtol"),
    ],
)
def test_what_is_refused(arguments, problem):
    with pytest.raises(UsageError, match=problem):
        chutecalc.uncertain(chute(uncertainty=KEYS), **arguments)


def test_what_is_certain_is_refused():
    with pytest.raises(UsageError, match="does not say what is uncertain"):
        chutecalc.uncertain(chute())
    with pytest.raises(UsageError, match="one design"):
        chutecalc.uncertain(chute(uncertainty=KEYS).vary({"flow.rate_t_h": [1.0, 2.0]}))


def test_every_standard_design_may_be_uncertain():
    """Also with a receiving belt, and a stream that some samples carry past the steel."""
    belt = chutecalc.load(ROOT / "specs/transfer_90.toml").data
    belt |= {"uncertainty": {"inlet.belt.velocity_m_s": 0.3, "liners.ceramic.friction_deg": 2}}
    found = chutecalc.uncertain(chutecalc.parse(belt), FEW)
    assert list(found.columns)[2:] == ["receiver_velocity_ratio", "receiver_velocity_into_m_s"]
    assert sum(own.share for status, own in found.chances.items() if status != "fails") == 1.0
