"""What a number of a spec may be: what a chute can be, with the reason, and the unit that was probably meant."""

import math

import numpy as np
import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.fields.units import convert, first_unit, unit_keys
from chutecalc.segments.flat import LONGEST
from tests.conftest import ROOT, chute
from tests.unit.test_plausibility import tables

SPEC = str(ROOT / "specs" / "vee.toml")
QUANTITIES = [
    pytest.param(quantity, key, id=f"{table.__name__}.{key}")
    for table in sorted(dict.fromkeys(tables()), key=lambda table: (table.__module__, table.__name__))
    for key, quantity in table.quantities().items()
]


def refused(**changed):
    with pytest.raises(chutecalc.SpecError) as caught:
        chute(**changed)
    return [fault.text("spec") for fault in caught.value.faults]


@pytest.mark.parametrize(("quantity", "key"), QUANTITIES)
def test_every_bound_has_its_reason_and_leaves_room_for_what_is_plausible(quantity, key):
    sizes = quantity.plausible
    assert sizes.least <= sizes.low < sizes.high <= sizes.most, key
    assert sizes.too_small or sizes.least == 0.0, key
    assert sizes.too_large or quantity.dimension == "angle", key  # an angle ends where it would be another one
    for unit in unit_keys(key, quantity.dimension).values():  # no bound lies within a range because of its unit
        limits = quantity.bounds_in(unit)
        high = convert(sizes.high, quantity.dimension, first_unit(quantity.dimension), unit)
        assert limits.get("le", limits.get("lt", np.inf)) >= high * (1.0 - 1e-12), key


def test_a_slip_of_a_unit_is_an_error_that_says_what_was_meant():
    (text,) = refused(sections={"body": {"shape": "rectangular", "width_mm": 0.01}})
    assert "width_mm = 0.01 must be at least 1 mm and at most 100,000 mm: less lets hardly a grain pass." in text
    assert text.endswith("Use a larger value.")  # no other unit makes a width of it
    (text,) = refused(sections={"body": {"shape": "rectangular", "width_mm": 0.5}})
    assert text.endswith("Did you mean width_m = 0.5?")
    (text,) = refused(sections={"body": {"shape": "rectangular", "width_m": 800}})
    assert text.endswith("more is wider than a whole plant. Did you mean width_mm = 800?")


@pytest.mark.parametrize("velocity", [5e-324, 1e-308, 1e-9, -1e-9, np.nextafter(200.0, 300.0)])
def test_a_stream_moves_or_is_at_rest(velocity):
    (text,) = refused(inlet={"velocity_m_s": velocity, "slope_deg": 40})
    assert "must be 0, or at least 0.001 m/s and at most 200 m/s" in text


def test_bounds_hold_in_arrays_too():
    base = chute()
    for values in ([3.0, 1e-308], [3.0, 500.0]):
        with pytest.raises(chutecalc.SpecError, match=r"must be 0, or at least 0\.001 m/s"):
            base.vary({"inlet.velocity_m_s": values})


def test_flanks_that_meet_leave_a_width():
    text = refused(sections={"body": {"shape": "vee", "chamfer_deg": 89.99999999999999}})[0]
    assert "leaves the section no width" in text
    assert "89° or less" in text


def test_friction_that_nothing_overcomes_is_refused():
    (text,) = refused(liners={"wall": {"friction_deg": 89.999999}})
    assert "more holds whatever lies on it" in text


def test_a_stream_that_no_chute_holds_is_refused_with_its_design():
    narrow = {"body": {"shape": "rectangular", "width_mm": 1}}
    (text,) = refused(sections=narrow, flow={"rate_t_h": 1000}, inlet={"velocity_m_s": 0.5, "slope_deg": 40})
    assert "deeper than 100 m where it enters" in text
    base = chute(sections={"body": {"shape": "rectangular", "width_m": 0.5}})
    with pytest.raises(chutecalc.SpecError, match="deeper than 100 m") as caught:
        base.vary({"inlet.velocity_m_s": [3.0, 0.001]})
    assert caught.value.designs.tolist() == [False, True]
    assert (
        "larger than 10,000 m² where it enters"
        in refused(
            flow={"rate_t_h": 1e6}, material={"density_kg_m3": 2}, inlet={"velocity_m_s": 0.01, "slope_deg": 40}
        )[0]
    )


def test_nothing_stands_further_away_than_a_chute_reaches():
    receiver = {"velocity_m_s": 2.0, "friction_deg": 30.0, "at_m": [0.0, -9000.0]}
    (text,) = refused(receiver=receiver)
    assert "receiver.at_m stands further than 2000 m from the inlet" in text


@pytest.mark.parametrize(("run_m", "slope_deg"), [(1.0, 89.9999999), (500.0, 80.0)])
def test_a_fall_ends_within_any_mine_or_is_missed(run_m, slope_deg):
    """4e17 m and 3e5 m were once ok."""
    falls = chute(inlet={"velocity_m_s": 2.0, "slope_deg": slope_deg}, segments=[{"kind": "fall", "run_m": run_m}])
    solution = chutecalc.solve(falls)
    assert solution.status[0] == "missed"
    text = next(finding for finding in solution.findings() if finding.code == "missed").message()
    assert f"and nothing here falls further than {LONGEST:g} m; give drop_m" in text


def test_the_reason_is_explained(capsys):
    assert main(["explain", "width_m"]) == 0
    assert "less lets hardly a grain pass, more is wider than a whole plant" in capsys.readouterr().out


def test_laboratory_models_and_the_largest_plants_are_chutes():
    flume = {"body": {"shape": "rectangular", "width_mm": 20}}
    model = chute(
        sections=flume,
        flow={"rate_t_h": 0.1},
        material={"density_kg_m3": 1500, "internal_friction_deg": 25, "lump_mm": 1},
        inlet={"velocity_m_s": 0.3, "slope_deg": 40},
    )
    assert chutecalc.solve(model).status[0] == "ok"
    largest = chute(sections={"body": {"shape": "rectangular", "width_m": 3}}, flow={"rate_t_h": 40_000})
    assert chutecalc.solve(largest).status[0] == "ok"


def test_a_sweep_beyond_a_bound_of_a_combination_says_so_row_by_row(capsys):
    assert main(["sweep", SPEC, "flow.rate_t_h=100,1000000", "inlet.velocity_m_s=3,0.001", "--csv", "-"]) == 0
    rows = capsys.readouterr().out.splitlines()[1:]
    assert ["impossible" in row for row in rows] == [False, False, True, True]


def test_from_0_the_sensitivity_is_that_to_the_numbers_that_are_taken():
    """None between 0 and 1 mm/s is, nor any below 0; slopes go to both sides of 0."""
    drops = {"kind": "fall", "drop_m": 1.0}
    still = chute(inlet={"velocity_m_s": 0.0, "slope_deg": 0.0}, segments=[drops])
    found = chutecalc.sensitivity(still)
    for path in ("inlet.velocity_m_s", "inlet.slope_deg"):
        assert abs(found.derivative[found.paths.index(path)]) < 1e-9, path  # v² = v0² + 2 g h
    ends_level = [drops, {"kind": "curve", "radius_m": 2.0, "to_slope_deg": 0.0, "from_slope_deg": 40.0}]
    found = chutecalc.sensitivity(chute(inlet={"velocity_m_s": 4.0, "slope_deg": 30.0}, segments=ends_level))
    assert np.isfinite(found.derivative).all()


def test_what_scatters_about_0_has_no_values_that_are_not_taken():
    with pytest.raises(chutecalc.SpecError, match=r"reaches from 0 to 1, and values must be 0, or at least 0\.001 m/s"):
        chute(uncertainty={"inlet.velocity_m_s": {"uniform": [0.0, 1.0]}})
    chute(uncertainty={"inlet.velocity_m_s": {"uniform": [0.001, 1.0]}})


def test_lists_are_no_longer_than_a_chute_needs():
    facets = [{"length_m": 0.01, "slope_deg": 5.0 + 0.5 * k} for k in range(101)]
    (text,) = refused(sections={"body": {"shape": "facets", "facets": facets}})
    assert "has 101 items, and at most 100 are allowed" in text
    rows = [[k + 1.0, 0.4 * k + 1.0] for k in range(101)]
    (text,) = refused(liners={"wall": {"yield_locus_kpa": rows}})
    assert "has 101 rows, and at most 100 are allowed" in text
    widest = chute(
        sections={"body": {"shape": "facets", "facets": facets[:100]}}, liners={"wall": {"yield_locus_kpa": rows[:100]}}
    )
    assert chutecalc.solve(widest).count == 1


@pytest.mark.parametrize(
    "value",
    [np.array([]), np.array(["1", "2"]), np.datetime64("2026-01-01"), np.ma.array([1.0, 2.0], mask=[0, 1]), [None]],
)
def test_what_is_no_number_is_refused_from_python_too(value):
    with pytest.raises(chutecalc.SpecError, match="takes numbers"):
        chute().vary({"flow.rate_t_h": value})


@pytest.mark.parametrize("rtol", [None, "1e-9", [1e-9], 1j, True])
def test_a_tolerance_that_is_no_number_is_refused(rtol):
    with pytest.raises(chutecalc.UsageError, match="rtol must be from"):
        chutecalc.solve(chute(), rtol=rtol)


def test_a_yield_locus_rises_no_more_steeply_than_the_roughest_wall():
    """From row to row, that is; a stream on a jump of friction would switch to and fro."""
    slope = math.tan(math.radians(85.0))
    chute(liners={"wall": {"yield_locus_kpa": [[1.0, 0.5], [2.0, 0.5 + 0.999 * slope], [3.0, 20.0]]}})
    (text,) = refused(liners={"wall": {"yield_locus_kpa": [[1.0, 0.5], [2.0, 0.5 + 1.001 * slope], [3.0, 20.0]]}})
    assert "liners.wall.yield_locus_kpa rises to row 2 more steeply than 85°" in text
