"""A finding about a solution: what it says, how severe it is, which designs it concerns and where."""

from dataclasses import dataclass
from enum import StrEnum
from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Mask, Numbers
from chutecalc.results.column import quantity_text
from chutecalc.results.columns import COLUMNS


class Severity(StrEnum):
    """How severe a finding is, the worst first.

    >>> list(Severity)
    [<Severity.FAILURE: 'failure'>, <Severity.WARNING: 'warning'>, <Severity.NOTE: 'note'>]
    """

    FAILURE = "failure"
    """The stream does not get through."""
    WARNING = "warning"
    """The design, or the validity of the model, is in doubt."""
    NOTE = "note"
    """Worth knowing."""


class _Quantity(NamedTuple):
    """A number of a message; the template may say its unit in the United States, or how to format it alone."""

    name: str
    value: float
    units: str

    def __format__(self, form: str) -> str:
        if form.startswith("."):
            return format(self.value, form)
        return quantity_text(self.name, self.value, self.units, form)


@dataclass(frozen=True, repr=False, eq=False)
class Finding:
    """One finding about some of the designs; arrays are of shape (designs,)."""

    code: str
    """Short name, such as ``stall``; docs/findings.md describes all of them."""
    severity: Severity
    """``failure``, ``warning`` or ``note``."""
    segment: str
    """Name of the segment concerned; empty for a finding about a key of the spec."""
    mask: Mask
    """True for the designs concerned."""
    s_m: Array
    """Position: distance from the inlet along the stream, m; NaN for a finding about a key."""
    template: str
    """The message, with names of ``numbers`` in braces; ``{depth_m:in}`` is in inches in US units, ``{given:.12g}`` a
    number alone."""
    numbers: Numbers
    """The numbers that led to the finding; names end in their units."""
    badness: Array
    """How bad it is, the larger the worse: comparable with the same finding of another operating state."""
    asks: str = ""
    """What its advice changes: ``steeper`` or ``flatter``, ``faster`` or ``slower``; empty for anything else."""
    key: str = ""
    """Path of the key of the spec concerned, where the finding is about no segment; else empty."""

    @property
    def subject(self) -> str:
        """The segment, or the path of the key, that the finding is about."""
        return self.segment or self.key

    def where(self, design: int = 0, units: str = "metric") -> str:
        """Return what the finding is about, and where along the stream, for one design.

        Args:
            design: index of the design, from 0.
            units: ``metric`` or ``us``.

        >>> import chutecalc
        >>> level = chutecalc.parse(chutecalc.STARTER).put({"segments.spoon.to_slope_deg": 0})
        >>> chutecalc.solve(level).findings()[0].where()
        'spoon, s = 6.712 m'
        """
        s, column = float(self.s_m[design]), COLUMNS["s_m"]
        return self.subject if s != s else f"{self.subject}, s = {column.shown(s, units)} {column.unit_text(units)}"

    def message(self, design: int = 0, units: str = "metric") -> str:
        """Return the finding in words for one design.

        Args:
            design: index of the design, from 0.
            units: ``metric`` or ``us``.

        Returns:
            A sentence without its final period.
        """
        return self.template.format(
            **{name: _Quantity(name, float(values[design]), units) for name, values in self.numbers.items()}
        )

    def __repr__(self) -> str:
        """Return code, position and message of the first design concerned.

        >>> import chutecalc
        >>> level = chutecalc.parse(chutecalc.STARTER).put({"segments.spoon.to_slope_deg": 0})
        >>> chutecalc.solve(level).findings()[0]  # doctest: +ELLIPSIS
        <warning below_cut_off: spoon, s = ... m: the spoon ends at ...>
        """
        concerned = np.flatnonzero(self.mask)
        first = int(concerned[0]) if concerned.size else 0
        designs = f" ({concerned.size} of {len(self.mask)} designs)" if len(self.mask) > 1 else ""
        return f"<{self.severity} {self.code}{designs}: {self.where(first)}: {self.message(first)}>"
