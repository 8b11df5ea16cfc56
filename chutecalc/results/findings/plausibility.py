"""Whether the numbers of a spec are of a size that such numbers have: else a unit is probably mistaken."""

from collections.abc import Iterator

import numpy as np

from chutecalc.fields.likely_units import PERCENT, likely_units
from chutecalc.fields.plausible import Plausible
from chutecalc.fields.units import TEXT
from chutecalc.physics.arrays import Array, Mask
from chutecalc.results.criterion import Case, criterion
from chutecalc.results.finding import Severity
from chutecalc.results.scene import Written
from chutecalc.spec.given import Given, given_quantities

NOWHERE = np.full(1, np.nan)
"""Position of what concerns no segment, m, shape (1,)."""


@criterion(
    "implausible",
    Severity.WARNING,
    summary="a number is so small or so large that its unit is probably mistaken",
    limit="a range for each key",
    source="rule of thumb",
    judges_spec=True,
)
def implausible(written: Written) -> Iterator[Case]:
    """Find numbers whose unit is probably mistaken, each with the unit in which it would be plausible.

    Args:
        written: the spec.
    """
    for given in given_quantities(written.spec, written.data):
        plausible = given.quantity.plausible
        if plausible is None:
            continue
        numbers = given.numbers()
        if plausible.mistaken(given.in_first_unit(numbers, given.unit)).any():
            yield from _cases(given, plausible, _oddest(given, plausible, numbers))


def _oddest(given: Given, plausible: Plausible, numbers: Array) -> Array:
    """Return the number of a list that is furthest out, for each design."""
    with np.errstate(divide="ignore"):
        away = np.abs(np.log(np.abs(given.in_first_unit(numbers, given.unit)) / plausible.middle))
    furthest = np.where(np.isfinite(away), away, -1.0).argmax(axis=0)
    return np.asarray(np.take_along_axis(numbers, furthest[None], axis=0)[0])


def _cases(given: Given, plausible: Plausible, number: Array) -> Iterator[Case]:
    """Yield a case for each side of the range and each remedy."""
    value = given.in_first_unit(number, given.unit)
    small = np.abs(value) < plausible.low
    likely = likely_units(given.quantity, number, given.unit)
    for like, side in ((plausible.below, small), (plausible.above, ~small)):
        rest = plausible.mistaken(value) & side
        for mask, remedy in (*_remedies(given, likely), (np.ones(1, dtype=bool), "check its value and its unit")):
            template = f"{{given:.12g}}{_unit_text(given.unit)} is {like}: {remedy}"
            yield Case(rest & mask, NOWHERE, template, _numbers(given, number), key=given.path)
            rest = rest & ~mask


def _remedies(given: Given, likely: dict[str, Mask]) -> Iterator[tuple[Mask, str]]:
    """Yield the designs that each other unit suits, the more common units first, and what to write then."""
    coefficient = given.quantity.plausible is not None and given.quantity.plausible.coefficient
    for unit, suits in likely.items():
        key = given.keys.get(unit, given.key)
        meant = f"if you meant{_unit_text(unit)}"
        if unit == "%":
            remedy = f"write {key} = {{share:.12g}} {meant}"
        elif given.quantity.shape:
            remedy = f"write it as {key} {meant}"
        else:
            remedy = f"write {key} = {{given:.12g}} {meant}"
        if coefficient and unit == "rad":
            remedy += f", or {given.keys['deg']} = {{angle}} if you meant a coefficient tan φ = {{given:.12g}}"
        yield suits, remedy


def _numbers(given: Given, number: Array) -> dict[str, Array]:
    """Return the numbers that messages quote."""
    return {"given": number, "share": number / PERCENT, "angle": np.degrees(np.arctan(number))}


def _unit_text(unit: str) -> str:
    """Return a unit as it stands behind a number."""
    text = {"rad": "radians"}.get(unit, TEXT.get(unit, unit))
    return text if text == "°" else f" {text}".rstrip()
