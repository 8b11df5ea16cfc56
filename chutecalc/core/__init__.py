"""One stream on one segment, in plain scalar Python that is compiled ahead of time where that is possible.

Every module is ordinary Python; the ``.pxd`` beside it tells the compiler the C types. Uncompiled it works the same, to
the last digit, and slower.
"""
