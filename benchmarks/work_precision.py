"""Run time against error: one spoon built, solved and told at 101 stations, by chutecalc and by what else there is.

    python benchmarks/work_precision.py [--quick] [--csv FILE] [--plot FILE.svg]

The error is the largest relative one of the velocity at the stations that tests/reference/spoon.csv knows to 20 digits.
All rivals run in turn, again and again; times are medians, and ratios are to chutecalc at its default tolerance in the
same round. The rivals' right-hand side is what one would write in Python for one design: plain floats and `math`. What
chutecalc does in that time is all of it: check the spec, solve it, and work out all columns at the stations.
"""

import argparse
import csv
import math
import statistics
import time
from collections.abc import Callable
from functools import partial
from itertools import groupby
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table
from scipy.integrate import odeint, solve_ivp

import chutecalc

REFERENCE = Path(__file__).parents[1] / "tests" / "reference" / "spoon.csv"
CASES = ("base_d55_b45_R3", "deep_b90", "near_b45", "beta89.999999")
STATIONS = 101
Case = dict[str, float]
Solver = Callable[[Case], np.ndarray]


def cases() -> dict[str, tuple[Case, np.ndarray]]:
    """The spoons by name: their numbers, and the velocities at every tenth station."""
    with open(REFERENCE, encoding="utf-8", newline="") as file:
        groups = {name: list(rows) for name, rows in groupby(csv.DictReader(file), key=lambda row: row["case"])}
    return {
        name: (
            {key: float(value) for key, value in groups[name][0].items() if key != "case" and value},
            np.array([float(row["velocity_m_s"]) for row in groups[name]]),
        )
        for name in CASES
    }


def with_chutecalc(rtol: float, case: Case) -> np.ndarray:
    """Spec, check, solution and stations."""
    chute = chutecalc.parse(
        {
            "flow": {"rate_t_h": case["rate_t_h"], "gravity_m_s2": case["gravity_m_s2"]},
            "material": {
                "density_kg_m3": case["density_kg_m3"],
                "internal_friction_deg": case["internal_friction_deg"],
            },
            "liners": {"wall": {"friction_deg": case["wall_friction_deg"]}},
            "sections": {"body": {"shape": "chamfered", "base_m": case["base_m"], "chamfer_deg": case["chamfer_deg"]}},
            "inlet": {"velocity_m_s": entry(case), "slope_deg": case["from_slope_deg"]},
            "segments": [{"kind": "curve", "radius_m": case["radius_m"], "to_slope_deg": case["to_slope_deg"]}],
        }
    )
    return chutecalc.solve(chute, rtol).stations(points=STATIONS)["velocity_m_s"][0]


def entry(case: Case) -> float:
    """Velocity after the fall."""
    return math.sqrt(2.0 * case["gravity_m_s2"] * case["drop_m"])


def equation(case: Case) -> tuple[Callable[[float, float], float], float]:
    """dv/dθ of the paper's Eq 1 and 11, and the angle of the whole spoon."""
    g, radius, base = case["gravity_m_s2"], case["radius_m"], case["base_m"]
    beta, delta = math.radians(case["chamfer_deg"]), math.radians(case["internal_friction_deg"])
    sine, cosine = math.sin(beta), math.cos(beta)
    ratio = (1 + math.sin(delta) * math.cos(2 * beta)) / (1 + math.sin(delta))
    flow = case["rate_t_h"] / 3.6 / case["density_kg_m3"] / sine
    mu = math.tan(math.radians(case["wall_friction_deg"]))

    def rate(theta: float, v: float) -> float:
        q = flow / v
        wetted = 2 * q / (base + math.sqrt(base * base + 4 * q * cosine))
        friction = mu * (1 + ratio * wetted * (1 - cosine) / (base + wetted * cosine))
        return (g * radius * math.cos(theta) - friction * (g * radius * math.sin(theta) + v * v)) / v

    return rate, math.radians(case["from_slope_deg"] - case["to_slope_deg"])


def with_solve_ivp(method: str, rtol: float, case: Case) -> np.ndarray:
    """One of SciPy's solvers at the stations."""
    rate, turn = equation(case)
    grid = np.linspace(0.0, turn, STATIONS)
    run = solve_ivp(
        lambda t, y: [rate(t, y[0])], (0.0, turn), [entry(case)], method, t_eval=grid, rtol=rtol, atol=1e-3 * rtol
    )
    return run.y[0]


def with_odeint(rtol: float, case: Case) -> np.ndarray:
    """SciPy's older interface to LSODA, in compiled code but for the right-hand side."""
    rate, turn = equation(case)
    grid = np.linspace(0.0, turn, STATIONS)
    return odeint(lambda y, t: rate(t, y[0]), entry(case), grid, rtol=rtol, atol=1e-3 * rtol)[:, 0]


def with_steps(order: int, steps: int, case: Case) -> np.ndarray:
    """Euler as in a spreadsheet, or the classical Runge-Kutta method, by hand."""
    rate, turn = equation(case)
    h, v = turn / steps, entry(case)
    shown = [v]
    for k in range(steps):
        t = k * h
        k1 = rate(t, v)
        if order == 1:
            v += h * k1
        else:
            k2 = rate(t + h / 2, v + h / 2 * k1)
            k3 = rate(t + h / 2, v + h / 2 * k2)
            v += h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(t + h, v + h * k3))
        if (k + 1) % (steps // (STATIONS - 1)) == 0:
            shown.append(v)
    return np.array(shown)


def solvers(quick: bool) -> dict[str, Solver]:
    """All that is compared; the first is what ratios are to."""
    ours = [1e-10] if quick else [1e-10, 1e-4, 1e-6, 1e-8, 1e-12, 1e-13]
    theirs = [1e-10] if quick else [1e-4, 1e-7, 1e-10, 1e-13]
    found: dict[str, Solver] = {f"chutecalc {rtol:.0e}": partial(with_chutecalc, rtol) for rtol in ours}
    for method in ("DOP853",) if quick else ("RK45", "DOP853", "LSODA", "Radau"):
        found |= {f"solve_ivp {method} {rtol:.0e}": partial(with_solve_ivp, method, rtol) for rtol in theirs}
    found |= {f"odeint {rtol:.0e}": partial(with_odeint, rtol) for rtol in theirs}
    found |= {f"Runge-Kutta 4, {n} steps": partial(with_steps, 4, n) for n in ((100,) if quick else (100, 1000))}
    return found | {"Euler, 1000 steps": partial(with_steps, 1, 1000)}


def measured(case: Case, exact: np.ndarray, rounds: int, quick: bool) -> list[tuple[str, float, float, float]]:
    """Name, median time in ms, median ratio, error of each solver on one case."""
    tried = solvers(quick)
    times: dict[str, list[float]] = {name: [] for name in tried}
    errors = {}
    for turn in range(rounds + 1):
        for name, solve in tried.items():
            start = time.perf_counter()
            velocity = solve(case)
            if turn:  # the first round warms up
                times[name].append(time.perf_counter() - start)
            errors[name] = float(np.max(np.abs(velocity[:: (STATIONS - 1) // 10] / exact - 1.0)))
    yardstick = times[next(iter(tried))]
    return [
        (
            name,
            1e3 * statistics.median(spent),
            statistics.median(a / b for a, b in zip(spent, yardstick, strict=True)),
            errors[name],
        )
        for name, spent in times.items()
    ]


def plot(results: dict[str, list[tuple[str, float, float, float]]], file: str) -> None:
    """Error over time, a panel a case."""
    from matplotlib import pyplot as plt

    figure, axes = plt.subplots(1, len(results), figsize=(4.0 * len(results), 4.0), sharey=True, squeeze=False)
    for axis, (name, rows) in zip(axes[0], results.items(), strict=True):
        for marker, (label, group) in zip(
            "osv^Dx+", groupby(rows, key=lambda row: row[0].rsplit(" ", 1)[0]), strict=False
        ):
            points = list(group)
            axis.loglog([row[1] for row in points], [max(row[3], 1e-16) for row in points], marker + "-", label=label)
        axis.set(title=name, xlabel="time, ms")
        axis.grid(alpha=0.3)
    axes[0][0].set_ylabel("largest relative error of the velocity")
    axes[0][-1].legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(file)


def main() -> None:
    """Measures and prints."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="few solvers, two rounds: to see that it runs")
    parser.add_argument("--csv")
    parser.add_argument("--plot")
    options = parser.parse_args()
    results = {
        name: measured(case, exact, 2 if options.quick else 15, options.quick)
        for name, (case, exact) in cases().items()
    }
    for name, rows in results.items():
        table = Table("solver", "ms", "ratio", "error", title=name, title_justify="left", box=None)
        for solver, spent, ratio, error in rows:
            table.add_row(solver, f"{spent:.2f}", f"{ratio:.2f}", f"{error:.1e}")
        Console().print(table)
    if options.csv:
        with open(options.csv, "w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(["case", "solver", "time_ms", "ratio", "error"])
            writer.writerows((name, *row) for name, rows in results.items() for row in rows)
    if options.plot:
        plot(results, options.plot)


if __name__ == "__main__":
    main()
