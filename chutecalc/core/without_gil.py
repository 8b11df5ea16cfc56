"""Solve rows of designs without the interpreter's lock, so that threads run in parallel.

Compiled, ``without_gil.pxd`` takes the place of this; plain Python keeps its lock.
"""

from chutecalc.core.batch import solve_rows

__all__ = ["solve_rows"]
