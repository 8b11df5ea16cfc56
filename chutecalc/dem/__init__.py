"""The discrete-element check of the friction law (Paper, section 7); LAMMPS runs as a separate program."""
