"""A bar for long work, on a terminal's standard error only."""

import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from rich.progress import Task

Item = TypeVar("Item")
WORTH_A_BAR = 20


@contextmanager
def progress(unit: str, slow: bool = False) -> Iterator[Callable[[int, int], None]]:
    """A bar with the time left; what it yields is called with how many are done and how many there are.

    Args:
        unit: what they are called.
        slow: each takes long: the time gone is told, rather than how many are done in a second.
    """
    if not sys.stderr.isatty():
        yield lambda done, total: None
        return
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        ProgressColumn,
        TextColumn,
        TimeElapsedColumn,
        TimeRemainingColumn,
    )
    from rich.text import Text

    class Rate(ProgressColumn):
        def render(self, task: "Task") -> Text:
            speed = task.finished_speed or task.speed
            return Text(f"{speed:,.0f}/s" if speed else "")

    pace = TimeElapsedColumn() if slow else Rate()
    columns = (BarColumn(), MofNCompleteColumn(), TextColumn(unit), pace, TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(unit, total=None)
        yield lambda done, total: bar.update(task, completed=done, total=total)


def with_progress(items: Iterable[Item], total: int, unit: str) -> Iterator[Item]:
    """The items as they come, with a bar where there are many.

    Args:
        items: whatever takes its time.
        total: how many there will be.
        unit: what they are called.
    """
    if total < WORTH_A_BAR:
        yield from items
        return
    with progress(unit) as told:
        told(0, total)
        for done, item in enumerate(items, 1):
            yield item
            told(done, total)
