"""Variants of a chute in several states: what a sweep says of each, wherever the rows come from."""

import numpy as np
import pytest

import chutecalc
from chutecalc.studies.sweep.parameters import read_parameters
from chutecalc.studies.sweep.solved_blocks import solve_block
from chutecalc.studies.sweep.sweep import Sweep
from chutecalc.studies.variants import Variants
from tests.conftest import ROOT

COLUMNS = ["receiver_velocity_ratio", "segments.spoon.max_depth_m"]


def transfer():
    return chutecalc.load(ROOT / "specs" / "transfer_90.toml")


def varied(chute, *arguments, columns=COLUMNS, states=("design",)):
    return Variants(chute, read_parameters(list(arguments), chute), columns, states)


def test_rows_in_all_states_are_those_of_a_sweep():
    chute = transfer()
    states = ("design", "wet", "slow_belt")
    variants = varied(chute, "segments.spoon.radius_m=3:5:1", "segments.hood.radius_m=1:2:1", states=states)
    radii, hoods = np.array([3.0, 3.5, 4.75]), np.array([1.4, 1.6, 1.5])
    found = variants([radii, hoods])
    for k, (radius, hood) in enumerate(zip(radii, hoods, strict=True)):
        arguments = [f"case={','.join(states)}", f"segments.spoon.radius_m={radius}", f"segments.hood.radius_m={hood}"]
        rows = solve_block(Sweep(chute, read_parameters(arguments, chute), columns=COLUMNS), 0)
        assert found["status"][:, k].tolist() == rows["status"].tolist()
        for name in COLUMNS:
            assert found[name].shape == (3, 3)
            assert np.array_equal(found[name][:, k], rows[name], equal_nan=True)
    assert {"ok", "missed"} == {*found["status"].ravel().tolist()}


def test_names_may_come_in_any_order_and_beside_numbers():
    chute = chutecalc.load(ROOT / "specs" / "coal_hood_spoon.toml")
    name, rate = "segments.spoon.liner", "flow.rate_t_h"
    column = "exit_velocity_m_s"
    variants = varied(chute, f"{name}=ceramic,steel", f"{rate}=500:1500:500", columns=[column])
    liners, rates = np.array(["steel", "ceramic", "steel"]), np.array([600.0, 700.0, 800.0])
    found = variants([liners, rates])[column][0]
    for computed, liner, value in zip(found, liners, rates, strict=True):
        changed = chute.vary({name: str(liner), rate: value})
        assert computed == pytest.approx(chutecalc.solve(changed).exit_velocity[0], rel=1e-10)


def test_a_call_checks_nothing_again(monkeypatch):
    variants = varied(transfer(), "segments.spoon.radius_m=3,5")
    monkeypatch.setattr("chutecalc.studies.sweep.sweep.chutes_by_names", None)
    assert variants([np.array([4.0])])["status"].tolist() == [["ok"]]


def test_a_value_out_of_bounds_is_impossible_in_a_call_and_refused_before():
    chute = transfer()
    found = varied(chute, "segments.spoon.radius_m=3,5")([np.array([4.0, -1.0])])
    assert found["status"].tolist() == [["ok", "impossible"]]
    assert np.isnan(found[COLUMNS[0]]).tolist() == [[False, True]]
    with pytest.raises(chutecalc.SpecError, match="radius_m"):
        varied(chute, "segments.spoon.radius_m=-1,5")


def test_a_state_that_there_is_not_is_told():
    with pytest.raises(chutecalc.UsageError, match="no case dusty"):
        varied(transfer(), "segments.spoon.radius_m=3,5", states=("design", "dusty"))
