"""The examples in README.md and docs/*.md: commands, programs and specs, with what they print.

python -m tests.pages    runs them all and writes their output into the pages anew

A ``console`` block holds commands, each after ``$``, and what they print. ``| head -3`` keeps the first three lines;
``echo $?`` shows the exit status. The ``python`` blocks of a page are one program; a ``text`` block right after one of
them is what it prints. The first ``toml`` block of a page is a whole spec, and the tables of the others replace those
in it.

On a page of docs/tutorial the commands follow from one another, and the ``toml`` block is the file that they begin
with, named as the page.
"""

import contextlib
import io
import os
import re
import shlex
import shutil
import tempfile
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import chutecalc
from chutecalc.cli import main

ROOT = Path(__file__).resolve().parents[1]
PAGES = [ROOT / "README.md", *sorted(path for path in (ROOT / "docs").glob("*.md") if path.stem != "paper")]
"""docs/paper.md is checked by tests/house/test_paper_page.py."""
LESSONS = sorted((ROOT / "docs" / "tutorial").glob("*.md"))
"""Pages of the tutorial."""
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
    """Work in a folder that has the specs and nothing else."""
    before = Path.cwd()
    with tempfile.TemporaryDirectory() as folder:
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
        words, piped, part = (*re.split(r" \| (head|tail) -", command), "", "")[:3]
        written = io.TextIOWrapper(io.BytesIO(), encoding="utf-8", newline="")
        with contextlib.redirect_stdout(written), contextlib.redirect_stderr(written):
            status = main(shlex.split(words)[1:])
            written.flush()
        printed = written.buffer.getvalue().decode().rstrip().splitlines()  # type: ignore[attr-defined]
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
    """Return the text of a page with its examples run."""
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
        return FENCE.sub(run, page.read_text(encoding="utf-8"))


def renewed_lesson(page: Path) -> str:
    """Return the text of a page of the tutorial with its commands run, one after the other in one folder."""
    with workplace():
        for block in blocks(page, "toml"):
            Path(f"{page.stem}.toml").write_text(block.text, encoding="utf-8")
        text = page.read_text(encoding="utf-8")
        return FENCE.sub(
            lambda match: match[0].replace(match[2], console(match[2])) if match[1] == "console" else match[0], text
        )


if __name__ == "__main__":
    for lesson in LESSONS:
        lesson.write_text(renewed_lesson(lesson), encoding="utf-8")
    for page in PAGES:
        page.write_text(renewed(page), encoding="utf-8")
        for block in blocks(page, "toml"):
            chutecalc.parse(spec(block.text, blocks(page, "toml")[0].text))
