"""``chutecalc explain``: what a word of a spec, a table or a command line means."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import typer

from chutecalc.errors import UsageError

if TYPE_CHECKING:
    from chutecalc.glossary.entry import Entry
    from chutecalc.output.printer import Printer

EXAMPLES = ("chutecalc explain radius_m", "chutecalc explain slow_stream", "chutecalc explain wear")
PAGE = "nomenclature.md"
SETTINGS = {"ignore_unknown_options": True}  # an option is a word too


def _words() -> list[str]:
    """Return all words, for completion."""
    from chutecalc.glossary.words import entries

    return list(dict.fromkeys(entry.word for entry in (*entries(), *_commands())))


def explain(
    word: str | None = typer.Argument(
        None,
        metavar="WORD",
        help="A key, also as a path or in another unit, a table, a column, a finding, a limit, a status, a symbol or an"
        " option; or words to look for in their meanings.",
        autocompletion=_words,
    ),
) -> int:
    """Explain a word: meaning, unit, bounds, default, formula, source, and where it is used.

    Without a word, list what can be explained.
    """
    from chutecalc.glossary.words import about, close_to, entries, found
    from chutecalc.output.catalogue import catalogue
    from chutecalc.output.printer import Printer

    printer, commands = Printer(), list(_commands())
    if word is None:
        groups: dict[str, list[Entry]] = {}
        for entry in (*entries(), *commands):
            groups.setdefault(entry.group, []).append(entry)
        own = {group: [each for each in named if not each.derived] or named for group, named in groups.items()}
        rows = ((group, str(len(named)), named[0].word) for group, named in own.items())
        printer.table(catalogue(("what there is", "words", "such as"), rows))
        printer.text()
        printer.prose("chutecalc explain WORD explains one; any other text is looked for in their meanings.")
        return 0
    if named := found(word, commands):
        for number, entry in enumerate(named):
            if number:
                printer.text()
            _print(printer, entry)
        return 0
    close, mentioned = close_to(word, commands), about(word, commands)
    meant = f"Did you mean {' or '.join(close)}? " if close else ""
    if not mentioned:
        raise UsageError(f"there is no word {word}. {meant}`chutecalc explain` lists what there is.")
    printer.prose(f"{word} is in the meaning of:")
    printer.text()
    rows = ((entry.word, entry.group, entry.meaning) for entry in mentioned)
    printer.table(catalogue(("word", "of", "meaning"), rows))
    return 0


def _print(printer: Printer, entry: Entry) -> None:
    """Print what is known of a word."""
    from chutecalc.output.catalogue import catalogue

    printer.prose(f"{entry.word}: {entry.meaning or entry.group}", "bold")
    printer.table(catalogue(("", ""), [("among", entry.group), *entry.facts]))


def _commands() -> Iterator[Entry]:
    """Yield an entry for each command, and for each option."""
    from chutecalc.cli import command_line
    from chutecalc.glossary.entry import Entry, facts

    group = command_line()
    options: dict[tuple[str, str], list[str]] = {}
    for name, command in group.commands.items():
        yield Entry("commands", name, command.get_short_help_str(1000), facts(help=f"chutecalc {name} --help"))
        for option in command.params:
            for spelling in option.opts if option.param_type_name == "option" else ():
                options.setdefault((spelling, getattr(option, "help", None) or ""), []).append(name)
    for (spelling, text), commands in options.items():
        yield Entry("options", spelling, text.removesuffix("."), facts(of=", ".join(commands)))
