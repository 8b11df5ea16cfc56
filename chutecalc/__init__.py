"""Lumped-mass continuum model of transfer chutes: how fast and how deep the stream runs, and where it fails.

>>> import chutecalc
>>> chutecalc.solve(chutecalc.parse(chutecalc.STARTER)).status
array(['ok'], dtype='<U12')
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from chutecalc.api.batch import exits
    from chutecalc.api.chute import Chute, load, parse, solve
    from chutecalc.api.solution import Solution
    from chutecalc.errors import ChutecalcError, Fault, SpecError, UsageError
    from chutecalc.results.exits import Exits
    from chutecalc.spec.starter import STARTER

__all__ = [
    "STARTER",
    "Chute",
    "ChutecalcError",
    "Exits",
    "Fault",
    "Solution",
    "SpecError",
    "UsageError",
    "__version__",
    "exits",
    "load",
    "parse",
    "solve",
]
__version__ = "0.1.0"

_ROOMS = {
    "STARTER": "chutecalc.spec.starter",
    "Chute": "chutecalc.api.chute",
    "ChutecalcError": "chutecalc.errors",
    "Exits": "chutecalc.results.exits",
    "Fault": "chutecalc.errors",
    "Solution": "chutecalc.api.solution",
    "SpecError": "chutecalc.errors",
    "UsageError": "chutecalc.errors",
    "exits": "chutecalc.api.batch",
    "load": "chutecalc.api.chute",
    "parse": "chutecalc.api.chute",
    "solve": "chutecalc.api.chute",
}


def __dir__() -> list[str]:
    return sorted(__all__)


def __getattr__(name: str) -> Any:
    """Public names are imported when first asked for, so that ``chutecalc --help`` loads nothing."""
    if name not in _ROOMS:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_ROOMS[name]), name)
