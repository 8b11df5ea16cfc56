"""Solve one stream in one chute, in plain scalar Python that is compiled ahead of time where possible.

Every module is ordinary Python; the ``.pxd`` beside it gives the compiler the C types. Uncompiled it works the same, to
the last digit, but slower. What is marked ``nogil`` there may not hold a Python object: no tuple except as a result,
and no local name for a record. Local names must not be those of modules.
"""

from importlib.util import find_spec


def compiled() -> bool:
    """Return whether the compiled form is in use."""
    found = find_spec("chutecalc.core.stepping")
    return found is not None and not str(found.origin).endswith(".py")
