"""``chutecalc limits``: from where on findings appear, and why there."""

EXAMPLES = ("chutecalc limits",)


def limits() -> int:
    """List the limits of findings, the keys of [limits]: unit, default, source, meaning."""
    from chutecalc.output.limits import limits_table
    from chutecalc.output.table import Printer

    Printer().table(limits_table())
    return 0
