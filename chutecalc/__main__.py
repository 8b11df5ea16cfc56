"""``python -m chutecalc``."""

import sys

from chutecalc.cli import main

if __name__ == "__main__":
    sys.exit(main())
