"""Against reference values of 20 digits, found by other methods (tests/reference/README.md)."""

import csv
from itertools import groupby

import numpy as np
import pytest

import chutecalc
from tests.conftest import REFERENCE, chute


def rows(name):
    with open(REFERENCE / name, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


SPOONS = {name: list(stations) for name, stations in groupby(rows("spoon.csv"), key=lambda row: row["case"])}


def spoon(row):
    """Return the chute of a row: the stream enters along the arc's own slope."""
    value = {name: float(text) for name, text in row.items() if name != "case" and text}
    return chute(
        flow={"rate_t_h": value["rate_t_h"], "gravity_m_s2": value["gravity_m_s2"]},
        material={"density_kg_m3": value["density_kg_m3"], "internal_friction_deg": value["internal_friction_deg"]},
        liners={"wall": {"friction_deg": value["wall_friction_deg"]}},
        sections={
            "body": {"shape": "chamfered", "base_m": value["base_m"], "chamfer_deg": value["chamfer_deg"]}
            if value["base_m"]
            else {"shape": "vee", "chamfer_deg": value["chamfer_deg"]}
        },
        inlet={
            "velocity_m_s": np.sqrt(2 * value["gravity_m_s2"] * value["drop_m"]),
            "slope_deg": value["from_slope_deg"],
        },
        segments=[{"kind": "curve", "radius_m": value["radius_m"], "to_slope_deg": value["to_slope_deg"]}],
    )


@pytest.mark.parametrize("rtol", [1e-10, 1e-12])
@pytest.mark.parametrize("case", SPOONS)
def test_velocity_at_every_station_of_the_seventeen_spoons(case, rtol):
    first = SPOONS[case][0]
    solution = chutecalc.solve(spoon(first), rtol)
    part = solution.trajectory.parts[-1]
    start, end = (np.radians(90.0 - float(first[name])) for name in ("from_slope_deg", "to_slope_deg"))
    stations = [row for row in SPOONS[case] if row["velocity_m_s"]]
    share = np.array([(float(row["theta_rad"]) - start) / (end - start) for row in stations])
    expected = np.array([float(row["velocity_m_s"]) for row in stations])

    _, travelled = part.span()
    velocity = part.at((np.clip(share, 0.0, 1.0) / travelled)[:, None], ["velocity_m_s"])["velocity_m_s"][:, 0]

    # the entry velocity is handed over as a double, and each panel rounds: 1e-15; near a stop a position is worth
    # dv = (dv/dc) rtol instead
    slope = np.abs(np.gradient(expected, share))
    allowed = np.maximum(rtol * expected, rtol * slope)
    if case == "near_b45":  # almost stops, at 0.09 m/s: as ill-conditioned as its error estimate says
        allowed = np.maximum(allowed, solution.error_estimate[0] * expected)
    assert (np.abs(velocity - expected) <= allowed).all()


@pytest.mark.parametrize("case", [case for case, stations in SPOONS.items() if stations[0]["stall_theta_rad"]])
def test_place_of_the_stall(case):
    first = SPOONS[case][0]
    solution = chutecalc.solve(spoon(first))
    radius = float(first["radius_m"])

    theta = np.pi / 2 - solution.trajectory.segment_solutions[-1].exit.slope[0]

    assert solution.status[0] == "stall"
    assert abs(theta - float(first["stall_theta_rad"])) * radius < 1e-8
    assert np.isnan(solution.exit_velocity[0])


@pytest.mark.parametrize(("rtol", "complete"), [(1e-10, True), (1e-12, True), (1e-10, False), (1e-12, False)])
def test_exit_of_512_random_spoons(rtol, complete):
    table = rows("designs.csv")
    column = {name: np.array([float(row[name]) for row in table]) for name in table[0]}
    base = chute(
        inlet={"velocity_m_s": 0.0, "slope_deg": 90.0},
        segments=[{"kind": "fall", "drop_m": 1.0}, {"kind": "curve", "radius_m": 1.0, "to_slope_deg": 0.0}],
    )
    designs = base.vary(
        {
            "flow.rate_t_h": column["rate_t_h"],
            "material.density_kg_m3": column["density_kg_m3"],
            "material.internal_friction_deg": column["internal_friction_deg"],
            "liners.wall.friction_deg": column["wall_friction_deg"],
            "sections.body.base_m": column["base_m"],
            "sections.body.chamfer_deg": column["chamfer_deg"],
            "segments.1.drop_m": column["drop_m"],
            "segments.2.radius_m": column["radius_m"],
        }
    )

    if complete:
        solution = chutecalc.solve(designs, rtol)
        velocity, depth, error = solution.exit_velocity, solution.exit_depth, solution.error_estimate
        assert np.abs(depth / column["exit_depth_m"] - 1).max() < rtol
    else:
        _, end = chutecalc.solver.chain.run_chain(designs.design, rtol, dense_output=False)
        velocity, error = end.velocity, end.error

    off = np.abs(velocity / column["exit_velocity_m_s"] - 1)
    assert off.max() < rtol
    assert (off <= error + 1e-15).all()  # 1e-15: rounding in the reference as read and in the ratio
