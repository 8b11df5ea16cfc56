"""Errors that a user can meet, with the exit status of each. The library raises them; only ``cli.main`` prints them."""

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
    FAILS = 1, "A chute or dem case fails, check finds a difference, or a search fails."
    USAGE = 2, "The command or a spec is wrong, or an output cannot be opened."
    EXTRA_MISSING = 3, "An optional library or program is not installed."
    INTERNAL = 70, "A bug in chutecalc; --debug shows a traceback."
    WRITE_FAILED = 74, "Writing an output failed, for example because the disk is full."
    INTERRUPTED = 130, "Interrupted with Ctrl-C."


class ChutecalcError(Exception):
    """Base of all errors that a user can correct."""

    exit_status = ExitStatus.USAGE


class Fault(NamedTuple):
    """One fault of a spec: what is wrong, where, and what to do."""

    path: str
    """Key path as the user wrote it, such as ``segments.2.radius_mm``; empty for the whole file."""
    problem: str
    """What is wrong, and what is allowed."""
    remedy: str
    """What to do."""
    given: str = ""
    """The value given, as text; empty if it does not matter."""
    line: int | None = None
    """Line of the file; None if it is not known."""
    argument: str = ""
    """What gave the value instead of the file, such as ``--set segments.2.radius_m=-3``."""

    def text(self, source: str) -> str:
        """Return the fault as a line of text; a character that would not print stands as its escape sequence.

        Args:
            source: name of the file.

        >>> Fault("segments.2.radius_m", "must be greater than 0 m", "change it", "-3", 12).text("spoon.toml")
        'spoon.toml:12: segments.2.radius_m = -3 must be greater than 0 m. Change it.'
        """
        location = source if self.line is None else f"{source}:{self.line}"
        what = self.argument or " = ".join(part for part in (self.path, self.given) if part)
        remedy = self.remedy[:1].upper() + self.remedy[1:]
        text = (
            f"{location}: "
            + " ".join(part for part in (what, self.problem) if part)
            + f". {remedy.rstrip('?.')}"
            + ("?" if remedy.endswith("?") else ".")
        )
        return "".join(each if each.isprintable() else each.encode("unicode_escape").decode() for each in text)


class SpecError(ChutecalcError):
    """A spec with faults.

    Args:
        faults: all faults of the spec.
        source: name of its file.
        designs: of variants that are impossible only in combination, a mask of the impossible ones, of length 1 or n.
    """

    def __init__(self, faults: Sequence[Fault], source: str = "spec", designs: Any = None) -> None:
        self.faults = tuple(faults)
        self.source = source
        self.designs = designs
        super().__init__("\n".join(fault.text(source) for fault in self.faults))

    def __reduce__(self) -> tuple[type[Exception], tuple[object, ...]]:
        """Return how to make the error again, for other processes."""
        return SpecError, (self.faults, self.source)


class AllSpecsError(SpecError):
    """Several specs with faults.

    Args:
        errors: one for each spec.
    """

    def __init__(self, errors: Sequence[SpecError]) -> None:
        super().__init__([fault for error in errors for fault in error.faults])
        self.args = ("\n".join(str(error) for error in errors),)


class UsageError(ChutecalcError):
    """Arguments that are wrong, or do not fit together."""


class OutputError(ChutecalcError):
    """An output that cannot be opened, found before anything is solved."""


class WriteError(ChutecalcError):
    """Writing an output failed after it was opened."""

    exit_status = ExitStatus.WRITE_FAILED


class ExtraMissingError(ChutecalcError):
    """An optional dependency is not installed."""

    exit_status = ExitStatus.EXTRA_MISSING
