"""The base class of segments that guide the stream."""

from typing import Annotated, ClassVar

from pydantic import Field

from chutecalc.design import Contact
from chutecalc.fields.faults import ALL_DESIGNS
from chutecalc.fields.quantities import Position
from chutecalc.fields.quantity import in_si
from chutecalc.physics.arrays import Array
from chutecalc.physics.motion import FLOOR
from chutecalc.physics.section import width_of
from chutecalc.segments.base import Context, Segment

MOST_TAPER = 100.0
"""Ratio of the widths of a taper's sections: a hopper has 20. Beyond 100 no stream of a chute fits into both."""


class Guide(Segment):
    """A segment that guides the stream."""

    section: str | Annotated[list[str], Field(min_length=2, max_length=2)] | None = Field(
        None, description="name of its section, or of those at its start and its end; needed if the spec has several"
    )
    liner: str | None = Field(None, description="name of its liner; needed if the spec has several")
    start_m: Position = Field(None, description="x and z of its drawn start, after a fall with onto_next")
    may_be_passed: bool = Field(
        False, description="true if a stream may fly past it without touching it; otherwise that is a failure"
    )

    side: ClassVar[float] = FLOOR
    """Sign of the surface, ``FLOOR`` or ``ROOF`` of :mod:`chutecalc.physics.motion`."""
    placed: ClassVar[dict[str, str]] = {"start_m": "start_m = [x, z]"}

    def contact(
        self,
        context: Context,
        entry_slope: Array | None,
        exit_slope: Array,
        radius: Array | None = None,
        length: Array | None = None,
        deflects: bool = False,
    ) -> Contact:
        """Return the segment in numbers, with its section and liner.

        Args:
            context: what the numbers follow from, beside this table.
            entry_slope: at its start, rad below horizontal; None if it is tangent to the stream that falls into it.
            exit_slope: at its end, rad below horizontal.
            radius: of an arc, m; None for a straight.
            length: of a straight, m; None for an arc.
            deflects: whether the stream only strikes it, as an impact plate.
        """
        first, last = self._section_names(context)
        start = None if self.start_m is None else (in_si(self.start_m[0], "length"), in_si(self.start_m[1], "length"))
        lining = context.linings[self.liner or next(iter(context.linings))]
        return Contact(
            name=context.name,
            kind=self.kind,
            side=self.side,
            deflects=deflects,
            entry_slope=entry_slope,
            exit_slope=exit_slope,
            radius=radius,
            length=length,
            start=start,
            may_be_passed=self.may_be_passed,
            section=context.drawn_sections[first],
            end_section=None if last is None else context.drawn_sections[last],
            wall=lining.wall,
            measured=lining.measured,
            own_material=lining.own_material,
            slip_ratio=lining.slip_ratio,
            thickness=lining.thickness,
            wear_rate=lining.wear_rate,
        )

    def _section_names(self, context: Context) -> tuple[str, str | None]:
        """Names of the sections at the start and, of a taper, at the end."""
        if not isinstance(self.section, list):
            return self.section or next(iter(context.sections)), None
        first, last = self.section
        if not context.sections[first].is_like(context.sections[last]):
            problem = f"tapers from {first} to {last}, which differ in more than their numbers"
            remedy = "give both the same shape and the same keys"
            context.faults.note(ALL_DESIGNS, (*context.location, "section"), None, problem, remedy)
            return first, None
        start, end = (width_of(context.drawn_sections[name], endless=0.0) for name in (first, last))
        far = (start > MOST_TAPER * end) | (end > MOST_TAPER * start)
        problem = f"tapers from {first} to {last}, of which one is more than {MOST_TAPER:g} times as wide as the other"
        remedy = "check the widths of both: is one in another unit?"
        context.faults.note(far, (*context.location, "section"), None, problem, remedy)
        return first, last if last != first else None
