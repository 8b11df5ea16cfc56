"""``chutecalc new``: write a spec to start from."""

from pathlib import Path

import typer

from chutecalc.errors import OutputError

EXAMPLES = ("chutecalc new", "chutecalc new spoon.toml")


def new(
    file: str = typer.Argument("chute.toml", metavar="FILE", help="File to write; - for standard output."),
) -> int:
    """Write a commented spec to start from. It lists all shapes of section and kinds of segment.

    An existing file is never overwritten.
    """
    from chutecalc.spec.starter import STARTER

    if file == "-":
        typer.echo(STARTER, nl=False)
        return 0
    try:
        with open(file, "x", encoding="utf-8") as stream:
            stream.write(STARTER)
    except FileExistsError:
        if Path(file).is_dir():
            raise OutputError(f"{file} is a folder. Name a file in it.") from None
        raise OutputError(f"{file} already exists and was not changed. Choose another name.") from None
    except FileNotFoundError:
        folder = Path(file).parent
        raise OutputError(f"{file} cannot be written: there is no folder {folder}. Create it first.") from None
    except OSError as error:
        raise OutputError(f"{file} cannot be written: {error.strerror}") from None
    typer.echo(f"wrote {file}. To run it: chutecalc run {file}")
    return 0
