"""Solve numeric descriptions of chutes: hand designs to the compiled core, and read its results as arrays."""
