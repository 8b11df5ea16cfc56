"""The blocks of a sweep on their way to a file: a folder beside it, each block whole or absent."""

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
        """Makes the folder, or takes up the one that there is.

        Args:
            target: the file that the blocks become.
            identity: what they follow from; see :meth:`chutecalc.studies.sweep.sweep.Sweep.identity`.
            resume: go on from blocks of an earlier sweep, if there are any.

        Raises:
            UsageError: there is a folder of another sweep, or one that was not to be resumed.
            OutputError: it cannot be made.
        """
        self.folder = Path(f"{os.path.realpath(target)}.part")
        self.name = f"{target}.part"
        try:
            if (self.folder / IDENTITY).exists():
                self._take_up(json.loads((self.folder / IDENTITY).read_text(encoding="utf-8")), identity, resume)
                return
            self.folder.mkdir(exist_ok=True)
            if any(self.folder.glob("[!.]*")):
                raise UsageError(f"{self.name} is no sweep's: move it away")
            self._place(IDENTITY, lambda file: Path(file).write_text(json.dumps(identity), encoding="utf-8"))
        except (OSError, WriteError) as error:
            raise OutputError(f"{self.name} cannot be written: {getattr(error, 'strerror', error)}") from None
        except ValueError:
            raise UsageError(f"{self.name}/{IDENTITY} cannot be read: remove {self.name} and begin again") from None

    def _take_up(self, before: Mapping[str, Any], identity: Mapping[str, Any], resume: bool) -> None:
        """Checks that blocks fit.

        Raises:
            UsageError: they do not, or are not to be taken up.
        """
        if not resume:
            raise UsageError(f"{self.name} is left of a sweep that was ended: go on with --resume, or remove it")
        now = json.loads(json.dumps(identity))
        other = [name for name in {**now, **before} if now.get(name) != before.get(name)]
        if other:
            what = ", ".join(WORDS.get(name, f"--{name}") for name in other)
            raise UsageError(
                f"{self.name} is of another sweep: it differs in {what}. Repeat that command, or remove it"
            )

    def __contains__(self, number: int) -> bool:
        return self._file(number).exists()

    def save(self, number: int, block: Block) -> None:
        """Keeps a block.

        Raises:
            WriteError: it could not be written.
        """
        self._place(self._file(number).name, lambda file: np.savez(file, **block))

    def blocks(self, count: int) -> Iterator[Block]:
        """The blocks from the first on, as far as they are there."""
        for number in range(count):
            if number not in self:
                return
            with np.load(self._file(number), allow_pickle=False) as stored:
                yield dict(stored)

    def remove(self) -> None:
        """Removes the folder."""
        shutil.rmtree(self.folder, ignore_errors=True)

    def _file(self, number: int) -> Path:
        return self.folder / f"{number:08d}.npz"

    def _place(self, name: str, write: Any) -> None:
        """Writes a file of the folder whole or not at all."""
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
"""What sets sweeps apart, in a user's words."""
