"""All cross-section shapes, found in the modules of this package."""

from typing import TYPE_CHECKING

import chutecalc.sections
from chutecalc.fields.registry import union, variants
from chutecalc.sections.base import Section

SHAPES = variants(chutecalc.sections, Section, "shape")
"""Tables of the shapes by the value of their key ``shape``."""

if TYPE_CHECKING:
    AnySection = Section
else:
    AnySection = union(SHAPES, "shape")
