"""What criteria judge: a segment as the stream went along it, or a spec as it is written."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from chutecalc.design import Contact, Design, Status
from chutecalc.physics.arrays import Array, Index, Mask, Numbers
from chutecalc.results.edges import Edge
from chutecalc.results.extremes import Extreme
from chutecalc.results.part import Part
from chutecalc.results.sampled import SampledPart
from chutecalc.solver.segment_solution import ContactSolution, SegmentSolution
from chutecalc.spec.chute_spec import ChuteSpec
from chutecalc.spec.limits import LIMITS

SPEC = "set in the spec"
"""Source of a limit that is not the default."""


class Scene(NamedTuple):
    """What a criterion judges: a segment as the stream went along it."""

    sampled: SampledPart
    continues: Mask
    """Designs whose stream goes on to another part after this one."""
    last_surface: bool
    """Whether this is the last guiding surface."""
    received: Numbers
    """Receiver columns, at the end of a chute that loads a belt; else empty."""
    exit_distance: Array
    """Distance from the inlet at the exit, m; there too."""
    inlet: Numbers
    """Numbers of the inlet, at the first segment; else empty."""
    edges: Sequence[Edge]
    """Edges of a stream that comes from a belt; none where it is on the segment again."""
    status: Index
    """How the designs end, shape (designs,)."""

    @property
    def designs(self) -> int:
        """Number of designs."""
        return len(self.status)

    @property
    def part(self) -> Part:
        """The part of the trajectory."""
        return self.sampled.part

    @property
    def solved(self) -> SegmentSolution:
        """The solved segment."""
        return self.part.solved

    @property
    def design(self) -> Design:
        """The numeric description of the chutes."""
        return self.part.design

    @property
    def contact(self) -> ContactSolution:
        """The contact with the guiding surface; there is none in a fall."""
        contact = self.part.contact
        assert contact is not None
        return contact

    @property
    def segment(self) -> Contact:
        """The description of the guiding surface; there is none of a fall."""
        return self.part.surface

    @property
    def overwhelmed(self) -> Mask:
        """Designs whose stream stalls or chokes here: it grows thick and slow on the way to that."""
        status = self.solved.status
        overwhelmed: Mask = (status == Status.STALL) | (status == Status.CHOKE)
        return overwhelmed

    @property
    def falls_back(self) -> Mask:
        """Designs whose stream ends here in a closed section: it falls out of the mouth that it came in through."""
        lost = self.segment.closed & (self.solved.status == Status.CONTACT_LOST)
        falls_back: Mask = lost & ~self.continues & (self.status == Status.CONTACT_LOST)
        return falls_back

    def limit(self, key: str) -> Array:
        """Return a limit in force, in the unit of its key, shape (1,) or (designs,).

        Args:
            key: of the table ``[limits]``.
        """
        return LIMITS[key].of(self.design.limits)

    def extreme(self, name: str, sign: float) -> Extreme:
        """Return the least or largest value of a column that the criterion needs.

        Args:
            name: of the column.
            sign: ``LEAST`` or ``LARGEST``.
        """
        return self.sampled.extremes[name, sign]

    def source(self, *keys: str) -> str:
        """Return where limits in force come from, for a message: from the spec if it changes one of them.

        Args:
            keys: of the table ``[limits]``, of one source.
        """
        limits = [LIMITS[key] for key in keys]
        changed = any((limit.of(self.design.limits) != limit.default).any() for limit in limits)
        return SPEC if changed else limits[0].source

    def distance(self, share: Array) -> Array:
        """Return the distance from the inlet at shares of the part's length.

        Args:
            share: dimensionless, shape (designs,).

        Returns:
            Distance along the stream, m, shape (designs,).
        """
        s = self.sampled.columns["s_m"]
        distance: Array = s[0] + share * (s[-1] - s[0])
        return distance

    def at(self, share: Array, *names: str) -> list[Array]:
        """Return columns at shares of the part's length.

        Args:
            share: dimensionless, shape (designs,).
            names: of the columns.

        Returns:
            Arrays of shape (designs,), one for each name; at the end of the part their limits there.
        """
        there, limits = self.part.at(np.broadcast_to(share, (1, len(share))), names), self.part.limits(names)
        return [np.where(share == 1.0, limits[name], there[name][0]) for name in names]


class Written(NamedTuple):
    """A spec, for what can be judged without a solution."""

    spec: ChuteSpec
    """The checked spec."""
    data: dict[str, Any]
    """The same as written."""
    design: Design
    """The same as numbers, on steel that is not yet laid down at the design point, but is in another state."""
    designs: int
    """Number of designs."""
