"""The examples in README.md and the pages in docs: commands, programs and specs, with what they print.

python -m tests.pages              runs them all and writes their output into the pages anew
python -m tests.pages PAGE...      does it for some pages

A ``console`` block holds commands, each after ``$``, and what they print. ``| head -3`` keeps the first three lines;
``> FILE`` writes them; ``echo $?`` shows the exit status. The ``python`` blocks of a page are one program; a ``text``
block right after one of them is what it prints. The first ``toml`` block of a page is a whole spec, and the tables of
the others replace those in it.

On a page of docs/tutorial and docs/howto the commands follow from one another, and the ``toml`` block is the file that
they begin with, named as the page.

What the tests cannot run says so by its language: ``sh`` is for a shell on the machine of the reader (installing, the
network, hours), and ``yaml``, ``json`` and ``lua`` are files of other programs. A block without one is a formula.
"""

import contextlib
import io
import os
import re
import shlex
import shutil
import sys
import tempfile
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest

import chutecalc
from chutecalc.cli import main

ROOT = Path(__file__).resolve().parents[1]
LESSONS = sorted((ROOT / "docs" / "tutorial").glob("*.md"))
"""Pages of the tutorial."""
STORIES = [*LESSONS, *sorted((ROOT / "docs" / "howto").glob("*.md"))]
"""Pages whose commands follow from one another."""
PAGES = [
    *(ROOT / name for name in ("README.md", "specs/README.md")),
    *sorted(path for path in (ROOT / "docs").glob("*.md") if path.stem != "paper"),
]
"""All others. docs/paper.md is checked by tests/house/test_paper_page.py, the recipes of CONTRIBUTING.md by
test_recipes.py."""
FENCE = re.compile(r"^```(console|python|toml)\n(.*?)^```\n(?:\n```text\n(.*?)^```\n)?", re.DOTALL | re.MULTILINE)


class Block(NamedTuple):
    """A fenced block of a page."""

    language: str
    text: str
    printed: str | None
    """The ``text`` block behind a program."""


def blocks(page: Path, language: str) -> list[Block]:
    """Return the blocks of a page in one language, in order."""
    found = (Block(*match.groups()) for match in FENCE.finditer(page.read_text(encoding="utf-8")))
    return [block for block in found if block.language == language]


@contextlib.contextmanager
def workplace() -> Iterator[None]:
    """Work in a folder that has the specs and nothing else, on a terminal of 80 columns."""
    before = Path.cwd()
    with tempfile.TemporaryDirectory() as folder, pytest.MonkeyPatch.context() as patch:
        patch.setenv("COLUMNS", "80")
        shutil.copytree(ROOT / "specs", Path(folder, "specs"))
        os.chdir(folder)
        try:
            yield
        finally:
            os.chdir(before)


def console(text: str) -> str:
    """Return a ``console`` block with what its commands print."""
    lines: list[str] = []
    status = 0
    for command in [*re.findall(r"^\$ (.*)$", text, re.MULTILINE), ""]:
        if command == "echo $?":
            lines += [f"$ {command}", str(status)]
            status = 0
            continue
        assert status == 0, f"{lines}: a command that fails is followed by echo $?"
        if not command:
            break
        lines.append(f"$ {command}")
        command, _, file = command.partition(" > ")
        words, piped, part = (*re.split(r" \| (head|tail) -", command), "", "")[:3]
        written = io.TextIOWrapper(io.BytesIO(), encoding="utf-8", newline="")
        with contextlib.redirect_stdout(written), contextlib.redirect_stderr(written):
            status = main(shlex.split(words)[1:])
            written.flush()
        said = written.buffer.getvalue().decode()  # type: ignore[attr-defined]
        if file:
            Path(file).write_text(said, encoding="utf-8")
        printed = [] if file else said.rstrip().splitlines()
        if piped:
            status, printed = 0, printed[: int(part)] if piped == "head" else printed[-int(part) :]
        lines += [line.rstrip() for line in printed]
    return "\n".join(lines) + "\n"


def program(text: str, names: dict[str, Any]) -> str:
    """Run a program with the names of those before it and return what it prints."""
    written = io.StringIO()
    with contextlib.redirect_stdout(written):
        exec(compile(text, "page.py", "exec"), names)
    return written.getvalue()


def spec(text: str, first: str) -> dict[str, Any]:
    """Return the whole spec of a ``toml`` block."""
    return tomllib.loads(first) | tomllib.loads(text)


def renewed(page: Path) -> str:
    """Return the text of a page with its examples run, one after the other in one folder."""
    names: dict[str, Any] = {"__name__": "page"}

    def run(match: re.Match[str]) -> str:
        language, text, printed = match.groups()
        if language == "console":
            return match[0].replace(text, console(text))
        if language == "python":
            now = program(text, names)
            return match[0] if printed is None else match[0].replace(f"```text\n{printed}", f"```text\n{now}")
        return match[0]

    with workplace():
        if page in STORIES and (specs := blocks(page, "toml")):
            Path(f"{page.stem}.toml").write_text(specs[0].text, encoding="utf-8")
        return FENCE.sub(run, page.read_text(encoding="utf-8"))


if __name__ == "__main__":
    for page in [Path(name).resolve() for name in sys.argv[1:]] or [*STORIES, *PAGES]:
        page.write_text(renewed(page), encoding="utf-8")
        for block in blocks(page, "toml") if page in PAGES else ():  # a sketch of a lesson is not a whole spec
            chutecalc.parse(spec(block.text, blocks(page, "toml")[0].text))
