"""``chutecalc columns``: the catalogue of columns."""

EXAMPLES = ("chutecalc columns", "chutecalc explain velocity_m_s")
PAGE = "nomenclature.md#columns"


def columns() -> int:
    """List the columns of data files: name, unit, symbol, meaning. Sweeps make names of their own from them."""
    from chutecalc.output.catalogue import catalogue, columns_table
    from chutecalc.output.printer import Printer
    from chutecalc.studies.sweep.columns import column_forms

    printer = Printer()
    printer.table(columns_table())
    printer.text()
    printer.table(catalogue(("in a sweep", "meaning"), column_forms()))
    return 0
