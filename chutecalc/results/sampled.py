"""Where a part of the trajectory is sampled, its columns there, and their extremes."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from chutecalc.core.profile import flight_lengths
from chutecalc.physics.arrays import Array, Numbers
from chutecalc.results.extremes import Extreme, ExtremeOf, extremes
from chutecalc.results.part import Part

FLIGHT_SHARES = np.linspace(0.0, 1.0, 65)
"""Shares at which a flight is sampled: all is smooth along it."""


class SampledPart(NamedTuple):
    """A part of the trajectory with its columns where it was sampled."""

    part: Part
    shares: Array
    """Shares of the part's length at which it was sampled, see :func:`sample_shares`."""
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
    shares = sample_shares(part)
    columns = part.at(shares, names)
    return SampledPart(part, shares, columns, extremes(part, columns, shares, extremes_of))


def sample_shares(part: Part) -> Array:
    """Return shares of the length travelled that resolve all columns: 0, the knots of the solver's panels, and 1.

    Between two neighbours everything is smooth, as panels end at kinks.

    Args:
        part: of a trajectory.

    Returns:
        Shares of shape (samples,) where they are the same for all designs, else (samples, designs); a design with
        fewer samples repeats its end.
    """
    begin, end = part.span()
    if part.contact is None:
        _, _, _, downward, gravity = part.solved.path
        rises = (downward < 0.0) & (end > 0.0)
        if not rises.any():
            return FLIGHT_SHARES
        top = np.minimum(-downward / gravity, part.solved.flight_time)[None]  # next to it the velocity has its dip
        length = np.empty(top.shape)
        flight_lengths(part.solved.path, top, length)
        share = np.where(rises, length[0] / np.where(rises, end, 1.0), 1.0)
        return np.sort(np.concatenate([np.repeat(FLIGHT_SHARES[:, None], len(share), axis=1), share[None]]), axis=0)
    positions = part.contact.panels.knot_shares()
    length = np.where(end > begin, end - begin, np.inf)
    shares = np.ones((len(positions) + 1, len(begin)))
    shares[0] = 0.0
    inside = np.clip((positions - begin) / length, 0.0, 1.0)
    shares[1:] = np.where(np.isnan(inside), 1.0, inside)
    alike = (shares == shares[:, :1]).all()
    return shares[:, 0] if alike else shares
