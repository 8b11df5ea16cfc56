"""A chute as a function from some of its numbers to numbers at its exit: for optimisers, root finders and sweeps."""

from collections.abc import Iterable, Mapping, Sequence
from threading import Lock
from typing import Any

import numpy as np

from chutecalc.api.parameter import Limits, check_distinct, check_names, parameter_at
from chutecalc.api.recording import Recording, VariedChute
from chutecalc.core.single_design import OUTPUTS, solve_single
from chutecalc.design import Design, Status
from chutecalc.errors import SpecError, UsageError
from chutecalc.physics.arrays import Array, Mask
from chutecalc.results.belts import RECEIVER_COLUMNS, receiver_numbers
from chutecalc.results.columns import AT_EXIT
from chutecalc.results.exits import at_exit, exit_needs, output_numbers, solve_exits
from chutecalc.solver.segment_solution import Ends
from chutecalc.spec.chute_spec import ChuteSpec


class Function:
    """A chute as a function of some of its numbers, as :meth:`chutecalc.Chute.function` returns it.

    ``f(*values)`` takes a number or an array for each parameter, in their order and in the units of their paths. It
    returns a number or an array for each output: a tuple, or a single one where there is one output. A design that
    fails or cannot be built gives NaN.

    >>> import chutecalc
    >>> chutecalc.parse(chutecalc.STARTER).function(["segments.spoon.radius_m"])
    <Function of segments.spoon.radius_m: exit_velocity_m_s>
    """

    def __init__(
        self,
        spec: ChuteSpec,
        chute: VariedChute,
        parameters: Mapping[str, Limits | None] | Sequence[str],
        outputs: Iterable[str],
        rtol: float,
    ) -> None:
        """Record what follows from the parameters, see :meth:`chutecalc.api.chute.Chute.function`.

        Args:
            spec: a copy of the spec for this function alone; varied values are put into it.
            chute: the chute, which is varied for values that cannot be replayed.
            parameters: as there.
            outputs: as there.
            rtol: as there, dimensionless.
        """
        self.outputs, self.rtol, self._chute = check_names(outputs, "outputs"), rtol, chute
        limits = parameters if isinstance(parameters, Mapping) else {}
        self.parameters = tuple(
            parameter_at(spec, path, limits.get(path)) for path in check_names(parameters, "parameters")
        )
        check_distinct(self.parameters)
        self._lock = Lock()  # records and numbers of a recipe are of one thread at a time
        self._limited = any(parameter.limits for parameter in self.parameters)
        self._exit_columns = [name.removeprefix("exit_") for name in self.outputs if name.startswith("exit_")]
        self._direct = set(OUTPUTS) >= set(self.outputs)  # without a profile of the stream at the end
        self._indices = [OUTPUTS.index(name) for name in self.outputs] if self._direct else []
        self._check_outputs(spec)
        needs = exit_needs(self._exit_columns)
        self._recording = Recording(chute, spec, self.parameters, rtol, needs, self._direct)

    def __repr__(self) -> str:
        return f"<Function of {', '.join(self.paths)}: {', '.join(self.outputs)}>"

    def __reduce__(self) -> tuple[Any, ...]:
        """Rebuild the function in another process."""
        limits = {parameter.path: parameter.limits for parameter in self.parameters}
        return self._chute.function, (limits, self.outputs, self.rtol)

    @property
    def traced(self) -> bool:
        """Whether calls replay a recording; otherwise each builds a chute."""
        return self._recording.holds

    @property
    def paths(self) -> tuple[str, ...]:
        """Paths of the parameters, in their order."""
        return tuple(parameter.path for parameter in self.parameters)

    def __call__(self, *values: Any) -> Any:
        """Return the outputs.

        Args:
            values: for each parameter a number, or an array of shape (designs,), in the unit of its path.

        Raises:
            UsageError: values are missing, do not fit together, or lie outside the given limits.
            SpecError: the spec does not accept a value.
        """
        if len(values) != len(self.parameters):
            raise UsageError(
                f"the function takes {len(self.parameters)} value(s), for {', '.join(self.paths)}, not {len(values)}"
            )
        single = self._recording.single_design
        if single is not None and (not self._limited or self._within_limits(values)):
            with self._lock:
                known = solve_single(single, values)
            if known is not None:
                return known[self._indices[0]] if len(self._indices) == 1 else tuple(known[k] for k in self._indices)
        rows = _rows(values)
        if self._limited:
            self._check_limits(rows)
        found = self._replayed(rows)
        if found is None:
            found = self._rebuilt(rows)
        outputs = found if any(map(np.ndim, values)) else [float(numbers[0]) for numbers in found]
        return outputs[0] if len(outputs) == 1 else tuple(outputs)

    def _within_limits(self, values: Sequence[Any]) -> bool:
        """Return whether all values are floats within the given limits."""
        return all(
            isinstance(value, float) and parameter.is_within(value)
            for parameter, value in zip(self.parameters, values, strict=True)
        )

    def _check_limits(self, rows: Array) -> None:
        for parameter, column in zip(self.parameters, rows.T, strict=True):
            wrong = column[~parameter.is_within(column)]
            if wrong.size:
                low, high = parameter.bounds
                raise UsageError(f"{parameter.path} must be from {low!r} to {high!r} here, not {float(wrong[0])!r}")

    def _replayed(self, rows: Array) -> list[Array] | None:
        """Return the outputs by the recording; None where it does not hold for all designs."""
        with self._lock:
            known = self._recording.replayed(rows)
        solved = None if known is None else self._recording.solved(known)
        return None if solved is None else self._outputs_of(*solved)

    def _rebuilt(self, values: Array) -> list[Array]:
        """Return the outputs by building a chute of that many designs, without those that cannot be built."""
        outputs = [np.full(len(values), np.nan) for _ in self.outputs]
        waiting = [np.arange(len(values))]
        while waiting:
            rows = waiting.pop()
            try:
                changes = dict(zip(self.paths, np.ascontiguousarray(values[rows].T), strict=True))
                found = solve_exits(self._chute.vary(changes).design, self.rtol, self._exit_columns, len(rows))
            except SpecError as error:
                if error.designs is None:
                    raise
                rest = rows[~np.broadcast_to(error.designs, len(rows))]
                waiting += [rest] if rest.size else []
            else:
                known = output_numbers(found.exit, found.receiver, found.error_estimate)
                for column, numbers in zip(outputs, self._chosen(known, found.ok), strict=True):
                    column[rows] = numbers
        return outputs

    def _outputs_of(self, design: Design, ends: Ends) -> list[Array]:
        """Return the outputs of designs from their ends."""
        if self._direct:
            depth = ends.stream_section[0][0] if ends.stream_section.size else np.full(1, np.nan)
            numbers = (ends.velocity, ends.error, ends.distance, ends.x, ends.z, np.degrees(ends.slope), depth)
            known = dict(zip(OUTPUTS, numbers, strict=True))
        else:
            found = at_exit(design, ends, self._exit_columns)
            known = output_numbers(found, receiver_numbers(design, ends), ends.error)
        return self._chosen(known, ends.status == Status.OK)

    def _chosen(self, known: Mapping[str, Array], ok: Mask) -> list[Array]:
        """Return the outputs among numbers by their names."""
        return [np.where(ok, known[name], np.nan) for name in self.outputs]

    def _check_outputs(self, spec: ChuteSpec) -> None:
        known = {"error_estimate", *(f"exit_{name}" for name in AT_EXIT)}
        known |= {f"receiver_{name}" for name in RECEIVER_COLUMNS} if spec.receiver else set()
        unknown = [name for name in self.outputs if name not in known]
        if unknown:
            raise UsageError(
                f"there is no output {', '.join(unknown)}: use exit_ and a station column other than time,"
                " receiver_ and a receiver column, or error_estimate"
            )


def _rows(values: Sequence[Any]) -> Array:
    """Return arrays and numbers as rows, one for each design."""
    try:
        arrays = [np.asarray(value) for value in values]
        if all(array.ndim <= 1 and (array.dtype.kind in "fiu" or not array.size) for array in arrays):
            columns = np.broadcast_arrays(*(np.atleast_1d(array.astype(float)) for array in arrays))
            return np.column_stack(columns)
    except (TypeError, ValueError, OverflowError):
        pass
    raise UsageError("give a number or a 1-dimensional array for each parameter, arrays all of the same length")
