"""Solutions as data frames of pandas and Polars, and as a picture."""

import sys

import numpy as np
import pytest

import chutecalc
from tests.conftest import chute

RAGGED = [
    {"name": "slide", "kind": "straight", "slope_deg": 30.0, "length_m": 5.0},
    {"name": "last", "kind": "straight", "slope_deg": 30.0, "length_m": 1.0},
]


@pytest.fixture(scope="module")
def two():
    """One design runs through; the other stalls before the second segment."""
    base = chute(segments=RAGGED, inlet={"velocity_m_s": 3.0, "slope_deg": 30.0})
    return chutecalc.solve(base.vary({"liners.wall.friction_deg": [15.0, 50.0]}))


@pytest.mark.parametrize("name", ["pandas", "polars"])
def test_a_row_is_a_station_that_a_design_reached(two, name):
    pytest.importorskip(name, reason=f"{name} is not installed")
    frame = two.to_dataframe(points=3, columns=["segment", "velocity_m_s"], library=name)
    stations = two.stations(points=3)
    assert list(frame.columns) == ["design", "segment", "velocity_m_s"]
    assert list(frame["design"]) == [0] * 6 + [1] * 3
    assert list(frame["segment"]) == ["slide"] * 3 + ["last"] * 3 + ["slide"] * 3
    reached = np.isfinite(stations["s_m"])
    assert np.array_equal(np.asarray(frame["velocity_m_s"]), stations["velocity_m_s"][reached])


def test_a_row_for_each_design(two):
    pytest.importorskip("pandas", reason="pandas is not installed")
    frame = two.designs_dataframe(columns=["velocity_m_s"])
    assert list(frame.columns) == ["design", "status", "exit_velocity_m_s"]
    assert list(frame["status"]) == ["ok", "stall"]
    assert np.array_equal(frame["exit_velocity_m_s"], two.exit_velocity, equal_nan=True)
    with pytest.raises(chutecalc.UsageError, match="no column wear"):
        two.designs_dataframe(columns=["wear"])


def test_one_column_by_its_name(two):
    pytest.importorskip("pandas", reason="pandas is not installed")
    assert list(two.to_dataframe(points=2, columns="depth_m").columns) == ["design", "depth_m"]
    assert list(two.designs_dataframe("depth_m").columns) == ["design", "status", "exit_depth_m"]
    assert list(two.stations(points=2, columns="depth_m")) == list(two.exit_columns("depth_m")) == ["depth_m"]


def test_all_columns_of_one_design():
    pytest.importorskip("pandas", reason="pandas is not installed")
    solution = chutecalc.solve(chutecalc.parse(chutecalc.STARTER))
    frame = solution.to_dataframe(spacing=0.5)
    table = solution.stations(spacing=0.5)
    assert list(frame.columns) == list(table)
    assert len(frame) == np.isfinite(table["s_m"]).sum()  # no row for padding
    assert frame["s_m"].dtype == np.float64


def test_a_library_that_is_missing_is_named(two, monkeypatch):
    for module in ("pandas", "polars"):
        monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(chutecalc.ChutecalcError, match=r"to_dataframe needs pandas.*pip install pandas"):
        two.to_dataframe()
    with pytest.raises(chutecalc.ChutecalcError, match=r"designs_dataframe needs Polars.*pip install polars"):
        two.designs_dataframe(library="polars")
    with pytest.raises(chutecalc.UsageError, match="pandas or polars, not 'xarray'"):
        two.to_dataframe(library="xarray")


def test_plot_draws_one_design(two):
    from matplotlib.figure import Figure

    assert isinstance(chutecalc.solve(chutecalc.parse(chutecalc.STARTER)).plot(units="us"), Figure)
    with pytest.raises(chutecalc.UsageError, match=r"take one design with `chute\.put` and solve it"):
        two.plot()
    with pytest.raises(chutecalc.UsageError, match="metric or us"):
        chutecalc.solve(chutecalc.parse(chutecalc.STARTER)).plot(units="furlongs")
