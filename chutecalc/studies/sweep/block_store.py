"""Blocks of a sweep, kept in a folder beside its data file until that is written. None is trusted before it is read."""

import hashlib
import json
import stat
from collections.abc import Iterable, Mapping
from contextlib import suppress
from typing import Any

from chutecalc.errors import OutputError, SpecError, UsageError, WriteError
from chutecalc.output.dataset import Block
from chutecalc.output.files import open_whole
from chutecalc.output.held import hold_folder, let_folder_go, named
from chutecalc.spec.reader import LARGEST, read_bytes
from chutecalc.studies.sweep.part_folder import IDENTITY, kind_of, part_folder
from chutecalc.studies.sweep.stored_block import DamagedError, packed, unpacked


class BlockStore:
    """The folder ``FILE.part``, which one process has to itself. No link in it is followed."""

    def __init__(self, target: str, identity: Mapping[str, Any], resume: bool) -> None:
        """Create the folder, or open the one that exists.

        Args:
            target: the data file.
            identity: everything that the rows depend on; see :meth:`chutecalc.studies.sweep.sweep.Sweep.identity`.
            resume: whether to use the blocks of an interrupted sweep.

        Raises:
            UsageError: the folder belongs to another sweep, was not to be used, or is not there to be continued.
            OutputError: it cannot be created, or another process uses it.
            WriteError: the disk is full.
        """
        self.folder = part_folder(target, resume)
        self.name = str(self.folder)
        text = json.dumps(identity)
        self.digest = hashlib.sha256(text.encode()).hexdigest()
        try:
            with named(self.name):
                self.folder.mkdir(exist_ok=True)
            hold_folder(self.name, self.name)
            if resume:
                self._open(text)
            else:
                self._write(IDENTITY, [text.encode()])
        except BaseException:
            self._leave()
            raise

    def _open(self, text: str) -> None:
        """Check that the blocks in the folder are of the sweep with this identity.

        Raises:
            UsageError: they are not.
        """
        before: Any = None
        with suppress(SpecError, ValueError, RecursionError, MemoryError):
            before = json.loads(read_bytes(self.folder / IDENTITY, LARGEST + len(text)))
        if not isinstance(before, dict):
            raise UsageError(f"{self.name}/{IDENTITY} cannot be read: remove {self.name} and leave out --resume")
        now = json.loads(text)
        other = [name for name in {**now, **before} if now.get(name) != before.get(name)]
        if other:
            what = ", ".join(
                dict.fromkeys(WORDS.get(name, f"--{name}" if name in now else "unknown entries") for name in other)
            )
            raise UsageError(
                f"{self.name} belongs to another sweep, which differs in {what}. Repeat that command, or remove it"
            )

    def __contains__(self, number: int) -> bool:
        return bool(kind_of(self.folder / self._name(number)))

    def save(self, number: int, block: Block) -> None:
        """Store a block.

        Args:
            number: number of the block.
            block: its rows.

        Raises:
            WriteError: it could not be written.
        """
        try:
            self._write(self._name(number), packed(block, number, self.digest))
        except OutputError as error:
            raise WriteError(*error.args) from None

    def _write(self, name: str, content: Iterable[bytes]) -> None:
        """Write a file of the folder, in place of what has its name: a link is not followed, a pipe not waited for."""
        path = self.folder / name
        with named(str(path)):
            path.unlink(missing_ok=True)
        with open_whole(str(path), "wb") as stream:
            stream.writelines(content)

    def load(self, number: int, rows: int | None) -> Block:
        """Return a stored block.

        Args:
            number: number of the block.
            rows: how many rows it has; None where only its solution tells.

        Raises:
            DamagedError: it is missing, or is not what was stored.
            OutputError: a folder is in its place, so that it cannot be stored again either.
        """
        path = self.folder / self._name(number)
        try:
            kind = kind_of(path)
            if kind == stat.S_IFDIR:
                raise OutputError(f"{path} is a folder in the place of a block: remove it and repeat the command")
            if kind != stat.S_IFREG:
                raise DamagedError("is no file" if kind else "is missing")
            with path.open("rb") as stream:
                return unpacked(stream, number, self.digest, rows)
        except DamagedError as error:
            raise DamagedError(f"{path} {error}") from None
        except OSError as error:
            raise DamagedError(f"{path} cannot be read: {error.strerror}") from None

    def remove(self) -> None:
        """Remove what was stored: the blocks first, so that what is left of it can be continued at any moment."""
        for name in ("[0-9]*.npz", ".[0-9]*.npz.*", IDENTITY):
            for file in self.folder.glob(name):
                with suppress(OSError):
                    file.unlink()
        self._leave()

    def _leave(self) -> None:
        """Let others have the folder, and remove it where nothing is in it."""
        let_folder_go(self.name)
        with suppress(OSError):  # blocks stay, and so does what others have put there
            self.folder.rmdir()

    def _name(self, number: int) -> str:
        return f"{number:08d}.npz"


WORDS = {
    "chutecalc": "the version of chutecalc",
    "spec": "the spec",
    "library": "the library",
    "parameters": "the parameters or their values",
    "stations": "--points or --stations",
    "tolerance": "--rtol",
    "top": "--top or --by",
    "block": "the size of its blocks",
}
"""Names of the entries of an identity, for messages."""
