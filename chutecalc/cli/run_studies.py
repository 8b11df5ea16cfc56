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
        self.bands: list[Band] = []
        self.sensitivities: list[Sensitivity | None] = []
        if band:
            from chutecalc.api.band import solve_band
            from chutecalc.spec.operating import DESIGN_POINT

            states = (chute if of.main == DESIGN_POINT else chute.cases[of.main] for chute, of in pairs)
            self.bands = [solve_band(state, rtol) for state in states]
        if sensitivity:
            from chutecalc.studies.sensitivity.study import sensitivity as solve

            self.sensitivities = [
                solve(chute, case=of.main, rtol=rtol) if of.main_solution.ok[0] else None for chute, of in pairs
            ]

    def document(self, number: int) -> dict[str, Any]:
        """Return what a chute's document has of them.

        Args:
            number: of the chute, from 0.
        """
        found: dict[str, Any] = {}
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
