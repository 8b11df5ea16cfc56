r"""Writes values at key paths into the text of a spec, with all comments kept."""

from collections.abc import Collection, Mapping
from typing import Any

import tomlkit
from tomlkit.items import AoT, InlineTable, Item, SingleKey, Table

from chutecalc.fields.units import same_quantity
from chutecalc.spec.paths import is_number, item_names


def edited_text(text: str, values: Mapping[str, Any]) -> str:
    r"""Return the text of a spec with values put at key paths.

    A key in another unit is replaced where it stands. A key that the table does not have goes below its own ones.

    Args:
        text: TOML of the spec.
        values: by key path, in the units of the paths. A table that does not exist is made.

    >>> print(edited_text("[flow]\nrate_t_h = 1000  # peak\n", {"flow.rate_kg_s": 250.0, "flow.gravity_m_s2": 9.8}))
    [flow]
    rate_kg_s = 250.0  # peak
    gravity_m_s2 = 9.8
    <BLANKLINE>
    """
    for path, value in values.items():
        document: Any = tomlkit.parse(text)
        *tables, key = path.split(".")
        here = document
        for item in tables:
            here = _below(here, item)
        if isinstance(here, list):
            here[_index(here, key)] = value
        else:
            put_key(here, key, value)
        text = tomlkit.dumps(document)
    return text


def put_key(table: Any, key: str, value: Any, replaced: Collection[str] = ()) -> None:
    """Put a key into a table of a document, which is good for nothing but to be written then.

    A key that it has, in whatever unit, keeps its place and its comment. Another goes below its own keys, before the
    blank lines and comments that lead to the next table.

    Args:
        table: the table.
        key: the key.
        value: its value.
        replaced: other keys that it replaces where they stand.
    """
    own = next((each for each in (*same_quantity(key), *replaced) if each in table), None)
    if own == key:
        table[key] = value
        return
    body = table.value.body if isinstance(table, Table | InlineTable) else []  # what is written, whatever its index
    there = [number for number, (each, item) in enumerate(body) if each and not isinstance(item, Table | AoT)]
    if own is not None and body:
        number, old = next((number, each) for number, (each, _) in enumerate(body) if each and each.key == own)
        written = old.as_string()
        spaced = key + written[len(written.rstrip()) :]
        body[number] = SingleKey(key, sep=old.sep, original=spaced), _in_place_of(body[number][1], value)
    elif there and isinstance(table, Table):
        last = body[there[-1]][1]
        last.trivia.trail = last.trivia.trail or "\n"  # the end of a file without one
        item = _in_place_of(last, value)
        item.trivia.comment_ws = item.trivia.comment = ""
        body.insert(there[-1] + 1, (SingleKey(key), item))
    else:
        if own is not None:
            table.pop(own)
        table[key] = value


def _in_place_of(old: Item, value: Any) -> Item:
    """Return an item with the indentation, the comment and the line ending of another."""
    item: Item = tomlkit.item(value)
    item.trivia.indent, item.trivia.comment_ws = old.trivia.indent, old.trivia.comment_ws
    item.trivia.comment, item.trivia.trail = old.trivia.comment, old.trivia.trail
    return item


def _below(here: Any, item: str) -> Any:
    """Return what a part of a path leads to; a table that does not exist is made."""
    if isinstance(here, list):
        return here[_index(here, item)]
    if item not in here:
        here[item] = tomlkit.table()
    return here[item]


def _index(here: Any, item: str) -> int:
    """Return the index of an item of a list, from its number or its name."""
    return int(item) - 1 if is_number(item) else item_names(here).index(item)
