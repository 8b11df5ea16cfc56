"""Impacts that are too steep."""

import pytest

from tests.unit.findings.chutes import all_of, codes, solved


@pytest.mark.parametrize("off", [-0.001, 0.001])
def test_steep_impact(off):
    solution = solved(
        inlet={"velocity_m_s": 5.0, "slope_deg": 60.0},
        segments=[{"kind": "straight", "slope_deg": 40.0 - off, "length_m": 1.0}],
    )
    assert ("steep_impact" in codes(solution)) == (off > 0)


def test_an_impact_that_stops_the_stream_is_a_steep_one():
    solution = solved(
        inlet={"velocity_m_s": 4.0, "slope_deg": 85.0},
        liners={"wall": {"friction_deg": 35.0}},
        segments=[{"kind": "straight", "slope_deg": 15.0, "length_m": 2.0}],
    )
    assert solution.status[0] == "stall"
    (steep,) = all_of(solution, "steep_impact")
    assert steep.numbers["incidence_deg"][0] == pytest.approx(70.0, rel=1e-12)
    assert steep.numbers["after_m_s"][0] == 0.0
