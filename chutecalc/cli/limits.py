"""``chutecalc limits``: from where on findings appear, and why there."""

EXAMPLES = ("chutecalc limits", "chutecalc explain max_impact_angle_deg")
PAGE = "spec.md#limits"


def limits() -> int:
    """List the limits of findings, the keys of [limits]: unit, default, source, meaning."""
    from chutecalc.output.catalogue import limits_table
    from chutecalc.output.printer import Printer

    Printer().table(limits_table())
    return 0
