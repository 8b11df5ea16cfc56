"""``chutecalc columns``: the catalogue of columns."""

EXAMPLES = ("chutecalc columns",)


def columns() -> int:
    """List the columns of data files: name, unit, symbol, meaning."""
    from chutecalc.output.table import Printer

    Printer().catalogue()
    return 0
