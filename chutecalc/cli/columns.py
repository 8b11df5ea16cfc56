"""``chutecalc columns``: the catalogue of columns."""

EXAMPLES = ("chutecalc columns",)


def columns() -> int:
    """List the columns of data files: name, unit, symbol, meaning. Sweeps make names of their own from them."""
    from chutecalc.output.grid import Grid
    from chutecalc.output.table import Printer
    from chutecalc.studies.sweep.columns import column_forms

    printer = Printer()
    printer.catalogue()
    printer.text()
    forms = Grid()
    forms.column("in a sweep", left=True, label=True)
    forms.column("meaning", left=True, words=True)
    for row in column_forms():
        forms.row(row)
    printer.table(forms)
    return 0
