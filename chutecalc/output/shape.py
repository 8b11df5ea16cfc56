"""Shapes of documents, as JSON Schema: what each command's JSON looks like.

A record has all of its keys, always; what does not exist or was not asked for is null, or an empty list or mapping. A
mapping has keys that depend on the data, such as names of segments.
"""

from collections.abc import Iterable, Mapping
from typing import Any

from chutecalc import __version__
from chutecalc.output.dataset import DOCUMENT_FORMAT
from chutecalc.results.column import Column

Shape = dict[str, Any]
"""A JSON Schema."""

TEXT: Shape = {"type": "string"}
TRUTH: Shape = {"type": "boolean"}
COUNT: Shape = {"type": "integer", "minimum": 0}
FINITE: Shape = {"type": "number"}
NUMBER: Shape = {"type": ["number", "null"]}
"""A number; null where it is infinite or does not exist."""
VALUE: Shape = {"type": ["number", "string", "boolean", "null"]}
SPEC: Shape = {"type": "object", "description": "the spec as nested tables; chutecalc schema describes it"}
SOURCE: Shape = TEXT | {"description": "file of the spec"}
CASE: Shape = TEXT | {"description": "operating state: design, or the name of a case"}
TOLERANCE: Shape = FINITE | {"description": "relative tolerance of the velocity"}


def record(description: str = "", /, **entries: Shape) -> Shape:
    """Return the shape of an object with fixed keys, all of which it has.

    Args:
        description: what it is.
        **entries: shape of each entry.

    >>> record(name=TEXT)["required"]
    ['name']
    """
    shape: Shape = {"description": description} if description else {}
    return shape | {
        "type": "object",
        "properties": entries,
        "required": list(entries),
        "additionalProperties": False,
    }


def columns(catalogue: Iterable[Column], description: str = "") -> Shape:
    """Return the shape of a record of columns, with meaning and unit of each.

    Args:
        catalogue: the columns.
        description: what it is.
    """
    return record(description, **{column.name: column_shape(column) for column in catalogue})


def column_shape(column: Column) -> Shape:
    """Return the shape of a value of a column.

    Args:
        column: the column.

    >>> column_shape(Column("depth_m", "depth", "H", "flow depth", "length", "m"))
    {'type': ['number', 'null'], 'description': 'flow depth', 'x-unit': 'm'}
    """
    kind = NUMBER if column.dimension else {"type": ["string", "null"]}
    unit = {"x-unit": column.unit_text("metric")} if column.unit else {}
    return kind | {"description": column.meaning} | unit


def numbers(named: Mapping[str, str]) -> dict[str, Shape]:
    """Return the shapes of numbers, as entries of a record.

    Args:
        named: meanings by name.
    """
    return {name: NUMBER | {"description": meaning} for name, meaning in named.items()}


def list_of(item: Shape, description: str = "") -> Shape:
    """Return the shape of a list.

    Args:
        item: shape of its items.
        description: what it is.
    """
    shape: Shape = {"description": description} if description else {}
    return shape | {"type": "array", "items": item}


def by_name(item: Shape, description: str = "") -> Shape:
    """Return the shape of a mapping, whose keys depend on the data.

    Args:
        item: shape of its values.
        description: what the keys are.
    """
    shape: Shape = {"description": description} if description else {}
    return shape | {"type": "object", "additionalProperties": item}


def one_of(values: Iterable[str], description: str = "") -> Shape:
    """Return the shape of a text that is chosen from a list.

    Args:
        values: all that there are.
        description: what it is.
    """
    shape: Shape = {"description": description} if description else {}
    return shape | {"enum": [str(value) for value in values]}


def ref(name: str) -> Shape:
    """Return a reference to a shape that is defined beside the documents.

    Args:
        name: of the definition.
    """
    return {"$ref": f"#/$defs/{name}"}


def maybe(shape: Shape) -> Shape:
    """Return a shape in whose place null may stand.

    Args:
        shape: of what may be missing.
    """
    return {"anyOf": [shape, {"type": "null"}]}


def document(command: str, description: str, /, **entries: Shape) -> Shape:
    """Return the shape of a command's document.

    Args:
        command: its name.
        description: what the document has.
        **entries: shape of each entry after those that all documents begin with.
    """
    head = {
        "chutecalc": TEXT | {"description": f"version of chutecalc, such as {__version__}"},
        "format": {"const": DOCUMENT_FORMAT, "description": "version of this layout"},
        "command": {"const": command, "description": "what the document is of"},
    }
    return record(description, **head, **entries)
