"""Outputs of one command beside its inputs: none is written twice, and none is read."""

import os
import stat
import sys
from collections.abc import Mapping, Sequence
from contextlib import suppress

from chutecalc.errors import UsageError

STANDARD_STREAM = "-"


def check_targets(outputs: Mapping[str, str | None], inputs: Sequence[str | None]) -> None:
    """Check that no two outputs are the same, and that no output is an input.

    Args:
        outputs: files that are written, by option; None for an output that was not asked for.
        inputs: files that are read; None for one that was not given.

    Raises:
        UsageError: the outputs that are the same, or the output that is an input or where standard output goes.
    """
    given = {option: output for option, output in outputs.items() if output}
    if list(given.values()).count(STANDARD_STREAM) > 1:
        raise UsageError("only one output can go to standard output (-)")
    if STANDARD_STREAM in given.values() and getattr(sys.stdout, "name", "") == os.devnull:
        raise UsageError("standard output is closed, so that nothing can be written to it (-): name a file")
    if list(inputs).count(STANDARD_STREAM) > 1:
        raise UsageError("only one spec can come from standard input (-)")
    read = [name for name in inputs if name not in (None, STANDARD_STREAM)]
    files: dict[str, str] = {}
    for option, output in given.items():
        if output == STANDARD_STREAM:
            continue
        for other, file in files.items():
            if _same(file, output):
                raise UsageError(f"{other} and {option} both write to {output}. Give one of them another name.")
        for name in read:
            if _same(str(name), output):
                raise UsageError(f"{name} is an input, and the output would overwrite it: choose another name")
        if _is_standard_output(output):
            raise UsageError(f"{output} is where standard output goes: name another file, or write - instead of it")
        files[option] = output


def _same(one: str, other: str) -> bool:
    """Return whether two names are of one file, as far as this can be known before the file is there."""
    with suppress(OSError):
        return os.path.samefile(one, other)
    with suppress(FileNotFoundError):  # the working folder was removed, which is told when the file is reserved
        return os.path.normcase(os.path.realpath(one)) == os.path.normcase(os.path.realpath(other))
    return False


def _is_standard_output(target: str) -> bool:
    """Return whether a target is the regular file that standard output goes to, whose place another would take."""
    with suppress(OSError, ValueError, AttributeError):  # no such file, or no standard output that is one
        there = os.fstat(sys.stdout.fileno())
        return stat.S_ISREG(there.st_mode) and os.path.samestat(there, os.stat(target))
    return False
