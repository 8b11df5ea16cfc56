"""What a stream is to do where it strikes a segment."""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from chutecalc.errors import UsageError
from chutecalc.fields.quantities import FAR
from chutecalc.fields.units import UNITS, convert, first_unit
from chutecalc.results.column_names import closest

DIMENSIONS = {"incidence": "angle", "x": "length", "z": "length", "share": "number"}
"""Dimension of each wish, by its name without a unit."""
BOUNDS = {"incidence": (0.0, 90.0), "x": (-FAR.most, FAR.most), "z": (-FAR.most, FAR.most), "share": (0.0, 1.0)}
"""Least and greatest value of each; a share of 1 is not allowed, as nothing of the segment would be left."""
EDGES = "edges"
"""The share that lets all edges of the stream strike; with a margin ``edges+0.05``."""


class Wish(NamedTuple):
    """How the middle of the stream is to strike a segment; None for what is left open."""

    incidence_deg: float | None = None
    """Angle between stream and surface, 0 for a stream that comes along it."""
    x_m: float | None = None
    """Where it strikes: x,"""
    z_m: float | None = None
    """or z instead."""
    share: float = 0.0
    """Share of the segment's length from its drawn start that lies before the strike, below 1."""
    edges_margin: float | None = None
    """If the share is to be the least at which all edges of the stream strike the segment: what is added to that."""


def read_wish(segment: str, given: Mapping[str, Any]) -> Wish:
    """Return a wish from its keys.

    Args:
        segment: name of the segment, for messages.
        given: ``incidence``, ``x`` or ``z``, and ``share``, each in its first unit or with a unit, such as ``x_ft``;
            a share may be ``edges``, or ``edges+0.05`` with a margin.

    Raises:
        UsageError: all faults of the keys and values.

    >>> read_wish("hood", {"incidence": 10, "x_mm": 1200, "share": 0.1})
    Wish(incidence_deg=10.0, x_m=1.2, z_m=None, share=0.1, edges_margin=None)
    """
    if not isinstance(given, Mapping):
        raise UsageError(f"{segment}: wishes are keys with numbers, such as incidence and x, not {given!r}")
    found: dict[str, float] = {}
    edges_margin, faults = None, []
    for key, value in given.items():
        name, _, unit = key.partition("_")
        dimension = DIMENSIONS.get(name)
        if dimension is None or unit not in ("", *UNITS[dimension]):
            faults.append(f"{segment}: there is no {key}. {closest([key], DIMENSIONS)}Use {', '.join(DIMENSIONS)}.")
            continue
        if name in found:
            faults.append(f"{segment}: {name} is given twice. Keep one.")
        found[name] = 0.0
        if name == "share" and str(value).startswith(EDGES):
            edges_margin = _number(str(value).removeprefix(EDGES).removeprefix("+") or 0.0)
            if not 0.0 <= edges_margin < 1.0:
                faults.append(f"{segment}: {key} must be {EDGES}, or {EDGES}+0.05 with a margin below 1, not {value}.")
            continue
        number = float(convert(_number(value), dimension, unit or first_unit(dimension), first_unit(dimension)))
        low, high = BOUNDS[name]
        if not low <= number <= high or (name == "share" and number == high):
            share = f"a number, at least 0 and below 1, or {EDGES}"
            bounds = share if name == "share" else f"a number from {low:g} to {high:g}"
            faults.append(f"{segment}: {key} must be {bounds}, not {value}.")
        found[name] = number
    if {"x", "z"} <= found.keys():
        faults.append(f"{segment}: x and z together are one too many: the stream decides the other. Give one of them.")
    if not faults and not {"incidence", "x", "z"} & found.keys():
        faults.append(f"{segment}: nothing is asked. Give incidence=DEG, x=M or z=M, such as incidence=10 x=1.2.")
    if faults:
        raise UsageError(*faults)
    return Wish(found.get("incidence"), found.get("x"), found.get("z"), found.get("share", 0.0), edges_margin)


def read_wishes(arguments: Sequence[str]) -> dict[str, dict[str, float | str]]:
    """Return the wishes that arguments stand for, by segment in order.

    Args:
        arguments: names of segments, each followed by its wishes as ``KEY=NUMBER``, ``share=edges`` or
            ``share=edges+0.05``.

    Raises:
        UsageError: a wish comes before the first segment, a segment is given twice, or a value is not a number.

    >>> read_wishes(["hood", "incidence=10", "x=1.2", "spoon", "incidence=8"])
    {'hood': {'incidence': 10.0, 'x': 1.2}, 'spoon': {'incidence': 8.0}}
    """
    found: dict[str, dict[str, float | str]] = {}
    for argument in arguments:
        key, equals, text = (part.strip() for part in argument.partition("="))
        if not equals:
            if argument in found:
                raise UsageError(f"{argument} is given twice: give all its wishes together")
            found[argument] = {}
            continue
        if not found:
            raise UsageError(f"{argument}: name the segment first, such as hood {argument}")
        wishes = found[next(reversed(found))]
        if key in wishes:
            raise UsageError(f"{argument}: {key} is given twice. Keep one")
        if text.startswith(EDGES):
            wishes[key] = text
            continue
        try:
            wishes[key] = float(text)
        except ValueError:
            raise UsageError(f"{argument} is not one number: give {key} one, such as {key}=0.2") from None
    return found


def _number(value: Any) -> float:
    """Return a value as a number, NaN for what is none: it is within no bounds."""
    try:
        return float(value)
    except (TypeError, ValueError):
        return float("nan")
