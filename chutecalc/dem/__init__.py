"""The discrete-element check of the friction law, with LAMMPS as a program of its own (Paper, section 7)."""
