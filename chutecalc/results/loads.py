"""What a stream does to each segment: its forces, and how it wears the liner."""

from collections.abc import Sequence
from functools import reduce

import numpy as np

from chutecalc.design import Status
from chutecalc.physics.arrays import Array, Numbers
from chutecalc.physics.loads import Force, filled_volume, force_on_segment, liner_life
from chutecalc.results.column import Column
from chutecalc.results.columns import HOUR
from chutecalc.results.part import Part

# fmt: off
LOAD_COLUMNS = {
    column.name: column
    for column in (
        Column("force_x_n", "force x", "", "force of the stream on the segment along the chute, impact included",
               "force", "n", 0, "lbf", 0,
               equation="F = ṁ (v_in − v_out) + m g, m = ṁ t", page="forces"),
        Column("force_z_n", "force z", "", "vertical force of the stream on the segment, upwards",
               "force", "n", 0, "lbf", 0,
               equation="F = ṁ (v_in − v_out) + m g, m = ṁ t", page="forces"),
        Column("force_n", "force", "", "resultant of both", "force", "n", 0, "lbf", 0,
               equation="√(force_x² + force_z²)", page="forces"),
        Column("static_weight_n", "full weight", "", "weight of the segment full to its wall height, as when it chokes",
               "force", "n", 0, "lbf", 0,
               equation="ρ g ∫ A ds below the wall height", page="forces"),
        Column("sliding_life_h", "sliding life", "", "time until sliding wears through the liner at its worst station",
               "time", "h", 0,
               equation="thickness/(k w), k the wear of the liner, w the greatest friction power", page="liner-life"),
        Column("impact_life_h", "impact life", "", "time until the impact wears through the liner",
               "time", "h", 0,
               equation="thickness/(k w), w the friction power of the impact", page="liner-life"),
        Column("liner_life_h", "liner life", "", "the shorter of both", "time", "h", 0,
               equation="min(sliding_life, impact_life)", page="liner-life"),
        Column("relative_wear", "relative wear", "",
               "greatest wear, sliding or impact, over that of the first segment that is worn",
               "number", "", 3,
               equation="w over w of the first segment", page="liner-life"),
    )
}
# fmt: on
"""Loads of a segment by name."""
RUBBED = 1e-6
"""Share of the greatest wear below which a segment is not worn: what is left of 90° is rounding."""
NONE = np.full(1, np.nan)
"""What there is not, shape (1,)."""
WEAR = ("wear_w_m2", "chamfer_wear_w_m2", "side_wear_w_m2")
"""Columns of the friction power on floor, chamfers and side walls, W/m²."""


def loads_of(part: Part, duration: Array, maximum: Numbers, impact: Numbers) -> Numbers:
    """Return the loads of a part of the trajectory by name, but for the relative wear.

    Args:
        part: of the trajectory.
        duration: time that the stream takes along it, s, shape (designs,).
        maximum: largest values of its columns, each of shape (designs,).
        impact: numbers of its impact; empty without one.

    Returns:
        Arrays of shape (1,) or (designs,), NaN where there is none; empty in flight.
    """
    if part.contact is None:
        return {}
    segment, design, force = part.contact.segment, part.design, stream_force(part, duration)
    volume = filled_volume(segment.section, segment.end_section, part.contact.surface.length)
    struck = impact.get("wear_w_m2", NONE)  # all that a plate shows
    sliding = NONE if segment.deflects else np.fmax.reduce([maximum[name] for name in WEAR])
    thickness, rate = (NONE if value is None else value for value in (segment.thickness, segment.wear_rate))
    lives = [liner_life(thickness, rate, wear) / HOUR for wear in (sliding, struck)]
    return {
        "force_x_n": force.x,
        "force_z_n": force.z,
        "force_n": np.hypot(force.x, force.z),
        "static_weight_n": design.density * design.gravity * volume,
        "sliding_life_h": lives[0],
        "impact_life_h": lives[1],
        "liner_life_h": np.fmin(*lives),
        "relative_wear": np.fmax(sliding, struck),
    }


def stream_force(part: Part, duration: Array) -> Force:
    """Return the force of the stream on the segment of a part, N; NaN where the stream does not get through.

    Args:
        part: of the trajectory, in contact with a surface.
        duration: time that the stream takes along it, s, shape (designs,).
    """
    assert part.contact is not None
    solved, arrival, side = part.solved, part.contact.arrival, part.contact.surface.side
    force = force_on_segment(
        mass_rate=part.design.mass_rate,
        gravity=part.design.gravity,
        duration=duration,
        velocity_in=arrival.velocity,
        slope_in=solved.entry.slope + side * arrival.incidence,
        velocity_out=solved.exit.velocity,
        slope_out=solved.exit.slope,
    )
    steady = (solved.status == Status.OK) | (solved.status == Status.CONTACT_LOST)
    return Force(np.where(steady, force.x, np.nan), np.where(steady, force.z, np.nan))


def joined_loads(first: Numbers, again: Numbers) -> Numbers:
    """Join the loads of two visits to a segment: forces add up, and wear is that of the worse visit.

    Args:
        first: of the first visit, empty for a fall.
        again: of the next one.
    """
    if not first:
        return first
    x, z = (
        np.where(np.isnan(again[name]), first[name], first[name] + again[name]) for name in ("force_x_n", "force_z_n")
    )
    lives = {name: np.fmin(first[name], again[name]) for name in first if name.endswith("_life_h")}
    worse = np.fmax(first["relative_wear"], again["relative_wear"])
    return first | lives | {"force_x_n": x, "force_z_n": z, "force_n": np.hypot(x, z), "relative_wear": worse}


def relative_to_first(loads: Sequence[Numbers]) -> list[Numbers]:
    """Return loads with their wear relative to that of the first part that is worn, design by design.

    Args:
        loads: of the parts in order, with the greatest wear, W/m², as ``relative_wear``.
    """
    every = [one["relative_wear"] for one in loads if one]
    if not every:
        return list(loads)
    with np.errstate(all="ignore"):
        least = RUBBED * np.fmax.reduce(np.broadcast_arrays(*every))
        base = reduce(lambda known, wear: np.where(known > least, known, wear), every)
        return [one | {"relative_wear": one["relative_wear"] / base} if one else one for one in loads]
