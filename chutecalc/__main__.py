"""``python -m chutecalc``, and the console script."""

import sys

from chutecalc.runtime import prepare_command

prepare_command()


def entry() -> None:
    """Run the command line that the process was given, and exit with its status."""
    from chutecalc.cli import main

    sys.exit(main())


if __name__ == "__main__":
    entry()
