"""A record of what NumPy does with some numbers, to do it again with others.

What follows from a varied number is a :class:`Traced`: it has the value that it has now, and every NumPy function that
it goes through is written down. Where a program asks whether something holds, the answer is written down too: with
other numbers that give another answer the record is of no use, and says so.
"""

from collections.abc import Callable
from typing import Any

import numpy as np


class Tape:
    """What was done, in order."""

    def __init__(self) -> None:
        self.steps: list[tuple[Callable[..., Any], list[Any], dict[str, Any], int]] = []
        """Function, arguments, and where its result goes; a Traced argument stands for where its own is."""
        self.answers: list[tuple[int, bool]] = []
        """Where a truth value is, and what it has to be."""
        self.size = 0

    def number(self, value: Any) -> "Traced":
        """The next number that is varied; all before anything else."""
        return self._new(np.atleast_1d(np.float64(value)))

    def call(self, function: Callable[..., Any], arguments: Any, options: Any = None) -> Any:
        """Does something with traced values, and notes it.

        Raises:
            TypeError: it asks for the shape of one design, and would be wrong for many.
        """
        if function is np.broadcast_to:
            raise TypeError("a shape is written down that is that of one design")
        found = function(*_map(arguments, lambda item: item.value), **(options or {}))
        if isinstance(found, tuple | list):  # of broadcasting
            return [self.call(_item, (self._note(function, arguments, options, found), k)) for k in range(len(found))]
        return self._note(function, arguments, options, found)

    def _note(self, function: Any, arguments: Any, options: Any, found: Any) -> "Traced":
        own = self._new(found)
        self.steps.append((function, arguments, options or {}, own.place))
        return own

    def _new(self, value: Any) -> "Traced":
        own = Traced(self, value, self.size)
        self.size += 1
        return own

    def again(self, numbers: Any) -> list[Any] | None:
        """All values for other numbers, by their place; None where an answer changes."""
        values: list[Any] = [*numbers, *[None] * (self.size - len(numbers))]
        with np.errstate(all="ignore"):
            for function, arguments, options, place in self.steps:
                given = [values[item.place] if type(item) is Traced else _now(item, values) for item in arguments]
                values[place] = function(*given, **options)
        if any(bool(values[place]) != answer for place, answer in self.answers):
            return None
        return values


def _now(item: Any, values: list[Any]) -> Any:
    """An argument with what was traced in it as it is now."""
    return _map(item, lambda traced: values[traced.place]) if type(item) in (list, tuple) else item


class Traced(np.lib.mixins.NDArrayOperatorsMixin):
    """An array of one design whose value follows from varied numbers."""

    def __init__(self, tape: Tape, value: Any, place: int) -> None:
        self.tape, self.value, self.place = tape, value, place

    def __array_ufunc__(self, function: Any, method: str, *inputs: Any, **options: Any) -> Any:
        return self.tape.call(getattr(function, method), inputs, options)

    def __array_function__(self, function: Any, types: Any, arguments: Any, options: Any) -> Any:
        return self.tape.call(function, arguments, options)

    def __getitem__(self, key: Any) -> Any:
        return self.tape.call(_item, (self, key))

    def __len__(self) -> int:
        return len(self.value)

    def __bool__(self) -> bool:
        self.tape.answers.append((self.place, bool(self.value)))
        return bool(self.value)

    def any(self) -> Any:
        """Whether any is true."""
        return self.tape.call(np.any, (self,))

    def all(self) -> Any:
        """Whether all are."""
        return self.tape.call(np.all, (self,))

    def sum(self, axis: int) -> Any:
        """The sum."""
        return self.tape.call(np.sum, (self, axis))

    def reshape(self, *shape: int) -> Any:
        """In another shape; the designs are the last axis."""
        return self.tape.call(_reshaped, (self, shape[:-1]))

    def max(self) -> Any:
        """For words alone: nobody is told of other numbers."""
        return self.value.max()

    @property
    def flat(self) -> Any:
        """For words alone, likewise."""
        return self.value.flat

    @property
    def shape(self) -> Any:
        """Of the value."""
        return self.value.shape

    @property
    def ndim(self) -> int:
        """Of the value."""
        return int(self.value.ndim)


def _item(values: Any, key: Any) -> Any:
    return values[key]


def _reshaped(values: Any, shape: Any) -> Any:
    return values.reshape(*shape, -1)


def _map(item: Any, function: Callable[["Traced"], Any]) -> Any:
    """Traced values, also in tuples and lists, as what a function makes of them."""
    if isinstance(item, Traced):
        return function(item)
    if isinstance(item, tuple | list):
        return [_map(each, function) for each in item]
    return item
