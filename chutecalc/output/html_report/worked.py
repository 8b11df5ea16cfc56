"""Formulas with their numbers put in, so that a reader can follow a result with a pocket calculator."""

import re
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from chutecalc.results.symbols import SYMBOLS, Symbol

SIGNIFICANT = 5
"""Significant digits of the numbers that are put in."""

FUNCTIONS = ("sin", "cos", "tan", "dl", "dv", "ds", "root", "of", "rate")
"""Words of formulas that are no symbols."""


class Number(NamedTuple):
    """A number of a formula."""

    symbol: str
    """As the field writes it, with a subscript behind an underscore."""
    value: float
    """In its unit; angles in degrees."""
    unit: str = ""

    @property
    def text(self) -> str:
        """The number as people write it, without its unit, but for degrees."""
        return f"{self.value:z.{SIGNIFICANT}g}".replace("-", "−") + ("°" if self.unit == "°" else "")

    @property
    def operand(self) -> str:
        """The number as it stands in a formula, in parentheses if it is negative."""
        return f"({self.text})" if self.text.startswith("−") else self.text


class Worked(NamedTuple):
    """A formula with its numbers."""

    result: Number
    meaning: str
    """What the result is."""
    formula: str
    """The right-hand side with symbols."""
    numbers: str
    """The same with numbers; empty where the formula is not one for a pocket calculator."""
    source: str
    """Where the formula comes from."""


def worked(result: Number, meaning: str, template: str, source: str, **numbers: Number) -> Worked:
    """Return a formula with its numbers.

    Args:
        result: the left-hand side.
        meaning: what it is.
        template: the right-hand side, with names in braces for the numbers.
        source: where the formula comes from.
        **numbers: what stands for the names.

    >>> flow, velocity = Number("Q", 0.34722, "m³/s"), Number("v", 3.878, "m/s")
    >>> worked(Number("A", 0.08954, "m²"), "flow area", "{flow}/{v}", "continuity", flow=flow, v=velocity)[2:4]
    ('Q/v', '0.34722/3.878')
    """
    symbols, texts = ({name: getattr(number, of) for name, number in numbers.items()} for of in ("symbol", "operand"))
    return Worked(result, meaning, template.format(**symbols), template.format(**texts), source)


def stated(result: Number, meaning: str, formula: str, source: str) -> Worked:
    """Return a formula whose numbers are not put in: an integral, or a root.

    Args:
        result: the left-hand side.
        meaning: what it is.
        formula: the right-hand side.
        source: where it comes from.
    """
    return Worked(result, meaning, formula, "", source)


def with_subscripts(text: str) -> Iterator[tuple[str, bool]]:
    """Yield the pieces of a formula, and whether each is a subscript.

    Args:
        text: with subscripts behind underscores.

    >>> [*with_subscripts("μ_e n")]
    [('μ', False), ('e', True), (' n', False)]
    """
    for number, piece in enumerate(re.split(r"_([A-Za-z0-9]+)", text)):
        if piece:
            yield piece, number % 2 == 1


def symbols_in(lines: Iterable[Worked]) -> dict[str, Symbol]:
    """Return the symbols of formulas with what they mean, in the order of the alphabet, an entry for each meaning.

    A symbol with a number, or with k, stands for one of several: ``v_1`` before and ``v_2`` after an impact.

    Args:
        lines: the formulas.

    >>> line = stated(Number("χ", 0.05), "excess friction", "(1/A) ∫ K(ψ) (1 − cos ψ) ζ dl", "physics")
    >>> ", ".join(symbols_in([line]))
    'A, χ, K, ψ, ζ'
    """
    used = {name for line in lines for name in names_in(f"{line.result.symbol} {line.formula}")}
    return {each.symbol: each for each in SYMBOLS if used & set(each.symbol.split(", "))}


def names_in(formula: str) -> Iterator[str]:
    """Yield the symbols of a formula, without numbers and k behind them.

    Args:
        formula: with subscripts behind underscores.

    >>> [*names_in("v_1 · (cos i − μ_e · sin i)")]
    ['v', 'i', 'μ_e', 'i']
    """
    for name, index in re.findall(r"([^\W\d_²]\u0307?[^\W\d_²]*)(?:_([A-Za-z0-9]+))?", formula):
        if name not in FUNCTIONS:
            yield name if not index or re.fullmatch(r"\d+|k", index) or name == "F" else f"{name}_{index}"
