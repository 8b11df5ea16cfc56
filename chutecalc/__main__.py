"""``python -m chutecalc``, and the console script."""

import sys

from chutecalc.interrupt import INTERRUPTED, clean_up, ignore, install, listen

install()

from chutecalc.runtime import finish_command, prepare_command  # noqa: E402 - from here on Ctrl-C is no traceback

prepare_command()


def entry() -> None:
    """Run the command line that the process was given, and exit with its status."""
    from chutecalc.cli import main

    try:
        listen()
        status = main()
        ignore()
    except KeyboardInterrupt:  # in its last steps, or while an error was told
        ignore()
        clean_up()
        status = INTERRUPTED
    finish_command()
    sys.exit(status)


if __name__ == "__main__":
    entry()
