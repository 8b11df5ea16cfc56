"""What a report is made of: a solved chute with all that was asked of it."""

from typing import NamedTuple

from chutecalc.results.band import Band
from chutecalc.results.cases import Cases


class Reported(NamedTuple):
    """A chute for a report."""

    states: Cases
    """Its solutions, of one design each, that at the design point first."""
    digest: str
    """SHA-256 of the text of its spec; empty where it was not given as text."""
    library: str
    """File of the library whose entries the spec uses; empty where it uses none."""
    settings: tuple[str, ...]
    """Keys that were changed for this run, as ``PATH=VALUE``."""
    band: Band | None
    """The band of the model, if it could be solved."""
