"""A bar for long work, on a terminal's standard error only."""

import sys
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from rich.progress import Task

Item = TypeVar("Item")
WORTH_A_BAR = 20


def with_progress(items: Iterable[Item], total: int, unit: str) -> Iterator[Item]:
    """The items as they come, with how many have, how fast, and the time left.

    Args:
        items: whatever takes its time.
        total: how many there will be.
        unit: what they are called.
    """
    if total < WORTH_A_BAR or not sys.stderr.isatty():
        yield from items
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, ProgressColumn, TextColumn, TimeRemainingColumn
    from rich.text import Text

    class Rate(ProgressColumn):
        def render(self, task: "Task") -> Text:
            return Text("" if task.speed is None else f"{task.speed:.0f}/s")

    columns = (BarColumn(), MofNCompleteColumn(), TextColumn(unit), Rate(), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        yield from bar.track(items, total=total)
