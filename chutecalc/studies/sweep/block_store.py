"""Blocks of a sweep, stored in a folder beside its data file until that is written. Each block is whole or absent."""

import json
import os
import shutil
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from chutecalc.errors import OutputError, UsageError, WriteError
from chutecalc.output.dataset import Block

IDENTITY = "sweep.json"


class BlockStore:
    """The folder ``FILE.part``."""

    def __init__(self, target: str, identity: Mapping[str, Any], resume: bool) -> None:
        """Create the folder, or open the one that exists.

        Args:
            target: the data file.
            identity: everything that the rows depend on; see :meth:`chutecalc.studies.sweep.sweep.Sweep.identity`.
            resume: whether to use the blocks of an interrupted sweep.

        Raises:
            UsageError: the folder belongs to another sweep, was not to be used, or is not there to be continued.
            OutputError: it cannot be created.
        """
        self.folder = Path(f"{os.path.realpath(target)}.part")
        self.name = f"{target}.part"
        try:
            if (self.folder / IDENTITY).exists():
                self._open(json.loads((self.folder / IDENTITY).read_text(encoding="utf-8")), identity, resume)
                return
            if resume:
                raise UsageError(f"there is no {self.name} to continue. To start the sweep anew, leave out --resume.")
            self.folder.mkdir(exist_ok=True)
            if any(self.folder.glob("[!.]*")):
                raise UsageError(f"{self.name} does not belong to a sweep: move or rename it")
            self._put(IDENTITY, lambda file: Path(file).write_text(json.dumps(identity), encoding="utf-8"))
        except (OSError, WriteError) as error:
            raise OutputError(f"{self.name} cannot be written: {getattr(error, 'strerror', error)}") from None
        except ValueError:
            raise UsageError(f"{self.name}/{IDENTITY} cannot be read: remove {self.name} and start again") from None

    def _open(self, before: Mapping[str, Any], identity: Mapping[str, Any], resume: bool) -> None:
        """Check that the blocks in the folder fit this sweep.

        Raises:
            UsageError: they do not, or are not to be used.
        """
        if not resume:
            raise UsageError(f"{self.name} is left from an interrupted sweep: add --resume to continue, or remove it")
        now = json.loads(json.dumps(identity))
        other = [name for name in {**now, **before} if now.get(name) != before.get(name)]
        if other:
            what = ", ".join(WORDS.get(name, f"--{name}") for name in other)
            raise UsageError(
                f"{self.name} belongs to another sweep, which differs in {what}. Repeat that command, or remove it"
            )

    def __contains__(self, number: int) -> bool:
        return self._file(number).exists()

    def save(self, number: int, block: Block) -> None:
        """Store a block.

        Args:
            number: number of the block.
            block: its rows.

        Raises:
            WriteError: it could not be written.
        """
        self._put(self._file(number).name, lambda file: np.savez(file, **block))

    def blocks(self, count: int) -> Iterator[Block]:
        """Yield the stored blocks in order, up to the first that is missing.

        Args:
            count: number of blocks of the sweep.
        """
        for number in range(count):
            if number not in self:
                return
            with np.load(self._file(number), allow_pickle=False) as stored:
                yield dict(stored)

    def remove(self) -> None:
        """Remove the folder."""
        shutil.rmtree(self.folder, ignore_errors=True)

    def _file(self, number: int) -> Path:
        return self.folder / f"{number:08d}.npz"

    def _put(self, name: str, write: Any) -> None:
        """Write a file of the folder, whole or not at all."""
        part = self.folder / f".{name}"
        try:
            write(str(part))
            with open(part, "rb") as stream:
                os.fsync(stream.fileno())
            os.replace(part, self.folder / name)
        except OSError as error:
            raise WriteError(f"{self.name} could not be written: {error.strerror}") from None


WORDS = {
    "chutecalc": "the version of chutecalc",
    "spec": "the spec",
    "parameters": "the parameters or their values",
    "stations": "--points or --stations",
    "tolerance": "--rtol",
    "top": "--top or --by",
    "block": "the size of its blocks",
}
"""Names of the entries of an identity, for messages."""
