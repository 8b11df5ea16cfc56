"""A part of the trajectory with its columns where it was sampled, and their extremes."""

from collections.abc import Sequence
from typing import NamedTuple

from chutecalc.physics.arrays import Array, Numbers
from chutecalc.results.extremes import Extreme, ExtremeOf, extremes
from chutecalc.results.part import Part


class SampledPart(NamedTuple):
    """A part of the trajectory with its columns where it was sampled."""

    part: Part
    shares: Array
    """Shares of the part's length at which it was sampled, see :meth:`chutecalc.results.part.Part.shares`."""
    columns: Numbers
    """Columns by name, each of shape (samples, designs)."""
    extremes: dict[ExtremeOf, Extreme]

    def __repr__(self) -> str:
        return f"<SampledPart {self.part.name} ({self.part.kind}): {len(self.shares)} samples>"


def sample(part: Part, names: Sequence[str], extremes_of: Sequence[ExtremeOf]) -> SampledPart:
    """Sample a part where that resolves all quantities on it.

    Args:
        part: of a trajectory.
        names: of the columns to sample.
        extremes_of: extremes to find, of columns among them.
    """
    shares = part.shares()
    columns = part.at(shares, names)
    return SampledPart(part, shares, columns, extremes(part, columns, shares, extremes_of))
