"""Print the one line of a README that installs what the tests need and runs them; fail if there is not exactly one."""

import sys
from pathlib import Path

MARK = "'.[test,dem]'"
"""Marks the line."""
lines = [line for line in Path(sys.argv[1]).read_text(encoding="utf-8").splitlines() if MARK in line]
if len(lines) != 1:
    sys.exit(f"{sys.argv[1]} needs exactly one test command, a line with {MARK}, and has {len(lines)}")
print(lines[0])
