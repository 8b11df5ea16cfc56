"""The JSON Schema of a spec: pydantic's own, with every key in each of its units."""

import json
from collections.abc import Mapping
from typing import Any

from chutecalc.fields.quantity import Quantity
from chutecalc.fields.table import Table
from chutecalc.fields.units import unit_keys
from chutecalc.spec.chute_spec import ChuteSpec

DIALECT = "https://json-schema.org/draft/2020-12/schema"
"""The version of JSON Schema."""


def json_schema() -> dict[str, Any]:
    """Return the JSON Schema of a chute spec. Of the keys of a quantity in its units one at most may be given."""
    schema = ChuteSpec.model_json_schema()
    tables = {table.__name__: table for table in _all(Table)}
    for name, definition in schema["$defs"].items():
        if name in tables:
            _add_twins(definition, tables[name].quantities())
    return {"$schema": DIALECT} | schema


def schema_text(schema: Mapping[str, Any]) -> str:
    """Return a JSON Schema as the text of a file.

    Args:
        schema: the schema.
    """
    return json.dumps(schema, indent=2, ensure_ascii=False) + "\n"


def _all(table: type[Table]) -> list[type[Table]]:
    """Return a table and all that derive from it."""
    return [table] + [item for child in table.__subclasses__() for item in _all(child)]


def _add_twins(definition: dict[str, Any], quantities: dict[str, Quantity]) -> None:
    """Put the keys in other units beside each key of a definition, with bounds in those units."""
    required = set(definition.get("required", []))
    choices: list[dict[str, Any]] = []
    for key, quantity in quantities.items():
        own = definition["properties"].pop(key)
        own.pop("default", None)
        names = unit_keys(key, quantity.dimension)
        for name, unit in names.items():
            shared = {item: own[item] for item in ("description", "title", "x-dimension") if item in own}
            definition["properties"][name] = shared | quantity.json_type(unit)
        one = [{"required": [name]} for name in names]
        if key in required:
            required.discard(key)
            needed = {"oneOf": one} if len(one) > 1 else one[0]
            in_library = "use" in definition["properties"]
            choices.append({"anyOf": [{"required": ["use"]}, needed]} if in_library else needed)
        elif len(one) > 1:
            none = {"not": {"anyOf": one}}
            choices.append({"oneOf": [none, *one]})
    definition["required"] = sorted(required)
    if choices:
        definition["allOf"] = choices
