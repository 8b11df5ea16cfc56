"""Names of columns as users give them: one or several, known or not."""

from collections.abc import Collection, Iterable
from reprlib import repr as short

from chutecalc.errors import UsageError


def column_names(names: Iterable[str]) -> list[str]:
    """Return names of columns as a list, also where one name is given alone.

    Args:
        names: of columns, or one name.

    Raises:
        UsageError: they are something else.

    >>> column_names("depth_m"), column_names(("s_m", "depth_m"))
    (['depth_m'], ['s_m', 'depth_m'])
    """
    listed = [names] if isinstance(names, str) or not isinstance(names, Iterable) else list(names)
    if not all(isinstance(name, str) for name in listed):
        raise UsageError(f"columns must be a list of names, not {short(names)}")
    return listed


def check_columns(names: Iterable[str], known: Collection[str], where: str = "") -> None:
    """Check that columns exist.

    Args:
        names: of columns.
        known: names of the columns that exist.
        where: where they exist, for the message.

    Raises:
        UsageError: a name is unknown.

    >>> check_columns(["depth"], ["depth_m", "s_m"])
    Traceback (most recent call last):
    chutecalc.errors.UsageError: there is no column depth. Did you mean depth_m? `chutecalc columns` lists all
    """
    unknown = [name for name in names if name not in known]
    if unknown:
        raise UsageError(
            f"there is no column {', '.join(unknown)}{where}. {closest(unknown, known)}`chutecalc columns` lists all"
        )


def closest(unknown: Iterable[str], known: Collection[str]) -> str:
    """Return a question that offers known names in place of unknown ones, with a space behind; empty without any.

    Args:
        unknown: names.
        known: names.

    >>> closest(["depth", "nope"], ["depth_m", "s_m"])
    'Did you mean depth_m? '
    """
    from difflib import get_close_matches

    matches = [match for name in unknown for match in get_close_matches(name, known, n=1)]
    return f"Did you mean {', '.join(matches)}? " if matches else ""
