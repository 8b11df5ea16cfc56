"""Cross-sections, one module to a shape: its keys, rules, geometry and example. A new module is a new shape."""
