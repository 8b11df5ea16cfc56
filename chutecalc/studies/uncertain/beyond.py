"""How likely limits are exceeded, and warnings are told."""

from collections.abc import Sequence

import numpy as np

from chutecalc.design import Status
from chutecalc.studies.limit import Limit, check_column
from chutecalc.studies.uncertain.solved_rows import Rows
from chutecalc.studies.uncertain.statistics import Chance, chance

ANY = "any"
"""Name of all samples together that fail or exceed any limit."""


def exceeded(rows: Rows, limits: Sequence[Limit], source: str) -> dict[str, Chance]:
    """Return the chance that each limit is exceeded, among samples that do not fail; of all, that any is or one fails.

    Args:
        rows: the samples, one replicate after the other, with the columns of the limits.
        limits: what is to hold.
        source: name of the spec, for messages.

    Raises:
        UsageError: no sample that does not fail has the column.
    """
    ok = rows.ends == Status.OK
    found, any_of_them = {}, ~ok
    for limit in limits:
        values = rows.columns[limit.column]
        check_column(source, limit.column, ~np.isnan(values[ok]), f"leave out the limit {limit.text}")
        beyond = limit.is_exceeded(values)
        found[limit.text], any_of_them = chance(beyond, ok), any_of_them | beyond
    return found | ({ANY: chance(any_of_them, np.ones_like(ok))} if limits else {})


def warned(rows: Rows) -> dict[str, Chance]:
    """Return the chance of each warning among samples that do not fail, the most likely first.

    Args:
        rows: the samples, one replicate after the other, with their warnings.
    """
    ok = rows.ends == Status.OK
    found = {code: chance(those, ok) for code, those in rows.warned.items() if (those & ok).any()}
    return dict(sorted(found.items(), key=lambda each: (-each[1].share, each[0])))
