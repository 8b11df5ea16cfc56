"""Tables of columns along a stream: of the ends of segments, of stations, of the ends of several chutes."""

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from chutecalc.output.grid import Grid
from chutecalc.physics.arrays import Numbers
from chutecalc.results.column import Column
from chutecalc.results.columns import COLUMNS
from chutecalc.results.described import status_words
from chutecalc.results.segments import SegmentResult
from chutecalc.results.solved import SolvedChute


class StreamTables:
    """Makes tables of some columns along a stream.

    Args:
        columns: names of the columns; those of text are left out.
        units: ``metric`` or ``us``.
    """

    def __init__(self, columns: Sequence[str], units: str) -> None:
        self.columns, self.units = {name: COLUMNS[name] for name in columns if COLUMNS[name].formula}, units

    def segments(self, results: Sequence[SegmentResult]) -> Grid:
        """Return the ends of each segment, and the extremes that lie beyond those.

        Args:
            results: of one design, in order.
        """
        table = self._table(["segment", "kind", ""])
        named = None
        for result, label, numbers in self.ends(results):
            names = ("", "") if result is named else (result.name, result.kind)
            table.row([*names, label, *(self._cells(numbers) if numbers else ())])
            named = result
        return table

    def ends(self, results: Sequence[SegmentResult]) -> Iterator[tuple[SegmentResult, str, dict[str, float]]]:
        """Yield the ends of each segment, and the extremes that lie beyond those: what it is called, and the numbers.

        Args:
            results: of one design, in order. One that the stream does not reach has its status and no numbers.
        """
        for result in results:
            if result.entry["s_m"][0] != result.entry["s_m"][0]:
                yield result, status_words(result.status[0]), {}
                continue
            for label, numbers in self._ends(result):
                yield result, label, {name: float(values[0]) for name, values in numbers.items()}

    def stations(self, stations: Mapping[str, Any]) -> Grid:
        """Return a row for each station along the stream.

        Args:
            stations: stations of one design, from :meth:`chutecalc.Solution.stations`.
        """
        table = self._table(["segment"], place=("s_m",))
        for k, segment in enumerate(stations["segment"][0].tolist()):
            if stations["s_m"][0, k] == stations["s_m"][0, k]:
                table.row([segment, *self._cells({name: stations[name][0, k] for name in self.columns})])
        return table

    def comparison(self, solutions: Sequence[SolvedChute]) -> Grid:
        """Return the streams at the ends of several chutes, a row each.

        Args:
            solutions: solutions of one design each.
        """
        table = self._table(["spec", "status"], "comparison")
        for solution in solutions:
            numbers = {name: solution.exit[name][0] for name in self.columns}
            table.row([solution.source, str(solution.status[0]), *self._cells(numbers)])
        return table

    def _ends(self, result: SegmentResult) -> Iterator[tuple[str, Numbers]]:
        """Yield the stream where it enters and leaves a segment, and its extremes if any is beyond both ends."""
        yield "in", result.entry
        yield "out", result.exit
        for label, sign, extremes in (("min", -1.0, result.minimum), ("max", 1.0, result.maximum)):
            shown = [name for name in extremes if name in self.columns]
            if any(_exceeds(*(sign * of[name][0] for of in (extremes, result.entry, result.exit))) for name in shown):
                yield label, extremes

    def _cells(self, numbers: Mapping[str, Any]) -> Iterator[str]:
        """Yield the numbers of a row as text, empty where there is none."""
        for name, column in self.columns.items():
            yield column.shown(float(numbers[name]), self.units) if name in numbers else ""

    def _table(self, labels: Sequence[str], title: str = "", place: Sequence[str] = ()) -> Grid:
        """Return an empty table of labels and columns; those of ``place`` say where a row is."""
        table = Grid(title)
        for label in labels:
            table.column(label, left=True, label=True)
        for name, column in self.columns.items():
            table.column(heading(column, self.units), label=name in place)
        return table


def heading(column: Column, units: str) -> str:
    """Return the heading of a column with its unit, a line for each word.

    Args:
        column: of the catalogue.
        units: ``metric`` or ``us``.

    >>> heading(COLUMNS["chamfer_wear_w_m2"], "metric").splitlines()
    ['wear', 'chamfer', 'W/m²']
    """
    return "\n".join([*column.heading.split(" "), column.unit_text(units)])


def _exceeds(extreme: float, *ends: float) -> bool:
    """Return whether an extreme is visibly above both ends. A stream that comes to rest has only one."""
    end = max((end for end in ends if end == end), default=extreme)
    return extreme > end and (math.isinf(extreme) or extreme - end > 1e-6 * abs(extreme))
