"""A progress bar for long work, on standard error and only on a terminal."""

import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from rich.progress import Task

Item = TypeVar("Item")
MIN_ITEMS = 20
"""With fewer items there is no bar."""


@contextmanager
def progress(unit: str, slow: bool = False) -> Iterator[Callable[[int, int], None]]:
    """Show a bar with the time left.

    Args:
        unit: name of the items, plural.
        slow: whether an item takes long. The bar shows the time elapsed then, rather than items per second.

    Yields:
        A function that updates the bar, from the number of items done and the number of all items.
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
    """Yield items as they come, with a bar if there are many.

    Args:
        items: items that take time.
        total: number of items.
        unit: name of the items, plural.
    """
    if total < MIN_ITEMS:
        yield from items
        return
    with progress(unit) as show:
        show(0, total)
        for done, item in enumerate(items, 1):
            yield item
            show(done, total)
