"""Quantities along the way of a solved chute, by column name, at any share of each of its parts.

Arrays are of shape (places, designs) here, and of shape (designs,) where a place is meant that each design has one of.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from chutecalc.design import Contact, Design, Status, stretched
from chutecalc.physics.arrays import Array, Index, Mask
from chutecalc.physics.flight import path_length
from chutecalc.physics.section import Polygon
from chutecalc.physics.wear import wall_pressures
from chutecalc.solver.chain import ContactLeg, Leg
from chutecalc.solver.profile import Profile, flight_profile, slide_profile

Numbers = dict[str, Array]
SAMPLES = np.linspace(0.0, 1.0, 65)
LEAST_NORMAL = 1e-9  # of gravity; below it a stream is about to leave its surface, and what is divided by n is noise
ROUNDS, GRID = 2, np.linspace(0.0, 1.0, 17)  # each round leaves an eighth of the bracket around an extreme


class Part(NamedTuple):
    """A stretch of the way that is shown as one: a segment, or a flight that leads to one."""

    name: str
    kind: str
    leg: Leg
    contact: ContactLeg | None
    """None for a flight."""
    start_time: Array
    """s since the inlet, shape (designs,)."""
    design: Design

    def ends(self) -> tuple[Array, Array]:
        """From where to where each design travels on the part: m in flight, shares of the segment in contact."""
        if self.contact is None:
            flown = path_length(self.leg.path, self.leg.flight_time)
            flown = np.where((self.leg.flight_time > 0.0) | (self.kind != "flight"), flown, np.nan)
            return np.where(np.isnan(flown), np.nan, 0.0), flown
        begin = self.contact.arrival.place
        end = np.where(self.contact.arrival.status == Status.STALL, begin, np.nan)
        end[self.contact.rows] = self.contact.stretch.place
        return begin, end

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
        """What each design's impact on the segment is, NaN where there is none; empty where no design strikes it."""
        if self.contact is None or not (self.contact.arrival.incidence > 0.0).any():
            return {}
        arrival = self.contact.arrival
        struck = arrival.incidence > 0.0
        numbers = {
            "incidence_deg": np.degrees(arrival.incidence),
            "velocity_before_m_s": arrival.velocity,
            "velocity_after_m_s": arrival.after,
            "pressure_kpa": arrival.pressure / 1000.0,
        }
        return {name: np.where(struck, values, np.nan) for name, values in numbers.items()}

    def at(self, shares: Array) -> Numbers:
        """All columns at shares of the way, of shape (places,) for all designs or (places, designs) for each."""
        with np.errstate(all="ignore"):
            columns = self._columns(self._profile(shares))
        shape = np.broadcast_shapes(*(values.shape for values in columns.values()))
        return {name: stretched(values, shape) for name, values in columns.items()}

    def end_time(self) -> Array:
        """Time since the inlet at the end of the part, s, shape (designs,); NaN where a design does not get there."""
        with np.errstate(all="ignore"):
            time: Array = self.start_time + self._profile(np.ones(1)).time[0]
        return time

    def _profile(self, shares: Array) -> Profile:
        alike, each = (shares, shares[:, None]) if shares.ndim == 1 else (None, shares)
        begin, end = self.ends()
        places = np.where(each == 1.0, end, begin + (end - begin) * each)  # the ends themselves, to the last digit
        if self.contact is None:
            return flight_profile(self.leg, self.design.volume_rate, places)
        return slide_profile(self.leg, self.contact, places, alike)

    def _columns(self, at: Profile) -> Numbers:
        """The catalogue's columns, the thickness (depth over the free surface's width) and the missing load."""
        floor, chamfer, side = self._pressures(at)
        guide = self.leg.segment if self.contact is not None else None
        guide = guide if isinstance(guide, Contact) else None
        slip = at.wall_friction * at.velocity * (guide.slip_ratio if guide else 1.0)
        chamfered = guide is not None and isinstance(guide.section, Polygon) and bool(guide.section.lengths)
        on_arc = guide is not None and guide.radius is not None
        return {
            "s_m": at.distance,
            "x_m": at.x,
            "z_m": at.z,
            "slope_deg": np.degrees(at.slope),
            "velocity_m_s": at.velocity,
            "depth_m": at.wet.depth,
            "chamfer_wetted_m": np.where(chamfered, at.wet.chamfer, np.nan),
            "area_m2": at.area,
            "equivalent_friction": at.friction,
            "normal_acceleration_m_s2": at.normal,
            "pressure_kpa": floor / 1000.0,
            "wear_w_m2": slip * floor,
            "chamfer_pressure_kpa": chamfer / 1000.0,
            "chamfer_wear_w_m2": slip * chamfer,
            "side_pressure_kpa": side / 1000.0,
            "side_wear_w_m2": slip * side,
            "wear_number": np.where(on_arc, at.normal / self.design.gravity, np.nan),
            "froude": np.where(
                at.normal > LEAST_NORMAL * self.design.gravity,
                at.velocity / np.sqrt(at.normal * at.area / at.wet.width),
                np.nan,
            ),
            "time_s": self.start_time + at.time,
            "thickness": at.wet.depth / at.wet.width,
            "missing_load": at.wet.missing,
            "wall_friction": at.wall_friction,
        }

    def _pressures(self, at: Profile) -> tuple[Array, Array, Array]:
        """On floor, chamfers and side walls, Pa; none in flight."""
        if self.contact is None:
            return at.wet.depth, at.wet.depth, at.wet.depth
        slide = self.contact.slide
        section, table = slide.section_at(at.place), slide.facets_at(at.place)
        weight = self.design.density * np.maximum(at.normal, 0.0)
        return wall_pressures(section, table, at.wet, at.area, weight, slide.equilibrium)


class Extreme(NamedTuple):
    """Where a quantity is least or largest along a part, shape (designs,)."""

    value: Array
    share: Array
    """Of the part's way."""


LEAST, LARGEST = -1.0, 1.0
Wanted = tuple[str, float]
"""A column's name, and ``LEAST`` or ``LARGEST``."""


def extremes(part: Part, sampled: Numbers, wanted: Sequence[Wanted]) -> dict[Wanted, Extreme]:
    """Extremes of quantities along a part, found between its samples too.

    Args:
        part: of the way.
        sampled: its columns at ``SAMPLES``.
        wanted: which.

    Returns:
        One for each. Inside, it is that of the parabola through three places 5e-4 of the way apart: for what varies
        smoothly, right to about 1e-11 of its variation. What grows without bound towards a stop, as depth does, is
        taken up to the last place before it.
    """
    signs = np.array([sign for _, sign in wanted])[:, None]
    values = np.stack([sampled[name] for name, _ in wanted], axis=1) * signs  # (places, wanted, designs)
    best, low, high = _best(values, np.broadcast_to(SAMPLES[:, None, None], values.shape))
    settled = _at_an_end(values)
    open_ = np.flatnonzero(~settled.all(axis=1)).tolist()
    for _ in range(ROUNDS if open_ else 0):
        grid = low[open_] + (high - low)[open_] * GRID[:, None, None]
        columns = part.at(grid.reshape(-1, grid.shape[2]))
        finer = [columns[wanted[item][0]].reshape(grid.shape)[:, k] for k, item in enumerate(open_)]
        found, low[open_], high[open_] = _best(np.stack(finer, axis=1) * signs[open_], grid)
        for field, new in zip(best, found, strict=True):
            field[open_] = np.where(settled[open_], field[open_], new)
    return {
        item: Extreme(item[1] * best.value[k] + 0.0, best.share[k])  # + 0: no -0
        for k, item in enumerate(wanted)
    }


def _at_an_end(values: Array) -> Mask:
    """Whether the largest value along the first axis is plainly at an end: the parabola there has its top beyond it.

    Also where there are no values at all.
    """
    top = np.where(np.isnan(values), -np.inf, values).argmax(axis=0)
    inward = np.where(top == 0, 1, -1)
    last = len(values) - 1
    near = np.stack([np.clip(top + k * inward, 0, last) for k in range(3)])
    first, second, third = np.take_along_axis(values, near, axis=0)
    slope, bend = second - first, third - 2.0 * second + first
    plain = (slope < 0.0) & (slope - 0.5 * bend <= 0.25 * slope)  # down from the end on, and not by the bend alone
    settled: Mask = ((top == 0) | (top == last)) & plain | np.isnan(values).all(axis=0)
    return settled


def _best(values: Array, shares: Array) -> tuple[Extreme, Array, Array]:
    """The largest along the first axis, by the parabola through it and its neighbours, and the bracket of those."""
    top = np.where(np.isnan(values), -np.inf, values).argmax(axis=0)
    left, right = np.maximum(top - 1, 0), np.minimum(top + 1, len(values) - 1)
    near = np.stack([left, top, right])
    x, f = np.take_along_axis(shares, near, axis=0), np.take_along_axis(values, near, axis=0)
    inside = (left < top) & (top < right) & np.isfinite(f[0]) & np.isfinite(f[2])
    f = np.where(inside, f, f[1])
    bend = f[2] - 2.0 * f[1] + f[0]  # equally spaced
    shift = np.where(bend < 0.0, 0.5 * (f[0] - f[2]) / np.where(bend < 0.0, bend, 1.0), 0.0)
    value = f[1] - 0.25 * (f[0] - f[2]) * shift
    return Extreme(value, x[1] + shift * (x[2] - x[1])), x[0], x[2]
