"""The method itself: its order, its quadrature, and the cost that a kink does not have."""

from itertools import groupby, pairwise

import numpy as np
import pytest

import chutecalc
from chutecalc.core.gauss import Equation, Iterate, integrate
from chutecalc.design import Status
from chutecalc.solver.chain import run_chain
from chutecalc.solver.collocation import rule, transfer
from chutecalc.solver.options import compiled_rule
from tests.conftest import chute


@pytest.mark.parametrize("count", [4, 6, 8, 12, 16, 24])
def test_a_rule_integrates_polynomials_to_their_degree(count):
    own = rule(count)
    for power in range(2 * count):  # the end to degree 2N - 1
        assert own.integral[-1] @ own.nodes**power == pytest.approx(1 / (power + 1), rel=1e-14)
    for power in range(count):  # the nodes to degree N - 1
        assert np.allclose(own.integral[:-1] @ own.nodes**power, own.nodes ** (power + 1) / (power + 1), atol=2e-16)


@pytest.mark.parametrize("pair", [(4, 8), (6, 12), (8, 24), (16, 24)])
def test_a_transfer_is_exact_for_polynomials(pair):
    coarse, fine = (rule(count) for count in pair)
    power = pair[0] + 1
    assert np.allclose(transfer(*pair) @ coarse.knots**power, fine.nodes**power, rtol=0, atol=2e-15)


@pytest.mark.parametrize(("count", "order"), [(4, 8), (6, 12)])
def test_the_end_of_a_panel_converges_with_twice_the_number_of_nodes(count, order):
    """u' = -u²/2 + cos t on (0, 1.6), halving panels: log2 of the errors' ratio, above what doubles leave of them."""
    nodes, own = rule(count).nodes, compiled_rule(count)
    equation, curve = Equation(), Iterate()

    def solve(panels):
        u = 1.0
        for k in range(panels):
            h = 1.6 / panels
            t = (k + nodes) * h
            guess = np.full(count, u)
            for _ in range(8):
                for j in range(count):
                    equation.forcing[j], equation.jacobian[j] = h * (np.cos(t[j]) + guess[j] ** 2 / 2), -h * guess[j]
                integrate(own, equation, u, curve)
                guess = np.array(curve.solution)[1 : count + 1]
            u = curve.solution[count + 1]
        return u

    exact = solve(64)
    errors = [abs(solve(panels) - exact) for panels in ((2, 4) if count == 4 else (1, 2))]
    assert np.log2(errors[0] / errors[1]) > order - 1.5


def kinked(**more):
    """Return a spoon on which the depth passes the chamfer's top, down and up again."""
    return chute(
        sections={"body": {"shape": "chamfered", "base_m": 0.4, "chamfer_deg": 50.0, "chamfer_m": 0.18}},
        inlet={"velocity_m_s": 4.6, "slope_deg": 85.0},
        segments=[{"name": "spoon", "kind": "curve", "radius_m": 3.0, "to_slope_deg": 5.0}],
        **more,
    )


def test_a_kink_costs_no_accuracy_at_any_tolerance():
    exact = chutecalc.solve(kinked(), 1e-13)
    top = 0.18 * np.sin(np.radians(50.0))
    depth = exact.stations()["depth_m"][0]
    assert depth[0] > top > depth.min()
    assert depth[-1] > top
    for rtol in (1e-4, 1e-6, 1e-8, 1e-10, 1e-12):
        solution = chutecalc.solve(kinked(), rtol)
        assert abs(solution.exit_velocity[0] / exact.exit_velocity[0] - 1) < rtol
        assert np.abs(solution.stations()["velocity_m_s"] / exact.stations()["velocity_m_s"] - 1).max() < rtol


def test_a_panel_never_crosses_a_kink():
    solution = chutecalc.solve(kinked())
    panels = solution.trajectory.segment_solutions[0].contact.panels.of_design(0)
    facets = [int(facet) for facet in panels[:, 2]]
    assert [facet for facet, _ in groupby(facets)] == [1, 0, 1]  # wall, chamfer, wall
    assert len(facets) <= 6  # and each in a panel or two
    height, run = 0.18 * np.sin(np.radians(50.0)), 0.18 * np.cos(np.radians(50.0))
    top = (0.4 + run) * height
    speed = 1000 / 3.6 / 800 / top  # of the stream that just fills the chamfers
    for before, after in pairwise(panels):
        if before[2] != after[2]:
            assert after[6] ** 0.5 == pytest.approx(speed, rel=1e-12)


@pytest.mark.parametrize("rtol", [1e-4, 1e-6, 1e-8, 1e-10, 1e-12])
@pytest.mark.parametrize(
    ("rate", "density", "internal", "width", "friction", "velocity", "slope", "end", "radius"),
    [
        (1000.0, 800.0, 50.0, 0.8, 25.0, 3.2, 0.0, 55.0, 4.0),
        (582.0, 1473.0, 44.84, 0.1571, 9.648, 0.4665, 23.06, 35.26, 2.36),
    ],
)
def test_a_stream_that_just_clears_its_wall_does_not_choke(
    rate, density, internal, width, friction, velocity, slope, end, radius, rtol
):
    """The stream over a crest is deepest within it; a wall higher than that by ten times the tolerance is cleared."""

    def crest(**more):
        return chute(
            flow={"rate_t_h": rate},
            material={"density_kg_m3": density, "internal_friction_deg": internal},
            liners={"wall": {"friction_deg": friction}},
            sections={"body": {"shape": "rectangular", "width_m": width, **more}},
            inlet={"velocity_m_s": velocity, "slope_deg": slope},
            segments=[{"name": "crest", "kind": "curve", "radius_m": radius, "to_slope_deg": end}],
        )

    depths = chutecalc.solve(crest(), 1e-13).stations(points=20001)["depth_m"][0]
    deepest = depths.max()
    assert depths[0] < deepest > depths[-1]
    spare = max(10 * rtol, 1e-8)  # between stations depth may rise by 1e-9
    for share, status in ((1 + spare, Status.OK), (1 - spare, Status.CHOKE)):
        walled = crest(wall_height_m=deepest * share)
        for complete in (True, False):
            _, ended = run_chain(walled.design, rtol, complete)
            assert ended.status[0] == status
