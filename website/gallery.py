"""The gallery: every standard design with its picture, what it shows, what `chutecalc run` says of it, and its file."""

import contextlib
import io
import os
import re
import tempfile
import tomllib
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[1]
INDEX = ROOT / "specs" / "README.md"
GROUPS = {"": "Chutes that work", "fails": "Chutes that fail", "paper": "The worked example of the paper"}
"""Headings of the gallery, by the folder in specs."""


class Drawn(NamedTuple):
    """A design that has been run."""

    printed: str
    picture: bytes


class Design(NamedTuple):
    """A standard design: its path in specs without ending, its title, and one line of what it shows."""

    name: str
    title: str
    shows: str

    @property
    def path(self) -> Path:
        """Where its spec is."""
        return ROOT / "specs" / f"{self.name}.toml"

    @property
    def group(self) -> str:
        """The folder that it is in."""
        return self.name.rpartition("/")[0]

    @property
    def command(self) -> str:
        """What solves it."""
        return f"chutecalc run specs/{self.name}.toml"


def designs() -> list[Design]:
    """Return all standard designs, in the order of specs/README.md."""
    return [Design(name, _title(ROOT / "specs" / f"{name}.toml"), shows) for name, shows in _listed()]


def _listed() -> Iterator[tuple[str, str]]:
    for links, shows in re.findall(r"^\| (\[.*) \| (.*) \|$", INDEX.read_text(encoding="utf-8"), re.MULTILINE):
        for target in re.findall(r"\]\(([^)]+)\)", links):
            path = INDEX.parent / target
            specs = [path] if path.is_file() else sorted(path.glob("*.toml"))
            for spec in specs:
                if not spec.name.endswith(".baseline.toml"):
                    yield spec.relative_to(INDEX.parent).with_suffix("").as_posix(), shows


def _title(path: Path) -> str:
    return str(tomllib.loads(path.read_text(encoding="utf-8"))["title"])


def draw(design: Design) -> Drawn:
    """Run a design and draw it.

    Args:
        design: the design.

    Returns:
        What the command prints, and the picture as SVG.
    """
    from chutecalc.cli import main

    written = io.TextIOWrapper(io.BytesIO(), encoding="utf-8", newline="")
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(ROOT), contextlib.redirect_stdout(written):
        picture = Path(folder, "picture.svg")
        main(["run", f"specs/{design.name}.toml", "--plot", str(picture)])
        written.seek(0)
        return Drawn(written.read().rstrip(), picture.read_bytes())


def draw_all(chosen: list[Design]) -> dict[str, Drawn]:
    """Run designs in processes, one for each core: Matplotlib holds the interpreter.

    Args:
        chosen: the designs.

    Returns:
        Each one by its name.
    """
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        return dict(zip((each.name for each in chosen), pool.map(draw, chosen), strict=True))


def status(drawn: Drawn) -> str:
    """Return how a design ends, as its report says.

    Args:
        drawn: the design.
    """
    found = re.search(r"^status (\w+)", drawn.printed, re.MULTILINE)
    return found[1] if found else "unknown"


def page(design: Design, drawn: Drawn) -> str:
    """Return the page of a design, as Markdown.

    Args:
        design: the design.
        drawn: the same, run.
    """
    name, gallery = design.path.stem, "../index.md" if design.group else "index.md"
    return f"""# {design.title}

{design.shows[0].upper()}{design.shows[1:]}. One of the [gallery]({gallery}).

[![The chute to scale, with the stream along it]({name}.svg)]({name}.svg)

```console
$ {design.command}
{drawn.printed}
```

## The file

```toml
{design.path.read_text(encoding="utf-8").rstrip()}
```
"""


def index(chosen: list[Design], drawn: dict[str, Drawn]) -> str:
    """Return the gallery, as Markdown.

    Args:
        chosen: the designs.
        drawn: the same, run.
    """
    lines = [
        "# Gallery",
        "",
        "Every standard design, as `chutecalc run --plot` draws it. Copy the one nearest to your chute to start from;",
        "behind each are its file and all that a run says of it.",
    ]
    for folder, heading in GROUPS.items():
        lines += ["", f"## {heading} {{ #{folder or 'works'} }}", "", '<div class="grid cards" markdown>', ""]
        for each in chosen:
            if each.group == folder:
                lines += [_card(each, status(drawn[each.name])), ""]
        lines += ["</div>"]
    return "\n".join(lines) + "\n"


def _card(design: Design, ends: str) -> str:
    return f"""-   [![{design.title}]({design.name}.svg){{ loading=lazy }}]({design.name}.md)

    **[{design.title}]({design.name}.md)**

    {design.shows[0].upper()}{design.shows[1:]}. *Status {ends}.*

    `{design.command}`"""
