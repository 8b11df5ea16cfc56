"""``python -m chutecalc``, and the console script: what Ctrl-C does from the first import to the last moment."""

from __future__ import annotations

import _signal  # type: ignore[import-not-found]  # signal itself imports enum first
import _thread
import os
import sys

TYPE_CHECKING = False  # typing is slow to import, and an interrupt before the handler stands is a traceback
if TYPE_CHECKING:
    from types import FrameType
    from typing import Any

INTERRUPTED = 130
"""The exit status after Ctrl-C; imports do not wait for :class:`chutecalc.errors.ExitStatus`."""


class _Command:
    """The command of this process."""

    status = INTERRUPTED
    """With which it ends where it is interrupted now."""
    running = False
    """Whether it is to clean up before."""


def _interrupted(number: int, frame: FrameType | None) -> None:
    """Interrupt the command; end the process where there is nothing to clean up.

    Modules that are half imported print tracebacks of their own, those written in C among them.

    Args:
        number: of the signal.
        frame: what runs.
    """
    if _Command.running and not _importing(frame):
        raise KeyboardInterrupt
    if _Command.status == INTERRUPTED:
        _clean_up()
    os._exit(_Command.status)


def _importing(frame: FrameType | None) -> bool:
    """Return whether a frame belongs to an import."""
    while frame is not None and not frame.f_code.co_filename.startswith("<frozen importlib"):
        frame = frame.f_back
    return frame is not None


def _clean_up() -> None:
    """Remove what is not written to its end, and say why."""
    held = sys.modules.get("chutecalc.output.held")
    if release := getattr(held, "release", None):  # not imported yet, there is nothing
        release()
    try:  # noqa: SIM105 - contextlib is not imported yet
        os.write(2, b"chutecalc: interrupted\n")
    except OSError:
        pass  # nobody is to be told


def _unraisable(error: Any) -> None:
    """Interrupt again what could not be interrupted, such as the removal of an object, instead of printing that.

    Args:
        error: as :func:`sys.unraisablehook` takes it.
    """
    if error.exc_type is KeyboardInterrupt:
        _thread.interrupt_main()
    else:
        sys.__unraisablehook__(error)


if _signal.getsignal(_signal.SIGINT) is _signal.default_int_handler:  # jobs in the background ignore it
    _signal.signal(_signal.SIGINT, _interrupted)
    sys.unraisablehook = _unraisable

from chutecalc.runtime import prepare_command  # noqa: E402 - from here on an interrupt is no traceback

prepare_command()


def entry() -> None:
    """Run the command line that the process was given, and exit with its status."""
    from chutecalc.cli import main

    _Command.running = True
    try:
        status = main()
    except KeyboardInterrupt:  # again, while the first was told
        _Command.running = False
        status = INTERRUPTED
    _Command.running = False
    _Command.status = int(status)
    sys.exit(status)


if __name__ == "__main__":
    entry()
