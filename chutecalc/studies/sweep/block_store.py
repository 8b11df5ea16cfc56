"""Blocks of a sweep, kept in a folder beside its data file until that is written. None is trusted before it is read."""

import hashlib
import json
import os
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from chutecalc.errors import OutputError, UsageError, WriteError
from chutecalc.output.dataset import Block
from chutecalc.output.files import open_whole
from chutecalc.output.held import hold_folder, let_folder_go
from chutecalc.studies.sweep.stored_block import DamagedError, packed, unpacked

IDENTITY = "sweep.json"


class BlockStore:
    """The folder ``FILE.part``, which one process has to itself."""

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
        self.folder = Path(f"{os.path.realpath(target)}.part")
        self.name = f"{target}.part"
        text = json.dumps(identity)
        self.digest = hashlib.sha256(text.encode()).hexdigest()
        if resume and not self._has(IDENTITY):
            raise UsageError(f"there is no {self.name} to continue. To start the sweep anew, leave out --resume.")
        try:
            self.folder.mkdir(exist_ok=True)
            hold_folder(str(self.folder), self.name)
            if self._has(IDENTITY):
                self._open(json.loads(text), resume)
                return
            if any(self.folder.glob("[!.]*")):
                raise UsageError(f"{self.name} does not belong to a sweep: move or rename it")
        except OSError as error:
            raise OutputError(f"{self.name} cannot be written: {error.strerror}") from None
        with open_whole(str(self.folder / IDENTITY)) as stream:
            stream.write(text)

    def _open(self, now: Mapping[str, Any], resume: bool) -> None:
        """Check that the blocks in the folder fit this sweep.

        Raises:
            UsageError: they do not, or are not to be used.
        """
        if not resume:
            raise UsageError(f"{self.name} is left from an interrupted sweep: add --resume to continue, or remove it")
        before: Any = None
        with suppress(OSError, ValueError, RecursionError, MemoryError):
            before = json.loads((self.folder / IDENTITY).read_bytes())
        if not isinstance(before, dict):
            raise UsageError(f"{self.name}/{IDENTITY} cannot be read: remove {self.name} and start again")
        other = [name for name in {**now, **before} if now.get(name) != before.get(name)]
        if other:
            what = ", ".join(WORDS.get(name, f"--{name}" if name in now else "unknown entries") for name in other)
            raise UsageError(
                f"{self.name} belongs to another sweep, which differs in {what}. Repeat that command, or remove it"
            )

    def __contains__(self, number: int) -> bool:
        return self._has(self._name(number))

    def save(self, number: int, block: Block) -> None:
        """Store a block.

        Args:
            number: number of the block.
            block: its rows.

        Raises:
            WriteError: it could not be written.
        """
        path = self.folder / self._name(number)
        try:
            if not path.is_file():
                path.unlink(missing_ok=True)  # a pipe would wait for a reader
            with open_whole(str(path), "wb") as stream:
                stream.writelines(packed(block, number, self.digest))
        except (OutputError, WriteError) as error:
            raise WriteError(str(error).replace(str(self.folder), self.name)) from None
        except OSError as error:
            raise WriteError(f"{self.name}/{path.name} could not be written: {error.strerror}") from None

    def load(self, number: int, rows: int | None) -> Block:
        """Return a stored block.

        Args:
            number: number of the block.
            rows: how many rows it has; None where only its solution tells.

        Raises:
            DamagedError: it is missing, or is not what was stored.
        """
        name = self._name(number)
        if not self._has(name):
            raise DamagedError(f"{self.name}/{name} is missing")
        try:
            return unpacked((self.folder / name).read_bytes(), number, self.digest, rows)
        except DamagedError as error:
            raise DamagedError(f"{self.name}/{name} {error}") from None
        except OSError as error:
            raise DamagedError(f"{self.name}/{name} cannot be read: {error.strerror}") from None

    def remove(self) -> None:
        """Remove what was stored: the blocks first, so that what is left of it can be continued at any moment."""
        for name in ("*.npz", ".*.npz.*", IDENTITY):
            for file in self.folder.glob(name):
                with suppress(OSError):
                    file.unlink()
        let_folder_go(str(self.folder))
        with suppress(OSError):  # what others have put there stays
            self.folder.rmdir()

    def _name(self, number: int) -> str:
        return f"{number:08d}.npz"

    def _has(self, name: str) -> bool:
        return (self.folder / name).is_file()


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
