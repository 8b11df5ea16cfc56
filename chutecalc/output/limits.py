"""The table of the limits of findings."""

from chutecalc.output.grid import Grid
from chutecalc.spec.limits import LIMITS


def limits_table() -> Grid:
    """Return a row for each limit: its key, default, finding, source and meaning.

    >>> limits_table().rows[0][:4]
    ('max_impact_angle_deg', '20°', 'steep_impact', 'rule of thumb')
    """
    table = Grid()
    for heading in ("key", "default", "finding", "source", "meaning"):
        table.column(heading, left=True, label=heading == "key", words=heading == "meaning")
    for limit in LIMITS.values():
        table.row([limit.key, limit.text, limit.finding, limit.source, limit.meaning])
    return table
