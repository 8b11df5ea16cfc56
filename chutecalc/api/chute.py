"""A chute from its spec, and its solution."""

from collections.abc import Mapping, Sequence
from functools import cached_property
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import ValidationError

from chutecalc.design import Contact, Design, Fall
from chutecalc.errors import Fault, SpecError, UsageError
from chutecalc.fields.faults import GeometryError
from chutecalc.physics.arrays import Array
from chutecalc.results.solution import Solution
from chutecalc.solver.chain import run_chain
from chutecalc.spec.build import build
from chutecalc.spec.chute_spec import ChuteSpec
from chutecalc.spec.faults import faults_of, geometry_faults, value_text
from chutecalc.spec.parse import parse_text, read_text
from chutecalc.spec.paths import with_values

if TYPE_CHECKING:
    from chutecalc.api.function import Function

TOLERANCES = (1e-13, 1e-3)


class Chute:
    """A chute, or n variants of it: the spec as written, checked, and as numbers."""

    def __init__(
        self,
        data: dict[str, Any],
        source: str = "spec",
        text: str = "",
        drawn_slopes: Mapping[int, Array] | None = None,
    ) -> None:
        """Checks a spec and turns it into numbers.

        Args:
            data: nested tables as TOML gives them; where designs are varied, with arrays of length 1 or n.
            source: what messages call it.
            text: that the data come from, for the lines in messages.
            drawn_slopes: see :func:`chutecalc.spec.build.build`.

        Raises:
            SpecError: all faults of keys, values and names; where there are none, all faults of geometry.
        """
        self.data, self.source, self._text = data, source, text
        self.count = _count(data, source)
        """How many designs there are."""
        try:
            self.spec = ChuteSpec.model_validate(data)
            self.design: Design = build(self.spec, drawn_slopes)
        except ValidationError as error:
            raise SpecError(faults_of(error, data, text), source) from None
        except GeometryError as error:
            raise SpecError(geometry_faults(error.faults, data, text), source, error.designs) from None

    def __repr__(self) -> str:
        """Source, title and segments.

        >>> import chutecalc
        >>> chutecalc.parse({**chutecalc.parse(chutecalc.STARTER).data, "title": "Spoon"})
        <Chute 'spec': Spoon; fall, spoon>
        """
        title = f"{self.spec.title}; " if self.spec.title else ""
        designs = f"; {self.count} designs" if self.count > 1 else ""
        return f"<Chute {self.source!r}: {title}{', '.join(segment.name for segment in self.design.segments)}{designs}>"

    def vary(self, changes: Mapping[str, Any]) -> "Chute":
        """Variants of this chute: parallel arrays put at spec paths, design k taking entry k of each.

        Args:
            changes: path to a number or a 1-dimensional array, all of length 1 or n, in the units of the path. A key in
                another unit replaces the one given.

        Returns:
            The chute of n designs. A curve tangent to a falling stream keeps the slope that it has in this chute.

        Raises:
            SpecError: a path that leads nowhere, arrays that do not fit together, a value out of bounds.

        >>> import chutecalc
        >>> spoon = chutecalc.parse(chutecalc.STARTER)
        >>> variants = spoon.vary({"segments.spoon.radius_m": [2.0, 3.0], "material.internal_friction_deg": 40})
        >>> chutecalc.solve(variants).exit_velocity.shape
        (2,)
        """
        arrays = {path: _as_array(path, value, self.source) for path, value in changes.items()}
        return Chute(with_values(self.data, arrays, self.source), self.source, self._text, self._drawn_slopes)

    def put(self, changes: Mapping[str, Any]) -> "Chute":
        """This chute with single values, or text, put at spec paths: a changed spec rather than a variant.

        Raises:
            SpecError: as :meth:`vary`.
        """
        return Chute(with_values(self.data, dict(changes), self.source), self.source, self._text)

    def function(
        self,
        parameters: Mapping[str, tuple[float, float] | None] | Sequence[str],
        outputs: Sequence[str] = ("exit_velocity_m_s",),
        rtol: float = 1e-10,
    ) -> "Function":
        """This chute as a function of some of its numbers: for optimisers, root finders and many designs.

        What follows from the parameters is found out once; a call works that out with other numbers, and solves.

        Args:
            parameters: paths of numbers that the spec has, in the order of the arguments; with limits for each, where
                they are to be narrower than the spec's own bounds.
            outputs: as columns of a sweep are called: ``exit_`` before a station's columns, ``receiver_`` before those
                of the belt, ``error_estimate``.
            rtol: as of :func:`solve`.

        Returns:
            What takes a number or an array for each parameter, in the units of their paths, and gives a number or an
            array for each output: NaN where a design fails or cannot be built. A curve tangent to a falling stream
            keeps the slope that it has in this chute, as of :meth:`vary`.

        Raises:
            SpecError: a path that leads to no number of the spec.
            UsageError: an output that there is not, or a chute of several designs.

        >>> import chutecalc
        >>> spoon = chutecalc.parse(chutecalc.STARTER)
        >>> velocity = spoon.function(["segments.spoon.radius_m"])
        >>> round(velocity(3.0), 3), velocity([2.0, 3.0]).round(3)
        (3.878, array([3.578, 3.878]))
        """
        from chutecalc.api.function import Function  # what a run does not need

        check_tolerance(rtol)
        if self.count != 1:
            raise UsageError(f"takes a chute of one design, not of {self.count}")
        spec = ChuteSpec.model_validate(self.data)  # its own: what is varied is put there
        return Function(spec, self.vary, self._drawn_slopes, parameters, outputs, rtol)

    @cached_property
    def _drawn_slopes(self) -> dict[int, Array]:
        """Entry slopes of the curves that begin tangent to a falling stream, by number of the segment."""
        slopes = {
            number: segment.entry_slope
            for number, (before, segment) in enumerate(pairwise(self.design.segments), 1)
            if isinstance(before, Fall) and isinstance(segment, Contact)
        }
        known = {number: slope for number, slope in slopes.items() if slope is not None}
        if len(known) == len(slopes):
            return known
        legs, _ = run_chain(self.design, 1e-10, complete=False)
        return {
            leg.number: leg.contact.surface.slope
            for leg in legs
            if leg.number in slopes and leg.contact and np.isfinite(leg.contact.surface.slope).all()
        }


def _count(data: Any, source: str) -> int:
    """How many designs the arrays in a spec's data describe."""
    lengths: dict[int, str] = {}

    def look(item: Any, path: str) -> None:
        if isinstance(item, np.ndarray) and item.ndim == 1 and item.size > 1:
            lengths.setdefault(len(item), path)
        elif isinstance(item, dict | list):
            for key, value in item.items() if isinstance(item, dict) else enumerate(item, 1):
                look(value, f"{path}.{key}".lstrip("."))

    look(data, "")
    if len(lengths) > 1:
        given = ", ".join(f"{path} {length}" for length, path in lengths.items())
        raise SpecError([Fault("", f"the arrays differ in length: {given}", "give 1 or n values each")], source)
    return next(iter(lengths), 1)


def load(path: str | Path, changes: Mapping[str, Any] | None = None) -> Chute:
    """A chute from a TOML file.

    Args:
        path: of the file.
        changes: values, or text, by spec path, put before all is checked: they may be what the file lacks.

    Raises:
        SpecError: the file cannot be read, or all that is wrong with what it says.
    """
    file = Path(path)
    return parse(read_text(file), str(file), changes)


def parse(spec: str | Mapping[str, Any], source: str = "spec", changes: Mapping[str, Any] | None = None) -> Chute:
    """A chute from the text of a spec, or from its nested tables.

    Args:
        spec: TOML, or what ``tomllib`` would make of it.
        source: what messages call it.
        changes: as of :func:`load`.

    Raises:
        SpecError: all that is wrong with it.
    """
    if not isinstance(spec, str | Mapping):
        raise SpecError([Fault("", f"is a {type(spec).__name__}", "give TOML text or a table")], source)
    text = spec if isinstance(spec, str) else ""
    data = parse_text(spec, source) if isinstance(spec, str) else dict(spec)
    return Chute(with_values(data, dict(changes), source) if changes else data, source, text)


def solve(chute: Chute, rtol: float = 1e-10) -> Solution:
    """The stream through a chute, or through each of n.

    Args:
        chute: from :func:`load`, :func:`parse` or :meth:`Chute.vary`.
        rtol: error allowed to the velocity at every place, relative, or as a shift of the place by that share of its
            segment's length, whichever is larger; from 1e-13 to 1e-3.

    Returns:
        The solution; a design that fails says so in its status, and never keeps others from being solved.

    Raises:
        UsageError: ``rtol`` out of its range.
        SpecError: a hood tangent to a falling stream that is steeper than the hood's end.

    >>> import chutecalc
    >>> solution = chutecalc.solve(chutecalc.parse(chutecalc.STARTER))
    >>> solution.status, solution.exit_velocity.round(3)
    (array(['ok'], dtype='<U12'), array([3.878]))
    """
    if not isinstance(chute, Chute):
        raise UsageError(f"solve takes a chute, as chutecalc.load gives one, not {chute!r}")
    check_tolerance(rtol)
    try:
        legs, ends = run_chain(chute.design, rtol)
    except SpecError as error:
        raise SpecError(error.faults, chute.source, error.designs) from None
    return Solution(chute.design, tuple(legs), ends, rtol, chute.count)


def check_tolerance(rtol: float) -> None:
    """Raises a UsageError where the solver does not take such a tolerance."""
    low, high = TOLERANCES
    if not low <= rtol <= high:
        raise UsageError(f"rtol has to be from {low:g} to {high:g}, not {rtol!r}")


def _as_array(path: str, value: Any, source: str) -> Any:
    """A varied value as a 1-dimensional array of floats."""
    try:
        array = np.asarray(value)
        array = array.astype(np.float64) if array.dtype.kind in "fiu" else np.empty(0)
    except (TypeError, ValueError):
        array = np.empty(0)
    if array.ndim > 1:
        problem = f"is given as an array of {array.ndim} dimensions, and takes one: a value for each design"
        raise SpecError([Fault(path, problem, "flatten it")], source)
    if array.size == 0:
        raise SpecError([Fault(path, "takes numbers", "give a number or a list of numbers", value_text(value))], source)
    return np.atleast_1d(array)
