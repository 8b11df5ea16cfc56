"""Numbers and ranges as they are written on a command line: ``30,45,60``, ``15:90:15``, ``15:90:#16``."""

import math
from decimal import Decimal, InvalidOperation
from fractions import Fraction

import numpy as np

from chutecalc.errors import UsageError
from chutecalc.physics.arrays import Array

MOST = 10_000_000
"""Most numbers that a range may have, unless a caller allows fewer."""
DECADES, LONGEST = 300, 40
"""Powers of ten between which numbers are, and characters that one has at most."""


def read_values(name: str, text: str, most: int = MOST) -> Array:
    """Return the numbers of a list of numbers and ranges, worked out in decimal arithmetic.

    Args:
        name: of the argument, for messages.
        text: items between commas: a number; ``a:b:step``, which includes b if a step lands on it; or ``a:b:#n`` for n
            numbers from a to b.
        most: numbers that a range may have.

    Returns:
        The numbers in the units of the text, in its order, shape (numbers,).

    Raises:
        UsageError: An item is neither a number nor a range, or a range has too many numbers.

    >>> read_values("beta", "0.1:0.3:0.1").tolist(), read_values("beta", "15:90:#4").tolist()
    ([0.1, 0.2, 0.3], [15.0, 40.0, 65.0, 90.0])
    """
    return np.concatenate([_item(name, item.strip(), most) for item in text.split(",")])


def _item(name: str, item: str, most: int) -> Array:
    """A number or a range."""
    parts = item.split(":")
    if len(parts) == 1:
        return np.array([float(_number(name, item))])
    if len(parts) != 3:
        raise UsageError(f"{name}: {item!r} is not a range. Give FROM:TO:STEP or FROM:TO:#COUNT.")
    first, last = _number(name, parts[0]), _number(name, parts[1])
    if parts[2].startswith("#"):
        text = parts[2][1:]
        count = int(text) if text.isascii() and text.isdecimal() and len(text) < 20 else 0
        if count < 1 or (count == 1 and first != last):
            raise UsageError(f"{name}: {parts[2]!r} is not a count. Give # and a whole number from 2, such as #16.")
        step = (last - first) / max(count - 1, 1)
    else:
        step = _number(name, parts[2])
        if step == 0:
            raise UsageError(f"{name}: the step must not be 0.")
        if (last - first) / step < 0:
            text = parts[2].strip()
            turned = text[1:] if text.startswith("-") else f"-{text.removeprefix('+')}"
            raise UsageError(
                f"{name}: a step of {text} does not lead from {parts[0]} to {parts[1]}. Use a step of {turned}."
            )
        count = math.floor((last - first) / step) + 1
    if count > most:
        counted = f"{count:.3g}" if count < 10**DECADES else f"more than 1e+{DECADES}"
        raise UsageError(f"{name}: {item} has {counted} values, and the limit is {most:,}. Use fewer.")
    common = math.lcm(first.denominator, step.denominator)
    start, stride = int(first * common), int(step * common)
    return np.fromiter(((start + k * stride) / common for k in range(count)), float, count)  # integers: rounded once


def _number(name: str, text: str) -> Fraction:
    """A decimal number, exactly."""
    try:
        number = Decimal(text.strip() if len(text) <= LONGEST else "")
        if number.is_finite() and (number == 0 or -DECADES < number.adjusted() < DECADES):
            return Fraction(number)
    except InvalidOperation:
        pass
    raise UsageError(
        f"{name}: {text.strip()!r} is not a number. Give numbers such as 30,45,60 or a range such as 15:90:15."
    )
