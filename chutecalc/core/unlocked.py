"""Rows of designs solved without the interpreter's lock, so that threads run beside each other.

Compiled, ``unlocked.pxd`` stands for this; plain Python keeps its lock.
"""

from chutecalc.core.batch import solve_rows

__all__ = ["solve_rows"]
