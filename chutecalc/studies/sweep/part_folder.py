"""What has the name of a sweep's folder of blocks, or a name in it: found before it is read or written."""

import os
import stat
from pathlib import Path

from chutecalc.errors import UsageError
from chutecalc.output.held import hold_folder, let_folder_go, named

IDENTITY = "sweep.json"
"""Name of the file that says which sweep the blocks are of."""
ANEW = "To start the sweep anew, leave out --resume."


def part_folder(target: str, resume: bool) -> Path:
    """Return the folder ``FILE.part``, which may or may not be there.

    Args:
        target: the data file.
        resume: whether it is to be continued.

    Raises:
        UsageError: something else has its name, it is not to be used, or there is nothing in it to be continued.
        OutputError: another process uses it, or what is there cannot be found out.
    """
    folder = Path(f"{os.path.realpath(target) if os.path.islink(target) else target}.part")
    with named(str(folder)):
        _check(folder, resume)
    return folder


def _check(folder: Path, resume: bool) -> None:
    """Refuse a folder that does not fit."""
    kind = kind_of(folder)
    if not kind and resume:
        raise UsageError(f"there is no {folder} to continue. {ANEW}")
    if kind == stat.S_IFLNK:
        remedy = "Put the folder that it leads to in its place, or remove it and leave out --resume."
        raise UsageError(f"{folder} is a link, and blocks are kept in no other place. {remedy}")
    if kind not in (0, stat.S_IFDIR):
        problem = "is no folder, and the blocks of the sweep need one of that name"
        raise UsageError(f"{folder} {problem}. Remove or rename it, and leave out --resume.")
    if kind_of(folder / IDENTITY) == stat.S_IFREG:
        if not resume:
            hold_folder(str(folder), str(folder))  # else it belongs to a sweep that is about to end
            let_folder_go(str(folder))
            raise UsageError(f"{folder} is left from an interrupted sweep: add --resume to continue, or remove it")
    elif kind and any(not name.startswith(".") for name in os.listdir(folder)):
        problem = f"does not belong to a sweep, since {IDENTITY} in it is missing, or no file"
        raise UsageError(f"{folder} {problem}. Remove or rename it, and leave out --resume.")
    elif resume:
        raise UsageError(f"there is nothing in {folder} to continue. {ANEW}")


def kind_of(path: Path) -> int:
    """Return the type of what is at a path, 0 where there is nothing. A link is one, wherever it leads.

    Args:
        path: of what may be there.

    Raises:
        OSError: it cannot be found out.
    """
    try:
        return stat.S_IFMT(os.lstat(path).st_mode)
    except FileNotFoundError:
        return 0
