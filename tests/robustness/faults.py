"""What every fault of a spec has to say: what is wrong, where, and what to do."""

from collections.abc import Iterator
from typing import Any

import chutecalc
from chutecalc.errors import SHOWN
from chutecalc.printable import printable


def check_faults(error: chutecalc.SpecError, data: Any) -> None:
    """Holds all faults of a spec, its tables or its text, against that."""
    assert error.faults
    for fault in error.faults:
        assert fault.problem, fault
        assert fault.remedy, fault
        assert "nan" not in fault.problem, fault
        text = fault.text("x.toml")
        assert text.startswith("x.toml"), fault
        assert printable(fault.problem)[:SHOWN] in text, fault
        assert printable(text) == text, fault
    if isinstance(data, dict):
        known = set(paths(data))
        for fault in error.faults:
            table, _, _ = fault.path.rpartition(".")
            if table.startswith("cases."):  # another stream on steel that is right: the fault is that of the case
                table = ".".join(table.split(".")[:2])
            # a key that stands there, or one that is missing in a table that stands there or at the top
            assert fault.path in known or (fault.path and (not table or table in known)), fault


def paths(data: Any, above: tuple[str, ...] = ()) -> Iterator[str]:
    """Yield every key of nested tables, in full, as users write them: lists count from 1."""
    items = data.items() if isinstance(data, dict) else enumerate(data, 1) if isinstance(data, list) else ()
    for key, value in items:
        location = (*above, str(key))
        yield ".".join(location)
        yield from paths(value, location)
