"""Options that several commands share, or that one command takes as one object.

A group of options is a class. A command has it as the type of a parameter, and :func:`with_groups` shows Typer the
options instead.
"""

import inspect
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, get_type_hints

import typer

from chutecalc.errors import UsageError

if TYPE_CHECKING:
    from chutecalc.results.solved import SolvedChute

RTOL = typer.Option(1e-10, min=1e-13, max=1e-3, metavar="R", help="Relative tolerance of the velocity.")
DASK = typer.Option(
    None, metavar="ADDRESS", help="Solve on the workers of a Dask scheduler, such as tcp://10.0.0.1:8786 (needs Dask)."
)
LIBRARY = typer.Option(
    None,
    "--library",
    metavar="FILE",
    help="Materials and liners that specs use by name. Default: chute-library.toml beside the spec.",
)
JOBS = typer.Option(None, min=1, metavar="N", help="Number of jobs at once. Default: one for each processor.")


def names_of(text: str | None) -> list[str]:
    """Return the names of an option that takes several, each once.

    Args:
        text: names between commas, or None.

    >>> names_of("depth_m, s_m"), names_of(None)
    (['depth_m', 's_m'], [])
    """
    return list(dict.fromkeys(name.strip() for name in text.split(","))) if text else []


def option(name: str, kind: Any, default: Any) -> inspect.Parameter:
    """Return a parameter that Typer makes an option or an argument of.

    Args:
        name: of the parameter.
        kind: its type.
        default: its default, a ``typer.Option`` or ``typer.Argument``.
    """
    return inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=kind)


class OptionGroup:
    """Base of groups: a dataclass, each of whose fields has an option as its default."""

    @classmethod
    def parameters(cls) -> list[inspect.Parameter]:
        """Return the options as parameters of a function."""
        hints = get_type_hints(cls)
        return [
            option(each.name, hints[each.name], each.default)
            for each in fields(cls)  # type: ignore[arg-type]  # every subclass is a dataclass, or has its own method
        ]


@dataclass(frozen=True, eq=False)
class StationOptions(OptionGroup):
    """Stations along the stream that a user asks for."""

    points: int | None = typer.Option(None, min=2, metavar="N", help="Report N stations along each segment.")
    stations: float | None = typer.Option(None, metavar="D", help="Report stations every D metres along each segment.")

    def __post_init__(self) -> None:
        if self.points is not None and self.stations is not None:
            raise UsageError("--points and --stations exclude each other: give one of them")
        if self.stations is not None and not 0.0 < self.stations < math.inf:
            raise UsageError(f"--stations must be a length greater than 0 m, and finite, not {self.stations:g}")

    @property
    def given(self) -> bool:
        """Whether there are any."""
        return self.points is not None or self.stations is not None

    def of(self, solution: "SolvedChute", columns: Sequence[str]) -> dict[str, Any]:
        """Return the stations of a solution.

        Args:
            solution: of one or several designs.
            columns: names of the columns to work out.
        """
        return solution.stations(self.points, self.stations, columns)


def with_groups(command: Callable[..., int]) -> Callable[..., int]:
    """Return a command for Typer that takes the options of groups instead of the groups.

    Args:
        command: function whose parameters are arguments and options of Typer, or typed as an :class:`OptionGroup`.
    """
    hints = get_type_hints(command)
    groups: dict[str, tuple[type[OptionGroup], list[str]]] = {}
    parameters: list[inspect.Parameter] = []
    for parameter in inspect.signature(command).parameters.values():
        kind = hints[parameter.name]
        if isinstance(kind, type) and issubclass(kind, OptionGroup):
            options = kind.parameters()
            groups[parameter.name] = kind, [option.name for option in options]
            parameters += options
        else:
            parameters.append(option(parameter.name, kind, parameter.default))

    def called(**values: Any) -> int:
        taken = {name: kind(**{key: values.pop(key) for key in keys}) for name, (kind, keys) in groups.items()}
        return command(**values, **taken)

    called.__name__, called.__doc__ = command.__name__, command.__doc__
    called.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    called.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]  # Typer reads it
    return called
