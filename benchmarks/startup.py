"""`chutecalc run` as a process, beside the least that such a program can take.

    python benchmarks/startup.py [RUNS]

The rival is a Typer program with one argument that imports NumPy and prints one rich table of the same size. Both run
in turn; the ratio is taken pair by pair.
"""

import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

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


def seconds(command: list[str]) -> float:
    """Wall time of a process."""
    start = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return time.perf_counter() - start


def main(runs: int) -> None:
    """Measures and prints."""
    with tempfile.TemporaryDirectory() as folder:
        hello = Path(folder, "hello.py")
        hello.write_text(HELLO, encoding="utf-8")
        ours = [sys.executable, "-m", "chutecalc", "run", str(SPEC)]
        rival = [sys.executable, str(hello), "world"]
        seconds(ours), seconds(rival)
        pairs = [(seconds(ours), seconds(rival)) for _ in range(runs)]
    ratios = [a / b for a, b in pairs]
    low, _, high = statistics.quantiles(ratios, n=4)
    print(f"chutecalc run   median {statistics.median(a for a, _ in pairs):.3f} s")
    print(f"Typer + NumPy   median {statistics.median(b for _, b in pairs):.3f} s")
    print(f"ratio           median {statistics.median(ratios):.3f}, quartiles {low:.3f} to {high:.3f}, {runs} pairs")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 30)
