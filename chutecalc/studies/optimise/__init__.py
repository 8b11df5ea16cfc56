"""Optima: the best values of some keys, subject to limits, and the front of two objectives."""
