"""Quantities along the way of a solved chute, by column name, at any share of each of its parts.

Arrays are of shape (places, designs) here, and of shape (designs,) where a place is meant that each design has one of.
"""

from collections.abc import Iterable
from functools import cached_property

import numpy as np

from chutecalc.core.profile import flown
from chutecalc.design import Contact, Design, Segment, Status, stretched
from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.section import Polygon
from chutecalc.results.column import Numbers
from chutecalc.results.columns import ALL_COLUMNS, Needs
from chutecalc.results.impacts import impact_of
from chutecalc.solver.leg import ContactLeg, Ends, Leg
from chutecalc.solver.profile import EndFlight, EndProfile, FlightProfile, SlideProfile

EVEN = np.linspace(0.0, 1.0, 65)
"""Shares of a flight, along which all is smooth."""
AT_REST = (1e-40, 1e-44)
"""v², m²/s², so near rest that what has a limit there has it to the last digits."""
LOOSE = 1e-6
"""Of gravity: what is left of the normal acceleration where contact is lost, and not never there."""

Profile = FlightProfile | SlideProfile


class Site:
    """Where quantities are told: on a segment of a design, or in a flight to it."""

    def __init__(self, segment: Segment, design: Design, guided: bool) -> None:
        self.segment, self.design, self.guided = segment, design, guided

    @cached_property
    def start_time(self) -> Array:
        """From the inlet, s; not known where nothing of the way is."""
        return np.full(1, np.nan)

    @property
    def slip_ratio(self) -> Array:
        """Slip at the wall over mean velocity."""
        assert isinstance(self.segment, Contact)
        return self.segment.slip_ratio

    @property
    def between_facets(self) -> bool:
        """Whether the stream lies between drawn facets here."""
        section = self.segment.section if isinstance(self.segment, Contact) else None
        return self.guided and isinstance(section, Polygon) and bool(section.lengths)

    @property
    def on_arc(self) -> bool:
        """Whether it follows an arc."""
        return self.guided and isinstance(self.segment, Contact) and self.segment.radius is not None


class Part(Site):
    """A stretch of the way that is shown as one: a segment, or a flight that leads to one."""

    def __init__(
        self, name: str, kind: str, leg: Leg, contact: ContactLeg | None, before: "Part | None", design: Design
    ) -> None:
        """A part; ``contact`` is None for a flight, ``before`` the part before it."""
        super().__init__(leg.segment, design, contact is not None)
        self.name, self.kind, self.leg, self.contact, self.before = name, kind, leg, contact, before

    @cached_property
    def start_time(self) -> Array:
        """S since the inlet, shape (designs,)."""
        return np.zeros(1) if self.before is None else self.before.end_time

    @cached_property
    def end_time(self) -> Array:
        """The same at the end of the part; at the start where a design does not go along it."""
        with np.errstate(all="ignore"):
            time = self.start_time + self._profile(np.ones(1)).time[0]
        return np.where(np.isfinite(time), time, self.start_time)

    def ends(self) -> tuple[Array, Array]:
        """From where to where each design travels on the part: m in flight, shares of the segment in contact."""
        if self.contact is None:
            flies = (self.leg.flight_time > 0.0) | (self.kind != "flight")
            end = np.where(flies, self.leg.flown, np.nan)
            return np.where(np.isnan(end), np.nan, 0.0), end
        ends = self.contact.ends
        return ends[0], ends[2]

    def length(self) -> Array:
        """How far that is, m."""
        begin, end = self.ends()
        return end - begin if self.contact is None else (end - begin) * self.contact.surface.length

    def status(self) -> Index:
        """How the part ends for each design; a flight to a segment ends well where it lands."""
        if self.kind == "flight":
            return np.where(self.leg.flight_time > 0.0, Status.OK, Status.NOT_REACHED)
        return self.leg.status

    def impact(self) -> Numbers:
        """Return each design's impact on the segment, see :func:`chutecalc.results.impacts.impact_of`."""
        return {} if self.contact is None else impact_of(self.contact.arrival, self.slip_ratio)

    def shares(self) -> Array:
        """Shares of the way that resolve all quantities on it: 0, the knots of the solution's panels, and 1.

        Between two neighbours everything is smooth, for panels end where something has a kink. Of shape (places,) where
        they are the same for all designs, else (places, designs); what a design has too few of repeats its end.
        """
        begin, end = self.ends()
        if self.contact is None:
            _, _, _, downward, gravity = self.leg.path
            rises = (downward < 0.0) & (end > 0.0)
            if not rises.any():
                return EVEN
            top = np.minimum(-downward / gravity, self.leg.flight_time)[None]  # next to it the velocity has its dip
            way = np.empty(top.shape)
            flown(self.leg.path, top, way)
            share = np.where(rises, way[0] / np.where(rises, end, 1.0), 1.0)
            return np.sort(np.concatenate([np.repeat(EVEN[:, None], len(share), axis=1), share[None]]), axis=0)
        places = self.contact.panels.knots()
        way = np.where(end > begin, end - begin, np.inf)
        shares = np.ones((len(places) + 1, len(begin)))
        shares[0] = 0.0
        inside = np.clip((places - begin) / way, 0.0, 1.0)
        shares[1:] = np.where(np.isnan(inside), 1.0, inside)
        alike = (shares == shares[:, :1]).all()
        return shares[:, 0] if alike else shares

    def limits(self, names: Iterable[str]) -> Numbers:
        """Columns at the end of the way, each of shape (designs,), as what they tend to there.

        Towards a stall depth grows without bound, towards a loss of contact the Froude number: infinite, where a
        station has nothing.
        """
        with np.errstate(all="ignore"):
            at = self._profile(np.ones(1))
            values = {name: ALL_COLUMNS[name].values(self, at)[0] for name in names}
            if not isinstance(at, SlideProfile):
                return values
            rest = at.velocity_squared[0] == 0.0
            if rest.any():
                slow, slower = (at.moving(tiny) for tiny in AT_REST)
                for name, there in values.items():
                    near, nearer = (ALL_COLUMNS[name].values(self, one)[0] for one in (slow, slower))
                    tends = np.where(np.abs(nearer) > 2.0 * np.abs(near), np.copysign(np.inf, near), near)
                    values[name] = np.where(rest, np.where(np.abs(nearer) < 0.5 * np.abs(near), 0.0, tends), there)
            for name in values:
                if ALL_COLUMNS[name].infinite_at_lift_off:
                    lost = self.leg.status == Status.CONTACT_LOST
                    lost = lost & (np.abs(at.normal[0]) < LOOSE * self.design.gravity)
                    values[name] = np.where(lost, np.inf, values[name])
        return values

    def at(self, shares: Array, names: Iterable[str]) -> Numbers:
        """Columns at shares of the way, of shape (places,) for all designs or (places, designs) for each.

        Only those named are worked out.
        """
        at = self._profile(shares)
        with np.errstate(all="ignore"):
            values = {name: ALL_COLUMNS[name].values(self, at) for name in names}
        shapes = {at.shape, *(column.shape for column in values.values())}
        shape = at.shape if len(shapes) == 1 else np.broadcast_shapes(*shapes)
        return {name: stretched(column, shape) for name, column in values.items()}

    def _profile(self, shares: Array) -> Profile:
        each = shares[:, None] if shares.ndim == 1 else shares
        leg = self.leg
        if each.shape[1] > leg.table.shape[1]:  # designs that differ in what the stream does not feel, as slip at walls
            leg = leg.widened(each.shape[1])
        begin, end = self.ends()
        places = np.where(each == 1.0, end, begin + (end - begin) * each)  # the ends themselves, to the last digit
        if self.contact is None:
            return FlightProfile(leg, self.design.volume_rate, places)
        assert leg.contact is not None
        return SlideProfile(leg, leg.contact, self.design.volume_rate, places)


def at_exit(design: Design, ends: Ends, names: Iterable[str]) -> Numbers:
    """Columns at the end of the chute, each of shape (designs,), NaN where a design fails.

    Args:
        design: the chutes.
        ends: theirs, with the tables that :func:`asked` tells.
        names: of columns, without time.
    """
    last = design.segments[-1]
    site, well = Site(last, design, isinstance(last, Contact)), ends.status == Status.OK
    at: Profile = EndProfile(ends, design.volume_rate) if site.guided else EndFlight(ends, design.volume_rate)
    with np.errstate(all="ignore"):
        columns = {name: ALL_COLUMNS[name].values(site, at)[0] for name in names}
    return {name: np.where(well, values, np.nan) for name, values in columns.items()}


def asked(names: Iterable[str]) -> tuple[bool, bool]:
    """Whether columns at an exit take how the stream lies there, and what the walls bear."""
    needs = Needs.NOTHING
    for name in names:
        needs |= ALL_COLUMNS[name].needs
    return Needs.DEPTH in needs, Needs.WALLS in needs
