"""A chute as a spec whose steel no longer depends on the stream."""

import numpy as np

from chutecalc.api.chute import Chute, check_chute
from chutecalc.api.written import text_of
from chutecalc.design import Contact
from chutecalc.errors import UsageError
from chutecalc.fields.units import same_quantity
from chutecalc.physics.arrays import Array
from chutecalc.spec.frozen import Drawn, frozen_text

DECIMALS = 12
"""Decimals of written places, m and degrees."""
FROM_SLOPE = same_quantity("from_slope_deg")


def freeze(chute: Chute) -> str:
    """Return the spec of a chute with every place and slope explicit, as drawn at its design point.

    Args:
        chute: a chute of one design. One that was read from text keeps its comments.

    Returns:
        TOML text.

    Raises:
        UsageError: the stream of the design point does not get to all segments, or the chute has several designs.

    >>> import chutecalc
    >>> text = chutecalc.freeze(chutecalc.parse(chutecalc.STARTER))
    >>> lines = [line.partition("#")[0].strip() for line in text.splitlines()]
    >>> [line for line in lines if line.startswith(("onto_next", "start_m", "from_slope"))]
    ['onto_next = true', 'start_m = [0.0, -2.0]', 'from_slope_deg = 90.0']
    """
    check_chute(chute)
    if chute.count != 1:
        raise UsageError(f"freeze takes a chute of one design, not {chute.count}")
    steel = chute.drawing.steel_for()
    drawn, unknown = {}, []
    for number, segment in enumerate(chute.design.segments):
        if not isinstance(segment, Contact):
            continue
        place = steel.get(number)
        fixed = None if place is None else place.start
        start = None if fixed is None else tuple(_written(number) for number in fixed)
        slope = segment.entry_slope if place is None or place.slope is None else place.slope
        turns = None if segment.radius is None else slope
        if not np.isfinite([*(start or ()), *np.ravel(turns if turns is not None else 0.0)]).all():
            unknown.append(segment.name)
        given = any(key in chute.data["segments"][number] for key in FROM_SLOPE)
        slopes = {} if given or turns is None else {FROM_SLOPE[0]: _written(np.degrees(turns))}
        drawn[number] = Drawn(start, slopes)
    if unknown:
        raise UsageError(
            f"{chute.source}: the stream does not get to {', '.join(unknown)} at the design point, so it is not known"
            " where that is drawn. Correct the chute first, or give start_m."
        )
    return frozen_text(text_of(chute), drawn)


def _written(number: Array) -> float:
    """Return a number of a place as the spec has it; its rounding is less than what a stream may be off a start."""
    return round(number.item(), DECIMALS) + 0.0
