"""Functions that the benchmarks share: rounds of tasks, ratios within a round, tables, CSV files and pictures."""

import argparse
import csv
import statistics
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table


class Report:
    """The options of a benchmark, and where its results go."""

    def __init__(self, name: str, doc: str | None) -> None:
        parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
        parser.add_argument("--quick", action="store_true", help="small and few: to see that it runs")
        parser.add_argument(
            "--out", type=Path, default=Path("benchmarks/out"), help="folder for the CSV and the picture"
        )
        options = parser.parse_args()
        self.quick: bool = options.quick
        self.file = options.out / name
        options.out.mkdir(parents=True, exist_ok=True)

    def write(self, header: Sequence[str], rows: Sequence[Sequence[Any]], digits: Sequence[str], by: int = 0) -> None:
        """Print a table for each value of the first ``by`` columns, and write everything as CSV."""
        groups: dict[tuple[Any, ...], list[Sequence[Any]]] = {}
        for row in rows:
            groups.setdefault(tuple(row[:by]), []).append(row[by:])
        for name, group in groups.items():
            table = Table(*header[by:], title=", ".join(map(str, name)) or None, title_justify="left", box=None)
            for row in group:
                table.add_row(*(format(value, how) for value, how in zip(row, digits[by:], strict=True)))
            Console(width=120).print(table)
        with open(self.file.with_suffix(".csv"), "w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows([header, *rows])

    def plot(self, panels: dict[str, dict[str, list[tuple[float, float]]]], x: str, y: str) -> None:
        """Draw a panel for each name, with a line for each label; both axes logarithmic."""
        if plt := _pyplot():
            labels = list(dict.fromkeys(label for lines in panels.values() for label in lines))
            figure, axes = plt.subplots(1, len(panels), figsize=(4.2 * len(panels), 4.2), sharey=True, squeeze=False)
            for axis, (name, lines) in zip(axes[0], panels.items(), strict=True):
                for number, label in enumerate(labels):
                    style = {"color": f"C{number % 10}", "marker": "osv^Dx+*P<>"[number % 11], "markersize": 5}
                    points = sorted(lines.get(label, []), key=lambda point: point[1])
                    axis.loglog(*np.array(points).reshape(-1, 2).T, label=label, **style)
                axis.set(title=name, xlabel=x)
                axis.grid(alpha=0.3)
            axes[0][0].set_ylabel(y)
            axes[0][-1].legend(fontsize=7, loc="center left", bbox_to_anchor=(1.0, 0.5))
            figure.savefig(self.file.with_suffix(".svg"), bbox_inches="tight")

    def bars(self, panels: dict[str, dict[str, float]], x: str) -> None:
        """Draw a panel for each name, with a bar for each label."""
        if plt := _pyplot():
            figure, axes = plt.subplots(1, len(panels), figsize=(5.5 * len(panels), 3.4), squeeze=False)
            for axis, (name, lengths) in zip(axes[0], panels.items(), strict=True):
                drawn = axis.barh(list(lengths), list(lengths.values()))
                axis.bar_label(
                    drawn, [f"{value:,.0f}" if value >= 100 else f"{value:.3g}" for value in lengths.values()]
                )
                axis.invert_yaxis()
                axis.margins(x=0.2)
                axis.locator_params(axis="x", nbins=4)
                axis.set(title=name, xlabel=x)
            figure.tight_layout()
            figure.savefig(self.file.with_suffix(".svg"), bbox_inches="tight")


def _pyplot() -> Any:
    """Return Matplotlib, if it is installed."""
    try:
        from matplotlib import pyplot
    except ImportError:
        print("no picture: matplotlib is not installed")
        return None
    return pyplot


def in_turn(
    tasks: dict[str, Callable[[], Any]], rounds: int, clock: Callable[[], float] = time.perf_counter
) -> dict[str, list[float]]:
    """Measure the time of each task in each round, s; the first round warms up and does not count."""
    spent: dict[str, list[float]] = {name: [] for name in tasks}
    for turn in range(rounds + 1):
        for name, task in tasks.items():
            start = time.perf_counter()
            task()
            if turn:
                spent[name].append(time.perf_counter() - start)
    return spent


def ratio(times: Sequence[float], rival: Sequence[float]) -> float:
    """Return the median of the ratios within the rounds."""
    return statistics.median(a / b for a, b in zip(times, rival, strict=True))


median = statistics.median
