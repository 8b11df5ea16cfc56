"""The belt that feeds the chute, and the one that it feeds."""

import numpy as np
import pytest

import chutecalc
from tests.unit.findings.chutes import PASSABLE, G, codes, fed, found, solved


@pytest.mark.parametrize("friction", [{}, {"friction_deg": 30.0}])
@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_slides_on_pulley(factor, friction):
    incline = 10.0
    thrown = np.sqrt(G * 0.4 * np.cos(np.radians(incline)))
    solution = chutecalc.solve(fed(velocity_m_s=factor * thrown, incline_deg=incline, **friction))
    assert ("slides_on_pulley" in codes(solution)) == (factor < 1)
    assert ("held_slope_deg" in solution.inlet) == (factor < 1)
    if factor < 1:
        finding = found(solution, "slides_on_pulley")
        assert (finding.severity, finding.segment, finding.s_m[0]) == ("warning" if friction else "note", "fall", 0.0)
        assert ("it slides on the pulley from" in finding.message()) == bool(friction)


def test_a_stream_on_a_pulley_is_told_its_bounds():
    held, slides = (chutecalc.solve(fed(velocity_m_s=1.0, **more)) for more in ({}, {"friction_deg": 30.0}))
    froude = 1.0 / (G * 0.4)
    for solution in (held, slides):
        inlet = {name: values[0] for name, values in solution.inlet.items()}
        assert np.cos(np.radians(inlet["held_slope_deg"])) == pytest.approx(froude, rel=1e-13)
        assert np.cos(np.radians(inlet["frictionless_slope_deg"])) == pytest.approx((froude + 2.0) / 3.0, rel=1e-13)
        assert inlet["frictionless_velocity_m_s"] == pytest.approx(np.sqrt(G * 0.4 * (froude + 2.0) / 3.0), rel=1e-13)
    bounds = [held.inlet[f"{name}_slope_deg"][0] for name in ("frictionless", "held")]
    assert held.inlet["slope_deg"][0] == bounds[1]
    assert bounds[0] < slides.inlet["slope_deg"][0] < bounds[1]
    assert "at 75.23° and 1 m/s if the belt holds it to the end" in found(held, "slides_on_pulley").message()
    assert "leaves at 75.23° and 196.9 fpm if" in found(held, "slides_on_pulley").message(units="us")


def test_only_the_slow_designs_of_a_batch_slide_on_the_pulley():
    solution = chutecalc.solve(fed(friction_deg=30.0).vary({"inlet.belt.velocity_m_s": [1.0, 3.0, 1.5]}))
    finding = found(solution, "slides_on_pulley")
    assert finding.mask.tolist() == [True, False, True]
    assert np.isnan(solution.inlet["slide_start_deg"]).tolist() == [False, True, False]


@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_belt_overfull(factor):
    # a flat belt carries a parabola on its usable width: b² tan θ/6
    full = 3600.0 * 0.8 * 3.0 * (0.9 * 0.8 - 0.05) ** 2 * np.tan(np.radians(20.0)) / 6.0
    base = fed(width_m=0.8, trough_deg=0.0, surcharge_deg=20.0)
    solution = chutecalc.solve(base.put({"flow.rate_t_h": factor * full}))
    assert solution.inlet["belt_fill"][0] == pytest.approx(factor, rel=1e-13)
    assert ("belt_overfull" in codes(solution)) == (factor > 1)
    if factor > 1:
        message = found(solution, "belt_overfull").message(units="us")
        assert f"the load of {solution.inlet['load_area_m2'][0] / 0.3048**2:.4g} ft² fills" in message
        assert f"would cover {solution.inlet['load_width_m'][0] / 0.0254:.4g} in of belt" in message


@pytest.mark.parametrize("off", [-1e-6, 1e-6])
@pytest.mark.parametrize("name", ["lower", "upper"])
def test_edge_misses(name, off):
    base = fed(material_depth_m=0.1)
    lands = {edge.name: edge.numbers["landing_distance_m"][0] for edge in chutecalc.solve(base).edges}
    if name == "upper":  # the floor ends just before or behind where that edge lands
        moved = base.put({"segments.floor.length_m": lands[name] - off})
    else:  # or begins there
        along = (lands[name] + off) * np.array([np.cos(np.radians(55.0)), -np.sin(np.radians(55.0))])
        moved = base.put({"segments.floor.start_m": [0.3 + float(along[0]), -0.5 + float(along[1])]})
    solution = chutecalc.solve(moved)
    assert ("edge_misses" in codes(solution)) == (off > 0)
    if off > 0:
        finding = found(solution, "edge_misses")
        assert (finding.severity, finding.segment) == ("warning", "floor")
        assert finding.s_m[0] == solution.segments["fall"].exit["s_m"][0]
        assert finding.message().startswith(
            f"the {name} edge of the stream misses the segment on which its middle lands"
        )


def test_an_edge_that_lands_on_another_segment_misses():
    base = fed(material_depth_m=0.2)
    floor = base.data["segments"][1]
    lower = chutecalc.solve(base).edges[0].numbers
    # a short ledge just where the lower edge would come down, which the middle flies past
    x, z = lower["landing_x_m"][0] - 0.02, lower["landing_z_m"][0] + 0.05
    ledge = {"kind": "straight", "name": "ledge", "start_m": [x, z], "slope_deg": 60.0, "length_m": 0.05} | PASSABLE
    segments = [base.data["segments"][0], ledge, {"kind": "fall", "onto_next": True, "name": "on"}, floor]
    solution = chutecalc.solve(chutecalc.parse(base.data | {"segments": segments}))
    assert [edge.segment[0] for edge in solution.edges] == ["ledge", "floor", "floor"]
    finding = found(solution, "edge_misses")
    assert finding.segment == "floor"
    assert "the lower edge" in finding.message()
    assert "lands on another one" in finding.message()


@pytest.mark.parametrize("off", [-0.001, 0.001])
def test_not_accelerated(off):
    # a belt uphill at ε lifts material by friction only if μ_b cos ε > sin ε: up to its friction angle
    solution = solved(receiver={"velocity_m_s": 9.0, "slope_deg": -(20.0 + off), "friction_deg": 20.0})
    assert ("not_accelerated" in codes(solution)) == (off > 0)
    assert np.isinf(solution.receiver["acceleration_length_m"][0]) == (off > 0)
