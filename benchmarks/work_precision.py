"""Run time against error: one spoon solved, at 101 stations or at its exit, by chutecalc and by other solvers.

    python benchmarks/work_precision.py [--quick] [--out FOLDER]

The error is the largest relative error of the velocity at the stations that tests/reference/spoon.csv knows to 20
digits. For the spoon that fills its chamfers it is compared with two DOP853 runs at rtol 3e-14 that meet at the top of
the chamfers. All solvers run in turn, many times; times are medians, and ratios are to DOP853 at 1e-10 in the same
round. The right-hand side of the others is what one would write in Python for one design, in v², with plain floats and
`math`; that of heyoka and of numbalsoda (if installed: `pip install numbalsoda`, with a Fortran compiler) is compiled
beforehand. The time of chutecalc includes building the numbers from the checked spec, solving, and velocity and depth
at the stations; 'with check' also reads and checks the spec. `chute.function` takes radius and wall friction and gives
the exit.
"""

import csv
from functools import partial
from importlib.util import find_spec
from itertools import groupby
from pathlib import Path

import numpy as np
from measure import Report, in_turn, median, ratio
from scipy.integrate import solve_ivp
from spoon import (
    STATIONS,
    Case,
    entry,
    equation,
    heyoka_numbers,
    spec,
    turn,
    with_chutecalc,
    with_function,
    with_heyoka,
    with_odeint,
    with_solve_ivp,
    with_steps,
)

import chutecalc

REFERENCE = Path(__file__).parents[1] / "tests" / "reference" / "spoon.csv"
CASES = ("base_d55_b45_R3", "deep_b90", "near_b45", "beta89.999999")
OVERFLOWN = "base_d55_b45_R3 with a top"
YARDSTICK = "solve_ivp DOP853 1e-10"
Row = tuple[str, str, float, float, float]


def cases() -> dict[str, tuple[Case, np.ndarray]]:
    """Return the spoons by name: their numbers, and the velocities at every tenth station."""
    with open(REFERENCE, encoding="utf-8", newline="") as file:
        groups = {name: list(rows) for name, rows in groupby(csv.DictReader(file), key=lambda row: row["case"])}
    found = {
        name: (
            {key: float(value) for key, value in groups[name][0].items() if key != "case" and value},
            np.array([float(row["velocity_m_s"]) for row in groups[name]]),
        )
        for name in CASES
    }
    overflown = found[CASES[0]][0] | {"chamfer_m": 0.14}
    return found | {OVERFLOWN: (overflown, over_the_top(overflown))}


def over_the_top(case: Case) -> np.ndarray:
    """Return velocities at every tenth station of a spoon whose chamfers the stream fills."""
    rate = equation(case)
    beta, flow = np.radians(case["chamfer_deg"]), case["rate_t_h"] / 3.6 / case["density_kg_m3"]
    area = (case["base_m"] + case["chamfer_m"] * np.cos(beta)) * case["chamfer_m"] * np.sin(beta)

    def full(_: float, y: np.ndarray) -> float:
        return float(y[0] - (flow / area) ** 2)

    full.terminal = True
    grid, tight = np.linspace(0.0, turn(case), 11), {"rtol": 3e-14, "atol": 1e-15, "method": "DOP853"}
    start, y0, known = 0.0, entry(case) ** 2, {0.0: entry(case)}
    for event in (full, None):
        here = grid[grid > start]
        run = solve_ivp(lambda t, y: [rate(t, y[0])], (start, grid[-1]), [y0], t_eval=here, events=event, **tight)
        known |= dict(zip(run.t, np.sqrt(run.y[0]), strict=True))
        if event and run.t_events[0].size:
            start, y0 = run.t_events[0][0], run.y_events[0][0, 0]
    return np.array([known[angle] for angle in grid])


def rivals(quick: bool, case: Case, grid: np.ndarray) -> dict[str, partial[np.ndarray]]:
    """Return all solvers, by name and tolerance."""
    ours = ["1e-10"] if quick else ["1e-04", "1e-06", "1e-08", "1e-10", "1e-12", "1e-13"]
    theirs = ["1e-10"] if quick else ["1e-04", "1e-07", "1e-10", "1e-13"]
    checked = chutecalc.parse(spec(case))
    found = {YARDSTICK: partial(with_solve_ivp, "DOP853", 1e-10, grid, case)}
    found |= {f"chutecalc {rtol}": partial(with_chutecalc, float(rtol), grid, case, checked) for rtol in ours}
    found |= {"chutecalc with check 1e-10": partial(with_chutecalc, 1e-10, grid, case)}
    if len(grid) == 2:
        velocity = checked.function(["segments.spoon.radius_m", "liners.wall.friction_deg"], rtol=1e-10)
        found |= {"chute.function 1e-10": partial(with_function, velocity, case)}
    for method in ("DOP853",) if quick else ("RK45", "DOP853", "LSODA", "Radau"):
        found |= {
            f"solve_ivp {method} {rtol}": partial(with_solve_ivp, method, float(rtol), grid, case) for rtol in theirs
        }
    found |= {f"odeint {rtol}": partial(with_odeint, float(rtol), grid, case) for rtol in theirs}
    found |= {f"Runge-Kutta 4 {n}": partial(with_steps, 4, n, grid, case) for n in ((100,) if quick else (100, 1000))}
    found |= {"Euler 1000": partial(with_steps, 1, 1000, grid, case)}
    if "chamfer_m" not in case and find_spec("heyoka"):
        found |= {f"heyoka {rtol}": partial(with_heyoka, float(rtol), grid, case) for rtol in theirs}
    if "chamfer_m" not in case and find_spec("numbalsoda"):
        from compiled import with_numbalsoda

        data = entry(case), heyoka_numbers(case)
        for method in ("lsoda", "dop853"):
            found |= {
                f"numbalsoda {method} {rtol}": partial(with_numbalsoda, method, float(rtol), grid, *data)
                for rtol in theirs
            }
    return found


def measured(name: str, stations: int, case: Case, exact: np.ndarray, rounds: int, quick: bool) -> list[Row]:
    """Measure case and solver: median time, ms, median ratio to DOP853, and error."""
    grid = np.linspace(0.0, turn(case), stations)
    tried = rivals(quick, case, grid)
    known = exact if stations > 2 else exact[[0, -1]]
    errors = {
        label: float(np.max(np.abs(solve()[:: max(1, (stations - 1) // 10)] / known - 1.0)))
        for label, solve in tried.items()
    }
    spent = in_turn(dict(tried), rounds)
    where = f"{name}, {'exit alone' if stations == 2 else f'{stations} stations'}"
    return [
        (where, label, 1e3 * median(times), ratio(times, spent[YARDSTICK]), errors[label])
        for label, times in spent.items()
    ]


def main() -> None:
    """Measure and print."""
    report = Report("work_precision", __doc__)
    rows = [
        row
        for name, (case, exact) in cases().items()
        for stations in (STATIONS, 2)
        for row in measured(name, stations, case, exact, 2 if report.quick else 15, report.quick)
    ]
    report.write(("case", "solver", "time_ms", "ratio", "error"), rows, ("", "", ".3f", ".3f", ".1e"), by=1)
    panels: dict[str, dict[str, list[tuple[float, float]]]] = {}
    for where, label, spent, _, error in rows:
        if "exit" not in where:
            points = panels.setdefault(where.split(",")[0], {}).setdefault(label.rpartition(" ")[0], [])
            points.append((spent, max(error, 1e-16)))
    report.plot(panels, "time, ms", "largest relative error of the velocity")


if __name__ == "__main__":
    main()
