"""Where the time of `chutecalc run` goes: read, check, build, solve, stations, table, file.

    python benchmarks/stages.py [--quick] [--out FOLDER]

Medians in microseconds within one process, for the worked example of the paper and for a hood and spoon. What comes
after `solve` is only done if it is asked for.
"""

import io
from collections.abc import Callable
from pathlib import Path
from typing import Any

from measure import Report, in_turn, median

import chutecalc
from chutecalc.output.dataset import Dataset
from chutecalc.output.formats.csv import CsvRows
from chutecalc.output.printer import Printer
from chutecalc.output.report import print_report
from chutecalc.output.run import run_dataset
from chutecalc.results.cases import Cases
from chutecalc.solver.chain import run_chain
from chutecalc.spec.build import build
from chutecalc.spec.chute_spec import ChuteSpec
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.spec.parse import parse_text

SPECS = Path(__file__).parents[1] / "specs"
Tasks = dict[str, Callable[[], Any]]


def stages(file: Path) -> Tasks:
    """Return the steps between a spec and its report."""
    text = file.read_text(encoding="utf-8")
    data = parse_text(text, "spec")
    chute = chutecalc.parse(text)
    solution = chutecalc.solve(chute)
    table = solution.stations(points=101)
    solved = run_chain(chute.design, solution.rtol)

    def again() -> chutecalc.Solution:
        """Return a solution that has not computed anything yet."""
        return chutecalc.Solution(chute, *solved, solution.rtol)

    return {
        "read TOML": lambda: parse_text(text, "spec"),
        "check": lambda: ChuteSpec.model_validate(data),
        "build": lambda: build(chute.spec),
        "solve": lambda: chutecalc.solve(chute),
        "stations, velocity and depth": lambda: again().stations(columns=("velocity_m_s", "depth_m")),
        "stations, all columns": lambda: again().stations(),
        "extremes and findings": lambda: again().findings(),
        "table": lambda: print_report(Printer("metric", io.StringIO()), again()),
        "CSV file": lambda: write_csv(run_dataset([Cases({DESIGN_POINT: solution})], lambda solution: table)),
    }


def write_csv(dataset: Dataset) -> None:
    """Write rows as ``run --csv`` does."""
    rows = CsvRows(io.StringIO(), dataset)
    for block in dataset.blocks:
        rows.write(block)
    rows.close()


def main() -> None:
    """Measure and print."""
    report = Report("stages", __doc__)
    rows = []
    for file in (SPECS / "paper" / "r3_d55_chamfered.toml", SPECS / "coal_hood_spoon.toml"):
        spent = in_turn(stages(file), 3 if report.quick else 200)
        rows += [(file.stem, name, 1e6 * median(times)) for name, times in spent.items()]
    report.write(("chute", "stage", "time_us"), rows, ("", "", ".0f"), by=1)
    panels = {name: {stage: time for chute, stage, time in rows if chute == name} for name, *_ in rows}
    report.bars(panels, "time, µs")


if __name__ == "__main__":
    main()
