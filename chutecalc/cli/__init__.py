"""The command line: one thin file a command. ``main`` alone prints errors and sets the exit status."""

import io
import os
import sys
import traceback
from collections.abc import Sequence
from importlib import import_module

import typer

from chutecalc import __version__
from chutecalc.core import compiled
from chutecalc.errors import ChutecalcError, ExitStatus, SpecError

COMMANDS = ("run", "sweep", "check", "dem", "new", "schema", "columns")
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
    app = typer.Typer(
        name="chutecalc",
        rich_markup_mode=None,
        no_args_is_help=True,
        add_completion=False,
        context_settings={"help_option_names": ["-h", "--help"]},
    )
    app.callback(help=HELP, epilog=_block("Exit status:", exit_statuses()))(_common)
    for name in given[:1] if given and given[0] in COMMANDS else COMMANDS:
        module = import_module(f"chutecalc.cli.{name}")
        app.command(name, epilog=_block("Examples:", module.EXAMPLES))(getattr(module, name))
    return app


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
    """Runs a command line.

    Args:
        arguments: without the program's name; those of the process where none are given.

    Returns:
        The exit status, see :class:`chutecalc.errors.ExitStatus`.
    """
    given = list(sys.argv[1:] if arguments is None else arguments)
    _speak_unicode()
    try:
        status = _app(given)(args=given, prog_name="chutecalc", standalone_mode=False)
        if status == ExitStatus.INTERRUPTED:
            raise KeyboardInterrupt  # Typer has caught it
        sys.stdout.flush()
        return int(status or ExitStatus.OK)
    except (BrokenPipeError, SystemExit):
        # Whoever read our output has had enough; Typer makes SystemExit of it. Python would complain again at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return ExitStatus.OK
    except typer.TyperException as error:
        return _complain(error.format_message(), ExitStatus(error.exit_code))
    except SpecError as error:
        return _complain(str(error), error.exit_status)
    except ChutecalcError as error:
        return _complain(f"chutecalc: {error}", error.exit_status)
    except KeyboardInterrupt:
        return _complain("chutecalc: interrupted", ExitStatus.INTERRUPTED)
    except OSError as error:
        return _complain(f"chutecalc: the output could not be written: {error.strerror}", ExitStatus.WRITE_FAILED)
    except Exception as error:
        if "--debug" in given:
            traceback.print_exc()
        return _complain(
            f"a fault of the program, version {__version__}: {error!r}\n"
            "Please report it with the command and the spec; --debug shows where it happened.",
            ExitStatus.INTERNAL,
        )


def _speak_unicode() -> None:
    """Data leave in UTF-8 whatever the locale says; a terminal that cannot show a character shows another."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:  # closed before we began
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115 - stays open to the end
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper) and stream.encoding.lower().replace("-", "") != "utf8":
            if stream.isatty():
                stream.reconfigure(errors="replace")
            else:
                stream.reconfigure(encoding="utf-8")


def _complain(text: str, status: ExitStatus) -> int:
    """Says on standard error what is wrong. Faults of specs and usage texts say themselves what they are about."""
    print(text, file=sys.stderr)
    return status
