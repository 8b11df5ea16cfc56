"""Numbers, columns and statuses in the report on an uncertain chute."""

from chutecalc.results.column import Column


def cell(column: Column, value: float, units: str) -> str:
    """Return a number of a column, empty for NaN.

    Args:
        column: the column.
        value: in its metric unit.
        units: ``metric`` or ``us``.
    """
    if column.name == "error_estimate":
        return "" if value != value else f"{value:.0e}"
    return column.shown(float(value), units)


def label(column: Column, units: str) -> str:
    """Return the name of a column with its unit.

    Args:
        column: the column.
        units: ``metric`` or ``us``.
    """
    return ", ".join(part for part in (column.heading, column.unit_text(units)) if part)


def per_cent(share: float, digits: int = 2) -> str:
    """Return a share as per cent.

    Args:
        share: dimensionless.
        digits: significant ones.

    >>> per_cent(1.0), per_cent(3 / 16384)
    ('100 %', '0.018 %')
    """
    return f"{float(f'{100.0 * share:.{digits}g}'):g} %"
