"""Docstrings as Markdown, an extension of Griffe, which reads them for mkdocstrings."""

from typing import Any

from griffe import Extension, Object

from website.api import markdown


class Docstrings(Extension):
    """Rewrites docstrings before they are parsed."""

    def on_object(self, *, obj: Object, **_: Any) -> None:
        """Rewrite a docstring.

        Args:
            obj: what it belongs to.
        """
        if obj.docstring:
            obj.docstring.value = markdown(obj.docstring.value)
