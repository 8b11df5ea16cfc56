"""What ``chutecalc run`` tells beside the stream itself, if asked: the band of the model, and sensitivities."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from chutecalc.api.chute import Chute
    from chutecalc.output.printer import Printer
    from chutecalc.results.band import Band
    from chutecalc.results.cases import Cases
    from chutecalc.studies.sensitivity.study import Sensitivity


class RunStudies:
    """Band and sensitivity of each chute, in the state that is shown in full."""

    def __init__(
        self, chutes: Sequence[Chute], cases: Sequence[Cases], rtol: float, *, band: bool, sensitivity: bool
    ) -> None:
        """Work out what is asked for.

        Args:
            chutes: of one design each.
            cases: the same, solved in all their states.
            rtol: relative tolerance, dimensionless.
            band: whether to solve the assumptions that the model leaves open.
            sensitivity: whether to tell how much each number changes the exit velocity.
        """
        pairs = list(zip(chutes, cases, strict=True))
        self._pairs, self._rtol = pairs, rtol
        self._quiet: dict[int, Band | None] = {}
        """Bands that were not asked for, by number of the chute."""
        self.bands: list[Band] = []
        self.sensitivities: list[Sensitivity | None] = []
        if band:
            from chutecalc.api.band import solve_band

            self.bands = [solve_band(self._chute(number), rtol) for number in range(len(pairs))]
        if sensitivity:
            from chutecalc.studies.sensitivity.study import sensitivity as solve

            self.sensitivities = [
                solve(chute, case=of.main, rtol=rtol) if of.main_solution.ok[0] else None for chute, of in pairs
            ]

    def _chute(self, number: int) -> Chute:
        """Return a chute in the state that is shown in full."""
        from chutecalc.spec.operating import DESIGN_POINT

        chute, of = self._pairs[number]
        return chute if of.main == DESIGN_POINT else chute.cases[of.main]

    def band(self, number: int) -> Band | None:
        """Return the band of a chute, asked for or not; None where steel cannot be drawn for every variant.

        Args:
            number: of the chute, from 0.
        """
        from chutecalc.api.report import band_or_none

        if self.bands:
            return self.bands[number]
        if number not in self._quiet:
            self._quiet[number] = band_or_none(self._chute(number), self._rtol)
        return self._quiet[number]

    def band_line(self, number: int, units: str) -> str:
        """Return the band of the stream at the exit, in a line that every report has; empty where none gets there.

        Args:
            number: of the chute, from 0.
            units: ``metric`` or ``us``.
        """
        from chutecalc.output.band import exit_line

        if not self._pairs[number][1].main_solution.ok[0]:
            return ""
        band = self.band(number)
        return exit_line(band, units) if band else ""

    def document(self, number: int) -> dict[str, Any]:
        """Return what a chute's document has of them.

        Args:
            number: of the chute, from 0.
        """
        found: dict[str, Any] = {"band": None, "sensitivity": None}
        if self.bands:
            from chutecalc.output.band import band_document

            found["band"] = band_document(self.bands[number])
        if self.sensitivities:
            from chutecalc.studies.sensitivity.report import sensitivity_document

            own = self.sensitivities[number]
            found["sensitivity"] = None if own is None else sensitivity_document(own)
        return found

    def print(self, printer: Printer, number: int) -> None:
        """Print them.

        Args:
            printer: where to.
            number: of the chute, from 0.
        """
        if self.bands:
            from chutecalc.output.band import print_band

            print_band(printer, self.bands[number])
        if self.sensitivities:
            from chutecalc.studies.sensitivity.report import sensitivity_table

            printer.text()
            own = self.sensitivities[number]
            if own is None:
                printer.text("no sensitivity: a chute that fails has no exit velocity")
            else:
                printer.table(sensitivity_table(own, printer.units))
