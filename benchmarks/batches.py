"""Time and error of batches: thousands of spoons, compared with other solvers; stalls, memory, batch sizes.

    python benchmarks/batches.py [--quick] [--out FOLDER]

The spoons are random: radius, rate, density, base, friction, chamfers and entry vary; each turns from vertical to
level. Errors are the largest relative errors of the exit velocity, compared with chutecalc's own complete solution at
1e-13. tests/verification compares that with reference values, and this benchmark compares some of it with DOP853 at
1e-13. The other solvers integrate v², as chutecalc does, which halves their time; heyoka has `fast_math`. The time to
turn the numbers of spoons into those of a solver counts for all; what is parsed or compiled once does not count. All
use one thread, unless a row says otherwise. Solvers that take too long solve fewer spoons, and the table says how many.
Ratios are the time of `chute.function` over theirs in the same round: at the same tolerance, and at ten times that if
its largest error is still below the tolerance.
"""

import os
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from measure import Report, in_turn, median, ratio
from scipy.integrate import solve_ivp
from spoon import entry, equation, heyoka_equation, heyoka_numbers, numbers, spec, turn

import chutecalc
from chutecalc.design import Status
from chutecalc.solver.chain import run_chain

BASE = {
    "gravity_m_s2": 9.81,
    "radius_m": 3.0,
    "rate_t_h": 1000.0,
    "density_kg_m3": 1000.0,
    "base_m": 0.5,
    "wall_friction_deg": 22.0,
    "internal_friction_deg": 45.0,
    "chamfer_deg": 45.0,
    "drop_m": 2.0,
    "from_slope_deg": 90.0,
    "to_slope_deg": 0.0,
}
RANGES = {
    "radius_m": (1.5, 4.0),
    "rate_t_h": (200.0, 1500.0),
    "density_kg_m3": (700.0, 2500.0),
    "base_m": (0.3, 0.8),
    "wall_friction_deg": (15.0, 28.0),
    "internal_friction_deg": (30.0, 55.0),
    "chamfer_deg": (15.0, 90.0),
    "drop_m": (1.5, 4.0),
}
PATHS = {
    "radius_m": "segments.spoon.radius_m",
    "rate_t_h": "flow.rate_t_h",
    "density_kg_m3": "material.density_kg_m3",
    "base_m": "sections.body.base_m",
    "wall_friction_deg": "liners.wall.friction_deg",
    "internal_friction_deg": "material.internal_friction_deg",
    "chamfer_deg": "sections.body.chamfer_deg",
}
Batch = dict[str, Any]
Row = tuple[str, str, float, float, float, float]


def batch(count: int, stalls: bool = False) -> Batch:
    """Draw random spoons. For those that stall, higher friction and wider arcs stop some 40 %."""
    random = np.random.default_rng(1)
    ranges = RANGES | ({"wall_friction_deg": (22.0, 40.0), "drop_m": (0.5, 2.0)} if stalls else {})
    return BASE | {name: random.uniform(*ends, count) for name, ends in ranges.items()}


def base() -> chutecalc.Chute:
    """Return the chute that is varied."""
    return chutecalc.parse(spec(BASE))


def changes(spoons: Batch) -> dict[str, np.ndarray]:
    """Return the values that vary, by path."""
    velocity = np.sqrt(2.0 * spoons["gravity_m_s2"] * spoons["drop_m"])
    return {path: spoons[name] for name, path in PATHS.items()} | {"inlet.velocity_m_s": velocity}


def chute(spoons: Batch) -> chutecalc.Chute:
    """Return the spoons as variants of one chute."""
    return base().vary(changes(spoons))


def one(spoons: Batch, k: int) -> dict[str, float]:
    """Return one of the spoons."""
    return {name: float(values[k]) if np.ndim(values) else values for name, values in spoons.items()}


def stacked(spoons: Batch, rtol: float) -> np.ndarray:
    """Solve all in one system with DOP853 and NumPy; ``rtol`` holds for the worst of them."""
    g, radius, flow, base, beta, _, (pressure, _), mu = numbers(spoons)
    four, lift, cosine = 4.0 * flow / np.sin(beta), pressure * (1 - np.cos(beta)), np.cos(beta)

    def rate(theta: float, y: np.ndarray) -> np.ndarray:
        thin = four / np.sqrt(y)
        wide = base + np.sqrt(base * base + cosine * thin)
        friction = mu * (1.0 + lift * thin / (wide * wide))
        gr = g * radius
        return 2.0 * (gr * np.cos(theta) - friction * (gr * np.sin(theta) + y))

    start, end = 2.0 * g * spoons["drop_m"], turn(BASE)
    return np.sqrt(solve_ivp(rate, (0.0, end), start, "DOP853", rtol=rtol, atol=1e-3 * rtol, t_eval=[end]).y[:, 0])


def looped(spoons: Batch, rtol: float, count: int) -> np.ndarray:
    """Solve one after the other with solve_ivp."""
    cases = (one(spoons, k) for k in range(count))
    return np.sqrt([_alone(case, rtol).y[0, -1] for case in cases])


def _alone(case: dict[str, float], rtol: float, events: Any = None) -> Any:
    rate = equation(case)
    return solve_ivp(
        lambda t, y: [rate(t, y[0])],
        (0.0, turn(case)),
        [entry(case) ** 2],
        "DOP853",
        rtol=rtol,
        atol=1e-3 * rtol,
        events=events,
    )


def with_heyoka(spoons: Batch, rtol: float) -> Callable[[], np.ndarray]:
    """Solve with the batch integrator of heyoka, 16 at a time, compiled beforehand."""
    import heyoka as hy

    size = 16
    room = {"tol": rtol, "pars": np.ones((6, size)), "fast_math": True}
    integrator = hy.taylor_adaptive_batch(heyoka_equation(hy), np.ones((1, size)), **room)
    end = np.full(size, turn(BASE))

    def run() -> np.ndarray:
        parameters, start = heyoka_numbers(spoons), 2.0 * spoons["gravity_m_s2"] * spoons["drop_m"]
        out = np.empty_like(start)
        for first in range(0, len(start), size):
            integrator.pars[:] = parameters[:, first : first + size]
            integrator.set_time(0.0)
            integrator.state[0] = start[first : first + size]
            integrator.propagate_until(end)
            out[first : first + size] = integrator.state[0]
        return np.sqrt(out)

    return run


def with_numba(spoons: Batch, rtol: float) -> Callable[[], np.ndarray]:
    """Solve one at a time in a compiled loop with SciPy's coefficients and step control of DOP853."""
    from compiled import dop853

    def run() -> np.ndarray:
        parameters = np.ascontiguousarray(heyoka_numbers(spoons).T)
        return dop853(parameters, np.sqrt(2.0 * spoons["gravity_m_s2"] * spoons["drop_m"]), turn(BASE), rtol)

    return run


def exits(parsed: chutecalc.Chute, spoons: Batch, rtol: float) -> np.ndarray:
    """Compute exit velocities on one core."""
    variants = parsed.vary(changes(spoons))
    return chutecalc.exits(variants, rtol, columns=["velocity_m_s"], jobs=1).exit["velocity_m_s"]


def as_function(parsed: chutecalc.Chute, spoons: Batch, rtol: float) -> Callable[[], np.ndarray]:
    """Compute exit velocities with a function that was made beforehand."""
    velocity = parsed.function(list(changes(spoons)), rtol=rtol)
    return lambda: velocity(*changes(spoons).values())


def solved(parsed: chutecalc.Chute, spoons: Batch, rtol: float) -> np.ndarray:
    """Compute exit velocities from complete solutions."""
    return chutecalc.solve(parsed.vary(changes(spoons)), rtol).exit_velocity


def races(report: Report) -> list[Row]:
    """Return all solvers that can run, for each tolerance."""
    count = 1024 if report.quick else 8192
    rounds, few = (1, 4) if report.quick else (7, 24)
    spoons = batch(count)
    parsed = base()
    exact = solved(parsed, spoons, 1e-13)
    own = max(abs(_alone(one(spoons, k), 1e-13).y[0, -1] ** 0.5 / exact[k] - 1.0) for k in range(few))
    print(f"DOP853 at 1e-13 differs from the solution that errors are measured from by {own:.1e} at most\n")
    rows = []
    for rtol in (1e-10,) if report.quick else (1e-6, 1e-10, 1e-13):
        alike, loose = "chutecalc function", f"chutecalc function, rtol {10 * rtol:.0e}"
        tasks: dict[str, tuple[int, Callable[[], np.ndarray]]] = {
            alike: (count, as_function(parsed, spoons, rtol)),
            loose: (count, as_function(parsed, spoons, 10 * rtol)),
            "chutecalc exits": (count, partial(exits, parsed, spoons, rtol)),
            "chutecalc solve": (count, partial(solved, parsed, spoons, rtol)),
            "solve_ivp stacked": (count, partial(stacked, spoons, rtol)),
            f"solve_ivp looped, {few}": (few, partial(looped, spoons, rtol, few)),
        }
        for name, rival in (("heyoka, batch of 16", with_heyoka), ("numba DOP853", with_numba)):
            try:
                tasks[name] = (count, rival(spoons, rtol))
            except ImportError as error:
                print(f"{name} is left out: {error}")
        spent = in_turn({name: task for name, (_, task) in tasks.items()}, rounds)
        each = {name: [time / tasks[name][0] for time in times] for name, times in spent.items()}
        errors = {name: float(np.abs(task() / exact[:n] - 1.0).max()) for name, (n, task) in tasks.items()}
        enough = loose if errors[loose] <= rtol else alike
        rows += [
            (
                f"{count} spoons, rtol {rtol:.0e}",
                name,
                1e6 * median(times),
                ratio(each[alike], times),
                ratio(each[enough], times),
                errors[name],
            )
            for name, times in each.items()
        ]
    return rows


def sizes(report: Report) -> list[tuple[str, str, float, float, float]]:
    """Measure time and memory over the size of a batch, with one thread and with one per core."""
    rows = []
    for count in (1000, 10_000) if report.quick else (1000, 10_000, 100_000, 1_000_000):
        variants = chute(batch(count))
        spent = in_turn(
            {str(jobs): partial(chutecalc.exits, variants, jobs=jobs) for jobs in (1, os.cpu_count() or 1)}, 3
        )
        for jobs, times in spent.items():
            per, gain = 1e6 * median(times) / count, ratio(times, spent["1"])
            rows.append((f"exits over size, {jobs} threads", f"{count}", per, gain, peak(count)))
    return rows


def peak(count: int) -> float:
    """Measure the peak memory of a process that solves so many designs, MiB."""
    code = (
        "import sys, resource; sys.path.insert(0, 'benchmarks'); import chutecalc; from batches import batch, chute;"
        f"chutecalc.exits(chute(batch({count})), jobs=1); print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)"
    )
    return float(subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, text=True).stdout) / 1024


def stopped(_: float, y: np.ndarray) -> float:
    """Detect that the stream stops: not quite at rest, where the right-hand side is infinite."""
    return float(y[0] - 1e-10)


stopped.terminal = True


def stalls(report: Report) -> list[Row]:
    """Measure a batch of which some 40 % stall; the error is that of the position of the stall, rad."""
    count, few = (512, 8) if report.quick else (8192, 100)
    spoons = batch(count, stalls=True)
    parsed = base()

    def theirs() -> np.ndarray:
        return np.array([_alone(one(spoons, k), 1e-10, stopped).t[-1] for k in range(few)])

    name = "chutecalc exits"
    ours = partial(exits, parsed, spoons, 1e-10)
    spent = in_turn({name: ours, f"solve_ivp looped, {few}": theirs}, 1 if report.quick else 5)
    ends = run_chain(parsed.vary(changes(spoons)).design, 1e-10, dense_output=False)[1]
    share = float(np.mean(ends.status == Status.STALL))
    positions = np.where(ends.status == Status.STALL, ends.distance / spoons["radius_m"], turn(BASE))
    error = float(np.abs(positions[:few] - theirs()).max())
    each = {label: [time / (count if label == name else few) for time in times] for label, times in spent.items()}
    return [
        (
            f"{count} spoons, {share:.0%} stall",
            label,
            1e6 * median(times),
            ratio(each[name], times),
            ratio(each[name], times),
            error,
        )
        for label, times in each.items()
    ]


def main() -> None:
    """Measure and print."""
    report = Report("batches", __doc__)
    digits = ("", "", ".2f", ".4f", ".4f", ".1e")
    rows = races(report) + stalls(report)
    header = ("batch", "solver", "us_a_design", "chutecalc_over_it", "with_error_below_rtol", "error")
    report.write(header, rows, digits, by=1)
    panels: dict[str, dict[str, list[tuple[float, float]]]] = {}
    for where, name, spent, *_, error in rows:
        if "rtol" in where:
            points = panels.setdefault("8,192 spoons", {}).setdefault(name.partition(", rtol")[0], [])
            points.append((spent, max(error, 1e-16)))
    report.plot(panels, "µs a design", "largest relative error")
    report.file = report.file.with_name("batch_sizes")
    report.write(
        ("batch", "designs", "us_a_design", "over_one_thread", "peak_mib"),
        sizes(report),
        ("", "", ".2f", ".2f", ".0f"),
        by=1,
    )


if __name__ == "__main__":
    main()
