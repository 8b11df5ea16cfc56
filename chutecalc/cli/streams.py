"""Standard output and standard error: UTF-8, and what they do where nobody reads them or their disk is full."""

import errno
import io
import os
import sys
from typing import Any

from chutecalc.errors import WriteError

NO_READER = {errno.EPIPE, errno.EINVAL} if sys.platform == "win32" else {errno.EPIPE}
"""What systems answer where the reader of a pipe is gone."""


class _Told(io.FileIO):
    """Standard error: what it does not take is lost, and changes no exit status."""

    def write(self, content: Any) -> int:
        """Write bytes, or lose them.

        Args:
            content: the bytes.
        """
        try:
            return super().write(content) or 0
        except OSError:
            return len(content)


class _Printed(io.FileIO):
    """Standard output. A reader who has enough is no error, and the other outputs are still written."""

    gone = False
    """Whether nothing more can be written."""

    def write(self, content: Any) -> int:
        """Write bytes, or lose them where nobody reads them.

        Args:
            content: the bytes.

        Raises:
            WriteError: they cannot be written for another reason.
        """
        if self.gone:
            return len(content)
        try:
            return super().write(content) or 0
        except OSError as error:
            if error.errno in NO_READER:
                self.gone = True
                return len(content)
            raise WriteError(f"standard output could not be written: {error.strerror}") from None


def prepare_streams() -> None:
    """Write UTF-8 to files and pipes whatever the locale, and replace characters that a terminal cannot show."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:  # closed before the start
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115 - stays open until the end
    sys.stdout, sys.stderr = _prepared(sys.stdout, _Printed), _prepared(sys.stderr, _Told)


def finish_streams() -> None:
    """Lose what standard output has not taken, which has been said by now; Python would say it again at exit."""
    try:
        sys.stdout.flush()
    except WriteError:
        _raw(sys.stdout).gone = True


def reader_is_gone() -> bool:
    """Return whether what is written to standard output is lost from now on."""
    raw = _raw(sys.stdout)
    return isinstance(raw, _Printed) and raw.gone


def _raw(stream: Any) -> Any:
    """Return what is below the text of a stream and its buffer."""
    buffer = getattr(stream, "buffer", None)
    return getattr(buffer, "raw", buffer)


def _prepared(stream: Any, kind: type[_Told | _Printed]) -> Any:
    """Return a stream of the process in its new form; another, such as that of a console or of a test, as it is."""
    if stream not in (sys.__stdout__, sys.__stderr__) or type(_raw(stream)) is not io.FileIO:
        return stream
    stream.flush()
    raw, terminal = kind(stream.fileno(), "wb", closefd=False), stream.isatty()
    unknown = terminal and stream.encoding.lower().replace("-", "") != "utf8"
    return io.TextIOWrapper(
        raw if stream.write_through else io.BufferedWriter(raw),  # as python -u does it
        encoding=stream.encoding if terminal else "utf-8",
        errors="replace" if unknown else "backslashreplace",
        newline=None if terminal else "",  # files and pipes get the same bytes on all systems
        line_buffering=stream.line_buffering,
        write_through=stream.write_through,
    )
