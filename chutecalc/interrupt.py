"""What Ctrl-C does in a command, from the first import to the last moment.

The first one raises ``KeyboardInterrupt`` where that is no harm; the next one, or one that comes during an import,
removes what is half written and ends the process.
"""

from __future__ import annotations

import _signal  # type: ignore[import-not-found]  # signal itself imports enum first
import os
import sys

TYPE_CHECKING = False  # typing is slow to import, and an interrupt before the handler stands is a traceback
if TYPE_CHECKING:
    from types import FrameType
    from typing import Any, NoReturn

INTERRUPTED = 130
"""The exit status after Ctrl-C; imports do not wait for :class:`chutecalc.errors.ExitStatus`."""


class _State:
    """What the handler knows of this process."""

    listening = False
    """Whether the command can clean up by itself."""
    interrupted = False
    """Whether it has been asked to."""


def interrupted() -> bool:
    """Return whether Ctrl-C was pressed: libraries in C turn a ``KeyboardInterrupt`` into errors of their own."""
    return _State.interrupted


def install() -> None:
    """Take over Ctrl-C, unless the process ignores it, as jobs in the background do."""
    if _signal.getsignal(_signal.SIGINT) is _signal.default_int_handler:
        _signal.signal(_signal.SIGINT, _handle)
        sys.unraisablehook = _unraisable


def listen() -> None:
    """Raise ``KeyboardInterrupt`` at the next Ctrl-C, once."""
    _State.listening = True


def ignore() -> None:
    """Ignore Ctrl-C from now on: the command is done, and its process is about to end."""
    _signal.signal(_signal.SIGINT, _signal.SIG_IGN)


def clean_up() -> None:
    """Remove what is not written to its end, and say why."""
    held = sys.modules.get("chutecalc.output.held")
    if release := getattr(held, "release", None):  # not imported yet, there is nothing
        release()
    try:  # noqa: SIM105 - contextlib is not imported yet
        os.write(2, b"chutecalc: interrupted\n")
    except OSError:
        pass  # nobody is to be told


def _handle(number: int, frame: FrameType | None) -> None:
    """Interrupt the command, or end the process where there is nobody to clean up.

    Modules that are half imported print tracebacks of their own, those written in C among them.

    Args:
        number: of the signal.
        frame: what runs.
    """
    listening, _State.listening = _State.listening, False
    if listening and not _importing(frame):
        _State.interrupted = True
        raise KeyboardInterrupt
    _end()


def _end() -> NoReturn:
    clean_up()
    os._exit(INTERRUPTED)


def _importing(frame: FrameType | None) -> bool:
    """Return whether a frame belongs to an import."""
    while frame is not None and not frame.f_code.co_filename.startswith("<frozen importlib"):
        frame = frame.f_back
    return frame is not None


def _unraisable(error: Any) -> None:
    """End the process where an interrupt came while an object was removed: nobody can catch that one.

    Args:
        error: as :func:`sys.unraisablehook` takes it.
    """
    if error.exc_type is KeyboardInterrupt:
        _end()
    sys.__unraisablehook__(error)
