"""``chutecalc columns``: what columns there are."""


def columns() -> int:
    """List the columns of CSV and JSON: name, unit, symbol, meaning."""
    from chutecalc.output.table import Printer

    Printer().catalogue()
    return 0
