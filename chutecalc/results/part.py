"""Parts of a solved trajectory, and their columns at any share of their length.

Arrays are of shape (stations, designs), or of shape (designs,) where each design has one value.
"""

from collections.abc import Iterable
from functools import cached_property

import numpy as np

from chutecalc.core.profile import flight_lengths
from chutecalc.design import Design, Status, stretched
from chutecalc.physics.arrays import Array, Index, Numbers
from chutecalc.results.finding_columns import ALL_COLUMNS
from chutecalc.results.impacts import impact_of
from chutecalc.results.segment_context import SegmentContext
from chutecalc.solver.contact_profile import ContactProfile
from chutecalc.solver.flight_profile import FlightProfile
from chutecalc.solver.segment_solution import ContactSolution, SegmentSolution

FLIGHT = "flight"
"""Kind of the parts that lead through the air to a segment, and what their names end in."""
FLIGHT_SHARES = np.linspace(0.0, 1.0, 65)
"""Shares at which a flight is sampled: all is smooth along it."""
AT_REST = (1e-40, 1e-44)
"""Two values of v², m²/s², so near rest that a quantity with a limit there has reached it to the last digit."""
LIFT_OFF = 1e-6
"""Ratio to gravity of the normal acceleration below which contact was lost by it falling to 0."""

Profile = FlightProfile | ContactProfile


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
        return np.zeros(1) if self.before is None else self.before.end_time

    @cached_property
    def end_time(self) -> Array:
        """Time from the inlet to the end of the part, s, shape (designs,); to its start where a design skips it."""
        with np.errstate(all="ignore"):
            time = self.start_time + self._profile(np.ones(1)).time[0]
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

    def shares(self) -> Array:
        """Return shares of the length travelled that resolve all columns: 0, the knots of the solver's panels, and 1.

        Between two neighbours everything is smooth, as panels end at kinks.

        Returns:
            Shares of shape (samples,) where they are the same for all designs, else (samples, designs); a design with
            fewer samples repeats its end.
        """
        begin, end = self.span()
        if self.contact is None:
            _, _, _, downward, gravity = self.solved.path
            rises = (downward < 0.0) & (end > 0.0)
            if not rises.any():
                return FLIGHT_SHARES
            top = np.minimum(-downward / gravity, self.solved.flight_time)[None]  # next to it the velocity has its dip
            length = np.empty(top.shape)
            flight_lengths(self.solved.path, top, length)
            share = np.where(rises, length[0] / np.where(rises, end, 1.0), 1.0)
            return np.sort(np.concatenate([np.repeat(FLIGHT_SHARES[:, None], len(share), axis=1), share[None]]), axis=0)
        positions = self.contact.panels.knot_shares()
        length = np.where(end > begin, end - begin, np.inf)
        shares = np.ones((len(positions) + 1, len(begin)))
        shares[0] = 0.0
        inside = np.clip((positions - begin) / length, 0.0, 1.0)
        shares[1:] = np.where(np.isnan(inside), 1.0, inside)
        alike = (shares == shares[:, :1]).all()
        return shares[:, 0] if alike else shares

    def limits(self, names: Iterable[str]) -> Numbers:
        """Return the limits of columns at the end of the part.

        Towards a stall depth grows without bound, towards a loss of contact the Froude number: such limits are
        infinite, where a station has no value.

        Args:
            names: of the columns.

        Returns:
            Arrays of shape (designs,) by name.
        """
        with np.errstate(all="ignore"):
            at = self._profile(np.ones(1))
            values = {name: ALL_COLUMNS[name].values(self, at)[0] for name in names}
            if not isinstance(at, ContactProfile):
                return values
            rest = at.velocity_squared[0] == 0.0
            if rest.any():
                slow, slower = (at.with_velocity_squared(tiny) for tiny in AT_REST)
                for name, there in values.items():
                    near, nearer = (ALL_COLUMNS[name].values(self, one)[0] for one in (slow, slower))
                    tends = np.where(np.abs(nearer) > 2.0 * np.abs(near), np.copysign(np.inf, near), near)
                    values[name] = np.where(rest, np.where(np.abs(nearer) < 0.5 * np.abs(near), 0.0, tends), there)
            for name in values:
                if ALL_COLUMNS[name].infinite_at_lift_off:
                    lost = self.solved.status == Status.CONTACT_LOST
                    lost = lost & (np.abs(at.normal_acceleration[0]) < LIFT_OFF * self.design.gravity)
                    values[name] = np.where(lost, np.inf, values[name])
        return values

    def at(self, shares: Array, names: Iterable[str]) -> Numbers:
        """Return columns at shares of the length travelled.

        Args:
            shares: dimensionless, 0 to 1, of shape (stations,) for all designs or (stations, designs).
            names: of the columns to work out.

        Returns:
            Arrays of shape (stations, designs) by name.
        """
        at = self._profile(shares)
        with np.errstate(all="ignore"):
            values = {name: ALL_COLUMNS[name].values(self, at) for name in names}
        shapes = {at.shape, *(column.shape for column in values.values())}
        shape = at.shape if len(shapes) == 1 else np.broadcast_shapes(*shapes)
        return {name: stretched(column, shape) for name, column in values.items()}

    def _profile(self, shares: Array) -> Profile:
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
