"""Numbers by which the operating states of a chute are compared."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.results.belts import RECEIVER_COLUMNS
from chutecalc.results.column import Column
from chutecalc.results.columns import COLUMNS
from chutecalc.results.extremes import LARGEST, LEAST
from chutecalc.results.impacts import IMPACT_COLUMNS
from chutecalc.results.loads import LOAD_COLUMNS
from chutecalc.results.solved import SolvedChute


class Measure(NamedTuple):
    """A number by which operating states are compared."""

    column: Column
    of: Callable[[SolvedChute], Array | None]
    """Returns its values for a solution, shape (designs,); None where it has none."""
    badness: Any
    """Function of its values, the larger the worse; None where neither direction is."""


def _exit(name: str) -> Measure:
    column = replace(COLUMNS[name], name=f"exit_{name}", heading=f"exit {COLUMNS[name].heading}")
    return Measure(column, lambda solution: solution.exit_columns((name,))[name], None)


def _extreme(sign: float, numbers: str, column: Column, prefix: str = "", heading: str = "") -> Measure:
    """Return the least or largest value over all surfaces of a number of their results, such as of ``impact``."""
    which, extreme, worse = ("max", np.fmax, np.positive) if sign == LARGEST else ("min", np.fmin, np.negative)
    name, heading = f"{which}_{prefix}{column.name}", heading or f"{which} {column.heading}"

    def of(solution: SolvedChute) -> Array | None:
        found = [getattr(result, numbers) for result in solution.trajectory.results if result.loads]
        values = [each[column.name] for each in found if column.name in each]
        return extreme.reduce(values) if values else None

    return Measure(replace(column, name=name, heading=heading), of, worse)


def _received(name: str, badness: Any) -> Measure:
    column = replace(RECEIVER_COLUMNS[name], name=f"receiver_{name}")
    return Measure(column, lambda solution: solution.receiver.get(name), badness)


MEASURES = (
    _exit("velocity_m_s"),
    _extreme(LEAST, "minimum", COLUMNS["velocity_m_s"]),
    _extreme(LARGEST, "maximum", COLUMNS["depth_m"]),
    _extreme(LARGEST, "maximum", COLUMNS["fill"]),
    _extreme(LARGEST, "maximum", COLUMNS["pressure_kpa"]),
    _extreme(LARGEST, "impact", IMPACT_COLUMNS["pressure_kpa"], "impact_", "impact pressure"),
    _extreme(LARGEST, "maximum", COLUMNS["wear_w_m2"]),
    _extreme(LARGEST, "impact", IMPACT_COLUMNS["wear_w_m2"], "impact_", "impact wear"),
    _extreme(LEAST, "loads", LOAD_COLUMNS["liner_life_h"]),
    _received("velocity_ratio", lambda ratio: np.abs(ratio - 1.0)),
    _received("velocity_into_m_s", np.positive),
)
"""What states are compared by, in this order."""
