"""The Python API: pages of the public names of the package and of its formulas, and docstrings as Markdown."""

import inspect
import re
from pkgutil import iter_modules

import chutecalc
import chutecalc.physics

API = """\
# Python API

The public names of `chutecalc`: a chute is loaded, solved, and asked. [Python](python.md) shows them at work.
`import chutecalc` loads nothing else; each name is imported when it is first used.
"""
FORMULAS = """\
# Formulas in Python

`chutecalc.physics` holds the formulas of [Physics](physics.md), one function for each: of arrays, in SI units and
radians. They know nothing of specs and tables, so they serve for other calculations too.
"""
ROLE = re.compile(r":(?:attr|class|data|func|meth|mod):`~?([^`]+)`")
EXAMPLE = re.compile(r"^>>> (?:.+\n?)+", re.MULTILINE)


def markdown(docstring: str) -> str:
    """Return a docstring as Markdown: roles become code, and examples blocks of code.

    Args:
        docstring: without its indentation.
    """
    return EXAMPLE.sub(lambda found: f"```pycon\n{found[0].rstrip()}\n```\n", ROLE.sub(r"`\1`", docstring))


def api() -> str:
    """Return the page of the public names, as Markdown for mkdocstrings."""
    names = [name for name in chutecalc.__all__ if not name.startswith("_")]
    objects = {name: getattr(chutecalc, name) for name in names}
    errors = [name for name, one in objects.items() if inspect.isclass(one) and issubclass(one, Exception)]
    groups = {
        "Functions": [name for name, one in objects.items() if inspect.isfunction(one)],
        "Classes": [name for name, one in objects.items() if inspect.isclass(one) and name not in errors],
        "Errors": errors,
    }
    groups["Constants"] = [name for name in names if not any(name in group for group in groups.values())]
    lines = [API]
    for heading, members in groups.items():
        lines += [f"## {heading}", ""]
        for name in members:
            lines += [f"::: chutecalc.{name}", "    options:", "      heading_level: 3", ""]
    return "\n".join(lines)


def formulas() -> str:
    """Return the page of the formulas, as Markdown for mkdocstrings."""
    modules = sorted(module.name for module in iter_modules(chutecalc.physics.__path__, "chutecalc.physics."))
    return "\n\n".join([FORMULAS, *(f"::: {name}" for name in modules)])
