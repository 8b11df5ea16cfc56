"""Writes into the text of a spec where its segments are drawn, with all comments kept."""

import re
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import tomlkit
from tomlkit.items import InlineTable

from chutecalc.fields.units import same_quantity
from chutecalc.segments.fall import Fall
from chutecalc.segments.registry import KINDS
from chutecalc.spec.edited import put_key

FALL = next(kind for kind, table in KINDS.items() if table is Fall)
"""Kind of a fall."""
OF_SEGMENT = re.compile(r"segments\.(\d+)\.(.*)")
"""Key path of something of a segment by its number."""
FALL_ENDS = (*same_quantity("drop_m"), *same_quantity("run_m"))
"""Keys of a fall that say where it ends."""


class Drawn(NamedTuple):
    """Where a segment is drawn, as a spec says it."""

    start_m: tuple[float, ...] | None
    """x and z of its start, m; None if that is the drawn end of the segment before it."""
    slopes: Mapping[str, float]
    """Further keys, such as the slope at the start of an arc; each replaces the same quantity in another unit."""


def frozen_text(text: str, drawn: Mapping[int, Drawn]) -> str:
    """Return a spec with every place and slope explicit.

    A segment with a place of its own stands after a fall with ``onto_next``; one is added where there is none.

    Args:
        text: TOML of the spec.
        drawn: segments that guide the stream, by number from 0.
    """
    end = "" if text.endswith("\n") else "\n"  # of the last line, which may gain keys below it
    document: Any = tomlkit.parse(text + end)
    tables = document["segments"]
    for number, segment in drawn.items():
        start = {} if segment.start_m is None else {"start_m": list(segment.start_m)}
        if start and number:
            put_key(tables[number - 1], "onto_next", True, FALL_ENDS)
        for key, value in (start | dict(segment.slopes)).items():
            put_key(tables[number], key, value)
    if 0 in drawn and drawn[0].start_m is not None:
        inline = isinstance(tables[0], InlineTable)
        fall: Any = tomlkit.inline_table() if inline else tomlkit.table()
        fall.update({"kind": FALL, "onto_next": True})
        if not inline:
            fall.append(None, tomlkit.nl())
        tables.insert(0, fall)
        for table in (*document.get("cases", {}).values(), document.get("uncertainty", {})):
            _shift_numbers(table)
    return tomlkit.dumps(document).removesuffix(end)


def _shift_numbers(table: Any) -> None:
    """Add 1 to the numbers of segments in the key paths of a case or of uncertainty: one has been added before them."""
    renamed = {}
    for path, below, key in list(_values(table)):
        if (shifted := _shifted(path)) != path:
            renamed[shifted] = below.pop(key)
    table.update(renamed)
    for row in table.get("correlation", ()):
        for number in (0, 1):
            row[number] = _shifted(row[number])


def _shifted(path: str) -> str:
    """Return a key path with 1 added to the number of its segment."""
    found = OF_SEGMENT.fullmatch(path)
    return f"segments.{int(found[1]) + 1}.{found[2]}" if found else path


def _values(table: Any, above: str = "") -> Iterator[tuple[str, Any, str]]:
    """Yield the path of each value in a table, with the table that it stands in and its key there.

    What stands below a segment's number goes with it as a whole, such as a distribution.
    """
    for key, value in table.items():
        if isinstance(value, dict) and not OF_SEGMENT.fullmatch(f"{above}{key}"):
            yield from _values(value, f"{above}{key}.")
        else:
            yield f"{above}{key}", table, key
