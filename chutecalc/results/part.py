"""Parts of a solved trajectory, and their columns at any share of their length.

Arrays are of shape (stations, designs), or of shape (designs,) where each design has one value.
"""

from collections.abc import Iterable, Sequence
from functools import cached_property

import numpy as np

from chutecalc.design import Design, Status, stretched
from chutecalc.physics.arrays import Array, Index, Mask, Numbers
from chutecalc.physics.motion import ROOF
from chutecalc.results.finding_columns import ALL_COLUMNS
from chutecalc.results.impacts import impact_of
from chutecalc.results.limits_at_end import limits_at_end
from chutecalc.results.segment_context import SegmentContext
from chutecalc.solver.contact_profile import ContactProfile
from chutecalc.solver.flight_profile import FlightProfile
from chutecalc.solver.segment_solution import ContactSolution, SegmentSolution

FLIGHT = "flight"
"""Kind of the parts that lead through the air to a segment, and what their names end in."""


class Part(SegmentContext):
    """A part of the trajectory: a segment, or a flight that leads to one."""

    def __init__(
        self,
        name: str,
        kind: str,
        solved: SegmentSolution,
        *,
        contact: ContactSolution | None,
        before: "Part | None",
        design: Design,
    ) -> None:
        """Take a solved segment, or the flight to it.

        Args:
            name: of the segment; ``NAME:flight`` for a flight that leads to it.
            kind: of the segment, or ``flight``.
            solved: the solved segment.
            contact: its contact with the surface; None in flight.
            before: the part before it.
            design: the chutes.
        """
        super().__init__(solved.segment, design, contact is not None)
        self.name, self.kind, self.solved, self.contact, self.before = name, kind, solved, contact, before

    def __repr__(self) -> str:
        return f"<Part {self.name} ({self.kind})>"

    @property
    def is_flight(self) -> bool:
        """Whether the part is a flight that leads to a segment."""
        return self.kind == FLIGHT

    @cached_property
    def start_time(self) -> Array:
        """Time from the inlet to the start of the part, s, shape (designs,)."""
        behind, part = [], self.before
        while part is not None and "end_time" not in vars(part):
            behind.append(part)
            part = part.before
        for part in reversed(behind):  # one after the other: of thousands each would call the one before it
            part.end_time  # noqa: B018 - works it out
        return np.zeros(1) if self.before is None else self.before.end_time

    @cached_property
    def end_time(self) -> Array:
        """Time from the inlet to the end of the part, s, shape (designs,); to its start where a design skips it."""
        with np.errstate(all="ignore"):
            time = self.start_time + self.profile(np.ones(1)).time[0]
        return np.where(np.isfinite(time), time, self.start_time)

    def span(self) -> tuple[Array, Array]:
        """Return where each design enters and leaves the part: m flown in flight, shares of the segment in contact."""
        if self.contact is None:
            flies = (self.solved.flight_time > 0.0) | (not self.is_flight)
            end = np.where(flies, self.solved.flight_length, np.nan)
            return np.where(np.isnan(end), np.nan, 0.0), end
        ends = self.contact.bounds
        return ends[0], ends[2]

    def length(self) -> Array:
        """Return the distance travelled on the part, m, shape (designs,)."""
        begin, end = self.span()
        return end - begin if self.contact is None else (end - begin) * self.contact.surface.length

    def status(self) -> Index:
        """Return how the part ends for each design, by status number; a flight to a segment is ok where it lands."""
        if self.is_flight:
            return np.where(self.solved.flight_time > 0.0, Status.OK, Status.NOT_REACHED)
        return self.solved.status

    def impact(self) -> Numbers:
        """Return each design's impact on the segment, see :func:`chutecalc.results.impacts.impact_of`."""
        return {} if self.contact is None else impact_of(self.contact.arrival, self.slip_ratio)

    def strikes_roof(self) -> Mask:
        """Return whether each design's stream strikes the roof of a closed segment, shape (1,) or (designs,)."""
        if self.contact is None or not self.contact.segment.closed:
            return np.zeros(1, dtype=bool)
        strikes: Mask = (self.contact.side == ROOF) & (self.contact.arrival.incidence > 0.0)
        return strikes

    def landing_margin(self) -> Array:
        """Return how far from the nearer end of the segment a stream lands that comes through the air, m.

        Returns:
            Distances of shape (designs,): NaN where none lands, and in a closed section, which is entered by its mouth.
        """
        if self.contact is None or self.before is None or self.before.guided or self.segment.closed:
            return np.full(1, np.nan)
        arrival = self.contact.arrival
        margin = np.minimum(arrival.share, 1.0 - arrival.share) * self.contact.surface.length
        return np.where((arrival.status <= Status.STALL) & (self.before.length() > 0.0), margin, np.nan)

    def limits(self, names: Iterable[str]) -> Numbers:
        """Return the limits of columns at the end of the part.

        Towards a stall depth grows without bound, towards a loss of contact the Froude number: such limits are
        infinite, where a station has no value.

        Args:
            names: of the columns.

        Returns:
            Arrays of shape (designs,) by name.
        """
        return limits_at_end(self, self.profile(np.ones(1)), self.solved.status == Status.CONTACT_LOST, names)

    def at(self, shares: Array, names: Iterable[str]) -> Numbers:
        """Return columns at shares of the length travelled.

        Args:
            shares: dimensionless, 0 to 1, of shape (stations,) for all designs or (stations, designs).
            names: of the columns to work out.

        Returns:
            Arrays of shape (stations, designs) by name.
        """
        at = self.profile(shares)
        with np.errstate(all="ignore"):
            values = {name: ALL_COLUMNS[name].values(self, at) for name in names}
        shapes = {at.shape, *(column.shape for column in values.values())}
        shape = at.shape if len(shapes) == 1 else np.broadcast_shapes(*shapes)
        return {name: stretched(column, shape) for name, column in values.items()}

    def profile(self, shares: Array) -> FlightProfile | ContactProfile:
        """Return the stream at shares of the length travelled.

        Args:
            shares: dimensionless, 0 to 1, of shape (stations,) for all designs or (stations, designs).
        """
        each = shares[:, None] if shares.ndim == 1 else shares
        solved = self.solved
        # Designs may differ in what the stream does not feel, such as slip at walls: then they are solved as one.
        if each.shape[1] > solved.table.shape[1]:
            solved = solved.broadcast(each.shape[1])
        begin, end = self.span()
        positions = np.where(each == 1.0, end, begin + (end - begin) * each)  # the ends themselves, to the last digit
        if self.contact is None:
            return FlightProfile(solved, self.design.volume_rate, positions)
        assert solved.contact is not None
        return ContactProfile(solved, solved.contact, self.design.volume_rate, positions)


def leaving(parts: Sequence[Part], through: Mask) -> list[Mask]:
    """Return for each part the designs whose stream leaves the chute from there: the last part that guides it.

    One that was left and struck again, or may be passed, is not the only last; a fall is the end of a chute only as its
    last part, and a stream may come out of the mouth of a closed segment without touching it.

    Args:
        parts: of the trajectory, in order.
        through: designs whose stream gets through the chute, shape (designs,).
    """
    found = []
    for part in reversed(parts):
        ends = (Status.OK, Status.CONTACT_LOST, *((Status.PASSED,) if part.segment.closed else ()))
        here = through & np.isin(part.solved.status, ends) & (part.contact is not None or part is parts[-1])
        through = through & ~here
        found.append(here)
    return found[::-1]
