"""What a user may meet, with the exit status of each. The library raises; only ``cli.main`` prints."""

from collections.abc import Sequence
from enum import IntEnum
from typing import Any, NamedTuple


class ExitStatus(IntEnum):
    """Exit statuses of the commands, each with its meaning. ``chutecalc --help`` lists them."""

    meaning: str

    def __new__(cls, value: int, meaning: str = "") -> "ExitStatus":
        """Make a status of its number and meaning."""
        status = int.__new__(cls, value)
        status._value_, status.meaning = value, meaning
        return status

    OK = 0, "Success. A sweep succeeds whatever its rows say."
    FAILS = 1, "A chute fails, check finds a difference, or a dem case fails."
    USAGE = 2, "The command or a spec is wrong, or an output cannot be opened."
    EXTRA_MISSING = 3, "An optional library or program is not installed."
    INTERNAL = 70, "A fault of chutecalc itself. --debug shows a traceback."
    WRITE_FAILED = 74, "Writing an output failed, for example because the disk is full."
    INTERRUPTED = 130, "Interrupted with Ctrl-C."


class ChutecalcError(Exception):
    """Anything that a user can mend."""

    exit_status = ExitStatus.USAGE


class Fault(NamedTuple):
    """One thing wrong with a spec: the fact, the place, the next step."""

    path: str
    """Key path as the user wrote it, ``segments.2.radius_mm``; empty for the whole file."""
    problem: str
    """What is wrong, with what is allowed."""
    remedy: str
    """What to do."""
    given: str = ""
    """The value given, as text."""
    line: int | None = None

    def text(self, source: str) -> str:
        """As shown to people: ``spoon.toml:12: segments.2.radius_m = -3 has to be greater than 0 m. Change it.``."""
        place = source if self.line is None else f"{source}:{self.line}"
        what = " = ".join(part for part in (self.path, self.given) if part)
        remedy = self.remedy[:1].upper() + self.remedy[1:]
        return (
            f"{place}: "
            + " ".join(part for part in (what, self.problem) if part)
            + f". {remedy.rstrip('?.')}"
            + ("?" if remedy.endswith("?") else ".")
        )


class SpecError(ChutecalcError):
    """A spec that cannot be used; ``faults`` lists all that is wrong with it."""

    def __init__(self, faults: Sequence[Fault], source: str = "spec", designs: Any = None) -> None:
        self.faults = tuple(faults)
        self.source = source
        self.designs = designs
        """Of variants whose values are right one by one and do not go together: a mask of those, of length 1 or n."""
        super().__init__("\n".join(fault.text(source) for fault in self.faults))

    def __reduce__(self) -> tuple[type[Exception], tuple[object, ...]]:
        """Errors cross from process to process by what they are made of."""
        return SpecError, (self.faults, self.source)


class AllSpecsError(SpecError):
    """Several specs that cannot be used."""

    def __init__(self, errors: Sequence[SpecError]) -> None:
        super().__init__([fault for error in errors for fault in error.faults])
        self.args = ("\n".join(str(error) for error in errors),)


class UsageError(ChutecalcError):
    """Arguments that do not fit together."""


class OutputError(ChutecalcError):
    """An output that cannot be opened, found before anything is solved."""


class WriteError(ChutecalcError):
    """A write that failed after its output was opened."""

    exit_status = ExitStatus.WRITE_FAILED


class ExtraMissingError(ChutecalcError):
    """An optional dependency is not installed."""

    exit_status = ExitStatus.EXTRA_MISSING
