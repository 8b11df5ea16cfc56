"""From a chute's parameters straight to numbers at its end: for optimisers, root finders and sweeps."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from threading import Lock
from typing import Any

import numpy as np

from chutecalc.api.parameter import Limits, check_distinct, check_names, parameter_at
from chutecalc.api.tape import Tape, Traced, run_recipe
from chutecalc.core.answer import OUTPUTS, Answer, ask
from chutecalc.core.replay import Recipe
from chutecalc.design import Design, Status
from chutecalc.errors import SpecError, UsageError
from chutecalc.physics.arrays import Array, Index
from chutecalc.results.belts import received
from chutecalc.results.columns import COLUMNS, RECEIVER_COLUMNS
from chutecalc.results.exits import NOT_AT_EXIT, asked_of, at_ends, named
from chutecalc.results.trajectory import asked, at_exit
from chutecalc.solver.chain import answer_of, run_ends
from chutecalc.solver.course import Numbers, again_at, columns_of, kinds_of
from chutecalc.solver.effort import effort
from chutecalc.solver.leg import Ends
from chutecalc.spec.build import build
from chutecalc.spec.chute_spec import ChuteSpec


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
        """See :meth:`chutecalc.api.chute.Chute.function`.

        Args:
            spec: its own; what is varied is put there.
            vary: makes a chute with values at paths, for numbers that change what is to be done.
            drawn_slopes: as of :func:`chutecalc.spec.build.build`.
            parameters, outputs, rtol: as there.
        """
        self.outputs, self.rtol, self._vary = check_names(outputs, "outputs"), rtol, vary
        limits = parameters if isinstance(parameters, Mapping) else {}
        self.parameters = tuple(
            parameter_at(spec, path, limits.get(path)) for path in check_names(parameters, "parameters")
        )
        check_distinct(self.parameters)
        self._lock = Lock()  # records and numbers of a recipe are of one thread at a time
        self._limited = any(parameter.limits for parameter in self.parameters)
        self.exit_names = [name.removeprefix("exit_") for name in self.outputs if name.startswith("exit_")]
        self._plain = set(OUTPUTS) >= set(self.outputs)  # without a profile of the stream at the end
        self._places = [OUTPUTS.index(name) for name in self.outputs] if self._plain else []
        self._check_outputs(spec)
        self._trace(spec, drawn_slopes)

    def __repr__(self) -> str:
        return f"<Function of {', '.join(self.paths)}: {', '.join(self.outputs)}>"

    def __reduce__(self) -> tuple[Any, ...]:
        """For other processes: it is made again there."""
        vary: Any = self._vary  # of the chute
        limits = {parameter.path: parameter.limits for parameter in self.parameters}
        return vary.__self__.function, (limits, self.outputs, self.rtol)

    @property
    def traced(self) -> bool:
        """Whether calls go the short way; else a chute is built for each."""
        return self._recipe is not None

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
        if self._answer is not None and (not self._limited or self._within(values)):
            with self._lock:
                known = ask(self._answer, values)
            if known is not None:
                return known[self._places[0]] if len(self._places) == 1 else tuple(known[k] for k in self._places)
        rows = _rows(values)
        if self._limited:
            self._check_limits(rows)
        found = self._shortly(rows)
        if found is None:
            found = self._slowly(rows)
        told = found if any(map(np.ndim, values)) else [float(numbers[0]) for numbers in found]
        return told[0] if len(told) == 1 else tuple(told)

    def _within(self, values: Sequence[Any]) -> bool:
        """Whether all are floats within the limits that were asked for."""
        return all(
            isinstance(value, float) and parameter.is_within(value)
            for parameter, value in zip(self.parameters, values, strict=True)
        )

    def _check_limits(self, rows: Array) -> None:
        for parameter, column in zip(self.parameters, rows.T, strict=True):
            wrong = column[~parameter.is_within(column)]
            if wrong.size:
                low, high = parameter.bounds
                raise UsageError(f"{parameter.path} has to be from {low!r} to {high!r} here, not {float(wrong[0])!r}")

    def _shortly(self, rows: Array) -> list[Array] | None:
        """The outputs by what is written down; None where that does not hold for all designs."""
        with self._lock:
            known = None if self._recipe is None else run_recipe(self._recipe, rows)
        if known is None:
            return None
        try:
            ends = run_ends(self._kinds, Numbers(known, [], self._again), self.rtol, *self._asked)
        except SpecError:
            return None
        return self._told(_filled(self._design, known, self._leaves), ends)

    def _slowly(self, values: Array) -> list[Array]:
        """The same by way of a chute of that many designs, without those that cannot be built."""
        told = [np.full(len(values), np.nan) for _ in self.outputs]
        waiting = [np.arange(len(values))]
        while waiting:
            rows = waiting.pop()
            try:
                design = self._vary(dict(zip(self.paths, np.ascontiguousarray(values[rows].T), strict=True))).design
                found = at_ends(design, self.rtol, self.exit_names, len(rows))
            except SpecError as error:
                if error.designs is None:
                    raise
                rest = rows[~np.broadcast_to(error.designs, len(rows))]
                waiting += [rest] if rest.size else []
            else:
                known = named(found.exit, found.receiver, found.error_estimate)
                for column, numbers in zip(told, self._chosen(known, found.codes), strict=True):
                    column[rows] = numbers
        return told

    def _told(self, design: Design, ends: Ends) -> list[Array]:
        """The outputs of designs from their ends."""
        if self._plain:
            depth = ends.lying[0][0] if ends.lying.size else np.full(1, np.nan)
            numbers = (ends.velocity, ends.error, ends.distance, ends.x, ends.z, np.degrees(ends.slope), depth)
            known = dict(zip(OUTPUTS, numbers, strict=True))
        else:
            found = at_exit(design, ends, asked_of(design, self.exit_names))
            known = named(found, received(design, found), ends.error)
        return self._chosen(known, ends.status)

    def _chosen(self, known: Mapping[str, Array], status: Index) -> list[Array]:
        """The outputs among numbers by their names."""
        well = status == Status.OK
        return [np.where(well, known[name], np.nan) for name in self.outputs]

    def _check_outputs(self, spec: ChuteSpec) -> None:
        known = {"error_estimate", *(f"exit_{name}" for name in COLUMNS if name not in NOT_AT_EXIT)}
        known |= {f"receiver_{name}" for name in RECEIVER_COLUMNS} if spec.receiver else set()
        unknown = [name for name in self.outputs if name not in known]
        if unknown:
            raise UsageError(
                f"there is no output {', '.join(unknown)}: known are exit_ before a station's columns but time,"
                " receiver_ before those of the belt, and error_estimate"
            )

    def _trace(self, spec: ChuteSpec, drawn_slopes: Mapping[int, Array]) -> None:
        """Builds the chute once and writes down what follows from the parameters."""
        base = build(spec, drawn_slopes)
        self._kinds, self._again = kinds_of(base), 0
        self._asked = asked(self.exit_names)
        self._recipe: Recipe | None = None
        self._answer: Answer | None = None
        self._design, self._leaves = base, dict[int, int]()
        if base.segments[-1].deflects:  # where the stream is as the impact on it leaves it
            return
        before = [parameter.value for parameter in self.parameters]
        try:
            self._write(Tape(), spec, drawn_slopes)
        except (AttributeError, TypeError, ValueError):
            pass  # something that a tape does not hold
        finally:
            for parameter, value in zip(self.parameters, before, strict=True):
                parameter.set_value(value)

    def _write(self, tape: Tape, spec: ChuteSpec, drawn_slopes: Mapping[int, Array]) -> None:
        """Has a tape hold it, up to what a row of numbers for the solver is, and what the outputs take beside that."""
        given = [tape.new_variable(parameter.value_in_unit) for parameter in self.parameters]
        for parameter, value in zip(self.parameters, given, strict=True):
            converted = np.multiply(parameter.to_first_unit(value), 1.0)
            if not parameter.accepts(converted):
                raise ValueError("no value for the spec")
            parameter.set_value(converted)
        design = build(spec, drawn_slopes)
        columns, _, begins = columns_of(design)
        varied = [number for number, column in enumerate(columns) if isinstance(column, Traced)]
        self._again = again_at(design, begins, varied[0]) if varied else 0
        leaves = {} if self._plain else {leaf.slot: leaf for leaf in _leaves(design)}
        self._leaves = {slot: len(columns) + number for number, slot in enumerate(leaves)}
        self._recipe = tape.recipe([*columns, *leaves.values()])
        self._design = self._design if self._plain else design
        if self._plain:
            alone = tape.recipe(columns, width=1)
            self._answer = answer_of(self._kinds, alone, effort(self.rtol, complete=False), *self._asked)


def _rows(values: Sequence[Any]) -> Array:
    """Arrays and numbers as a row for each design."""
    try:
        arrays = [np.asarray(value) for value in values]
        if all(array.ndim <= 1 and (array.dtype.kind in "fiu" or not array.size) for array in arrays):
            columns = np.broadcast_arrays(*(np.atleast_1d(array.astype(float)) for array in arrays))
            return np.column_stack(columns)
    except (TypeError, ValueError, OverflowError):
        pass
    raise UsageError("takes a number, or an array of one dimension, for each parameter; arrays all of one length")


def _leaves(item: Any) -> Iterator[Traced]:
    """What was traced in a record."""
    if isinstance(item, Traced):
        yield item
    elif isinstance(item, tuple):
        for part in item:
            yield from _leaves(part)


def _filled(item: Any, known: Array, leaves: Mapping[int, int]) -> Any:
    """A record with what was traced as it is now."""
    if not leaves:
        return item
    if isinstance(item, Traced):
        return known[:, leaves[item.slot]]
    if isinstance(item, tuple):
        parts = [_filled(each, known, leaves) for each in item]
        return type(item)(*parts) if hasattr(item, "_fields") else tuple(parts)
    return item
