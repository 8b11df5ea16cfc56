"""``python -m chutecalc``, and the console script.

What is loaded at the start stays to the end: to have Python look through it for garbage takes a tenth of a short run,
and what comes after makes no cycles that would have to be found.
"""

import gc
import os
import sys

gc.set_threshold(1_000_000)
os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")  # to look for some reads the files of all packages


def entry() -> None:
    """Runs the command line that the process was given."""
    from chutecalc.cli import main

    sys.exit(main())


if __name__ == "__main__":
    entry()
