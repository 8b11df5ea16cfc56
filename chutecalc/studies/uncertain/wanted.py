"""The columns of a study of uncertainty: those asked for, those of limits, and those that tell margins."""

from collections.abc import Iterable

from chutecalc.api.chute import Chute
from chutecalc.design import Contact
from chutecalc.errors import UsageError
from chutecalc.studies.limit import Limit
from chutecalc.studies.sweep.checks import DEFAULT_ON_BELT
from chutecalc.studies.sweep.columns import row_columns

AT_EXIT = ("exit_velocity_m_s", "exit_depth_m")
"""Columns by default, beside those of a receiving belt: what the end of the chute tells, in microseconds a sample."""
MARGINS = ("min_velocity_m_s", "max_fill", "min_normal_acceleration_m_s2")
"""What is left before a stream stalls, chokes or loses contact: these are 0, 1 and 0 then."""


def wanted_columns(chute: Chute, columns: Iterable[str], margins: bool, limits: Iterable[Limit]) -> list[str]:
    """Return the names of the columns of a study, each once.

    Args:
        chute: the chute.
        columns: asked for; empty for those by default.
        margins: whether those of :data:`MARGINS` are, and where the stream lands on segments.
        limits: asked for.

    Raises:
        UsageError: a column is text.

    >>> import chutecalc
    >>> wanted_columns(chutecalc.parse(chutecalc.STARTER), ["exit_x_m"], True, [])[-2:]
    ['min_normal_acceleration_m_s2', 'segments.spoon.landing_margin_m']
    """
    names = list(columns) or [*AT_EXIT, *(DEFAULT_ON_BELT if chute.spec.receiver else ())]
    if margins:
        surfaces = [segment.name for segment in chute.design.segments if isinstance(segment, Contact)]
        names += [*MARGINS, *(f"segments.{name}.landing_margin_m" for name in surfaces)]
    names += [limit.column for limit in limits]
    known = row_columns()
    if text := [name for name in names if name.endswith(".status") or (name in known and not known[name].dimension)]:
        raise UsageError(f"{text[0]} is no number: use columns such as exit_velocity_m_s")
    return list(dict.fromkeys(names))
