"""What is written beside the stream: names of segments, incidences of impacts, numbers of findings."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from chutecalc.design import Receiver
from chutecalc.output.plots.belt_lines import is_end_on
from chutecalc.output.plots.flights import Line
from chutecalc.output.plots.labels import Label
from chutecalc.output.plots.traces import Trace, View
from chutecalc.physics.arrays import Array
from chutecalc.results.columns import COLUMNS
from chutecalc.results.impacts import IMPACT_COLUMNS
from chutecalc.results.part import FLIGHT
from chutecalc.results.solved import SolvedChute

SHORT = 0.08
"""Share of the chute below which a line leads from a segment to its name. Marks closer than half of it are drawn
together."""
UNNAMED = (FLIGHT, "inlet")
"""Kinds of the traces in the air that have no name: flights to a segment, and a stream that reaches none."""
MOST_NAMED = 20
"""With more segments and flights than this, neither they nor their impacts are named."""


class Mark(NamedTuple):
    """A number at a distance along the stream."""

    number: str
    s: float


def names(seen: View, units: str) -> list[Label]:
    """Return the names of segments: beside surfaces, on the side away from the stream, and beside the paths of falls.

    Flights from one segment to the next have none.

    Args:
        seen: the chute.
        units: ``metric`` or ``us``.
    """
    falls = [(trace.name, -1.0, trace.path) for trace in seen.stream if trace.side == 0.0 and trace.kind not in UNNAMED]
    named = [*((steel.name, steel.side, steel.path) for steel in seen.surfaces), *falls]
    found = []
    for name, side, line in named if len(named) <= MOST_NAMED else ():
        middle = line.shape[1] // 2
        x, z = (float(each) for each in COLUMNS["x_m"].converted(line[:, middle], units))
        forward, up = np.ptp(line[:, middle - 1 : middle + 1], axis=1) if line.shape[1] > 1 else (1.0, 0.0)
        short = float(np.hypot(*np.diff(line)).sum()) < SHORT * seen.size
        found.append(Label(name, x, z, _normal(-side, np.degrees(np.arctan2(up, forward))), leads=short))
    return found


def impact_labels(solution: SolvedChute, units: str) -> list[Label]:
    """Return a label with its incidence for each impact.

    Args:
        solution: solution of one design.
        units: ``metric`` or ``us``.
    """
    parts, unit = solution.trajectory.parts, IMPACT_COLUMNS["incidence_deg"].unit_text(units)
    found = []
    for part, result in zip(parts, solution.trajectory.results, strict=True):
        incidence = result.impact["incidence_deg"][0] if result.impact else np.nan
        if np.isfinite(incidence):
            assert part.contact is not None
            x, z = (float(COLUMNS["x_m"].converted(result.entry[name][0], units)) for name in ("x_m", "z_m"))
            text = f"{incidence:.3g}{unit}" if len(parts) <= MOST_NAMED else ""
            away = _normal(-float(part.contact.side[0]), float(result.entry["slope_deg"][0]))
            found.append(Label(text, x, z, away))
    return found


def mark_labels(stream: Sequence[Trace], marks: Sequence[Mark], size: float, units: str) -> list[Label]:
    """Return the numbers, those of neighbours together.

    Args:
        stream: traces of the stream.
        marks: the numbers.
        size: greater side of the chute, m.
        units: ``metric`` or ``us``.
    """
    groups: list[list[Mark]] = []
    for mark in sorted(marks, key=lambda mark: mark.s):
        if groups and mark.s - groups[-1][0].s < 0.5 * SHORT * size:
            groups[-1].append(mark)
        else:
            groups.append([mark])
    found = []
    for group in groups:
        distances = [float(np.abs(trace.columns["s_m"] - group[0].s).min()) for trace in stream]
        trace = stream[int(np.argmin(distances))]
        station = int(np.abs(trace.columns["s_m"] - group[0].s).argmin())
        text = ", ".join(sorted((mark.number for mark in group), key=int))
        found.append(_label(text, trace, station, units)._replace(leads=True, boxed=True))
    return found


def belt_labels(solution: SolvedChute, seen: View, units: str) -> Iterator[Label]:
    """Yield the labels of the belts: the velocity of each, and where one turns in plan, by how much.

    Args:
        solution: solution of one design.
        seen: its lines.
        units: ``metric`` or ``us``.
    """
    belt, receiver = solution.design.belt, solution.design.receiver
    if belt is not None:
        yield _belt_label(seen.feed[0], belt.velocity, 0.2, None, units)
    if receiver is not None and seen.received:
        yield _belt_label(seen.received[0], receiver.velocity, 0.6, receiver, units)


def _belt_label(path: Line, velocity: Array, share: float, receiver: Receiver | None, units: str) -> Label:
    """Return the label of a belt, at a share of its length, best below it."""
    line = COLUMNS["x_m"].converted(path, units)
    column = COLUMNS["velocity_m_s"]
    text = f"belt, {float(column.converted(velocity[0], units)):.3g} {column.unit_text(units)}"
    if receiver is not None and receiver.plan_angle[0]:
        text += f", at {np.degrees(receiver.plan_angle[0]):.3g}° in plan"
        text += ", seen end on" if is_end_on(receiver) else ""
    x, z = line[:, 0] + share * (line[:, -1] - line[:, 0])
    return Label(text, float(x), float(z), (0.0, -1.0))


def _label(text: str, trace: Trace, station: int, units: str) -> Label:
    """Return a label for a station of the stream, best on the side of the surface."""
    x, z = (float(COLUMNS["x_m"].converted(trace.columns[name][station], units)) for name in ("x_m", "z_m"))
    return Label(text, x, z, _normal(-trace.side or 1.0, float(trace.columns["slope_deg"][station])))


def _normal(side: float, slope_deg: float) -> tuple[float, float]:
    """Return the direction normal to a stream, up for a side of 1."""
    slope: Array = np.radians(np.array(slope_deg))
    return float(side * np.sin(slope)), float(side * np.cos(slope))
