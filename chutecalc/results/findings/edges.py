"""Edges of a stream that do not land where it does."""

from collections.abc import Iterator

import numpy as np

from chutecalc.results.criterion import Case, criterion
from chutecalc.results.finding import Severity
from chutecalc.results.scene import Scene


@criterion(
    "edge_misses", Severity.WARNING, summary="an edge of the stream misses the segment on which the stream lands"
)
def edge_misses(scene: Scene) -> Iterator[Case]:
    """Find edges of a stream in flight that do not land on the segment on which the line lands that is solved.

    Args:
        scene: the segment with the stream along it.
    """
    for edge in scene.edges:
        misses = edge.misses & (edge.target == scene.solved.number)
        begin, numbers = f"the {edge.name} edge of the stream misses the segment on which its middle lands: it ", {}
        if edge.leaves:
            begin = (
                f"the free surface of the stream, which leaves {edge.leaves} {{depth_m:in}} deep, misses the segment on"
                " which the stream lands: it "
            )
            numbers = {"depth_m": edge.numbers["depth_m"]}
        gap, before = edge.numbers["gap_m"], edge.numbers["before_m"]
        elsewhere, short = edge.segment != "", before > 0.0
        earlier = "begin the segment earlier or move it"
        for mask, fate, more in (
            (gap > 0.0, "passes {gap_m} beyond its end; make the segment longer or move it", {"gap_m": gap}),
            (~(gap > 0.0) & short, f"passes {{before_m}} before its start; {earlier}", {"before_m": before}),
            ((gap <= 0.0) & ~short, f"passes {{gap_m}} behind its end; {earlier}", {"gap_m": -gap}),
            (elsewhere, "lands on another one; move that out of its way", {}),
            (~elsewhere & ~short & np.isnan(gap), "never reaches it; move it towards the stream", {}),
        ):
            badness = next(iter(more.values()), 0.0)
            yield Case(misses & mask, edge.s_m, begin + fate, numbers | more, badness=badness)
