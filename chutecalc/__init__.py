"""Lumped-mass continuum model of transfer chutes: how fast and how deep the stream runs, and where it fails.

>>> import chutecalc
>>> chute = chutecalc.parse(chutecalc.STARTER)
>>> solution = chutecalc.solve(chute)
>>> solution
<Solution: ok, leaves spoon at 6.222 m/s, 0.09396 m deep>
>>> round(float(solution.segments["spoon"].maximum["velocity_m_s"][0]), 3)
6.607

Many variants are solved together:

>>> variants = chute.vary({"segments.spoon.radius_m": [2.0, 3.0]})
>>> chutecalc.solve(variants).exit_velocity.round(3)
array([5.603, 6.222])
"""

from __future__ import annotations

from importlib import import_module

TYPE_CHECKING = False  # as that of typing, which takes longer to import than all else before a command begins
if TYPE_CHECKING:
    from typing import Any

    from chutecalc.api.band import solve_band
    from chutecalc.api.batch import exits
    from chutecalc.api.cases import solve_cases
    from chutecalc.api.chute import Chute
    from chutecalc.api.freeze import freeze
    from chutecalc.api.function import Function
    from chutecalc.api.load import load, parse
    from chutecalc.api.report import write_report
    from chutecalc.api.solution import Solution
    from chutecalc.api.solve import solve
    from chutecalc.errors import ChutecalcError, ExtraMissingError, Fault, SpecError, UsageError
    from chutecalc.results.band import Band
    from chutecalc.results.cases import Cases
    from chutecalc.results.edges import Edge
    from chutecalc.results.exits import Exits
    from chutecalc.results.finding import Finding
    from chutecalc.results.segments import SegmentResult
    from chutecalc.spec.starter import STARTER
    from chutecalc.studies.aim.aim import Aim, aim
    from chutecalc.studies.optimise.optimise import optimise
    from chutecalc.studies.optimise.optimum import Optimum
    from chutecalc.studies.place.placement import Placement, place
    from chutecalc.studies.sensitivity.study import sensitivity
    from chutecalc.studies.uncertain.study import uncertain

__all__ = [
    "STARTER",
    "Aim",
    "Band",
    "Cases",
    "Chute",
    "ChutecalcError",
    "Edge",
    "Exits",
    "ExtraMissingError",
    "Fault",
    "Finding",
    "Function",
    "Optimum",
    "Placement",
    "SegmentResult",
    "Solution",
    "SpecError",
    "UsageError",
    "__version__",
    "aim",
    "exits",
    "freeze",
    "load",
    "optimise",
    "parse",
    "place",
    "sensitivity",
    "solve",
    "solve_band",
    "solve_cases",
    "uncertain",
    "write_report",
]
__version__ = "0.1.0"

_MODULES = {
    "STARTER": "chutecalc.spec.starter",
    "Aim": "chutecalc.studies.aim.aim",
    "Band": "chutecalc.results.band",
    "Cases": "chutecalc.results.cases",
    "Chute": "chutecalc.api.chute",
    "ChutecalcError": "chutecalc.errors",
    "Edge": "chutecalc.results.edges",
    "Exits": "chutecalc.results.exits",
    "ExtraMissingError": "chutecalc.errors",
    "Fault": "chutecalc.errors",
    "Finding": "chutecalc.results.finding",
    "Function": "chutecalc.api.function",
    "Optimum": "chutecalc.studies.optimise.optimum",
    "Placement": "chutecalc.studies.place.placement",
    "SegmentResult": "chutecalc.results.segments",
    "Solution": "chutecalc.api.solution",
    "SpecError": "chutecalc.errors",
    "UsageError": "chutecalc.errors",
    "aim": "chutecalc.studies.aim.aim",
    "exits": "chutecalc.api.batch",
    "freeze": "chutecalc.api.freeze",
    "load": "chutecalc.api.load",
    "optimise": "chutecalc.studies.optimise.optimise",
    "parse": "chutecalc.api.load",
    "place": "chutecalc.studies.place.placement",
    "sensitivity": "chutecalc.studies.sensitivity.study",
    "solve": "chutecalc.api.solve",
    "solve_band": "chutecalc.api.band",
    "solve_cases": "chutecalc.api.cases",
    "uncertain": "chutecalc.studies.uncertain.study",
    "write_report": "chutecalc.api.report",
}
"""Where each public name is defined."""


def __dir__() -> list[str]:
    return sorted(__all__)


def __getattr__(name: str) -> Any:
    """Import public names when they are first used, so that ``chutecalc --help`` loads nothing."""
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_MODULES[name]), name)
