"""Segments, a kind to a module: its keys, rules, build and example. A new module here is a new kind."""
