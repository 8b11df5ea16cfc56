"""Whether steel that several states share stands where only one of them goes."""

from collections.abc import Iterator

import numpy as np

from chutecalc.design import Contact
from chutecalc.results.criterion import Case, criterion
from chutecalc.results.finding import Severity
from chutecalc.results.scene import Written
from chutecalc.solver.steel import enters_vertically, follows_stream


@criterion(
    "placed_by_stream",
    Severity.NOTE,
    summary="the spec has cases, and the stream of the design point alone places segments",
    judges_spec=True,
)
def placed_by_stream(written: Written) -> Iterator[Case]:
    """Find segments without a place of their own, which stand where the stream of the design point comes down.

    Args:
        written: the spec.
    """
    spec, design = written.spec, written.design
    if not spec.cases or spec.model.steel != "fixed":
        return
    followers = [design.segments[number] for number in follows_stream(design, enters_vertically(design))]
    names = [segment.name for segment in followers if isinstance(segment, Contact)]
    if names:
        template = (
            f"{', '.join(names)} {'stands' if len(names) == 1 else 'stand'} where the stream of the design point comes"
            " down, and a slower one falls short: give start_m, further upstream; `chutecalc freeze` writes down the"
            " present place"
        )
        yield Case(np.ones(1, dtype=bool), np.full(1, np.nan), template, key="cases")
