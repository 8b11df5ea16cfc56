"""Cross-sections, a shape to a module: its keys, rules, geometry and example. A new module here is a new shape."""
