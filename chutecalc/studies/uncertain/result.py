"""What is known of a chute whose numbers are uncertain, with its text and pictures."""

from typing import TYPE_CHECKING

from chutecalc.results.described import html_table
from chutecalc.studies.uncertain.bands import POINTS, Bands, bands
from chutecalc.studies.uncertain.outcome import Outcome
from chutecalc.studies.uncertain.statistics import FAILS, Summary

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Uncertainty(Outcome):
    """Samples of a chute, what they say, and which keys matter; arrays of shape (samples,)."""

    def bands(self, points: int = POINTS) -> Bands:
        """Return quantiles of velocity and depth along the chute.

        Args:
            points: stations of each segment.
        """
        return bands(self, points)

    def plot(self, units: str = "metric") -> "Figure":
        """Draw what each key does alone, and the bands of velocity and depth along the chute.

        Args:
            units: ``metric`` or ``us``.
        """
        from chutecalc.studies.uncertain.plot import draw_uncertainty

        figure: Figure = draw_uncertainty(self, units)
        return figure

    def __repr__(self) -> str:
        r"""Return the samples, the first column and the chance of failure.

        >>> import chutecalc
        >>> chutecalc.uncertain(chutecalc.parse(chutecalc.STARTER + '[uncertainty]\n"flow.rate_t_h" = 100'))
        <Uncertainty of 16384 samples: exit_velocity_m_s 6.222 (5 to 95 %: 6.217 to 6.227), 0 % fail>
        """
        return f"<{self._described()}>"

    def _repr_html_(self) -> str:
        """Return a table of the columns, for notebooks."""
        rows = [
            (name, *(f"{value:.4g}" for value in (own.mean, own.deviation, *own.quantiles)))
            for name, own in self._known()
        ]
        headings = ("column", "mean", "standard deviation", "5 %", "50 %", "95 %")
        return html_table(self._described(), headings, rows)

    def _known(self) -> list[tuple[str, Summary]]:
        """Return the columns that any sample has, by name."""
        return [(name, own) for name, own in self.summaries.items() if own.mean == own.mean]

    def _described(self) -> str:
        """Return the first column that any sample has, and the chance of failure, as text."""
        spread = ""
        for name, own in self._known()[:1]:
            low, _, high = own.quantiles
            spread = f"{name} {own.mean:.4g} (5 to 95 %: {low:.4g} to {high:.4g}), "
        return f"Uncertainty of {self.count} samples: {spread}{100.0 * self.chances[FAILS].share:.3g} % fail"
