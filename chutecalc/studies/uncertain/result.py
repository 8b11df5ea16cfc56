"""What is known of a chute whose numbers are uncertain."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from chutecalc.api.chute import Chute
from chutecalc.api.uncertain_keys import UncertainKeys
from chutecalc.physics.arrays import Mask, Numbers
from chutecalc.results.described import html_table
from chutecalc.studies.uncertain.importance import Indices, Tornado
from chutecalc.studies.uncertain.statistics import FAILS, STATUSES, Chance, Ends, Summary

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from chutecalc.studies.uncertain.bands import Bands


@dataclass(frozen=True, repr=False, eq=False)
class Uncertainty:
    """Samples of a chute, what they say, and which keys matter; arrays of shape (samples,)."""

    chute: Chute
    """The chute in the state in which it was solved."""
    case: str
    """Name of that state, ``design`` for the spec as written."""
    keys: UncertainKeys
    """What is uncertain."""
    seed: int
    """From which the samples follow."""
    rtol: float
    """Relative tolerance of the solver."""
    values: Numbers
    """Values of the keys by path, in their units."""
    ends: Ends
    """Number of each sample's status, see :attr:`status`."""
    columns: Numbers
    """Columns by name: NaN where a sample fails."""
    summaries: dict[str, Summary]
    """Mean, standard deviation and quantiles of each column, over the samples that do not fail."""
    chances: dict[str, Chance]
    """Chance of each way to end, and of ``fails``: of all but ok."""
    indices: dict[str, Indices]
    """Sobol indices by column; under the name ``fails``, those of failure, where samples fail."""
    no_indices: str
    """Why there are none; empty if there are."""
    tornado: Tornado
    """Each key alone at its 5 % and 95 % quantile."""

    @property
    def count(self) -> int:
        """Number of samples."""
        return len(self.ends)

    @property
    def status(self) -> Any:
        """``ok``, ``stall``, ``choke``, ``contact_lost``, ``missed`` or ``impossible`` for each sample, as text."""
        return np.array(STATUSES)[self.ends]

    @property
    def ok(self) -> Mask:
        """Whether the stream of each sample reaches the end of the chute."""
        ok: Mask = self.ends == 0
        return ok

    def bands(self, points: int = 41) -> "Bands":
        """Return quantiles of velocity and depth along the chute.

        Args:
            points: stations of each segment.
        """
        from chutecalc.studies.uncertain.bands import bands

        return bands(self, points)

    def plot(self, units: str = "metric") -> "Figure":
        """Draw what each key does alone, and the bands of velocity and depth along the chute.

        Args:
            units: ``metric`` or ``us``.
        """
        from chutecalc.studies.uncertain.plot import draw_uncertainty

        return draw_uncertainty(self, units)

    def __repr__(self) -> str:
        r"""Return the samples, the first column and the chance of failure.

        >>> import chutecalc
        >>> chutecalc.uncertain(chutecalc.parse(chutecalc.STARTER + '[uncertainty]\n"flow.rate_t_h" = 100'))
        <Uncertainty of 16384 samples: exit_velocity_m_s 3.878 (5 to 95 %: 3.866 to 3.891), 0 % fail>
        """
        return f"<{self._described()}>"

    def _repr_html_(self) -> str:
        """Return a table of the columns, for notebooks."""
        rows = [
            (name, *(f"{value:.4g}" for value in (own.mean, own.deviation, *own.quantiles)))
            for name, own in self.summaries.items()
        ]
        headings = ("column", "mean", "standard deviation", "5 %", "50 %", "95 %")
        return html_table(self._described(), headings, rows)

    def _described(self) -> str:
        """Return the first column and the chance of failure, as text."""
        name, own = next(iter(self.summaries.items()))
        low, _, high = own.quantiles
        fails = 100.0 * self.chances[FAILS].share
        spread = f"{name} {own.mean:.4g} (5 to 95 %: {low:.4g} to {high:.4g})"
        return f"Uncertainty of {self.count} samples: {spread}, {fails:.3g} % fail"
