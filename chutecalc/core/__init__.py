"""One stream on one segment, in plain scalar Python that is compiled ahead of time where that is possible.

Every module is ordinary Python; the ``.pxd`` beside it tells the compiler the C types. Uncompiled it works the same, to
the last digit, and slower. What is marked ``nogil`` there may not hold a Python object: no tuple but as a result, no
local name for a record.
"""

from importlib.util import find_spec


def compiled() -> bool:
    """Whether the compiled form is the one that is used."""
    found = find_spec("chutecalc.core.march")
    return found is not None and not str(found.origin).endswith(".py")
