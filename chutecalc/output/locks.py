"""Locks on files. The system releases them when a process ends, however it ends, so that none is ever left behind."""

import errno
import os
import re
import stat
import sys
from contextlib import suppress
from pathlib import Path

HELD = {errno.EAGAIN, errno.EACCES, errno.EDEADLK}
"""What systems answer where another holds a lock. Whatever else they answer: a file system without locks."""
IN_THE_WAY = {errno.ELOOP, errno.EISDIR, errno.EACCES, errno.EPERM}
"""What systems answer where a link, a folder or the file of another user stands there."""
FLAGS = os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)
FAR = 2**30
"""Where the byte stands that Windows locks: others may not read what is locked, and there is nothing to read."""
NOTE = "chutecalc process {}\n"
NOTE_SIZE = 64


OPEN: "set[Lock]" = set()
"""All locks of this process."""


class HeldError(Exception):
    """Another holds the lock.

    Args:
        process: its number; None if it is not known.
    """

    def __init__(self, process: int | None) -> None:
        self.process = process
        super().__init__(process)


class Lock:
    """A file that one process holds, with the number of that process inside until it writes something else."""

    def __init__(self, path: Path) -> None:
        """Create the file, or take one that nobody holds any more.

        Args:
            path: of the file.

        Raises:
            HeldError: another process holds it, or this one already.
            OSError: it cannot be opened, or nothing can be written to it.
        """
        self.path, self.gone = path, False
        self.descriptor = _opened(path)
        OPEN.add(self)
        try:
            self.empty()
            os.write(self.descriptor, NOTE.format(os.getpid()).encode())
        except OSError:
            self.release()
            raise

    def empty(self) -> None:
        """Remove what is in the file."""
        os.ftruncate(self.descriptor, 0)
        os.lseek(self.descriptor, 0, os.SEEK_SET)

    def move(self, target: Path, fresh: bool) -> None:
        """Make the file another one, and so the lock one of nothing.

        Args:
            target: what it becomes; a file that is there is replaced.
            fresh: whether it must not be there.

        Raises:
            FileExistsError: it is there, and must not be.
            OSError: it cannot be moved. Where the system does not replace files that are open, one may be.
        """
        if sys.platform == "win32":
            self._close()  # an open file is not moved there; elsewhere nobody is to take it before it is moved
        if not fresh:
            os.replace(self.path, target)
        elif not _linked(self.path, target):
            os.rename(self.path, target)
        else:
            os.unlink(self.path)
        self.gone = True

    def release(self) -> None:
        """Give up the lock, and remove the file unless it was moved. Once more does nothing."""
        if sys.platform == "win32":
            self._close()
        if not self.gone:
            with suppress(OSError):  # another has taken it by now, or the folder is gone
                os.unlink(self.path)
            self.gone = True
        OPEN.discard(self)
        self._close()

    def _close(self) -> None:
        if self.descriptor >= 0:
            os.close(self.descriptor)
            self.descriptor = -1


def _opened(path: Path) -> int:
    """Return the descriptor of a file that is locked, and still is the one at its path."""
    while True:
        try:
            descriptor = os.open(path, FLAGS, 0o666)
        except OSError as error:
            if error.errno in IN_THE_WAY and os.path.lexists(path):
                raise FileExistsError(errno.EEXIST, f"{path} is in the way: remove it") from None
            raise
        try:
            if not stat.S_ISREG(os.fstat(descriptor).st_mode):
                raise FileExistsError(errno.EEXIST, f"{path} is in the way: remove it")
            _lock(descriptor)
            with suppress(FileNotFoundError):
                if os.path.samestat(os.fstat(descriptor), os.stat(path)):
                    return descriptor
        except BaseException:
            os.close(descriptor)
            raise
        os.close(descriptor)  # who held it has moved or removed it between the two calls


def _lock(descriptor: int) -> None:
    """Lock an open file at once, or raise HeldError."""
    try:
        if sys.platform == "win32":
            import msvcrt

            os.lseek(descriptor, FAR, os.SEEK_SET)
            msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        if error.errno in HELD:
            raise HeldError(_holder(descriptor)) from None


def _holder(descriptor: int) -> int | None:
    """Return the number of the process that holds a file, if it stands there."""
    with suppress(OSError):
        os.lseek(descriptor, 0, os.SEEK_SET)
        if found := re.fullmatch(NOTE.format(r"(\d+)").encode(), os.read(descriptor, NOTE_SIZE)):
            return int(found[1])
    return None


def _linked(path: Path, target: Path) -> bool:
    """Give a file a second name that must be free; return whether the file system can."""
    try:
        os.link(path, target)
    except FileExistsError:
        raise
    except OSError:
        if os.path.lexists(target):
            raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST)) from None
        return False
    return True
