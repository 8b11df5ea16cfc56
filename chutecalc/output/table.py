"""Reports for chute designers, with the same digits on a terminal and in a pipe."""

from __future__ import annotations

import math
import os
import sys
from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from chutecalc.fields.units import convert
from chutecalc.output.grid import Grid
from chutecalc.output.inlet import inlet_lines
from chutecalc.output.loads import loads_table
from chutecalc.output.receiver import receiver_lines
from chutecalc.results.column import Column, Units, quantity_text
from chutecalc.results.columns import COLUMNS, IN_TABLES
from chutecalc.results.finding import Finding, Severity
from chutecalc.results.segments import SegmentResult
from chutecalc.results.solved import SolvedChute
from chutecalc.spec.operating import DESIGN_POINT

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from chutecalc.results.cases import Cases

COLOURS: dict[str, str] = {Severity.FAILURE: "bold red", Severity.WARNING: "yellow", Severity.NOTE: "cyan"}
"""Styles of rich by the severity of a finding."""
PIPE_WIDTH = 80
"""Width of tables where there is no terminal, characters."""
NO_WRAP = 100_000
"""Width at which rich breaks no table, characters."""
HANGING = "    "
"""Text before the further lines of a line that is wrapped."""


class Printer:
    """Prints reports to a stream.

    Args:
        units: ``metric`` or ``us``.
        stream: where to print; None for standard output.
        columns: names of the station columns of tables.
    """

    def __init__(self, units: str = "metric", stream: Any = None, columns: Iterable[str] = IN_TABLES) -> None:
        self.units = units
        self.columns = [name for name in columns if COLUMNS[name].formula]
        self.stream = stream or sys.stdout
        self.is_terminal = self.stream.isatty()

    @cached_property
    def console(self) -> Console:
        """Console of rich, for a terminal."""
        from rich.console import Console

        return Console(
            file=self.stream,
            color_system=None if os.environ.get("NO_COLOR") else "auto",
            force_terminal=True,
            highlight=False,
            markup=False,
            emoji=False,
        )

    @property
    def width(self) -> int:
        """Width of a line, characters."""
        return self.console.width if self.is_terminal else PIPE_WIDTH

    def text(self, text: str = "", plain: str = "", style: str = "") -> None:
        """Print a line. On a terminal it is wrapped between words; elsewhere it stays one line, for grep.

        Args:
            text: the line, or its beginning if there is ``plain``.
            plain: the rest of the line, without style.
            style: style of ``text`` on a terminal, as rich takes it.
        """
        if self.is_terminal:
            from rich.text import Text

            line = Text(text, style=style).append(plain, style="none")
            if line.cell_len > self.width:
                lines = line.wrap(self.console, self.width - len(HANGING))
                for each in lines:
                    each.rstrip()
                line = Text(f"\n{HANGING}").join(lines)
            self.console.print(line, no_wrap=True, overflow="ignore", crop=False)
        else:
            self.stream.write(f"{text}{plain}\n")

    def table(self, grid: Grid) -> None:
        """Print a table; one that is too wide as several, one below the other. Numbers are never cut or broken.

        Args:
            grid: the table.
        """
        for number, part in enumerate(grid.fitted(self.width)):
            if number:
                self.text()
            if self.is_terminal:
                self._drawn(part.drawn())
            else:
                self.stream.writelines(f"{line}\n" for line in part.lines())

    def _drawn(self, table: Table) -> None:
        """Print a table of rich at its own width."""
        from rich.measure import Measurement

        needed = Measurement.get(self.console, self.console.options.update(width=NO_WRAP), table).maximum
        self.console.width, width = max(self.console.width, needed), self.console.width
        self.console.print(table, crop=False)
        self.console.width = width

    def report(self, solution: SolvedChute, case: str = DESIGN_POINT) -> None:
        """Print a chute: its title and flow, its segments, its outcome and findings.

        Args:
            solution: solution of one design.
            case: name of its operating state.
        """
        state = "" if case == DESIGN_POINT else f", case {case}"
        self.text(f"{solution.spec.title or solution.source}{state}", style="bold")
        self.text(_flow_line(solution, self.units))
        self.text()
        self.table(self._segments(solution.trajectory.rows))
        self.text()
        self.text(outcome(solution, self.units), style="" if solution.ok[0] else COLOURS[Severity.FAILURE])
        for line in (*self._impacts(solution), *self._belts(solution)):
            self.text(line)
        self.loads(solution)
        self.findings(solution.findings())

    def loads(self, solution: SolvedChute) -> None:
        """Print the forces on the segments and the wear of their liners, where a segment has any.

        Args:
            solution: solution of one design.
        """
        table = loads_table(solution.segments, self.units)
        if table.rows:
            self.text()
            self.table(table)
            self.text()

    def findings(self, findings: Sequence[Finding]) -> None:
        """Print findings, a line each.

        Args:
            findings: findings of one design.
        """
        for finding in findings:
            self.text(
                f"{finding.severity} {finding.code}",
                f"  {finding.where(0, self.units)}: {finding.message(0, self.units)}",
                COLOURS[finding.severity],
            )

    def cases(self, cases: Cases) -> None:
        """Print the operating states of a chute, and what goes wrong in them beside the findings of the design point.

        Args:
            cases: the states of one design.
        """
        from chutecalc.output.cases import cases_table

        self.text()
        self.table(cases_table(cases, self.units))
        self.text()
        self.case_findings(cases)

    def case_findings(self, cases: Cases) -> None:
        """Print what goes wrong in cases beside the findings of the design point, a line each.

        Args:
            cases: the states of one design.
        """
        from chutecalc.output.cases import case_findings

        for severity, begin, rest in case_findings(cases, self.units):
            self.text(begin, rest, COLOURS[severity])

    def stations(self, stations: dict[str, Any]) -> None:
        """Print stations along the stream.

        Args:
            stations: stations of one design, from :meth:`chutecalc.Solution.stations`.
        """
        table = self._new_table(["segment"], place=("s_m",))
        for k, segment in enumerate(stations["segment"][0].tolist()):
            if stations["s_m"][0, k] == stations["s_m"][0, k]:
                table.row([segment, *(COLUMNS[name].shown(stations[name][0, k], self.units) for name in self.columns)])
        self.table(table)

    def comparison(self, solutions: Sequence[SolvedChute]) -> None:
        """Print the streams at the ends of several chutes, a row each.

        Args:
            solutions: solutions of one design each.
        """
        table = self._new_table(["spec", "status"], "comparison")
        for solution in solutions:
            cells = (COLUMNS[name].shown(float(solution.exit[name][0]), self.units) for name in self.columns)
            table.row([solution.source, str(solution.status[0]), *cells])
        self.table(table)

    def catalogue(self) -> None:
        """Print the catalogue of columns."""
        table = Grid()
        for heading in ("name", "unit", "symbol", "meaning"):
            table.column(heading, left=True, label=heading == "name", words=heading == "meaning")
        for column in COLUMNS.values():
            table.row([column.name, column.unit_text("metric"), column.symbol, column.meaning])
        self.table(table)

    def _segments(self, results: Sequence[SegmentResult]) -> Grid:
        """Return the ends of each segment, and the extremes that lie beyond those."""
        table = self._new_table(["segment", "kind", ""])
        for result in results:
            if result.entry["s_m"][0] != result.entry["s_m"][0]:
                table.row([result.name, result.kind, str(result.status[0]).replace("_", " ")])
                continue
            rows = [("in", result.entry), ("out", result.exit)]
            for label, sign, extremes in (("min", -1.0, result.minimum), ("max", 1.0, result.maximum)):
                shown = [name for name in extremes if name in self.columns]
                if any(
                    _exceeds(*(sign * of[name][0] for of in (extremes, result.entry, result.exit))) for name in shown
                ):
                    rows.append((label, extremes))
            for row, (label, numbers) in enumerate(rows):
                names = (result.name, result.kind) if row == 0 else ("", "")
                cells = (
                    COLUMNS[name].shown(float(numbers[name][0]), self.units) if name in numbers else ""
                    for name in self.columns
                )
                table.row([*names, label, *cells])
        return table

    def _new_table(self, labels: Sequence[str], title: str = "", place: Sequence[str] = ()) -> Grid:
        """Return an empty table of labels and station columns; those of ``place`` say where a row is."""
        table = Grid(title)
        for label in labels:
            table.column(label, left=True, label=True)
        for name in self.columns:
            table.column(heading(COLUMNS[name], self.units), label=name in place)
        return table

    def _impacts(self, solution: SolvedChute) -> Iterator[str]:
        """Yield a line for each impact of the stream on a surface."""
        for segment in solution.trajectory.results:
            text = {name: quantity_text(name, float(values[0]), self.units) for name, values in segment.impact.items()}
            if segment.impact and segment.impact["incidence_deg"][0] == segment.impact["incidence_deg"][0]:
                yield (
                    f"impact  {segment.name}: at {text['incidence_deg']}, {text['velocity_before_m_s']} before and"
                    f" {text['velocity_after_m_s']} after, {text['pressure_kpa']} and {text['wear_w_m2']} over a length"
                    f" of {text['footprint_m']}"
                )

    def _belts(self, solution: SolvedChute) -> Iterator[str]:
        """Yield lines on the belt that the stream leaves and on the one that receives it."""
        yield from inlet_lines(solution, self.units)
        yield from receiver_lines(solution, self.units)


def heading(column: Column, units: str) -> str:
    """Return the heading of a column with its unit, a line for each word.

    Args:
        column: of the catalogue.
        units: ``metric`` or ``us``.

    >>> heading(COLUMNS["chamfer_wear_w_m2"], "metric").splitlines()
    ['wear', 'chamfer', 'W/m²']
    """
    return "\n".join([*column.heading.split(" "), column.unit_text(units)])


def outcome(solution: SolvedChute, units: str) -> str:
    """Return the status of a chute and the stream at its exit, in a line.

    Args:
        solution: solution of one design.
        units: ``metric`` or ``us``.
    """
    if not solution.ok[0]:
        return f"status {solution.status[0]}"
    parts = []
    for name in ("velocity_m_s", "depth_m", "slope_deg"):
        column, value = COLUMNS[name], float(solution.exit[name][0])
        if value == value:
            parts.append(f"{column.heading} {column.shown(value, units)} {column.unit_text(units)}")
    return (
        f"status {solution.status[0]}, exit {', '.join(parts)} (error estimate {float(solution.error_estimate[0]):.0e})"
    )


def _exceeds(extreme: float, *ends: float) -> bool:
    """Return whether an extreme is visibly above both ends. A stream that comes to rest has only one."""
    end = max((end for end in ends if end == end), default=extreme)
    return extreme > end and (math.isinf(extreme) or extreme - end > 1e-6 * abs(extreme))


def _flow_line(solution: SolvedChute, units: str) -> str:
    """Return the spec and what flows, in a line."""
    material, flow = solution.spec.material, solution.spec.flow
    rate, density = f"{flow.rate_t_h:g} t/h", f"{material.density_kg_m3:g} kg/m³"
    if units == Units.US:
        rate = f"{convert(flow.rate_t_h, 'mass rate', 't_h', 'stph'):.6g} short tons/h"
        density = f"{convert(material.density_kg_m3, 'density', 'kg_m3', 'lb_ft3'):.4g} lb/ft³"
    strength = f"δ {material.internal_friction_deg:g}°" if material.internal_friction_deg is not None else ""
    ratio = f"K_v {material.pressure_ratio:g}" if material.pressure_ratio is not None else ""
    what = ", ".join(part for part in (density, strength, ratio) if part)
    return f"{solution.source}: {rate} of {material.name or 'material'} ({what})"
