"""Segments, one module to a kind: its keys, rules, numbers and example. A new module is a new kind."""
