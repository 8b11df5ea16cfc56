"""The lines of a chute seen from the side: its stream, its surfaces, and flights that miss."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from chutecalc.design import Contact, Status
from chutecalc.physics.arrays import Array
from chutecalc.physics.surface import point
from chutecalc.results.columns import COLUMNS
from chutecalc.results.solved import SolvedChute

STATIONS = 101
"""Number of stations along each segment or flight."""
DEEPEST = 0.25
"""Greatest depth drawn, over the greater side of the chute: the depth has no bound where a stream nearly stops."""
Lines = dict[str, Array]


class Trace(NamedTuple):
    """The stations of one segment or flight that the stream reached."""

    name: str
    kind: str
    side: float
    """1 on a floor, -1 under a roof, 0 in flight."""
    columns: Lines


def traces(solution: SolvedChute) -> list[Trace]:
    """Return the stream of the first design, a trace for each segment and flight that it reached.

    A stream that reaches none has the inlet as its only trace.

    Args:
        solution: solution of one design.
    """
    stations = solution.stations(points=STATIONS)
    found = []
    for number, part in enumerate(solution.trajectory.parts):
        rows = slice(number * STATIONS, (number + 1) * STATIONS)
        reached = np.isfinite(stations["s_m"][0, rows])
        if reached.any():
            guide = part.solved.segment if part.contact is not None else None
            side = guide.side if isinstance(guide, Contact) else 0.0
            columns = {name: stations[name][0, rows][reached] for name in stations}
            found.append(Trace(part.name, part.kind, side, columns))
    return found or [_at_inlet(solution)]


def _at_inlet(solution: SolvedChute) -> Trace:
    """Return the inlet as a trace of one station."""
    inlet = {name: values[:1] for name, values in solution.inlet.items()}
    nowhere = {name: np.full(1, np.nan) for name in COLUMNS}
    return Trace("inlet", "inlet", 0.0, nowhere | inlet | {"s_m": np.zeros(1)})


def extent(solution: SolvedChute, stream: Sequence[Trace]) -> Array:
    """Return width and height of a chute with its stream, seen from the side, m.

    Args:
        solution: solution of one design.
        stream: traces of its stream.
    """
    paths = [(part.columns["x_m"], part.columns["z_m"]) for part in stream]
    points = np.concatenate([np.stack(line) for line in (*paths, *surfaces(solution))], axis=1)
    size: Array = np.ptp(points, axis=1)
    return size


def deepest(solution: SolvedChute, stream: Sequence[Trace]) -> float:
    """Return the greatest depth to which the stream is drawn, m.

    Args:
        solution: solution of one design.
        stream: traces of its stream.
    """
    return DEEPEST * float(extent(solution, stream).max())


def surfaces(solution: SolvedChute) -> Iterator[tuple[Array, Array]]:
    """Yield the line or arc of each contact segment that has a position.

    Args:
        solution: solution of one design.

    Yields:
        Horizontal position and height along it, m, each of shape (stations,).
    """
    for solved in {solved.number: solved for solved in reversed(solution.trajectory.segment_solutions)}.values():
        if solved.contact is not None:
            x, z, _ = point(solved.contact.surface, np.linspace(0.0, 1.0, STATIONS)[:, None])
            if np.isfinite(x[:, 0] + z[:, 0]).all():
                yield x[:, 0], z[:, 0]


def lost_flights(solution: SolvedChute, drawn: Sequence[tuple[Array, Array]]) -> Iterator[tuple[Array, Array]]:
    """Yield the paths of streams that miss the next segment, until they are below everything drawn.

    Args:
        solution: solution of one design.
        drawn: horizontal position and height of its surfaces, m.

    Yields:
        Horizontal position and height along the path, m, each of shape (stations,).
    """
    lowest = min((float(z.min()) for _, z in drawn), default=np.inf)
    further = max((float(np.ptp(z)) for _, z in drawn), default=1.0)
    for solved in solution.trajectory.segment_solutions:
        if solved.status[0] == Status.MISSED:
            x, z, forward, downward, gravity = solved.path[:, 0]
            drop = z - min(lowest, z) + 0.2 * further
            time = np.linspace(0.0, (np.sqrt(downward**2 + 2.0 * gravity * drop) - downward) / gravity, STATIONS)
            yield x + forward * time, z - (downward + 0.5 * gravity * time) * time
