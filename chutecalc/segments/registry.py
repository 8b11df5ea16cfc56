"""All kinds of segment, found in the modules of this package."""

from typing import TYPE_CHECKING

import chutecalc.segments
from chutecalc.fields.registry import union, variants
from chutecalc.segments.base import Segment

KINDS = variants(chutecalc.segments, Segment, "kind")
"""Tables of the kinds by the value of their key ``kind``."""

if TYPE_CHECKING:
    AnySegment = Segment
else:
    AnySegment = union(KINDS, "kind")
