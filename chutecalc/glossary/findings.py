"""Findings, and how designs end, explained."""

from collections.abc import Iterator

from chutecalc.design.status import MEANINGS
from chutecalc.glossary.entry import Entry, facts, listed
from chutecalc.results.findings import CRITERIA
from chutecalc.spec.limits import LIMITS

FINDINGS, STATUSES = "findings", "statuses"


def finding_entries() -> Iterator[Entry]:
    """Yield an entry for each finding and each status."""
    for one in CRITERIA:
        limits = [key for key, limit in LIMITS.items() if limit.finding == one.code]
        yield Entry(
            FINDINGS,
            one.code,
            one.summary,
            facts(
                severity=listed([str(each) for each in one.severities]),
                where=one.limit,
                source=one.source,
                limit=listed(limits),
                reads=listed(list(dict.fromkeys(name for name, _ in one.needs))),
                docs=f"docs/findings.md#{one.code}",
            ),
        )
    for status, meaning in MEANINGS.items():
        yield Entry(STATUSES, status, meaning, facts(docs="docs/running.md"))
