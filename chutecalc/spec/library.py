"""Materials and liners that a spec takes from a library: ``use`` stands for the keys of an entry."""

from collections.abc import Iterator
from typing import Any, NamedTuple

from chutecalc.errors import Fault, SpecError
from chutecalc.fields.units import same_quantity
from chutecalc.spec.lines import key_lines
from chutecalc.spec.operating import case_values

LIBRARY_NAME = "chute-library.toml"
"""Name of the file beside a spec that is its library."""
WALLS = ("friction_deg", "friction_rad", "yield_locus_kpa", "yield_locus_pa", "yield_locus_psf", "own_material")
"""Keys of a liner of which one says how it resists."""


class Library(NamedTuple):
    """The entries of a library by name, each a table as written."""

    source: str
    """Name of its file in messages."""
    materials: dict[str, dict[str, Any]]
    liners: dict[str, dict[str, Any]]


def uses(data: Any) -> Iterator[tuple[tuple[str, ...], str]]:
    """Yield the location of each table of a spec that uses an entry, with the name of the entry.

    Args:
        data: nested tables as the user wrote them.

    >>> list(uses({"material": {"use": "coal"}, "liners": {"wall": {"use": "steel"}, "bed": {"own_material": True}}}))
    [(('material',), 'coal'), (('liners', 'wall'), 'steel')]
    """
    material, liners = data.get("material"), data.get("liners")
    tables: dict[tuple[str, ...], Any] = {("material",): material}
    tables |= {("liners", str(name)): table for name, table in (liners.items() if isinstance(liners, dict) else ())}
    for location, table in tables.items():
        if isinstance(table, dict) and isinstance(table.get("use"), str):
            yield location, table["use"]


def is_used(data: Any) -> bool:
    """Return whether a spec, or one of its cases, uses an entry.

    Args:
        data: nested tables as the user wrote them.

    >>> is_used({"cases": {"wet": {"material.use": "wet coal"}}}), is_used({"material": {"name": "coal"}})
    (True, False)
    """
    cases = data.get("cases")
    tables = [case for case in cases.values() if isinstance(case, dict)] if isinstance(cases, dict) else []
    return any(uses(data)) or any(path.endswith(".use") for case in tables for path in case_values(case))


def resolved(data: dict[str, Any], library: Library | None, source: str, text: str) -> dict[str, Any]:
    """Return a spec's data with the keys of entries in place of ``use``. Keys that the spec gives itself stay.

    Args:
        data: nested tables as the user wrote them.
        library: the library; None if there is none.
        source: what messages call the spec.
        text: TOML text of the spec, for line numbers; empty if there is none.

    Raises:
        SpecError: there is no library, or it lacks an entry.

    >>> library = Library("lib.toml", {"coal": {"density_kg_m3": 850, "pressure_ratio": 0.4}}, {})
    >>> resolved({"material": {"use": "coal", "density_t_m3": 0.8}}, library, "spec", "")
    {'material': {'name': 'coal', 'pressure_ratio': 0.4, 'density_t_m3': 0.8}}
    """
    changed, faults = dict(data), []
    for location, name in uses(data):
        table, *below = location
        entries = {} if library is None else library.liners if below else library.materials
        if name not in entries:
            faults.append(_missing(location, name, library, entries, text))
        elif below:
            changed[table] = changed[table] | {below[0]: _merged(data[table][below[0]], name, entries[name])}
        else:
            changed[table] = _merged(data[table], name, entries[name])
    if faults:
        raise SpecError(faults, source)
    return changed


def _merged(own: dict[str, Any], name: str, entry: dict[str, Any]) -> dict[str, Any]:
    """Return a table with its own keys and those of an entry that it does not give, in whatever unit."""
    given = {each for key in own for each in (WALLS if key in WALLS else same_quantity(str(key)))}
    others = {key: value for key, value in ({"name": name} | entry).items() if key not in given}
    return others | {key: value for key, value in own.items() if key != "use"}


def _missing(
    location: tuple[str, ...], name: str, library: Library | None, entries: dict[str, Any], text: str
) -> Fault:
    """Return the fault of an entry that there is not."""
    path, line = ".".join((*location, "use")), key_lines(text).get((*location, "use"))
    if library is None:
        remedy = f"name one with --library FILE (library= in Python), or put {LIBRARY_NAME} beside the spec"
        return Fault(path, "needs a library", remedy, f'"{name}"', line)
    from difflib import get_close_matches

    table = "materials" if location == ("material",) else "liners"
    close = get_close_matches(name, entries, n=3, cutoff=0.5)
    remedy = f"did you mean {' or '.join(close)}?" if close else f'add [{table}."{name}"] there'
    return Fault(path, f"is not among the {table} of {library.source}", remedy, f'"{name}"', line)
