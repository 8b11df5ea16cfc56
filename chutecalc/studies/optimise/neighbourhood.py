"""The designs around an optimum over one or two keys: the objective in the worst state, and what is excluded."""

from typing import Any, NamedTuple

import numpy as np

from chutecalc.design import Status
from chutecalc.errors import UsageError
from chutecalc.output.dataset import Block
from chutecalc.physics.arrays import Array, Mask
from chutecalc.results.described import status_words
from chutecalc.studies.optimise.optimum import Optimum
from chutecalc.studies.sweep.parameters import Parameter
from chutecalc.studies.sweep.plot_status import LOOKS
from chutecalc.studies.sweep.sweep import Sweep
from chutecalc.studies.variants import Variants

GRID, LINE = 33, 201
"""Values of each of two keys, and of a single one."""
REACH = 0.25
"""Distance from the best, as a share of the bounds, up to which the neighbourhood goes."""


class Neighbourhood(NamedTuple):
    """Designs around an optimum, all combinations of the values of one or two keys."""

    sweep: Sweep
    """Of the keys, for their names and values; not solved."""
    worst: Array
    """The objective of each design in its worst state, in the unit of its column; NaN where a state fails."""
    state: Array
    """Number of that state, shape (designs,)."""
    fails: dict[str, Mask]
    """Designs that fail in any state, by status, as masks of shape (designs,)."""
    texts: dict[str, str]
    """Each of these statuses with the states in which designs end so, in words."""
    margins: dict[str, Array]
    """Distance from each limit in the state that is closest to it or breaks it most, in the unit of its column:
    negative where the design is excluded; by the limit in words. Of warnings -1 for designs that have any, else 1."""
    best: list[float]
    """Values of the keys at the optimum."""


def neighbourhood(found: Optimum) -> Neighbourhood:
    """Solve designs around the best one, over its first two keys of numbers, all other keys as they are best.

    Args:
        found: an optimum of one objective.

    Raises:
        UsageError: no key is a number.
    """
    varied = [key for key in found.keys if key.is_continuous][:2]
    if not varied:
        raise UsageError("a picture of an optimum needs a key with bounds, KEY=LOW:HIGH")
    count = LINE if len(varied) == 1 else GRID
    parameters, best = [], []
    for key in varied:
        (low, high), value = key.bounds, float(found.values[key.name][0])
        reach = REACH * (high - low)
        values = np.linspace(max(low, value - reach), min(high, value + reach), count)
        parameters.append(Parameter(key.name, key.parameter.paths, values))
        best.append(value)
    objective, drawn = found.objectives[0], found.chute.put(found.changes())
    names = [objective.column, *(limit.column for limit in found.limits), *(["warnings"] if found.no_warnings else [])]
    grid = np.meshgrid(*(each.values for each in parameters), indexing="ij")
    block = Variants(drawn, parameters, list(dict.fromkeys(names)), found.states)([each.ravel() for each in grid])
    values = objective.sign * block[objective.column]
    known = np.isfinite(values).all(axis=0) & (block["status"] == Status.OK_LABEL).all(axis=0)
    fails, texts = _failing(found, block)
    return Neighbourhood(
        sweep=Sweep(drawn, parameters, columns=[objective.column]),
        worst=np.where(known, objective.sign * np.where(known, values, 0.0).max(axis=0), np.nan),
        state=np.where(known, values, 0.0).argmax(axis=0),
        fails=fails,
        texts=texts,
        margins=_margins(found, block),
        best=best,
    )


def _failing(found: Optimum, block: Block) -> tuple[dict[str, Mask], dict[str, str]]:
    """Return the designs that fail by status, and each status with its states in words."""
    fails, texts = {}, {}
    for status in LOOKS:
        those = block["status"] == status
        if those.any():
            fails[status] = those.any(axis=0)
            texts[status] = _in_states(f"fails: {status_words(status)}", found.states, those.any(axis=1))
    return fails, texts


def _margins(found: Optimum, block: Block) -> dict[str, Array]:
    """Return how far designs are from each limit, by the limit in words."""
    margins = {}
    for limit in found.limits:
        own = limit.margin(block[limit.column])
        own[np.isnan(own) & (block["status"] == Status.OK_LABEL)] = np.inf  # what does not exist keeps a limit
        if (own < 0.0).any():
            broken = f"{limit.column} {'>' if limit.sign > 0 else '<'} {limit.value:g}"
            margins[_in_states(broken, found.states, (own < 0.0).any(axis=1))] = own.min(axis=0)
    warned = block["warnings"] != "" if found.no_warnings else np.zeros(block["status"].shape, dtype=bool)
    if warned.any():
        codes = dict.fromkeys(" ".join(block["warnings"][warned].tolist()).split())
        text = _in_states(f"warnings ({', '.join(codes)})", found.states, warned.any(axis=1))
        margins[text] = np.where(warned.any(axis=0), -1.0, 1.0)
    return margins


def _in_states(text: str, states: tuple[str, ...], those: Any) -> str:
    """Return text with the states that it is about, of several."""
    named = [state for state, is_one in zip(states, those, strict=True) if is_one]
    if len(states) == 1:
        return text
    return f"{text} in {', '.join(named) if len(named) < len(states) else 'all cases'}"
