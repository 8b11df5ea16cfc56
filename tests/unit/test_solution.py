"""Solutions: shapes, NaN after a failure, stations, extremes, text of numbers."""

import numpy as np
import pytest

import chutecalc
from chutecalc.fields.units import UNITS, convert, unit_keys
from chutecalc.results.column import quantity_text
from chutecalc.results.columns import AT_EXIT, COLUMNS
from chutecalc.results.segments import SegmentResult, joined
from tests.conftest import chute

FALL_AND_SPOON = [
    {"kind": "fall", "drop_m": 1.0},
    {"name": "spoon", "kind": "curve", "radius_m": 3.0, "to_slope_deg": 5.0},
]
REST = {"velocity_m_s": 0.0, "slope_deg": 90.0}


def three_designs():
    base = chute(sections={"body": {"shape": "rectangular", "width_m": 0.5}}, inlet=REST, segments=FALL_AND_SPOON)
    return base.vary({"liners.wall.friction_deg": [15.0, 40.0, 45.0], "flow.rate_t_h": [1000.0, 1000.0, 100.0]})


@pytest.fixture(scope="module")
def three():
    """One design runs through, two stall."""
    return chutecalc.solve(three_designs())


def test_a_failing_design_is_nan_and_disturbs_no_other(three):
    assert three.status.tolist() == ["ok", "stall", "stall"]
    assert np.isfinite(three.exit_velocity).tolist() == [True, False, False]
    assert np.isfinite(three.exit_depth).tolist() == [True, False, False]
    spoon = three.segments[1]
    assert np.isfinite(spoon.exit["s_m"]).all()  # where it failed
    assert spoon.exit["velocity_m_s"][1:].tolist() == [0.0, 0.0]


def test_stations_have_one_row_a_design_and_the_part_travelled(three):
    stations = three.stations(points=11)
    assert {values.shape for values in stations.values()} == {(3, 22)}
    assert set(stations) == set(COLUMNS) - {"spec", "case"}
    s = stations["s_m"]
    assert (np.diff(s[:, 11:], axis=1) > 0).all()
    assert np.allclose(s[:, -1], three.segments[1].exit["s_m"], rtol=1e-14)
    assert stations["velocity_m_s"][2, -1] == 0.0


@pytest.mark.parametrize("name", AT_EXIT)
def test_a_column_alone_at_an_exit_is_that_of_the_solution(three, name):
    """What a column declares that it needs is enough to work it out without the rest of the stream."""
    alone = chutecalc.exits(three_designs(), columns=[name])
    assert alone.status.tolist() == three.status.tolist()
    assert np.allclose(alone.exit[name], three.exit[name], rtol=1e-9, atol=1e-12, equal_nan=True)


def test_a_choke_shows_the_stream_up_to_the_walls_height():
    section = {"body": {"shape": "rectangular", "width_m": 0.5, "wall_height_m": 0.6}}
    solution = chutecalc.solve(
        chute(sections=section, liners={"wall": {"friction_deg": 40.0}}, inlet=REST, segments=FALL_AND_SPOON)
    )
    assert solution.status[0] == "choke"
    assert solution.segments[1].exit["depth_m"][0] == pytest.approx(0.6, rel=1e-12)
    assert np.isnan(solution.exit_depth[0])


def test_stations_by_spacing_are_padded_with_nan(three):
    stations = three.stations(spacing=0.5)
    lengths = np.isfinite(stations["s_m"]).sum(axis=1)
    assert lengths[0] > lengths[2]
    for row in range(3):
        s = stations["s_m"][row][np.isfinite(stations["s_m"][row])]
        assert s[:3] == pytest.approx([0.0, 0.5, 1.0], rel=1e-12)


def test_time_is_the_integral_of_ds_over_v():
    solution = chutecalc.solve(chute(inlet=REST, segments=FALL_AND_SPOON))
    stations = solution.stations(points=2001)
    s, v, t = (stations[name][0, 2001:] for name in ("s_m", "velocity_m_s", "time_s"))
    # Simpson: an error of h⁴ times the fourth derivative of 1/v, of the order of 1/m⁴ here
    h = (s[-1] - s[0]) / 2000
    simpson = h / 3 * (1 / v[0] + 4 * (1 / v[1:-1:2]).sum() + 2 * (1 / v[2:-2:2]).sum() + 1 / v[-1])
    assert t[-1] - t[0] == pytest.approx(simpson, rel=1e-10)


def test_time_to_a_stall_in_closed_form():
    # a frictionless slide up an arc would do; on a level vee friction alone brakes: t = v/(g μ_e)
    solution = chutecalc.solve(
        chute(
            sections={"body": {"shape": "vee", "chamfer_deg": 45.0}},
            inlet={"velocity_m_s": 3.0, "slope_deg": 0.0},
            segments=[{"kind": "straight", "slope_deg": 0.0, "length_m": 9.0}],
        )
    )
    friction = solution.segments[0].entry["equivalent_friction"][0]
    assert solution.segments[0].duration[0] == pytest.approx(3.0 / (9.80665 * friction), rel=1e-10)


def test_extremes_are_found_between_samples():
    solution = chutecalc.solve(chute(inlet=REST, segments=FALL_AND_SPOON), 1e-12)
    spoon = solution.segments[1]
    fine = solution.stations(points=200_001)
    v = fine["velocity_m_s"][0, 200_001:]
    top = int(v.argmax())
    assert 0 < top < 200_000
    # the finest sample lies within half a step of the top, and misses v''/2 times its square: 1e-11
    assert spoon.maximum["velocity_m_s"][0] == pytest.approx(v[top], rel=1e-11)
    assert spoon.maximum["velocity_m_s"][0] >= v[top] * (1 - 1e-14)
    assert spoon.minimum["depth_m"][0] <= fine["depth_m"][0, 200_001:].min() * (1 + 1e-14)


def test_stations_ask_for_something_possible(three):
    for wrong in (
        {"points": 1},
        {"points": 10**7},
        {"spacing": 0.0},
        {"spacing": float("nan")},
        {"points": 2, "spacing": 1.0},
    ):
        with pytest.raises(chutecalc.UsageError):
            three.stations(**wrong)


def test_later_segments_are_not_reached():
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 1.0, "slope_deg": 0.0},
            segments=[
                {"kind": "straight", "slope_deg": 0.0, "length_m": 5.0},
                {"kind": "fall", "drop_m": 1.0},
                {"name": "last", "kind": "straight", "slope_deg": 60.0, "length_m": 1.0},
            ],
        )
    )
    assert [segment.status[0] for segment in solution.segments] == ["stall", "not_reached", "not_reached"]
    assert all(np.isnan(values[0]) for values in solution.segments[2].exit.values())


def test_wear_and_pressure_of_a_rectangular_spoon_are_roberts():
    """W_c = Q_m g tan φ N_WR/B with N_WR = v²/(R g) + sin θ; p = ρ n H."""
    solution = chutecalc.solve(
        chute(
            sections={"body": {"shape": "rectangular", "width_m": 0.5}},
            inlet={"velocity_m_s": 5.0, "slope_deg": 80.0},
            segments=[{"kind": "curve", "radius_m": 3.0, "to_slope_deg": 10.0}],
        )
    )
    at = {name: values[0] for name, values in solution.stations(points=9).items()}
    number = at["velocity_m_s"] ** 2 / (3.0 * 9.80665) + np.cos(np.radians(at["slope_deg"]))
    wear = 1000 / 3.6 * 9.80665 * np.tan(np.radians(25.0)) * number / 0.5
    assert np.allclose(at["wear_w_m2"], wear, rtol=1e-12)
    assert np.allclose(at["pressure_kpa"], 0.8 * at["normal_acceleration_m_s2"] * at["depth_m"], rtol=1e-14)


def test_units_convert_there_and_back():
    for dimension, units in UNITS.items():
        for unit in units:
            first = next(iter(units))
            assert convert(convert(7.3, dimension, unit, first), dimension, first, unit) == pytest.approx(
                7.3, rel=1e-15
            )
    assert list(unit_keys("rate_t_h", "mass rate")) == ["rate_t_h", "rate_kg_s", "rate_stph"]


def test_numbers_of_messages_carry_their_units():
    assert quantity_text("slope_deg", 31.25, "metric") == "31.25°"
    assert quantity_text("margin", 1.2, "us") == "1.2"
    assert quantity_text("velocity_m_s", 0.00508, "us") == "1 fpm"
    assert quantity_text("wall_height_m", 0.3048, "us") == "1 ft"
    assert quantity_text("wall_height_m", 0.3048, "us", "in") == "12 in"


def test_an_impact_on_a_later_visit_counts_whatever_the_batch():
    def visit(*incidence):
        end = {"velocity_m_s": np.ones(len(incidence))}
        struck = {"incidence_deg": np.array(incidence)} if np.isfinite(incidence).any() else {}
        reached = np.full(len(incidence), "ok")
        return SegmentResult("hood", "hood", reached, end, end, end, end, np.zeros(len(incidence)), struck)

    nan = np.nan
    together = joined(visit(5.0, nan, nan), visit(7.0, 9.0, nan)).impact["incidence_deg"]
    np.testing.assert_array_equal(together, [5.0, 9.0, nan])
    for first, again, both in ((5.0, 7.0, 5.0), (nan, 9.0, 9.0), (5.0, nan, 5.0)):
        assert joined(visit(first), visit(again)).impact["incidence_deg"] == both
    assert joined(visit(nan), visit(nan)).impact == {}
