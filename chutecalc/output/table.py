"""Tables that a chute designer reads, with the same digits on a terminal and in a pipe."""

from __future__ import annotations

import math
import os
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from chutecalc.fields.units import convert
from chutecalc.output.grid import Grid
from chutecalc.results.column import quantity_text
from chutecalc.results.columns import COLUMNS, IN_TABLES
from chutecalc.results.finding import Finding, Severity
from chutecalc.results.segments import SegmentResult
from chutecalc.results.solved import SolvedChute

if TYPE_CHECKING:
    from rich.console import Console

COLOURS: dict[str, str] = {Severity.FAILURE: "bold red", Severity.WARNING: "yellow", Severity.NOTE: "cyan"}
NO_WRAP = 100_000


class Printer:
    """Prints reports to a stream, for people."""

    def __init__(self, units: str = "metric", stream: Any = None) -> None:
        self.units = units
        self.stream = stream or sys.stdout
        self.is_terminal = self.stream.isatty()

    @cached_property
    def console(self) -> Console:
        """Of the terminal."""
        from rich.console import Console

        return Console(
            file=self.stream,
            color_system=None if os.environ.get("NO_COLOR") else "auto",
            force_terminal=True,
            highlight=False,
            markup=False,
            emoji=False,
        )

    def text(self, text: str = "", plain: str = "", style: str = "") -> None:
        """A line, wrapped on a terminal only, where what comes before ``plain`` has a style."""
        if self.is_terminal:
            from rich.text import Text

            self.console.print(Text(text, style=style).append(plain, style="none"))
        else:
            self.stream.write(f"{text}{plain}\n")

    def table(self, grid: Grid) -> None:
        """A table at its own width: numbers are never cut or folded."""
        if not self.is_terminal:
            self.stream.writelines(f"{line}\n" for line in grid.lines())
            return
        from rich.measure import Measurement

        table = grid.drawn()
        needed = Measurement.get(self.console, self.console.options.update(width=NO_WRAP), table).maximum
        self.console.width, width = max(self.console.width, needed), self.console.width
        self.console.print(table, crop=False)
        self.console.width = width

    def report(self, solution: SolvedChute) -> None:
        """A chute: what it is, its segments, its findings."""
        self.text(solution.spec.title or solution.source, style="bold")
        self.text(_flow_line(solution, self.units))
        self.text()
        self.table(self._segments(solution.trajectory.results))
        self.text()
        self.text(outcome(solution, self.units), style="" if solution.status[0] == "ok" else COLOURS[Severity.FAILURE])
        for line in (*self._impacts(solution), *self._belts(solution)):
            self.text(line)
        self.findings(solution.findings())

    def findings(self, findings: Sequence[Finding]) -> None:
        """What a designer has to know."""
        for finding in findings:
            place = COLUMNS["s_m"].shown(float(finding.s_m[0]), self.units)
            unit = COLUMNS["s_m"].unit_text(self.units)
            self.text(
                f"{finding.severity} {finding.code}",
                f"  {finding.segment}, s = {place} {unit}: {finding.message(0, self.units)}",
                COLOURS[finding.severity],
            )

    def stations(self, stations: dict[str, Any]) -> None:
        """The stream along the chute."""
        table = self._new_table(["segment"])
        for k, segment in enumerate(stations["segment"][0].tolist()):
            if stations["s_m"][0, k] == stations["s_m"][0, k]:
                table.row([segment, *(COLUMNS[name].shown(stations[name][0, k], self.units) for name in IN_TABLES)])
        self.table(table)

    def comparison(self, solutions: Sequence[SolvedChute]) -> None:
        """Several chutes beside each other, at their ends."""
        table = self._new_table(["spec", "status"], "comparison")
        for solution in solutions:
            cells = (COLUMNS[name].shown(float(solution.exit[name][0]), self.units) for name in IN_TABLES)
            table.row([solution.source, str(solution.status[0]), *cells])
        self.table(table)

    def catalogue(self) -> None:
        """All columns."""
        table = Grid()
        for heading in ("name", "unit", "symbol", "meaning"):
            table.column(heading, to_left=True)
        for column in COLUMNS.values():
            table.row([column.name, column.unit_text("metric"), column.symbol, column.meaning])
        self.table(table)

    def _segments(self, ways: Sequence[SegmentResult]) -> Grid:
        """The ends and extremes of each segment."""
        table = self._new_table(["segment", "kind", ""])
        for way in ways:
            if way.entry["s_m"][0] != way.entry["s_m"][0]:
                table.row([way.name, way.kind, str(way.status[0]).replace("_", " ")])
                continue
            rows = [("in", way.entry), ("out", way.exit)]
            if any(
                _exceeds(-way.minimum[name][0], -way.entry[name][0], -way.exit[name][0])
                for name in way.minimum
                if name in IN_TABLES
            ):
                rows.append(("min", way.minimum))
            if any(
                _exceeds(way.maximum[name][0], way.entry[name][0], way.exit[name][0])
                for name in way.maximum
                if name in IN_TABLES
            ):
                rows.append(("max", way.maximum))
            for row, (label, numbers) in enumerate(rows):
                names = (way.name, way.kind) if row == 0 else ("", "")
                cells = (
                    COLUMNS[name].shown(float(numbers[name][0]), self.units) if name in numbers else ""
                    for name in IN_TABLES
                )
                table.row([*names, label, *cells])
        return table

    def _new_table(self, labels: Sequence[str], title: str = "") -> Grid:
        """A table of labels and the shown columns, headed with their units."""
        table = Grid(title)
        for label in labels:
            table.column(label, to_left=True)
        for name in IN_TABLES:
            column = COLUMNS[name]
            table.column(f"{column.heading}\n{column.unit_text(self.units)}")
        return table

    def _impacts(self, solution: SolvedChute) -> Iterator[str]:
        """Each place at which the stream strikes a surface."""
        for segment in solution.trajectory.results:
            said = {name: quantity_text(name, float(values[0]), self.units) for name, values in segment.impact.items()}
            if segment.impact and segment.impact["incidence_deg"][0] == segment.impact["incidence_deg"][0]:
                yield (
                    f"impact  {segment.name}: at {said['incidence_deg']}, {said['velocity_before_m_s']} before and"
                    f" {said['velocity_after_m_s']} after, {said['pressure_kpa']} and {said['wear_w_m2']} on"
                    f" {said['footprint_m']}"
                )

    def _belts(self, solution: SolvedChute) -> Iterator[str]:
        """The belt that the stream comes from, and the one that it goes to with what would suit it better."""

        def said(numbers: Mapping[str, Any], name: str) -> str:
            return quantity_text(name, float(numbers[name][0]), self.units)

        inlet = solution.inlet
        if "discharge_froude" in inlet:
            x, z, low_x, low_z = (said(inlet, name) for name in ("x_m", "z_m", "lower_edge_x_m", "lower_edge_z_m"))
            yield (
                f"inlet  leaves the belt at {said(inlet, 'slope_deg')} (V²/gr"
                f" {said(inlet, 'discharge_froude')}); its centre"
                f" line from x {x}, z {z}, lower edge from x {low_x}, z {low_z}"
            )
        belt = solution.receiver
        if not belt or belt["velocity_ratio"][0] != belt["velocity_ratio"][0]:
            return
        yield (
            f"receiver  {said(belt, 'velocity_along_m_s')} along the belt ({said(belt, 'velocity_ratio')} of its own),"
            f" {said(belt, 'velocity_across_m_s')} into it ({said(belt, 'impact_pressure_kpa')}); belt wear"
            f" {said(belt, 'wear_w_m2')}"
        )
        yield (
            f"receiver  at the belt's speed {self._reached(belt['acceleration_length_m'][0])}, with"
            f" {said(belt, 'acceleration_power_kw')}; friction on the impact leaves {said(belt, 'landed_velocity_m_s')}"
            f" along it, from there {self._reached(belt['landed_acceleration_length_m'][0])}"
        )
        yield f"receiver  {_advice(solution, said)}"

    def _reached(self, length: float) -> str:
        """Where material has the belt's velocity."""
        if length == float("inf"):
            return "never"
        way = quantity_text("length_m", abs(length), self.units)
        return f"after {way}" if length >= 0.0 else f"{way} behind where it falls, for it runs back first"


def outcome(solution: SolvedChute, units: str) -> str:
    """Status and exit of a chute in a line."""
    status = str(solution.status[0])
    if status != "ok":
        return f"status {status}"
    parts = []
    for name in ("velocity_m_s", "depth_m", "slope_deg"):
        column, value = COLUMNS[name], float(solution.exit[name][0])
        if value == value:
            parts.append(f"{column.heading} {column.shown(value, units)} {column.unit_text(units)}")
    return f"status ok, exit {', '.join(parts)} (error estimate {float(solution.error_estimate[0]):.0e})"


def _exceeds(extreme: float, *ends: float) -> bool:
    """Whether an extreme lies visibly above both ends, of which a stream at rest has one less."""
    end = max((end for end in ends if end == end), default=extreme)
    return extreme > end and (math.isinf(extreme) or extreme - end > 1e-6 * abs(extreme))


def _advice(solution: SolvedChute, said: Callable[[Mapping[str, Any], str], str]) -> str:
    """Which way the exit's velocity or slope is off the belt's."""
    belt, exit_ = solution.receiver, solution.exit
    ratio, slope = belt["velocity_ratio"][0], exit_["slope_deg"][0]
    if abs(ratio - 1.0) < 0.005:
        return "the stream has the belt's velocity along it"
    off = f"the stream is too {'slow' if ratio < 1.0 else 'fast'} for the belt"
    velocity = f"at this slope an exit velocity of {said(belt, 'matching_velocity_m_s')} would match"
    match = belt["matching_slope_deg"][0]
    if match != match:
        return f"{off}, even along it; {velocity}"
    way = "flatter" if match < slope else "steeper"
    return f"{off}; {velocity}, or an exit {way}, at {said(belt, 'matching_slope_deg')}, which changes what strikes it"


def _flow_line(solution: SolvedChute, units: str) -> str:
    """What flows."""
    material, flow = solution.spec.material, solution.spec.flow
    rate, density = f"{flow.rate_t_h:g} t/h", f"{material.density_kg_m3:g} kg/m³"
    if units == "us":
        rate = f"{convert(flow.rate_t_h, 'mass rate', 't_h', 'stph'):.6g} short tons/h"
        density = f"{convert(material.density_kg_m3, 'density', 'kg_m3', 'lb_ft3'):.4g} lb/ft³"
    strength = f"δ {material.internal_friction_deg:g}°" if material.internal_friction_deg is not None else ""
    ratio = f"K_v {material.pressure_ratio:g}" if material.pressure_ratio is not None else ""
    what = ", ".join(part for part in (density, strength, ratio) if part)
    return f"{solution.source}: {rate} of {material.name or 'material'} ({what})"
