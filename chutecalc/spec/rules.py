"""Rules between the keys of a table, and between the tables of a spec."""

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import numpy as np

from chutecalc.fields.quantities import ROUGH
from chutecalc.fields.table import Violation
from chutecalc.fields.units import unit_keys
from chutecalc.segments.base import Segment
from chutecalc.segments.registry import KINDS


def known_format(table: dict[str, Any]) -> Iterator[Violation]:
    """Yield a fault if the format is not the integer 1; pydantic takes true and 1.0 for it too.

    Args:
        table: the spec, with documented keys.
    """
    if "format" in table and type(table["format"]) is not int:
        yield Violation(("format",), "must be 1", "correct the value")


def some_friction(table: dict[str, Any]) -> Iterator[Violation]:
    """Yield a fault if a material has neither an angle of internal friction nor a pressure ratio.

    Args:
        table: of a material, with documented keys.
    """
    if "internal_friction_deg" not in table and "pressure_ratio" not in table:
        problem, remedy = "is missing: give it or pressure_ratio", "add the effective angle of internal friction"
        yield Violation(("internal_friction_deg",), problem, remedy, is_missing=True)


MOST_ROWS = 100
"""Rows of a yield locus at most; a shear test gives a few."""
STEEPEST_LOCUS = math.tan(math.radians(ROUGH.most))
"""Most rise of shear stress per normal stress from row to row. A stream on a steeper locus switches between two rows of
it instead of sliding."""


def locus_rows(table: dict[str, Any]) -> Iterator[Violation]:
    """Yield faults of a yield locus: too few or many rows, stresses out of order, a jump, no first normal stress.

    Args:
        table: of a liner, with documented keys.
    """
    rows = table.get("yield_locus_kpa")
    if not isinstance(rows, list) or not all(isinstance(row, list) and len(row) == 2 for row in rows):
        return  # has a fault already
    if not all(isinstance(item, int | float | np.ndarray) for row in rows for item in row):
        return
    if len(rows) < 2:
        yield Violation(("yield_locus_kpa",), "must have at least two rows", "add a row [normal stress, shear stress]")
    if len(rows) > MOST_ROWS:
        problem = f"has {len(rows)} rows, and at most {MOST_ROWS} are allowed"
        yield Violation(("yield_locus_kpa",), problem, "leave out rows that lie on a line between others")
    for number, (one, other) in enumerate(pairwise(rows), 2):
        if not (np.all(np.less(one[0], other[0])) and np.all(np.less_equal(one[1], other[1]))):
            problem = f"is out of order at row {number}: normal stress must rise, and shear stress must not fall"
            yield Violation(("yield_locus_kpa",), problem, "sort the rows")
        elif np.any(np.subtract(other[1], one[1]) > STEEPEST_LOCUS * np.subtract(other[0], one[0])):
            problem = f"rises to row {number} more steeply than {ROUGH.most:g}°, as no wall friction does"
            yield Violation(("yield_locus_kpa",), problem, "correct the row, or leave it out")
    if rows and np.any(np.less_equal(rows[0][0], 0.0)):
        yield Violation(("yield_locus_kpa",), "begins at a normal stress of 0 or less", "remove that row")


def one_inlet(table: dict[str, Any]) -> Iterator[Violation]:
    """Yield faults of an inlet that has not either a velocity and a slope, or a belt.

    Args:
        table: of the inlet, with documented keys.
    """
    for key, names in (
        ("velocity_m_s", " or ".join(unit_keys("velocity_m_s", "velocity"))),
        ("slope_deg", "slope_deg"),
    ):
        if "belt" in table and key in table:
            yield Violation((key,), "follows from the belt", "remove it, or remove [inlet.belt]")
        elif "belt" not in table and key not in table:
            yield Violation((key,), "is missing", f"add {names}, or describe the belt in [inlet.belt]", is_missing=True)


def names(table: dict[str, Any]) -> Iterator[Violation]:
    """Yield faults of names: of segments with the same one, of sections and liners that are needed or not defined.

    Args:
        table: the spec, with documented keys.
    """
    segments = table.get("segments")
    seen: dict[str, int] = {}
    for number, segment in enumerate(segments if isinstance(segments, list) else []):
        if not isinstance(segment, dict):
            continue
        location = ("segments", number)
        name = segment.get("name")
        if isinstance(name, str):
            if name in seen:
                yield Violation(
                    (*location, "name"), f"is already the name of segment {seen[name]}", "choose another name"
                )
            seen.setdefault(name, number + 1)
        if _guides(segment):
            yield from _reference(table, segment, location, "section", "sections")
            yield from _reference(table, segment, location, "liner", "liners")


def _table_of(segment: dict[str, Any]) -> type[Segment] | None:
    """Return the table of a segment's kind; None if the kind is missing or not known."""
    kind = segment.get("kind")
    return KINDS.get(kind) if isinstance(kind, str) else None


def _guides(segment: dict[str, Any]) -> bool:
    """Return whether a segment is of a kind that guides the stream."""
    table = _table_of(segment)
    return table is not None and table.guides


def _reference(
    table: dict[str, Any], segment: dict[str, Any], location: tuple[str | int, ...], key: str, kinds: str
) -> Iterator[Violation]:
    """Check the names of sections, or of a liner, that a segment gives."""
    defined, named = table.get(kinds), segment.get(key)
    if not isinstance(defined, dict) or not defined:
        return
    known = ", ".join(defined)
    if named is None and len(defined) > 1:
        yield Violation(
            (*location, key), f"is missing, and the spec has several {kinds}", f"use one of {known}", is_missing=True
        )
    for name in named if isinstance(named, list) else [named]:
        if isinstance(name, str) and name not in defined:
            problem = f"names {name or 'nothing'}, which is not defined in [{kinds}]"
            added = f", or add [{kinds}.{name}]" if name else ""
            remedy = f"use {known if len(defined) == 1 else f'one of {known}'}{added}"
            yield Violation((*location, key), problem, remedy)


def placement(table: dict[str, Any]) -> Iterator[Violation]:
    """Yield faults of a fall with ``onto_next`` without such a segment, and of drawn starts that miss or lack a fall.

    Args:
        table: the spec, with documented keys.
    """
    segments = table.get("segments")
    listed = [
        segment if isinstance(segment, dict) else {} for segment in (segments if isinstance(segments, list) else [])
    ]
    for number, segment in enumerate(listed):
        before = listed[number - 1] if number else {}
        after = listed[number + 1] if number + 1 < len(listed) else {}
        location, table_of = ("segments", number), _table_of(segment)
        if segment.get("onto_next") is True and not _guides(after):
            problem = "needs a segment after it that guides the stream"
            yield Violation((*location, "onto_next"), problem, "add one, or give drop_m instead")
        if before.get("onto_next") is True and table_of is not None and table_of.guides:
            for key, example in table_of.placed.items():
                if not _given(segment, key):
                    yield Violation(
                        (*location, key),
                        "is missing, and needed after onto_next = true",
                        f"add {example}, or let chutecalc place find it",
                        is_missing=True,
                    )
        elif starts := _given(segment, "start_m"):
            remedy = "put a fall with onto_next = true before the segment, or remove this key"
            yield Violation((*location, starts[0]), "is only for a segment after onto_next = true", remedy)


def _given(table: dict[str, Any], key: str) -> list[str]:
    """Return the keys of a table that stand for a documented one, whatever unit they end in."""
    stem, _, _ = key.rpartition("_")
    return [str(given) for given in table if str(given).startswith(f"{stem}_")]


def known_strength(table: dict[str, Any]) -> Iterator[Violation]:
    """Yield faults of liners whose friction the material's own strength limits, if that is not known.

    Args:
        table: the spec, with documented keys.
    """
    material, liners = table.get("material"), table.get("liners")
    if not isinstance(material, dict) or not isinstance(liners, dict):
        return
    if any(str(key).startswith("internal_friction_") for key in material):
        return
    for name, liner in liners.items():
        for key in liner if isinstance(liner, dict) else ():
            if key == "own_material" or str(key).startswith("yield_locus_"):
                problem = "needs the material's effective angle of internal friction, the upper limit of wall friction"
                yield Violation(("liners", name, key), problem, "add material.internal_friction_deg")
