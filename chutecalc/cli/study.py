"""What commands share that look for designs: their arguments, and the spec that they write."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import typer

from chutecalc.cli.outputs import Outputs
from chutecalc.errors import UsageError
from chutecalc.output.held import reserve

if TYPE_CHECKING:
    from chutecalc.studies.found import Found

ARGUMENTS = typer.Argument(
    ...,
    metavar="SPEC KEY=LOW:HIGH...",
    help="A spec (.toml, or - for standard input), and the keys that may change: paths or short names as in sweep.",
)
CASE = typer.Option(None, metavar="NAME", help="One operating state of [cases]; design for the spec as written.")
COLUMNS = typer.Option(None, metavar="NAMES", help="Columns to show, separated by commas, as in sweep.")
WRITE = typer.Option(False, "--write", help="Put the solution into the spec file; comments stay.")
TAKE = typer.Option(None, min=1, metavar="N", help="Which of several solutions --write takes.")


class StudyOutputs(Outputs):
    """Outputs of a search for designs."""

    has_units = True


def spec_and_keys(arguments: Sequence[str]) -> tuple[str, list[str]]:
    """Return the spec and the keys among arguments.

    Args:
        arguments: in any order.

    Raises:
        UsageError: there is not one spec.

    >>> spec_and_keys(["radius=1:4", "chute.toml"])
    ('chute.toml', ['radius=1:4'])
    """
    specs = [argument for argument in arguments if argument == "-" or argument.endswith(".toml")]
    if len(specs) != 1:
        raise UsageError(f"name one spec (.toml, or - for standard input), not {', '.join(specs) or 'none'}")
    return specs[0], [argument for argument in arguments if argument not in specs]


def check_writing(spec: str, write: bool, take: int | None) -> None:
    """Check that a solution can be written, and keep others from writing. Call it before the spec is read.

    Args:
        spec: name of its file.
        write: whether to write.
        take: which solution to write.

    Raises:
        UsageError: the spec is no file, or there is nothing to take a solution for.
        OutputError: it cannot be written, or another process is writing it.
    """
    if take is not None and not write:
        raise UsageError("--take says what --write takes: add --write")
    if write and spec == "-":
        raise UsageError("--write needs a spec in a file, not standard input")
    if write:
        reserve(spec)


def number_of(option: str, text: str, value: str) -> float:
    """Return the number in the value of an option.

    Args:
        option: its name.
        text: what was given, for the message.
        value: the part that is to be a number.

    Raises:
        UsageError: it is no finite number.

    >>> number_of("--target", "exit_velocity_m_s=4", "4")
    4.0
    """
    import math

    try:
        number = float(value)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise UsageError(f"{option} {text}: {value.strip() or 'nothing'} is not a number")
    return number


def write_solution(found: Found, write: bool, take: int | None, quiet: bool = False) -> None:
    """Write a solution into the spec file, if that is wanted and there is any.

    Args:
        found: the solutions.
        write: whether it is wanted.
        take: which of several.
        quiet: whether to say nothing of it.

    Raises:
        UsageError: there are several and it is not said which, or there is no such one. All else is delivered by then.
    """
    if write and found.count:
        try:
            found.write(take=take)
        except UsageError as error:
            raise UsageError(f"nothing written into {found.chute.source}: {error}") from None
        if not quiet:
            from tomlkit import item

            from chutecalc.output.printer import Printer

            written = (f"{path} = {item(value).as_string()}" for path, value in found.changes(take).items())
            Printer().prose(f"wrote {', '.join(written)}")
