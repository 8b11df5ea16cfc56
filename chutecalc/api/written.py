"""The text of a chute's spec, as it was read or with other values."""

from collections.abc import Mapping
from typing import Any

import tomli_w

from chutecalc.api.chute import Chute
from chutecalc.spec.edited import edited_text
from chutecalc.spec.parse import parse_text


def text_of(chute: Chute) -> str:
    """Return the TOML text of a chute: the one that it was read from, with its comments, if it says what the chute is.

    Args:
        chute: a chute of one design.
    """
    own = chute.text and parse_text(chute.text, chute.source) == chute.written
    return chute.text if own else tomli_w.dumps(chute.data)


def changed_text(chute: Chute, values: Mapping[str, Any]) -> str:
    """Return the text of a chute with other values in it, its comments kept.

    Args:
        chute: a chute of one design.
        values: numbers or names by key path, in the units of the paths.

    >>> import chutecalc
    >>> text = changed_text(chutecalc.parse(chutecalc.STARTER), {"segments.spoon.radius_mm": 2000.0})
    >>> [line.split("#")[0].strip() for line in text.splitlines() if line.startswith("radius")]
    ['radius_mm = 2000.0']
    """
    return edited_text(text_of(chute), values)
