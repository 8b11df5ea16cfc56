"""Errors that a user can meet, with the exit status of each. The library raises them; only ``cli.main`` prints them."""

from collections.abc import Sequence
from enum import IntEnum
from typing import Any, NamedTuple

from chutecalc.printable import abbreviated, printable


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


SHOWN = 200
"""Characters that a fault shows of a key or a value."""


class ChutecalcError(Exception):
    r"""Base of all errors that a user can correct. Each argument is a line of its text.

    >>> print(UsageError("there is no column x\n42 designs: ok"))
    there is no column x\n42 designs: ok
    """

    exit_status = ExitStatus.USAGE

    def __str__(self) -> str:
        return "\n".join(abbreviated(printable(str(line))) for line in self.args)


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

    @property
    def shown(self) -> str:
        """Key path and value, and a short piece of either that is long."""
        return " = ".join(abbreviated(part, SHOWN) for part in (self.path, self.given) if part)

    def text(self, source: str) -> str:
        """Return the fault as a line of text, with a short piece of whatever is long.

        Args:
            source: name of the file.

        >>> Fault("segments.2.radius_m", "must be greater than 0 m", "change it", "-3", 12).text("spoon.toml")
        'spoon.toml:12: segments.2.radius_m = -3 must be greater than 0 m. Change it.'
        """
        location = source if self.line is None else f"{source}:{self.line}"
        what = abbreviated(self.argument, SHOWN) or self.shown
        words, remedy = " ".join(part for part in (what, self.problem) if part), self.remedy
        end = "?" if remedy.endswith("?") else "."
        return abbreviated(printable(f"{location}: {words}. {remedy[:1].upper()}{remedy[1:].rstrip('?.')}{end}"))


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
        super().__init__(*(fault.text(source) for fault in self.faults))

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
        self.args = tuple(line for error in errors for line in error.args)


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
