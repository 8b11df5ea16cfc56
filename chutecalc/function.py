"""From a chute's parameters straight to numbers at its end: for optimisers, root finders and sweeps."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from pydantic_core import PydanticCustomError

from chutecalc.along import asked, at_exit
from chutecalc.belts import received
from chutecalc.columns import COLUMNS, RECEIVER_COLUMNS
from chutecalc.design import Contact, Design, Status
from chutecalc.errors import Fault, SpecError, UsageError
from chutecalc.physics.arrays import Array
from chutecalc.solver.chain import run_ends
from chutecalc.solver.course import Numbers, again_at, columns_of, kinds_of, numbers_of
from chutecalc.solver.leg import Ends
from chutecalc.spec.build import build
from chutecalc.spec.model import ChuteSpec
from chutecalc.spec.quantity import Quantity, Table
from chutecalc.tape import Tape, Traced
from chutecalc.units import convert, first_unit

NOT_AT_EXIT = ("spec", "segment", "kind", "time_s")
Limits = tuple[float, float]
PLAIN = {"exit_velocity_m_s": 1, "error_estimate": 2, "exit_s_m": 3, "exit_x_m": 4, "exit_z_m": 5}
"""Outputs that stand among the ends as they are, and where."""


class Parameter(NamedTuple):
    """A number of the spec that is varied."""

    path: str
    table: Table
    """That it stands in, with its documented key and, of a list, the places in it."""
    key: str
    places: tuple[int, ...]
    unit: str
    limits: Limits | None

    @property
    def quantity(self) -> Quantity:
        """Its bounds and its dimension."""
        return self.table.quantities()[self.key]

    @property
    def value(self) -> Any:
        """In the dimension's first unit, as the spec has it."""
        value = getattr(self.table, self.key)
        for place in self.places:
            value = value[place]
        return value

    def put(self, value: Any) -> None:
        """Has the spec say so."""
        if not self.places:
            self.table.__dict__[self.key] = value  # a model is frozen against everybody else
            return
        rows = getattr(self.table, self.key)
        for place in self.places[:-1]:
            rows = rows[place]
        rows[self.places[-1]] = value

    def converted(self, value: Any) -> Any:
        """To the dimension's first unit."""
        return convert(value, self.quantity.dimension, self.unit, first_unit(self.quantity.dimension))

    def fits(self, value: Any) -> bool:
        """Whether the spec's bounds, and the rules of its table, let it be so."""
        try:
            self.quantity.number(value)
        except PydanticCustomError:
            return False
        if self.places or not self.table.rules:
            return True
        table = {key: item for key, item in self.table.__dict__.items() if item is not None} | {self.key: value}
        return not any(True for rule in self.table.rules for _ in rule(table))


class Function:
    """A chute as a function of some of its numbers.

    ``f(*values)`` takes a number or an array for each parameter, in their order and in the units of their paths, and
    gives a number or an array for each output; one alone where there is one. A design that fails, or that cannot be
    built, gives NaN.
    """

    def __init__(
        self,
        spec: ChuteSpec,
        vary: Callable[[Mapping[str, Any]], Any],
        drawn_slopes: Mapping[int, Array],
        parameters: Mapping[str, Limits | None] | Sequence[str],
        outputs: Iterable[str],
        rtol: float,
    ) -> None:
        """See :meth:`chutecalc.chute.Chute.function`.

        Args:
            spec: its own; what is varied is put there.
            vary: makes a chute with values at paths, for numbers that change what is to be done.
            drawn_slopes: as of :func:`chutecalc.spec.build.build`.
            parameters, outputs, rtol: as there.
        """
        self.outputs, self.rtol, self._vary = tuple(outputs), rtol, vary
        given = parameters if isinstance(parameters, Mapping) else dict.fromkeys(parameters)
        self.parameters = tuple(_parameter(spec, path, limits) for path, limits in given.items())
        self.exit_names = [name.removeprefix("exit_") for name in self.outputs if name.startswith("exit_")]
        self._check_outputs(spec)
        self._trace(spec, drawn_slopes)

    @property
    def traced(self) -> bool:
        """Whether calls go the short way; else a chute is built for each."""
        return self._tape is not None

    @property
    def paths(self) -> tuple[str, ...]:
        """Of the parameters, in their order."""
        return tuple(parameter.path for parameter in self.parameters)

    def __call__(self, *values: Any) -> Any:
        """The outputs.

        Raises:
            UsageError: not a value for each parameter, or one outside the limits that were asked for.
            SpecError: a value that the spec does not take.
        """
        if len(values) != len(self.parameters):
            raise UsageError(f"takes {len(self.parameters)} value(s), for {', '.join(self.paths)}, not {len(values)}")
        for parameter, value in zip(self.parameters, values, strict=True):
            if parameter.limits and not (parameter.limits[0] <= np.min(value) and np.max(value) <= parameter.limits[1]):
                low, high = parameter.limits
                raise UsageError(f"{parameter.path} has to be from {low:g} to {high:g} here, not {value}")
        single = not any(isinstance(value, np.ndarray | list | tuple) for value in values)
        found = self._at([float(value) if single else np.atleast_1d(np.float64(value)) for value in values])
        told = [float(numbers[0]) for numbers in found] if single else found
        return told[0] if len(told) == 1 else tuple(told)

    def _at(self, values: list[Any]) -> list[Array]:
        """The outputs for an array of each parameter."""
        converted = [parameter.converted(value) for parameter, value in zip(self.parameters, values, strict=True)]
        fits = all(parameter.fits(value) for parameter, value in zip(self.parameters, converted, strict=True))
        known = self._tape.again(converted) if fits and self._tape is not None else None
        if known is None:
            return self._slowly(values)
        count = max(np.size(value) for value in converted)
        rows = np.repeat(self._row, count, axis=0) if count > 1 else self._row.copy()
        for column, place in self._varied:
            rows[:, column] = known[place]
        try:
            ends = run_ends(self._kinds, Numbers(rows, [], self._again), self.rtol, *self._asked)
        except SpecError:
            return self._slowly(values)
        return self._told(self._base if self._simple else _filled(self._design, known), ends)

    def _slowly(self, values: list[Any]) -> list[Array]:
        """The same by way of a chute of that many designs, without those that cannot be built."""
        count = max(np.size(value) for value in values)
        whole = [np.broadcast_to(value, count) for value in values]
        told = [np.full(count, np.nan) for _ in self.outputs]
        waiting = [np.arange(count)]
        while waiting:
            rows = waiting.pop()
            try:
                design = self._vary({path: column[rows] for path, column in zip(self.paths, whole, strict=True)}).design
                ends = run_ends(kinds_of(design), numbers_of(design), self.rtol, *self._asked)
            except SpecError as error:
                if error.designs is None:
                    raise
                rest = rows[~np.broadcast_to(error.designs, len(rows))]
                waiting += [rest] if rest.size else []
            else:
                for column, found in zip(told, self._told(design, ends), strict=True):
                    column[rows] = found
        return told

    def _told(self, design: Design, ends: Ends) -> list[Array]:
        """The outputs of designs from their ends."""
        well = ends.status == Status.OK
        exits, belt = {}, {}
        if not self._simple:
            names = [*self.exit_names, *(("velocity_m_s", "slope_deg") if design.receiver else ())]
            exits = at_exit(design, ends, names)
            if design.receiver is not None:
                belt = received(design.receiver, design, exits["velocity_m_s"], np.radians(exits["slope_deg"]))
        told = []
        for name in self.outputs:
            if name in PLAIN:
                values = ends[PLAIN[name]]
            elif name == "exit_slope_deg":
                values = np.degrees(ends.slope)
            elif name == "exit_depth_m":
                values = ends.lying[0][0] if self._guided else np.full(well.shape, np.nan)
            else:
                way, _, own = name.partition("_")
                values = exits[own] if way == "exit" else belt[own]
            told.append(np.where(well, values, np.nan))
        return told

    def _check_outputs(self, spec: ChuteSpec) -> None:
        known = {"error_estimate", *(f"exit_{name}" for name in COLUMNS if name not in NOT_AT_EXIT)}
        known |= {f"receiver_{name}" for name in RECEIVER_COLUMNS} if spec.receiver else set()
        unknown = [name for name in self.outputs if name not in known]
        if unknown or not self.outputs:
            raise UsageError(
                f"there is no output {', '.join(unknown) or 'asked for'}: known are exit_ before a station's columns,"
                " receiver_ before those of the belt, and error_estimate"
            )

    def _trace(self, spec: ChuteSpec, drawn_slopes: Mapping[int, Array]) -> None:
        """Builds the chute once and writes down what follows from the parameters."""
        self._base = build(spec, drawn_slopes)
        self._kinds = kinds_of(self._base)
        self._guided = isinstance(self._base.segments[-1], Contact)
        self._simple = {*PLAIN, "exit_slope_deg", "exit_depth_m"}.issuperset(self.outputs)
        self._asked = asked(self.exit_names)
        tape, before = Tape(), [parameter.value for parameter in self.parameters]
        self._tape: Tape | None = tape
        try:
            for parameter, value in zip(self.parameters, before, strict=True):
                parameter.put(tape.number(value))
            self._design = build(spec, drawn_slopes)
            columns, _, begins = columns_of(self._design)
        except (AttributeError, TypeError, ValueError):  # something that a tape does not hold
            self._tape, self._design = None, self._base
            columns, _, begins = columns_of(self._base)
        finally:
            for parameter, value in zip(self.parameters, before, strict=True):
                parameter.put(value)
        self._varied = [(k, column.place) for k, column in enumerate(columns) if isinstance(column, Traced)]
        first = self._varied[0][0] if self._varied else 0
        self._again = again_at(self._base, begins, first)
        self._row = np.array([[_number(column) for column in columns]])


def _number(column: Any) -> float:
    value = column.value if isinstance(column, Traced) else column
    return float(value if isinstance(value, float) else value[0])


def _parameter(spec: ChuteSpec, path: str, limits: Limits | None) -> Parameter:
    """Where a path leads in a checked spec."""
    here: Any = spec
    parts = path.split(".")
    try:
        for number, part in enumerate(parts):
            if isinstance(here, Table):
                name, unit = here.keys()[part]
                if name in type(here).quantities():
                    places = tuple(int(place) - 1 for place in parts[number + 1 :])
                    found = Parameter(path, here, name, places, unit, limits)
                    if isinstance(found.value, float | int) and all(place >= 0 for place in places):
                        return found
                    break
                part = name
            here = _below(here, part)
    except (KeyError, IndexError, AttributeError, ValueError, TypeError, StopIteration):
        pass
    raise SpecError(
        [Fault(path, "is no number that the spec gives", "choose one that it has, or give it one there first")]
    )


def _below(here: Any, part: str) -> Any:
    if isinstance(here, dict):
        return here[part]
    if isinstance(here, list):
        return here[int(part) - 1] if part.isdecimal() else next(item for item in here if item.name == part)
    return getattr(here, part)


def _filled(item: Any, known: list[Any]) -> Any:
    """A record with what was traced as it is now."""
    if isinstance(item, Traced):
        return known[item.place]
    if isinstance(item, tuple):
        parts = [_filled(each, known) for each in item]
        return type(item)(*parts) if hasattr(item, "_fields") else tuple(parts)
    return item
