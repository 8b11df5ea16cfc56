"""A command of Typer, with help, checks and messages in this project's words."""

import re
from collections.abc import Sequence
from difflib import get_close_matches
from itertools import pairwise
from typing import Any

import typer
from typer.core import TyperCommand

from chutecalc.errors import UsageError
from chutecalc.printable import abbreviated

MOST_SHOWN = 60
"""Characters of a value that a message shows."""


class Command(TyperCommand):
    """A command whose options are given once, and whose help shows arguments as they are written."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Parse the arguments, once no option of a single value is given twice.

        Args:
            ctx: Typer's context.
            args: arguments of the command.

        Raises:
            UsageError: an option is given twice, or its value is empty.
        """
        before = [word.partition("=")[0] for word in (args[: args.index("--")] if "--" in args else args)]
        for option in self.get_params(ctx):
            single = option.param_type_name == "option" and option.nargs == 1 and not _repeatable(option)
            if single and sum(before.count(name) for name in option.opts) > 1:
                raise UsageError(f"{option.opts[0]} is given twice. Give it once.")
            empty = {f"{name}=" for name in option.opts}.intersection(args)
            if empty or any(word in option.opts and following == "" for word, following in pairwise(args)):
                raise UsageError(f"{option.opts[0]} needs a value after it, which is empty.")
        return super().parse_args(ctx, args)

    def collect_usage_pieces(self, ctx: Any) -> list[str]:
        """Return the pieces of the usage line, without Typer's braces around what is required, and with dots once.

        Args:
            ctx: Typer's context.
        """
        pieces = [re.sub(r"\.\.\.([]}])\.\.\.$", r"...\1", piece) for piece in super().collect_usage_pieces(ctx)]
        return [re.sub(r"^\{(.*)\}(\.\.\.)?$", r"\1", piece) for piece in pieces]

    def format_options(self, ctx: Any, formatter: Any) -> None:
        """Write the arguments without their Python types, and the options under their headings.

        Args:
            ctx: Typer's context.
            formatter: takes the text.
        """
        sections: dict[str, list[tuple[str, str]]] = {}
        for param in self.get_params(ctx):
            name, text = param.get_help_record(ctx) or ("", "")
            is_argument = param.param_type_name == "argument"
            heading = getattr(param, "rich_help_panel", None) or ("Arguments" if is_argument else "Options")
            sections.setdefault(heading, []).append((name.partition(" <")[0] if is_argument else name, text))
        for heading, rows in sections.items():
            with formatter.section(heading):
                formatter.write_dl(rows)


def _repeatable(option: Any) -> bool:
    """Return whether an option may be given several times: it collects its values, or is a switch."""
    return bool(option.multiple or option.is_flag or option.count)


def explained(
    error: typer.TyperException, given: Sequence[str], examples: Sequence[str], commands: Sequence[str]
) -> str:
    """Return what is wrong with a command line, and what to do.

    Args:
        error: raised by Typer.
        given: the arguments.
        examples: of the command that was called; empty if there is no such command.
        commands: names of all commands.
    """
    param, message = getattr(error, "param", None), error.format_message()
    if param is not None:
        name = param.metavar if param.param_type_name == "argument" else param.opts[0]
        if type(error).__name__ == "MissingParameter":
            return f"{name.split('.')[0]} is missing. For example: {examples[0]}"
        return f"{name} {_worded(error)}"
    if found := re.match(r"No such command '(.*?)'\.", message, re.DOTALL):
        close = get_close_matches(found[1], commands, n=1)
        if found[1].endswith(".toml"):
            remedy = f"To solve a chute: chutecalc run {found[1]}"
        else:
            remedy = f"Did you mean {close[0]}?" if close else f"Use {', '.join(commands[:-1])} or {commands[-1]}."
        return f"there is no command {found[1]}. {remedy}"
    if message == "Missing command.":
        return f"give a command: {', '.join(commands[:-1])} or {commands[-1]}."
    called = ["chutecalc", *(word for word in given[:1] if word in commands)]
    option = getattr(error, "option_name", None)
    if option and message.startswith("No such option"):
        close = list(getattr(error, "possibilities", None) or ())
        if word := next((word for word in given if re.match(rf"{re.escape(option)}\w", word)), None):
            return f"there is no option {word}. Names of options have two minus signs: -{word}."
        remedy = f"Did you mean {' or '.join(close)}?" if close else f"{' '.join(called)} --help lists the options."
        return f"there is no option {option}. {remedy}"
    if option and "requires an argument" in message:
        return f"{option} needs a value after it."
    if option and "does not take a value" in message:
        return f"{option} takes no value. Write {option} alone."
    if found := re.fullmatch(r"Got unexpected extra argument\(?s?\)? \((.*)\)", message):
        return f"{found[1]} is more than the command takes. For example: {examples[0]}"
    return message


def _worded(error: Any) -> str:
    """Return what is wrong with the value of an option, as the end of a sentence.

    Depending on the version of Typer, the value is in an error of pydantic, or at the beginning of the message.
    """
    message, param = error.message, error.param
    causes, named = getattr(error.__cause__, "errors", None), re.match(r"(?:Value error, )?'?(.*?)'? is not ", message)
    value = named[1] if named else causes(include_url=False)[0]["input"] if causes else ""
    shown = abbreviated(value, MOST_SHOWN)
    holder = param if hasattr(param, "min") else param.type
    low, high = getattr(holder, "min", None), getattr(holder, "max", None)
    if re.search("greater than|less than|in the range", message):
        one_sided = f"at most {high:g}" if low is None else f"at least {low:g}"
        bound = one_sided if None in (low, high) else f"from {low:g} to {high:g}"
        return f"must be {bound}, not {shown if len(value) > MOST_SHOWN else format(float(value), 'g')}."
    if re.search("valid int|as an int", message):
        return f"must be a whole number, not {shown}."
    if re.search("valid (number|float)|finite", message):
        point = f" Write a decimal point: {value.replace(',', '.')}." if re.fullmatch(r"[+-]?\d+,\d+", value) else ""
        return f"must be a number, not {shown}.{point}"
    if found := re.search(r" is not one of (.*)\.", message):
        *others, last = found[1].replace("'", "").split(", ")
        return f"must be {', '.join(others)} or {last}, not {shown}."
    return f"cannot be used: {message.removeprefix('Value error, ')}"
