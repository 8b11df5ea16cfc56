"""Commands as processes, compared with the least that such programs can take.

    python benchmarks/startup.py [--quick] [--out FOLDER]

"bare" is an interpreter that does nothing; "hello" a Typer program with one argument that imports NumPy and prints one
Rich table of the same size as ours; "solve_ivp" a script that imports what it needs and solves the worked example once.
All run in turn; ratios are taken within the rounds.
"""

import os
import subprocess
import sys
import tempfile
from functools import partial
from pathlib import Path

from measure import Report, in_turn, median, ratio

SPEC = Path(__file__).parents[1] / "specs" / "paper" / "r3_d55_chamfered.toml"
HELLO = """
import numpy as np
import typer

app = typer.Typer(rich_markup_mode=None, add_completion=False)


@app.command()
def main(name: str) -> None:
    from rich.console import Console
    from rich.table import Table

    table = Table(box=None)
    for number in range(12):
        table.add_column(f"column {number}\\nm", justify="right")
    for row in np.linspace(0.0, 1.0, 72).reshape(6, 12):
        table.add_row(*(f"{value:.4f}" for value in row))
    Console(width=1000).print(table)


app()
"""


SCRIPT = """
import math
from scipy.integrate import solve_ivp

g, R, B, mu, K, q = 9.81, 3.0, 0.5, math.tan(math.radians(25)), 0.5497, 1000 / 3.6 / 800 / math.sin(math.pi / 4)


def rate(t, y):
    v = y[0]
    c = 2 * q / v / (B + math.sqrt(B * B + 4 * q / v * math.cos(math.pi / 4)))
    m = mu * (1 + K * c * (1 - math.cos(math.pi / 4)) / (B + c * math.cos(math.pi / 4)))
    return [(g * R * math.cos(t) - m * (g * R * math.sin(t) + v * v)) / v]


print(solve_ivp(rate, (0, math.pi / 2), [math.sqrt(4 * g)], rtol=1e-8).y[0, -1])
"""


def main() -> None:
    """Measure and print."""
    report = Report("startup", __doc__)
    with tempfile.TemporaryDirectory() as folder:
        hello, script = Path(folder, "hello.py"), Path(folder, "script.py")
        hello.write_text(HELLO, encoding="utf-8")
        script.write_text(SCRIPT, encoding="utf-8")
        ours = [sys.executable, "-m", "chutecalc"]
        commands = {
            "bare": [sys.executable, "-c", ""],
            "hello": [sys.executable, str(hello), "world"],
            "solve_ivp": [sys.executable, str(script)],
            "chutecalc --help": [*ours, "--help"],
            "chutecalc run": [*ours, "run", str(SPEC)],
            "chutecalc sweep": [*ours, "sweep", "beta", str(SPEC)],
        }
        # Installed programs come with their bytecode.
        kept = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
        tasks = {
            name: partial(subprocess.run, command, check=True, stdout=subprocess.DEVNULL, env=kept)
            for name, command in commands.items()
        }
        spent = in_turn(tasks, 2 if report.quick else 40)
    rows = [
        (name, 1e3 * median(times), *(ratio(times, spent[rival]) for rival in ("bare", "hello", "solve_ivp")))
        for name, times in spent.items()
    ]
    header = ("process", "time_ms", "over_bare", "over_hello", "over_solve_ivp")
    report.write(header, rows, ("", ".0f", ".2f", ".2f", ".2f"))
    report.bars({"start-up": {row[0]: row[1] for row in rows}}, "time, ms")


if __name__ == "__main__":
    main()
