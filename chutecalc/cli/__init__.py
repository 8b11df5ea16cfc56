"""The command line, one file for each command. ``main`` alone prints errors and sets the exit status."""

import os
import sys
import traceback
from collections.abc import Sequence
from importlib import import_module

import typer

from chutecalc import __version__
from chutecalc.cli.command import Command, explained
from chutecalc.cli.streams import finish_streams, prepare_streams
from chutecalc.core import compiled
from chutecalc.errors import ChutecalcError, ExitStatus, SpecError
from chutecalc.interrupt import interrupted
from chutecalc.output.held import release
from chutecalc.printable import abbreviated, printable

COMMANDS = (
    *("new", "run", "sweep", "place", "aim", "optimise", "uncertain", "check", "freeze"),
    *("explain", "schema", "columns", "limits", "dem"),
)
MOST_FAULTS = 1000
"""Faults of specs that are shown."""
HELP = "Compute how a stream of bulk material flows through a transfer chute, by a lumped-mass continuum model."


def _show_version(requested: bool) -> None:
    if requested:
        typer.echo(f"chutecalc {__version__}{'' if compiled() else ' (core not compiled: slower)'}")
        raise typer.Exit()


def _common(
    version: bool = typer.Option(
        False, "--version", callback=_show_version, is_eager=True, help="Show the version and exit."
    ),
) -> None:
    pass


def _app(given: Sequence[str]) -> typer.Typer:
    """Return the commands, or only the one that is called: each takes some milliseconds to set up."""
    called = bool(given) and given[0] in COMMANDS
    app = typer.Typer(
        name="chutecalc",
        rich_markup_mode=None,
        no_args_is_help=True,
        add_completion=not called,  # the shell asks without a command
        context_settings={"help_option_names": ["-h", "--help"]},
    )
    epilog = f"{_block('Exit status:', exit_statuses())}\n\n{documentation('README.md')}"
    app.callback(help=HELP, epilog=epilog)(_common)
    for name in given[:1] if called else COMMANDS:
        module = import_module(f"chutecalc.cli.{name}")
        epilog = f"{_block('Examples:', module.EXAMPLES)}\n\n{documentation(module.PAGE)}"
        settings = getattr(module, "SETTINGS", None)
        app.command(name, cls=Command, epilog=epilog, context_settings=settings)(getattr(module, name))
    return app


def command_line() -> typer.core.TyperGroup:
    """Return all commands with their options, as Typer has them."""
    group = typer.main.get_command(_app([]))
    assert isinstance(group, typer.core.TyperGroup)
    return group


def documentation(page: str) -> str:
    """Return where a help text continues.

    Args:
        page: of the documentation.
    """
    return _block(
        "Documentation:",
        [f"docs/{page} in the source of chutecalc", "chutecalc explain WORD: what a key, column or finding means"],
    )


def exit_statuses() -> list[str]:
    """Return a line for each exit status: its number, and what it means.

    >>> exit_statuses()[-1]
    '130  Interrupted with Ctrl-C.'
    """
    return [f"{status.value:>3}  {status.meaning}" for status in ExitStatus]


def _block(heading: str, lines: Sequence[str]) -> str:
    """Return lines under a heading, as the end of a help text that is not wrapped."""
    return "\n".join(["\b", heading, *(f"  {line}" for line in lines)])


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command line.

    Args:
        arguments: arguments without the name of the program; None for those of the process.

    Returns:
        The exit status, see :class:`chutecalc.errors.ExitStatus`.
    """
    given = list(sys.argv[1:] if arguments is None else arguments)
    debug, given = "--debug" in given, [each for each in given if each != "--debug"]  # of every command
    prepare_streams()
    try:
        status = _app(given)(args=given, prog_name="chutecalc", standalone_mode=False)
        if status == ExitStatus.INTERRUPTED:
            raise KeyboardInterrupt  # Typer has caught it
        sys.stdout.flush()
        return int(status or ExitStatus.OK)
    except typer.TyperException as error:
        return _complain(_explained(error, given), ExitStatus(error.exit_code))
    except SpecError as error:
        more = len(error.args) - MOST_FAULTS
        end = f"\n{more:,} more faults are not shown" if more > 0 else ""
        error.args = error.args[:MOST_FAULTS]
        return _complain(f"{error}{end}", error.exit_status)
    except ChutecalcError as error:
        return _complain(f"chutecalc: {error}", error.exit_status)
    except KeyboardInterrupt:
        return _complain("chutecalc: interrupted", ExitStatus.INTERRUPTED)
    except OSError as error:
        name = printable(error.filename) if isinstance(error.filename, str) else "output"
        reason = error.strerror or abbreviated(printable(str(error)))
        return _complain(f"chutecalc: {name} could not be opened or written: {reason}", ExitStatus.WRITE_FAILED)
    except MemoryError:
        return _complain(
            "chutecalc: there is not enough memory for that. Take fewer designs, samples or stations at once.",
            ExitStatus.USAGE,
        )
    except Exception as error:
        if debug:
            traceback.print_exc()
        if "_CHUTECALC_COMPLETE" in os.environ:
            return ExitStatus.FAILS  # a shell that asks for completions in a wrong way has no use for words
        return _complain(
            f"chutecalc {__version__} failed, which is a fault of the program: {abbreviated(repr(error))}\n"
            "Keep the command, the spec and what it says with --debug added: who maintains your copy of chutecalc needs"
            " them. Another value of what was changed last may get you on meanwhile.",
            ExitStatus.INTERNAL,
        )
    finally:
        release()
        finish_streams()


def _explained(error: typer.TyperException, given: Sequence[str]) -> str:
    """Return what is wrong with a command line; the help, if it is empty."""
    if not given:
        return error.format_message()
    called = next((word for word in given if not word.startswith("-")), "")
    examples = import_module(f"chutecalc.cli.{called}").EXAMPLES if called in COMMANDS else ()
    return abbreviated(printable(f"chutecalc: {explained(error, given, examples, COMMANDS)}"))


def _complain(text: str, status: ExitStatus) -> int:
    """Print an error to standard error, and return its exit status; an interrupt is the reason for what follows it."""
    if interrupted():
        text, status = "chutecalc: interrupted", ExitStatus.INTERRUPTED
    print(text, file=sys.stderr)
    return status
