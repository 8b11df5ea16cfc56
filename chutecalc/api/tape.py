"""Records what NumPy does with some numbers, so that compiled code can repeat it with others.

What follows from a varied number is a :class:`Traced`: it holds its present value, and the tape records every operation
on it. Where a program branches on a comparison, the tape records its outcome as well: for numbers with another outcome
the record does not hold, and running it says so.
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
    """A record of operations in order, on the numbers of one design.

    Attributes:
        values: present value of each slot.
        steps: operations as :mod:`chutecalc.core.replay` reads them: code, three arguments, result.
        varied: how many numbers are varied; they have the first slots.
    """

    def __init__(self) -> None:
        self.values: list[float] = []
        self.steps: list[int] = []
        self.varied = 0
        self._constants: dict[tuple[float, float], Slot] = {}

    def new_variable(self, value: float) -> "Traced":
        """Return a number that is varied. All must be made before anything else is recorded.

        Args:
            value: its present value, in any unit.
        """
        self.varied += 1
        return Traced(self, np.array([value], dtype=float), self.new_slot(float(value)))

    def new_slot(self, value: float = np.nan) -> Slot:
        """Return a slot for one more value.

        Args:
            value: its present value, in any unit.
        """
        self.values.append(value)
        return len(self.values) - 1

    def slot(self, item: Any) -> Slot:
        """Return the slot of a number; a constant gets one when it is first used.

        Args:
            item: a :class:`Traced`, or anything that NumPy takes for one number.

        Raises:
            TypeError: It is more than one number.
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
        """Record an operation and return the slot of its result.

        Args:
            name: of the operation, one of :data:`chutecalc.core.replay.NAMES`.
            slots: of its arguments, at most three.
        """
        found = self.new_slot()
        self.steps += [CODE[name], *slots, *[0] * (3 - len(slots)), found]
        return found

    def check(self, slot: Slot, answer: bool) -> None:
        """Record that a condition must keep its outcome.

        Args:
            slot: of the condition; any number but 0 is true.
            answer: its present outcome.
        """
        holds = self.record("not", self.record("not", slot))  # whatever is not 0 is true
        self.steps += [CODE["check"], holds, self.slot(answer), 0, 0]

    def recipe(self, taken: Sequence[Any], width: int = replay.WIDTH) -> replay.Recipe:
        """Return the record in the form that compiled code runs.

        Args:
            taken: the results of each design, traced or constant.
            width: how many designs are worked out at once.
        """
        slots = [self.slot(item) for item in taken]
        return replay.Recipe(self.steps, self.values, slots, self.varied, width)


def run_recipe(recipe: replay.Recipe, numbers: Array) -> Array | None:
    """Return the results of a record for other numbers; None if a condition has another outcome for any of them.

    Args:
        recipe: of :meth:`Tape.recipe`.
        numbers: the varied ones in their units, shape (designs, varied).

    Returns:
        The results in their units, shape (designs, results), or None.

    >>> tape = Tape()
    >>> recipe = tape.recipe([2.0 * tape.new_variable(1.0)])
    >>> run_recipe(recipe, np.array([[3.0], [4.0]])).tolist()
    [[6.0], [8.0]]
    """
    if numbers.shape[1] != recipe.varied:  # the compiled loop does not look
        raise TypeError(f"takes {recipe.varied} numbers, not {numbers.shape[1]}")
    out = np.empty((len(numbers), len(recipe.taken)))
    return out if replay.replay(recipe, numbers, out) == len(numbers) else None


class Traced(np.lib.mixins.NDArrayOperatorsMixin):
    """An array of one number that follows from varied numbers.

    Args:
        tape: the tape that records it.
        value: its present value, an array of one number.
        slot: slot of the value on the tape.
    """

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
        """Return the same number in another shape."""
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
        """Return the number itself, as any of one."""
        return self._reshaped(self.value.any())

    def all(self) -> Any:
        """Return the number itself, as all of one."""
        return self._reshaped(self.value.all())

    def max(self) -> Any:
        """Return the present value, for messages alone: it is not recorded."""
        return self.value.max()

    @property
    def flat(self) -> Any:
        """Present value for messages alone: it is not recorded."""
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
    """Return the better of two numbers; NaN if one is NaN."""
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
    np.exp: _plain("exponential"),
    np.negative: _negative,
    np.absolute: _absolute,
    np.minimum: _least,
    np.maximum: _largest,
    np.power: _power,
    np.square: lambda tape, one: tape.record("multiply", one, one),
}
"""NumPy's functions as operations of :mod:`chutecalc.core.replay`."""
