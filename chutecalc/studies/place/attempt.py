"""A segment placed where the stream strikes it as wanted, or the nearest that can be had."""

from collections.abc import Iterator, Sequence
from math import nan, radians
from typing import Any, NamedTuple

from chutecalc.api.cases import solve_cases
from chutecalc.api.chute import Chute
from chutecalc.api.solve import solve
from chutecalc.design import Contact
from chutecalc.errors import SpecError
from chutecalc.fields.units import same_quantity
from chutecalc.spec.library import Library
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.place.approach import RTOL, chute_up_to
from chutecalc.studies.place.stand import length_of, stand_for, start_of
from chutecalc.studies.place.strike import Launch, NotReachedError
from chutecalc.studies.place.struck import MIDDLE, Struck, struck_by
from chutecalc.studies.place.wish import Wish

CLOSE = 1e-9
"""Distance, m, and angle, rad, within which the stream strikes as wanted."""
GRAZING = 1e-4
"""Incidence, rad. A stream at i strikes 1/i further along for each unit that the surface is off, down to this one."""
HALVINGS = 40
SHARES = 20
"""Number of shares that are tried for one at which all edges strike."""
FINE = 1e-3
"""Share to which that one is found."""


class Drawn(NamedTuple):
    """A segment that the stream strikes as wanted."""

    start: tuple[float, float]
    """x and z of its start, m."""
    slopes: dict[str, float]
    """Its slopes, degrees, by key."""
    chute: Chute
    """The chute up to it."""
    struck: Struck


class Attempt(NamedTuple):
    """What is asked of a segment."""

    data: dict[str, Any]
    """Tables of the spec."""
    number: int
    """Number of the segment, from 0."""
    launch: Launch
    """Where the flight to it begins."""
    wish: Wish
    source: str
    library: Library | None = None
    """That the spec may use."""

    def drawn(self) -> Drawn:
        """Return the segment where it is struck as wanted.

        Raises:
            NotReachedError: it cannot be, with the nearest that can.
            UsageError: the spec has no slope, and the wishes do not give it.
        """
        if self.wish.edges_margin is not None:
            return self._catching()
        drawn = self.at(self.wish.share)
        if drawn is None:
            raise NotReachedError(self._nearest())
        return drawn

    def at(self, share: float) -> Drawn | None:
        """Return the segment with a share of its length before the strike; None if the stream strikes it otherwise.

        Args:
            share: of its length.

        Raises:
            NotReachedError: it cannot stand so, whatever the stream does.
            UsageError: the spec has no slope, and the wishes do not give it.
        """
        stand = stand_for(self.launch, self.data["segments"][self.number], self.wish._replace(share=share))
        segment = self._chute(stand.slopes, (0.0, 0.0)).design.segments[-1]
        assert isinstance(segment, Contact)
        start = start_of(segment, self.launch, stand, share)
        try:
            chute = self._chute(stand.slopes, start)
        except SpecError as error:  # with a start near the stream it is a chute
            x, z = start
            raise NotReachedError(f"its start, x {x:.5g} m and z {z:.5g} m, {error.faults[0].problem}") from None
        solution = solve(chute, RTOL)
        struck = struck_by(solution, len(solution.segments) - 1)
        if struck is None:
            return None
        incidence = segment.side * (self.launch.slope_at(stand.strike.time) - stand.strike.slope)
        along = abs(struck.share - share) * length_of(segment).item() * max(incidence, GRAZING)
        as_wanted = max(along, abs(radians(struck.incidence_deg) - incidence)) <= CLOSE
        return Drawn(start, stand.slopes, chute, struck) if as_wanted else None

    def _chute(self, slopes: dict[str, float], start: tuple[float, float]) -> Chute:
        """Return the chute up to the segment, with slopes and a start that replace its own, whatever their units."""
        own = {"start_m": list(start)} | slopes
        replaced = {other for key in own for other in same_quantity(key)}
        table = {key: value for key, value in self.data["segments"][self.number].items() if key not in replaced}
        return chute_up_to(self.data, self.number, table | own, self.source, self.library)

    def _at(self, share: float) -> Drawn | None:
        """Return the segment with a share before the strike; None if that cannot be."""
        try:
            return self.at(share)
        except NotReachedError:
            return None

    def _nearest(self) -> str:
        """Return why a share cannot be had, with the greatest that can, found by halving."""
        low, high, elsewhere = 0.0, self.wish.share, "the stream would meet it elsewhere first, or from behind"
        if self._at(low) is None:
            return f"{elsewhere}, wherever it begins. Change its slopes or radius"
        for _ in range(HALVINGS):
            middle = 0.5 * (low + high)
            low, high = (low, middle) if self._at(middle) is None else (middle, high)
        return f"{elsewhere}; the nearest is a share of {low:.6g} of its length before the strike"

    def _catching(self) -> Drawn:
        """Return the segment with the least share before the strike at which all edges strike it, in all states.

        Raises:
            NotReachedError: there is none.
        """
        found: dict[float, list[tuple[str, str]]] = {}
        refusal = ""
        for number in range(SHARES):
            share = number / SHARES
            try:
                drawn = self.at(share)
            except NotReachedError as error:
                if not share:  # it cannot be for any
                    raise
                refusal = refusal or str(error)
                continue
            if drawn is not None:
                found[share] = list(_missing(drawn.chute))
                if not found[share]:
                    return self._with_margin(*self._least(share, drawn))
        if not found:
            raise NotReachedError(self._nearest())
        share = min(found, key=lambda share: len(found[share]))
        more = f" More than {max(found):g} cannot be had: {refusal}." if refusal else ""
        raise NotReachedError(
            f"no share lets the whole stream strike it in every state. Best of those tried is {share:g}, with which"
            f" these miss it: {_named(found[share])}.{more} Let it be struck more steeply or elsewhere, or make it"
            " longer"
        )

    def _least(self, share: float, drawn: Drawn) -> tuple[float, Drawn]:
        """Return the least share that does, which is at most one step below the first found, and the segment then."""
        low = share - 1.0 / SHARES
        while share > 0.0 and share - low > FINE:
            middle = 0.5 * (low + share)
            if (tried := self._at(middle)) is not None and not [*_missing(tried.chute)]:
                share, drawn = middle, tried
            else:
                low = middle
        return share, drawn

    def _with_margin(self, share: float, drawn: Drawn) -> Drawn:
        """Return the segment with a margin beyond the least share that does.

        Raises:
            NotReachedError: the whole stream does not strike it so.
        """
        margin = self.wish.edges_margin
        if not margin:
            return drawn
        begins = f"the whole stream strikes it from a share of {share:.3f} on, but with the margin"
        try:
            further = self.at(share + margin)
        except NotReachedError as error:
            raise NotReachedError(f"{begins} {error}") from None
        missing = [(MIDDLE, DESIGN_POINT)] if further is None else list(_missing(further.chute))
        if further is None or missing:
            raise NotReachedError(f"{begins} these miss it: {_named(missing)}. Take a smaller margin")
        return further


def _missing(chute: Chute) -> Iterator[tuple[str, str]]:
    """Yield what of the stream does not strike the last segment of a chute: the edge and the state."""
    for state, solution in solve_cases(chute).solutions.items():
        struck = struck_by(solution, len(solution.segments) - 1)
        edges = {MIDDLE: nan} if struck is None else struck.edges
        yield from ((edge, state) for edge, incidence in edges.items() if incidence != incidence)


def _named(missing: Sequence[tuple[str, str]]) -> str:
    """Return what does not strike as text, each edge with its states."""
    states: dict[str, list[str]] = {}
    for edge, state in missing:
        states.setdefault(edge if edge == MIDDLE else f"{edge} edge", []).append(state)
    return ", ".join(f"its {what} ({', '.join(names)})" for what, names in states.items())
