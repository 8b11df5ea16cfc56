"""One spoon, or many, for chutecalc and for other solvers: the spec, the equation, the solvers."""

import math
from collections.abc import Callable
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
from scipy.integrate import odeint, solve_ivp

import chutecalc
from chutecalc.api.solution import Solution
from chutecalc.solver.chain import run_chain
from chutecalc.spec.build import build

STATIONS = 101
REST = 1e-10
"""v², m²/s²: a stage of a step may lie beyond rest, where there is no depth."""
Case = dict[str, float]


def spec(case: Case) -> dict[str, Any]:
    """Return the spoon as a spec."""
    section = {"shape": "chamfered", "base_m": case["base_m"], "chamfer_deg": case["chamfer_deg"]}
    return {
        "flow": {"rate_t_h": case["rate_t_h"], "gravity_m_s2": case["gravity_m_s2"]},
        "material": {
            "density_kg_m3": case["density_kg_m3"],
            "internal_friction_deg": case["internal_friction_deg"],
        },
        "liners": {"wall": {"friction_deg": case["wall_friction_deg"]}},
        "sections": {"body": section | ({"chamfer_m": case["chamfer_m"]} if "chamfer_m" in case else {})},
        "inlet": {"velocity_m_s": entry(case), "slope_deg": case["from_slope_deg"]},
        "segments": [
            {"kind": "curve", "name": "spoon", "radius_m": case["radius_m"], "to_slope_deg": case["to_slope_deg"]}
        ],
    }


def entry(case: Case) -> float:
    """Return the velocity after the fall, m/s."""
    return math.sqrt(2.0 * case["gravity_m_s2"] * case["drop_m"])


def turn(case: Case) -> float:
    """Return the angle that the spoon turns by, rad."""
    return math.radians(case["from_slope_deg"] - case["to_slope_deg"])


def numbers(case: Any) -> tuple[Any, ...]:
    """Return gravity, radius, flow, base, chamfer, its top, K of chamfers and walls, μ; floats, or arrays of spoons."""
    strength = np.sin(np.radians(case["internal_friction_deg"]))
    chamfer = np.radians(case["chamfer_deg"])
    ratio = (1 + strength * np.cos(2 * chamfer)) / (1 + strength)
    flow = case["rate_t_h"] / 3.6 / case["density_kg_m3"]
    top = case.get("chamfer_m", math.inf)
    mu = np.tan(np.radians(case["wall_friction_deg"]))
    vertical = (1 - strength) / (1 + strength)
    return case["gravity_m_s2"], case["radius_m"], flow, case["base_m"], chamfer, top, (ratio, vertical), mu


def equation(case: Case) -> Callable[[float, float], float]:
    """Compute dy/dθ of the paper's Eq 1 and 11 for one spoon, in floats; vertical walls stand above the chamfer's top.

    In y = v² the equation is nearly linear: all solvers need about half the steps that they need in v.
    """
    g, radius, flow, base, beta, top, (ratio, vertical), mu = (
        tuple(map(float, item)) if isinstance(item, tuple) else float(item) for item in numbers(case)
    )
    sine, cosine = math.sin(beta), math.cos(beta)
    full = (base + top * cosine) * top * sine if math.isfinite(top) else math.inf

    def rate(theta: float, y: float) -> float:
        area = flow / math.sqrt(max(y, REST))
        if area <= full:
            q = area / sine
            wetted = 2 * q / (base + math.sqrt(base * base + 4 * q * cosine))
            excess = ratio * wetted * (1 - cosine) / (base + wetted * cosine)
        else:
            above = (area - full) / (base + 2 * top * cosine)
            own = ratio * (1 - cosine) * top
            excess = (own * top * sine + above * (2 * own + vertical * above)) / area
        friction = mu * (1 + excess)
        return 2.0 * (g * radius * math.cos(theta) - friction * (g * radius * math.sin(theta) + y))

    return rate


def with_solve_ivp(method: str, rtol: float, grid: np.ndarray, case: Case) -> np.ndarray:
    """Solve with one of SciPy's solvers."""
    rate = equation(case)
    start = [entry(case) ** 2]
    run = solve_ivp(
        lambda t, y: [rate(t, y[0])], (0.0, turn(case)), start, method, t_eval=grid, rtol=rtol, atol=1e-3 * rtol
    )
    return np.sqrt(run.y[0])


def with_odeint(rtol: float, grid: np.ndarray, case: Case) -> np.ndarray:
    """Solve with SciPy's older interface to LSODA: compiled, except for the right-hand side."""
    rate = equation(case)
    start = entry(case) ** 2
    return np.sqrt(odeint(lambda y, t: rate(t, y[0]), start, grid, rtol=rtol, atol=1e-3 * rtol)[:, 0])


def with_steps(order: int, steps: int, grid: np.ndarray, case: Case) -> np.ndarray:
    """Solve with Euler's method, as in a spreadsheet, or classical Runge-Kutta; ``grid`` divides ``steps``."""
    rate = equation(case)
    h, y = grid[-1] / steps, entry(case) ** 2
    shown, every = [y], steps // (len(grid) - 1)
    for k in range(steps):
        t = k * h
        k1 = rate(t, y)
        if order == 1:
            y += h * k1
        else:
            k2 = rate(t + h / 2, y + h / 2 * k1)
            k3 = rate(t + h / 2, y + h / 2 * k2)
            y += h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(t + h, y + h * k3))
        if (k + 1) % every == 0:
            shown.append(y)
    return np.sqrt(shown)


def heyoka_equation(hy: Any) -> Any:
    """Return dy/dθ for heyoka, of spoons without a top; parameters: g R, base, 4 q v, K (1 - cos β), cos β, μ."""
    y = hy.make_vars("y")
    gr, base, four, lift, cosine, mu = (hy.par[k] for k in range(6))
    thin = four * y**-0.5
    wide = base + hy.sqrt(base * base + cosine * thin)
    friction = mu * (1.0 + lift * thin / (wide * wide))
    return [(y, 2.0 * (gr * hy.cos(hy.time) - friction * (gr * hy.sin(hy.time) + y)))]


def heyoka_numbers(case: Any) -> np.ndarray:
    """Return the parameters of that equation, shape (6,) or (6, spoons)."""
    g, radius, flow, base, beta, _, (ratio, _), mu = numbers(case)
    four = 4.0 * flow / np.sin(beta)
    return np.array(
        [g * radius * np.ones_like(mu), base, four, ratio * (1 - np.cos(beta)), np.cos(beta), mu], dtype=float
    )


@cache
def heyoka_integrator(tolerance: float) -> Any:
    """Compile once, as users would; the time of compiling does not count."""
    import heyoka as hy

    return hy.taylor_adaptive(heyoka_equation(hy), [1.0], tol=tolerance, pars=[1.0] * 6, fast_math=True)


def with_heyoka(tolerance: float, grid: np.ndarray, case: Case) -> np.ndarray:
    """Solve with an adaptive Taylor series, compiled."""
    integrator = heyoka_integrator(tolerance)
    integrator.pars[:] = heyoka_numbers(case)
    integrator.time, integrator.state[0] = 0.0, entry(case) ** 2
    return np.sqrt(integrator.propagate_grid(grid)[-1][:, 0])


def with_function(velocity: Callable[..., float], case: Case) -> np.ndarray:
    """Return the exit alone as a function of radius and wall friction."""
    return np.array([entry(case), velocity(case["radius_m"], case["wall_friction_deg"])])


def with_chutecalc(rtol: float, grid: np.ndarray, case: Case, checked: chutecalc.Chute | None = None) -> np.ndarray:
    """Solve and return the stations. Check the spec first, unless it is checked already."""
    if checked is None:
        solution = chutecalc.solve(chutecalc.parse(spec(case)), rtol)
    else:
        chute = SimpleNamespace(**vars(checked) | {"design": build(checked.spec)})
        segment_solutions, final = run_chain(chute.design, rtol, dense_output=len(grid) > 2)
        solution = Solution(chute, segment_solutions, final, rtol)
    if len(grid) == 2:
        return np.array([entry(case), solution.exit_velocity[0]])
    return solution.stations(points=len(grid), columns=("velocity_m_s", "depth_m"))["velocity_m_s"][0]
