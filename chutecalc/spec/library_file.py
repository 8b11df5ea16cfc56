"""The file of a library: materials and liners by name, with the keys of their tables in a spec."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any, ClassVar

from pydantic import Field, ValidationError

from chutecalc.errors import SpecError
from chutecalc.fields.table import Table, Violation
from chutecalc.spec.chute_spec import Density, Liner, Material
from chutecalc.spec.faults import faults_of
from chutecalc.spec.library import Library
from chutecalc.spec.parse import parse_text, read_text
from chutecalc.spec.rules import locus_rows


def no_use(table: dict[str, Any]) -> Iterator[Violation]:
    """Yield a violation where an entry uses another.

    Args:
        table: of the entry.
    """
    if "use" in table:
        yield Violation(("use",), "is for specs: an entry does not use another", "give the keys themselves")


class LibraryMaterial(Material):
    """A material of a library. Any key may be left to the spec."""

    density_kg_m3: Density = Field(None, description="bulk density in the stream")
    rules: ClassVar = (no_use,)


class LibraryLiner(Liner):
    """A liner of a library. Any key may be left to the spec."""

    rules: ClassVar = (no_use, locus_rows)


class LibraryFile(Table):
    """A library."""

    materials: dict[str, LibraryMaterial] = Field({}, description="materials by name")
    liners: dict[str, LibraryLiner] = Field({}, description="liners by name")


def read_library(path: str | Path) -> Library:
    """Read a library from its file.

    Args:
        path: of the file.

    Raises:
        SpecError: it cannot be read; otherwise all faults in it, of entries that no spec uses too.
    """
    text, source = read_text(Path(path)), str(path)
    data = parse_text(text, source)
    try:
        LibraryFile.model_validate(data)
    except ValidationError as error:
        raise SpecError(faults_of(error, data, text), source) from None
    return Library(source, data.get("materials", {}), data.get("liners", {}))
