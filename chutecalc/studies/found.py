"""Designs that a study has found: what they are, what they do, and their spec."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from chutecalc.api.chute import Chute
from chutecalc.api.written import changed_text
from chutecalc.errors import UsageError
from chutecalc.output.dataset import Block, numbers
from chutecalc.output.files import changed, open_whole
from chutecalc.physics.arrays import Array
from chutecalc.results.column import Column
from chutecalc.results.described import html_table
from chutecalc.spec.parse import decode, encode
from chutecalc.studies.keys import Key
from chutecalc.studies.sweep.table import column_of
from chutecalc.studies.variants import Variants


@dataclass(frozen=True, repr=False, eq=False)
class Found:
    """Some designs of a chute, and their columns in some of its states."""

    chute: Chute
    """The chute that was varied."""
    keys: tuple[Key, ...]
    """What could change."""
    states: tuple[str, ...]
    """Operating states that were solved, ``design`` for the spec as written."""
    values: dict[str, Any]
    """Numbers, in the units of the keys, or names: an array of shape (designs,) by the name of each key."""
    outcome: Block
    """``status`` and columns, arrays of shape (states, designs) by name; NaN where a design fails."""
    columns: dict[str, Column]
    """How people read the values and the outcome, by name."""

    @property
    def count(self) -> int:
        """Number of designs."""
        return len(next(iter(self.values.values())))

    def changes(self, take: int | None = None) -> dict[str, Any]:
        """Return the values of one design by key path.

        Args:
            take: its number, from 1; may be left out where there is one.

        Raises:
            UsageError: there is no such design, or it is not said which.
        """
        if take is None and self.count > 1:
            raise UsageError(f"there are {self.count} solutions: choose one of them with --take N (take=N in Python)")
        number = 1 if take is None else take
        if not 1 <= number <= self.count:
            raise UsageError(f"there is no solution {number} to take: there are {self.count}")
        return {
            path: key.written(self.values[key.name][number - 1].item())
            for key in self.keys
            for path in key.parameter.paths
        }

    def text(self, take: int | None = None) -> str:
        """Return the spec with the values of one design, its comments kept.

        Args:
            take: as for :meth:`changes`.
        """
        return changed_text(self.chute, self.changes(take))

    def write(self, file: str | Path | None = None, take: int | None = None) -> None:
        """Write the spec with the values of one design.

        Args:
            file: where to; the chute's own file if left out.
            take: as for :meth:`changes`.

        Raises:
            UsageError: the chute has no file of its own.
            OutputError: the file cannot be written, or another process is writing it.
            WriteError: writing failed, or the chute's own file has changed since it was read.
        """
        if file is None and not Path(self.chute.source).is_file():
            raise UsageError(f"{self.chute.source} is no file to write to: name one")
        own, target = Path(self.chute.source), str(file or self.chute.source)
        was = own.read_bytes() if own.is_file() else b""
        if file is None and decode(was, target) != self.chute.text:
            raise changed(target)
        content = encode(self.text(take), like=was)
        with open_whole(target, "wb", read=was if file is None else None) as stream:
            stream.write(content)

    def _described(self) -> str:
        """Return what was found, as text."""
        raise NotImplementedError

    def __repr__(self) -> str:
        return f"<{self._described()}>"

    def _repr_html_(self) -> str:
        """Return a table for notebooks: a row for each design in each state."""
        return html_table(self._described(), list(self.rows()), self._cells())

    def rows(self) -> Block:
        """Return a row for each design in each state, for files."""
        count, states = self.count, len(self.states)
        return {
            "solution": _column([k + 1.0 for k in range(count) for _ in range(states)]),
            **{name: own.repeat(states) for name, own in self.values.items()},
            "state": _column([*self.states] * count),
            **{name: own.T.ravel() for name, own in self.outcome.items()},
        }

    def _cells(self) -> list[Sequence[str]]:
        """Return the rows as text."""
        columns = [
            [f"{value:.6g}" if isinstance(value, float) else str(value) for value in own.tolist()]
            for own in self.rows().values()
        ]
        return list(zip(*columns, strict=True))

    def document(self) -> dict[str, Any]:
        """Return the solutions and the outcome of each by column name, of several states an object of numbers."""

        def told(own: Array) -> Any:
            values = numbers(own)
            return values[0] if len(self.states) == 1 else dict(zip(self.states, values, strict=True))

        return {
            "solutions": [
                {key.name: key.written(self.values[key.name][k].item()) for key in self.keys} for k in range(self.count)
            ],
            "outcome": [{name: told(own[:, k]) for name, own in self.outcome.items()} for k in range(self.count)],
        }


def solved(variants: Variants, keys: Sequence[Key], places: Array) -> tuple[dict[str, Any], Block, dict[str, Column]]:
    """Return the values of designs, their outcome, and the columns of both.

    Args:
        variants: solves them.
        keys: what varies.
        places: of the designs, as :meth:`Key.at` takes them, shape (designs, keys).
    """
    values = {key.name: key.at(own) for key, own in zip(keys, places.T, strict=True)}
    names = ["status", *variants.columns]
    columns = {name: column_of(variants.sweep, name) for name in (*values, *names)}
    none = {name: _column([]).reshape(len(variants.states), 0) for name in names}
    return values, variants(list(values.values())) if len(places) else none, columns


def _column(values: Sequence[Any]) -> Any:
    """Return values as an array."""
    import numpy as np

    return np.array(values)
