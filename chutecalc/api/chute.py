"""Chutes from their specs, and variants of them."""

import sys
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from reprlib import repr as short
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import ValidationError

from chutecalc.api.tolerance import check_tolerance
from chutecalc.design import Design
from chutecalc.errors import Fault, SpecError, UsageError
from chutecalc.fields.faults import GeometryError
from chutecalc.solver.steel import Steel, drawn_steel, enters_vertically, follows_stream, with_steel
from chutecalc.spec.bounded import excess_of_tables
from chutecalc.spec.build import build
from chutecalc.spec.chute_spec import ChuteSpec
from chutecalc.spec.faults import case_faults, faults_of, geometry_faults, value_text
from chutecalc.spec.library import Library, resolved
from chutecalc.spec.operating import case_values, drawing_faults, is_felt, is_operating
from chutecalc.spec.paths import with_values

if TYPE_CHECKING:
    from chutecalc.api.function import Function
    from chutecalc.api.uncertain_keys import UncertainKeys


class Chute:
    """A chute, or n variants of it: the spec as written, checked, and as numbers."""

    data: dict[str, Any]
    """The spec: nested tables as TOML gives them, with arrays of shape (designs,) where it is varied, and with the keys
    of a library's entries where it uses any."""
    written: dict[str, Any]
    """The same as written, with ``use`` in place of those keys."""
    library: Library | None
    """Materials and liners that the spec may use."""
    source: str
    """Name of the spec in messages and tables, usually its file."""
    text: str
    """TOML text of the spec, for line numbers in messages; empty if it was given as tables."""
    count: int
    """Number of designs."""
    spec: ChuteSpec
    """The checked spec."""
    design: Design
    """The numeric description, SI and radians."""

    def __init__(
        self,
        data: dict[str, Any],
        source: str = "spec",
        text: str = "",
        drawing: "Chute | None" = None,
        library: Library | None = None,
    ) -> None:
        """Check a spec and turn it into numbers.

        Args:
            data: nested tables as TOML gives them; where designs are varied, with arrays of length 1 or n.
            source: name of the spec in messages.
            text: from which the data were read, for line numbers in messages.
            drawing: the chute at the design point, on whose steel this one runs; drawn anew if not given.
            library: materials and liners that the spec may use.

        Raises:
            SpecError: all faults of keys, values and names; where there are none, all faults of geometry.
        """
        self.written, self.library, self._drawing = data, library, drawing
        self.data = data = resolved(data, library, source, text)
        self.source, self.text = source, text
        self.count = _count(data, source)
        try:
            self.spec = ChuteSpec.model_validate(data)
            design = build(self.spec, drawing.design if drawing and drawing.spec.model.steel == "fixed" else None)
            self.design = with_steel(design, drawing.steel_for(design)) if drawing else design
        except ValidationError as error:
            raise SpecError(faults_of(error, data, text), source) from None
        except GeometryError as error:
            raise SpecError(geometry_faults(error.faults, data, text), source, error.designs) from None

    def __repr__(self) -> str:
        """Return source, title and segments.

        >>> import chutecalc
        >>> chutecalc.parse({**chutecalc.parse(chutecalc.STARTER).data, "title": "Spoon"})
        <Chute 'spec': Spoon; fall, spoon>
        """
        title = f"{self.spec.title}; " if self.spec.title else ""
        designs = f"; {self.count} designs" if self.count > 1 else ""
        return f"<Chute {self.source!r}: {title}{', '.join(segment.name for segment in self.design.segments)}{designs}>"

    @property
    def drawing(self) -> "Chute":
        """The chute at its design point, where its steel is drawn; itself unless operating keys were varied."""
        return self._drawing or self  # kept as None, so that a chute is no circle that needs a garbage collector

    def vary(self, changes: Mapping[str, Any]) -> "Chute":
        """Return variants of this chute: design k takes entry k of each array.

        The steel stands still while operating keys vary: flow, material, liners, velocities of inlet and belts. Where
        geometry varies each variant is drawn anew, at the operating state of the spec. With
        ``model.steel = "follows_stream"`` what is placed by the stream moves with it instead.

        Args:
            changes: for each spec path a number or a 1-dimensional array of length 1 or n, in the unit of the path. A
                key in another unit replaces the one given. A path that takes a name, such as that of a liner, takes
                text, and one that is true or false takes that, for all designs.

        Returns:
            The chute of n designs.

        Raises:
            SpecError: a path does not exist, arrays differ in length, or a value is out of bounds.
            UsageError: the changes are no values by path.

        >>> import chutecalc
        >>> spoon = chutecalc.parse(chutecalc.STARTER)
        >>> variants = spoon.vary({"segments.spoon.radius_m": [2.0, 3.0], "material.internal_friction_deg": 40})
        >>> chutecalc.solve(variants).exit_velocity.shape
        (2,)
        """
        arrays = {path: _as_array(path, value, self.source) for path, value in check_changes(changes).items()}
        return self._on_steel(arrays)

    def _on_steel(self, changes: dict[str, Any]) -> "Chute":
        """Return the chute with changes, on the steel of its drawing."""
        drawing = self.drawing
        drawn = {path: value for path, value in changes.items() if not is_operating(path)}
        fixed = self.spec.model.steel == "fixed"
        if drawing is self and fixed and not any(is_operating(path) and is_felt(path) for path in changes):
            return self._with(changes)
        return self._with(changes, drawing._with(drawn) if drawn else drawing)

    def _with(self, changes: dict[str, Any], drawing: "Chute | None" = None) -> "Chute":
        """Return the chute with changes, on the steel of a drawing, or drawn anew."""
        changed = with_values(self.written, changes, self.source)
        return Chute(changed, self.source, self.text, drawing, self.library)

    @cached_property
    def cases(self) -> dict[str, "Chute"]:
        r"""The operating states of the spec's ``[cases]`` on the same steel, by name.

        >>> import chutecalc
        >>> spoon = chutecalc.parse(chutecalc.STARTER + '[cases.surge]\n"flow.rate_t_h" = 1500')
        >>> spoon.cases["surge"].spec.flow.rate_t_h
        1500.0
        """
        found, faults = {}, []
        for name, table in self.spec.cases.items():
            values = case_values(table)
            faults += case_faults(drawing_faults(values), name, self.text)
            try:
                found[name] = self._on_steel({path: value for path, value in values.items() if is_operating(path)})
            except SpecError as error:
                faults += case_faults(error.faults, name, self.text)
        if faults:
            raise SpecError(faults, self.source)
        return found

    @cached_property
    def uncertain(self) -> "UncertainKeys":
        r"""The numbers of the spec that ``[uncertainty]`` says are uncertain; of a case, about the values of that case.

        >>> import chutecalc
        >>> spoon = chutecalc.parse(chutecalc.STARTER + '[uncertainty]\n"flow.rate_t_h" = { uniform = [800, 1100] }')
        >>> spoon.uncertain.keys[0].scatter.text
        '800 to 1100'
        """
        from chutecalc.api.uncertain_keys import read_uncertainty  # what a run does not need

        return read_uncertainty(self.spec, self.source, self.text)

    def steel_for(self, *states: Design) -> Steel:
        """Return where the segments are drawn that follow the stream at this design point.

        Args:
            states: other states of the chute, which are to run on that steel; none for any state.

        Raises:
            SpecError: a curve is not tangent to the stream that falls into it.
        """
        vertical = bool(states) and all(enters_vertically(state) for state in (self.design, *states))
        moving = follows_stream(self.design, vertical)
        return {number: place for number, place in self._steel.items() if number in moving} if moving else {}

    @cached_property
    def _steel(self) -> Steel:
        """Where all segments are drawn that may follow the stream."""
        try:
            return drawn_steel(self.design, self.spec.model.steel == "fixed")
        except SpecError as error:
            raise SpecError(error.faults, self.source, error.designs) from None

    def put(self, changes: Mapping[str, Any]) -> "Chute":
        """Return this chute with single values or text put at spec paths: a changed spec rather than variants.

        Args:
            changes: for each spec path its new value, in the unit of the path.

        Raises:
            SpecError: as for :meth:`vary`.
            UsageError: as for :meth:`vary`.

        >>> import chutecalc
        >>> spoon = chutecalc.parse(chutecalc.STARTER).put({"segments.spoon.radius_m": 2.0})
        >>> chutecalc.solve(spoon).exit_velocity.round(3)
        array([5.603])
        """
        if fault := excess_of_tables(list(check_changes(changes).values())):
            raise SpecError([fault], self.source)
        return self._with(dict(changes))

    def function(
        self,
        parameters: Mapping[str, tuple[float, float] | None] | Sequence[str],
        outputs: Sequence[str] = ("exit_velocity_m_s",),
        rtol: float = 1e-10,
    ) -> "Function":
        """Return this chute as a function of some of its numbers: for optimisers, root finders and many designs.

        What follows from the parameters is recorded once; a call repeats it with other numbers, and solves.

        Args:
            parameters: paths of numbers in the spec, in the order of the arguments; as a mapping, with limits that are
                narrower than the spec's own bounds, in the unit of the path.
            outputs: names as those of a sweep's columns: ``exit_`` and a station column, ``receiver_`` and a receiver
                column, or ``error_estimate``.
            rtol: relative error allowed to the velocity, as for :func:`chutecalc.solve`.

        Returns:
            A function that takes a number or an array for each parameter, in the units of their paths, and returns a
            number or an array for each output: NaN where a design fails or cannot be built. The steel stands still
            as for :meth:`vary`. Where both geometry and operating keys are varied and the drawing depends on the
            stream, each call draws and builds the chutes anew, which is slower.

        Raises:
            SpecError: a path leads to no number of the spec.
            UsageError: an output is unknown, or the chute has several designs.

        >>> import chutecalc
        >>> spoon = chutecalc.parse(chutecalc.STARTER)
        >>> velocity = spoon.function(["segments.spoon.radius_m"])
        >>> round(velocity(3.0), 3), velocity([2.0, 3.0]).round(3)
        (6.222, array([5.603, 6.222]))
        """
        from chutecalc.api.function import Function  # what a run does not need

        check_tolerance(rtol)
        if self.count != 1:
            raise UsageError(f"function takes a chute of one design, not {self.count}: use the chute before vary")
        spec = ChuteSpec.model_validate(self.data)  # its own: what is varied is put there
        return Function(spec, self, parameters, outputs, rtol)


def check_chute(chute: Any) -> None:
    """Check that a caller gives a chute.

    Args:
        chute: what is given.

    Raises:
        UsageError: it is something else.
    """
    if not isinstance(chute, Chute):
        raise UsageError(f"give a chute from chutecalc.load or chutecalc.parse, not {short(chute)}")


def check_changes(changes: Any) -> Mapping[str, Any]:
    """Return changes if they are values by spec path.

    Args:
        changes: what is given.

    Raises:
        UsageError: they are something else.
    """
    if not isinstance(changes, Mapping) or not all(isinstance(path, str) for path in changes):
        raise UsageError(f'give values by path, such as {{"flow.rate_t_h": 800}}, not {short(changes)}')
    return changes


def _count(data: Any, source: str) -> int:
    """Return how many designs the arrays in a spec's data describe."""
    lengths: dict[int, str] = {}
    for path, array in _arrays(data, ""):
        if array.ndim == 1 and array.size > 1:
            lengths.setdefault(len(array), path)
    if len(lengths) > 1:
        given = ", ".join(f"{path} {length}" for length, path in lengths.items())
        raise SpecError([Fault("", f"the arrays differ in length: {given}", "give 1 or n values each")], source)
    return next(iter(lengths), 1)


def _arrays(item: Any, path: str) -> Iterator[tuple[str, Any]]:
    """Yield the arrays in a spec's data with their paths."""
    if isinstance(item, np.ndarray):
        yield path, item
    elif isinstance(item, dict | list):
        for key, value in item.items() if isinstance(item, dict) else enumerate(item, 1):
            yield from _arrays(value, f"{path}.{key}".lstrip("."))


def _as_array(path: str, value: Any, source: str) -> Any:
    """Return a varied value as a 1-dimensional array of floats; text, true and false as they are."""
    if isinstance(value, str | bool):
        return value
    try:
        array = np.asarray(value)
        masked = "numpy.ma" in sys.modules and np.ma.is_masked(value)  # which is slow to load
        numbers = array.dtype.kind in "fiu" and not masked
        array = array.astype(np.float64) if numbers else np.empty(0)
    except (TypeError, ValueError):
        array = np.empty(0)
    if array.ndim > 1:
        problem = f"is an array of {array.ndim} dimensions; it must have one: a value for each design"
        raise SpecError([Fault(path, problem, "flatten it")], source)
    if array.size == 0:
        raise SpecError([Fault(path, "takes numbers", "give a number or a list of numbers", value_text(value))], source)
    return np.atleast_1d(array)
