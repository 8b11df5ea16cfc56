"""The flights behind the last surface of a chute: out of the mouth of a pipe, and onto the receiving belt."""

from collections.abc import Iterator

import numpy as np

from chutecalc.core import profile
from chutecalc.design import Design, Fall, Status
from chutecalc.physics.arrays import Array
from chutecalc.results.part import FLIGHT, Part
from chutecalc.solver.segment_solution import FIELD, Ends, SegmentSolution

EXIT, RECEIVER = "exit", "receiver"
"""What these flights lead to."""
LEAST = 1e-9
"""Duration, s, below which there is no flight but rounding."""


def last_flights(design: Design, ends: Ends, last: Part) -> Iterator[Part]:
    """Yield the flights that no segment follows, as parts that continue a trajectory.

    Args:
        design: the chutes.
        ends: how the designs end.
        last: the last part of the trajectory.
    """
    leaves = [ends.distance, ends.x, ends.z, ends.velocity, ends.slope]
    touched = _last_touched(last, leaves)
    past = touched[0] > ends.distance  # it has flown on past segments, along flights that are told already
    goes_on = [np.where(past, there, left) for there, left in zip(touched, leaves, strict=True)]
    for name, begins, velocity, slope in (
        (EXIT, touched, ends.velocity, ends.slope),
        (RECEIVER, goes_on, ends.landing_velocity, ends.landing_slope),
    ):
        gained = velocity * np.sin(slope) - begins[3] * np.sin(begins[4])
        time = np.where(ends.status == Status.OK, gained / design.gravity, np.nan)
        if (time > LEAST).any():
            last = _flight(name, design, last, begins, np.where(time > LEAST, time, np.nan))
            yield last


def _last_touched(last: Part, otherwise: list[Array]) -> list[Array]:
    """Return distance, x, z, velocity and slope at the end of the last part that streams touch or fly along."""
    found, open_ = otherwise, np.ones(1, dtype=bool)
    part: Part | None = last
    while part is not None:
        here = open_ & np.isin(part.solved.status, (Status.OK, Status.CONTACT_LOST))
        end = part.solved.exit
        point = (end.distance, end.x, end.z, end.velocity, end.slope)
        found = [np.where(here, new, known) for new, known in zip(point, found, strict=True)]
        open_, part = open_ & ~here, part.before
    return found


def _flight(name: str, design: Design, before: Part, begins: list[Array], time: Array) -> Part:
    """Return a flight of some duration, s, that begins at a distance, x, z, with a velocity and a slope."""
    count = len(time)
    distance, x, z, velocity, slope = (np.broadcast_to(values, count) for values in begins)
    table = np.full((len(FIELD), count), np.nan)
    forward = np.where(slope == np.pi / 2, 0.0, velocity * np.cos(slope))
    path = (x, z, forward, velocity * np.sin(slope), np.broadcast_to(design.gravity, count))
    table[FIELD["start_distance"]], table[FIELD["flight_time"]] = distance, time
    table[FIELD["status"]] = np.where(np.isfinite(time), Status.OK, Status.NOT_REACHED)
    table[FIELD["path_x"] : FIELD["path_x"] + 5] = path
    lengths = np.empty((1, count))
    profile.flight_lengths(np.array(path), time[None], lengths)
    table[FIELD["distance"]] = lengths[0]
    fall = Fall(name=name, kind=FLIGHT, drop=None, run=None)
    solved = SegmentSolution(len(design.segments), fall, table, None)
    return Part(f"{name}:{FLIGHT}", FLIGHT, solved, contact=None, before=before, design=design)
