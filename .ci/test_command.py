"""Prints the one line of a README that installs what the tests need and runs them; says so where there is none."""

import sys
from pathlib import Path

MARK = "'.[test,dem]'"
"""What no other line has."""
lines = [line for line in Path(sys.argv[1]).read_text(encoding="utf-8").splitlines() if MARK in line]
if len(lines) != 1:
    found = "there is none" if not lines else f"there are {len(lines)}"
    sys.exit(f"{sys.argv[1]} has to have exactly one test command, a line with {MARK}: {found}")
print(lines[0])
