"""Samples of a chute whose numbers are uncertain, and what they say."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from chutecalc.api.chute import Chute
from chutecalc.api.uncertain_keys import UncertainKeys
from chutecalc.physics.arrays import Mask, Numbers
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.uncertain.importance import Indices, Tornado
from chutecalc.studies.uncertain.statistics import STATUSES, Chance, Ends, Summary


@dataclass(frozen=True, repr=False, eq=False)
class Outcome:
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
    exceeded: dict[str, Chance]
    """Chance that each limit asked for is exceeded, by its text, among the samples that do not fail; then, of all
    samples, that one fails or exceeds any."""
    warned: dict[str, Chance] | None
    """Chance of each warning that any sample has, by its code, among the samples that do not fail; None if not asked
    for."""
    indices: dict[str, Indices]
    """Sobol indices by column; under the name ``fails``, those of failure, where samples fail."""
    no_indices: str
    """Why there are none; empty if there are."""
    tornado: Tornado
    """Each key alone at its 5 % and 95 % quantile."""

    @property
    def where(self) -> str:
        """Where the values of the keys stand about which they scatter, in words."""
        return "in the spec" if self.case == DESIGN_POINT else f"in case {self.case}"

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
