"""The keys that a study may change: continuous between bounds, or one of several numbers or names."""

import re
from collections.abc import Mapping, Sequence
from reprlib import repr as short
from typing import Any, NamedTuple

import numpy as np

from chutecalc.api.chute import Chute
from chutecalc.errors import UsageError
from chutecalc.physics.arrays import Array
from chutecalc.studies.sweep.parameters import AnyParameter, read_parameters
from chutecalc.studies.sweep.text_parameter import CASE, TextParameter

BOUNDS = re.compile(r"([^=]+)=([^:,]+):([^:,#]+)")
"""An argument with bounds alone."""


class Key(NamedTuple):
    """What a study may change."""

    parameter: AnyParameter
    """Its name and paths, with its two bounds or its choices as values."""
    is_continuous: bool
    """Whether it may have any value between its bounds."""

    @property
    def name(self) -> str:
        """Name of its column."""
        return self.parameter.name

    @property
    def bounds(self) -> tuple[float, float]:
        """Least and greatest place: of a continuous key its value, of another the number of a choice, from 0."""
        values = self.parameter.values
        return (float(values[0]), float(values[1])) if self.is_continuous else (0.0, len(values) - 1.0)

    def at(self, places: Array) -> Any:
        """Return the values at places, numbers or names.

        Args:
            places: within the bounds, in the unit of the key, shape (designs,).

        >>> import chutecalc
        >>> (liner,) = read_keys(["segments.2.liner=steel,ceramic"], chutecalc.parse(chutecalc.STARTER))
        >>> liner.at(np.array([1.0, 0.0])).tolist()
        ['ceramic', 'steel']
        """
        return places if self.is_continuous else self.parameter.values[np.rint(places).astype(int)]

    def written(self, value: float | str) -> float | str | bool:
        """Return a value as a spec holds it.

        Args:
            value: a number or a name, as :meth:`at` returns it.
        """
        return self.parameter.value(str(value)) if isinstance(self.parameter, TextParameter) else value


def read_keys(arguments: Sequence[str], chute: Chute) -> list[Key]:
    """Return the keys that some arguments stand for.

    Args:
        arguments: ``KEY=LOW:HIGH`` each for a continuous key; for a choice as :func:`read_parameters` takes them:
            ``KEY=LOW:HIGH:STEP``, a list of numbers, or a list of names.
        chute: in whose spec short names are looked up.

    Raises:
        UsageError: an argument is wrong.

    >>> import chutecalc
    >>> (key,) = read_keys(["radius=1:4"], chutecalc.parse(chutecalc.STARTER))
    >>> key.name, key.bounds, key.is_continuous
    ('radius_m', (1.0, 4.0), True)
    """
    if chute.count != 1:
        raise UsageError(f"what is sought starts from a chute of one design, not {chute.count}")
    if not arguments:
        raise UsageError("nothing may change: add a key with its bounds, such as radius=1:4")
    found = [BOUNDS.fullmatch(argument.strip()) for argument in arguments]
    as_lists = [
        f"{bounds[1]}={bounds[2]},{bounds[3]}" if bounds else argument
        for argument, bounds in zip(arguments, found, strict=True)
    ]
    if any(argument.partition("=")[0].strip() == CASE for argument in arguments):
        raise UsageError("case is not a key that may change: choose a state with --case")
    keys = [Key(each, bool(bounds)) for each, bounds in zip(read_parameters(as_lists, chute), found, strict=True)]
    for key, argument in zip(keys, arguments, strict=True):
        if key.is_continuous and not key.parameter.values[0] < key.parameter.values[1]:
            raise UsageError(f"{argument}: the lower bound must be below the upper one. Write {key.name}=LOW:HIGH.")
    return keys


def key_arguments(keys: Mapping[str, Any]) -> list[str]:
    """Return keys as they are written on a command line.

    Args:
        keys: by path or short name: bounds, as a tuple of two numbers; bounds and a step, as a tuple of three; or a
            list of numbers or names to choose from.

    >>> key_arguments({"radius": (1, 4), "beta": (30, 60, 5), "segments.2.liner": ["steel", "ceramic"]})
    ['radius=1:4', 'beta=30:60:5', 'segments.2.liner=steel,ceramic']
    """
    if not isinstance(keys, Mapping):
        raise UsageError(f'give bounds by path, such as {{"segments.2.radius_m": (1, 4)}}, not {short(keys)}')
    wrong = [name for name, given in keys.items() if not isinstance(given, Sequence | np.ndarray) or len(given) == 0]
    if wrong:
        raise UsageError(f"{', '.join(wrong)}: give bounds (low, high), (low, high, step), or a list to choose from")
    marks = {name: ":" if isinstance(given, tuple) else "," for name, given in keys.items()}
    return [f"{name}={marks[name].join(map(_text, given))}" for name, given in keys.items()]


def _text(value: Any) -> str:
    """Return a value as a spec writes it, without quotes."""
    return str(value).lower() if isinstance(value, bool | np.bool_) else str(value)
