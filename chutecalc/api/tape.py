"""What NumPy does with some numbers, written down to be done again with others, compiled.

What follows from a varied number is a :class:`Traced`: it has the value that it has now, and every operation that it
goes through is written down. Where a program asks whether something holds, the answer is written down too: with other
numbers that give another answer the record is of no use, and says so.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from chutecalc.core import replay
from chutecalc.physics.arrays import Array

CODE = {name: number for number, name in enumerate(replay.NAMES)}
Slot = int


class Tape:
    """What was done, in order. Each value is one number, that of one design."""

    def __init__(self) -> None:
        self.values: list[float] = []
        self.steps: list[int] = []
        self.varied = 0
        self._constants: dict[tuple[float, float], Slot] = {}

    def new_variable(self, value: float) -> "Traced":
        """The next number that is varied; all before anything else."""
        self.varied += 1
        return Traced(self, np.array([value], dtype=float), self.new_slot(float(value)))

    def new_slot(self, value: float = np.nan) -> Slot:
        """A slot for one more value."""
        self.values.append(value)
        return len(self.values) - 1

    def slot(self, item: Any) -> Slot:
        """Where a number is; what never changes takes a slot too.

        Raises:
            TypeError: it is more than one number.
        """
        if isinstance(item, Traced):
            return item.slot
        if np.size(item) != 1:
            raise TypeError("more than one number")
        value = float(item if np.ndim(item) == 0 else np.ravel(item)[0])
        key = value, math.copysign(1.0, value)  # −0 is another
        if key not in self._constants:
            self._constants[key] = self.new_slot(value)
        return self._constants[key]

    def record(self, name: str, *slots: Slot) -> Slot:
        """An operation; tells where its result goes."""
        found = self.new_slot()
        self.steps += [CODE[name], *slots, *[0] * (3 - len(slots)), found]
        return found

    def check(self, slot: Slot, answer: bool) -> None:
        """An answer that has to stay what it is."""
        holds = self.record("not", self.record("not", slot))  # whatever is not 0 is true
        self.steps += [CODE["check"], holds, self.slot(answer), 0, 0]

    def recipe(self, taken: Sequence[Any], width: int = replay.WIDTH) -> replay.Recipe:
        """What to do for so many designs at once, and the numbers to tell of each, varied or not."""
        slots = [self.slot(item) for item in taken]
        return replay.Recipe(self.steps, self.values, slots, self.varied, width)


def run_recipe(recipe: replay.Recipe, numbers: Array) -> Array | None:
    """What is asked for, a row for each row of varied numbers; None where an answer changes."""
    if numbers.shape[1] != recipe.varied:  # the compiled loop does not look
        raise TypeError(f"takes {recipe.varied} numbers, not {numbers.shape[1]}")
    out = np.empty((len(numbers), len(recipe.taken)))
    return out if replay.replay(recipe, numbers, out) == len(numbers) else None


class Traced(np.lib.mixins.NDArrayOperatorsMixin):
    """An array of one design whose value follows from varied numbers."""

    def __init__(self, tape: Tape, value: Any, slot: Slot) -> None:
        self.tape, self.value, self.slot = tape, value, slot

    def __array_ufunc__(self, function: Any, method: str, *inputs: Any, **options: Any) -> Any:
        if method != "__call__" or options or function not in _OPERATIONS:
            return NotImplemented
        return self._result(function, _OPERATIONS[function], inputs)

    def __array_function__(self, function: Any, types: Any, arguments: Any, options: Any) -> Any:
        if function is np.where and len(arguments) == 3 and not options:
            return self._result(np.where, _plain("choose"), arguments)
        if function in (np.any, np.all, np.atleast_1d) and not options:
            return self._reshaped(function(self.value))
        return NotImplemented

    def _result(self, function: Callable[..., Any], operation: Callable[..., Slot], inputs: Sequence[Any]) -> "Traced":
        value = function(*(item.value if isinstance(item, Traced) else item for item in inputs))
        return Traced(self.tape, value, operation(self.tape, *(self.tape.slot(item) for item in inputs)))

    def _reshaped(self, value: Any) -> "Traced":
        """The same number in another shape."""
        if np.size(value) != 1:
            raise TypeError("more than one number")
        return Traced(self.tape, value, self.slot)

    def __getitem__(self, key: Any) -> Any:
        return self._reshaped(self.value[key])

    def __len__(self) -> int:
        return len(self.value)

    def __bool__(self) -> bool:
        self.tape.check(self.slot, bool(self.value))
        return bool(self.value)

    def any(self) -> Any:
        """Whether any is true: of one, itself."""
        return self._reshaped(self.value.any())

    def all(self) -> Any:
        """Whether all are."""
        return self._reshaped(self.value.all())

    def max(self) -> Any:
        """For words alone: nobody is told of other numbers."""
        return self.value.max()

    @property
    def flat(self) -> Any:
        """For words alone, likewise."""
        return self.value.flat


def _plain(name: str) -> Callable[..., Slot]:
    return lambda tape, *slots: tape.record(name, *slots)


def _swapped(name: str) -> Callable[..., Slot]:
    return lambda tape, one, other: tape.record(name, other, one)


def _negative(tape: Tape, one: Slot) -> Slot:
    return tape.record("multiply", one, tape.slot(-1.0))


def _absolute(tape: Tape, one: Slot) -> Slot:
    size = tape.record("choose", tape.record("less", one, tape.slot(0.0)), _negative(tape, one), one)
    return tape.record("add", size, tape.slot(0.0))  # −0 is 0


def _least(tape: Tape, one: Slot, other: Slot) -> Slot:
    return _first(tape, tape.record("less", one, other), one, other)


def _largest(tape: Tape, one: Slot, other: Slot) -> Slot:
    return _first(tape, tape.record("less", other, one), one, other)


def _first(tape: Tape, better: Slot, one: Slot, other: Slot) -> Slot:
    """The one that is better, or no number."""
    none = tape.record("not", tape.record("equal", one, one))
    return tape.record("choose", tape.record("or", better, none), one, other)


def _power(tape: Tape, one: Slot, exponent: Slot) -> Slot:
    if exponent != tape.slot(2.0):
        raise TypeError("a power that is no square")
    return tape.record("multiply", one, one)


_OPERATIONS: dict[Any, Callable[..., Slot]] = {
    np.add: _plain("add"),
    np.subtract: _plain("subtract"),
    np.multiply: _plain("multiply"),
    np.divide: _plain("divide"),
    np.less: _plain("less"),
    np.less_equal: _plain("less_equal"),
    np.greater: _swapped("less"),
    np.greater_equal: _swapped("less_equal"),
    np.equal: _plain("equal"),
    np.not_equal: lambda tape, one, other: tape.record("not", tape.record("equal", one, other)),
    np.bitwise_and: _plain("and"),
    np.bitwise_or: _plain("or"),
    np.invert: _plain("not"),
    np.logical_not: _plain("not"),
    np.sqrt: _plain("root"),
    np.sin: _plain("sine"),
    np.cos: _plain("cosine"),
    np.tan: _plain("tangent"),
    np.arccos: _plain("arccosine"),
    np.negative: _negative,
    np.absolute: _absolute,
    np.minimum: _least,
    np.maximum: _largest,
    np.power: _power,
    np.square: lambda tape, one: tape.record("multiply", one, one),
}
"""What NumPy's functions are in operations of :mod:`chutecalc.core.replay`, of numbers that are numbers."""
