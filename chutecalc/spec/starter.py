"""The spec that ``chutecalc new`` writes: a chute that runs, and examples of what else a spec may say."""

from collections.abc import Mapping
from string import Formatter

from chutecalc.sections.registry import SHAPES
from chutecalc.segments.registry import KINDS
from chutecalc.spec.limits import LIMITS

_CHUTE = """\
# A chute for chutecalc. Run it:  chutecalc run chute.toml
# The unit of a number is the end of its key: radius_mm = 3000 or radius_ft = 9.84 mean the same as radius_m = 3.0.
format = 1
title = "Fall and spoon, coal"

[flow]
rate_t_h = 1000

[material]
name = "coal"
density_kg_m3 = 800
internal_friction_deg = 55      # effective angle of internal friction
# pressure_ratio = 0.4          # instead: pressure on a vertical wall over that on the floor
# lump_mm = 150                 # largest lump, to check that the chute has room for it

[liners.ceramic]
friction_deg = 25               # wall friction angle
# thickness_mm = 20             # these two, for the life of the liner
# wear_mm3_per_j = 1e-4         # volume lost per frictional work, measured with the material

[sections.body]                 # {shapes}
{chamfered}# wall_height_m = 0.4           # above the floor; a deeper stream chokes the chute

[inlet]
velocity_m_s = 0.0              # where the stream enters, along slope_deg below horizontal
slope_deg = 90                  # 90 falls straight down

[[segments]]                    # {kinds}, in the order in which the stream meets them
{fall}
[[segments]]
name = "spoon"
{curve}"""
_FURTHER = """
# What else a chute may have. Remove the # in front of what you need.

# The title block of reports, all text:

# [project]
# client = "Northern Coal Terminal"
# project = "CV-204 to CV-205"
# number = "4711-CH-001"
# revision = "A"
# prepared = "A. Miller"
# checked = "J. Novak"
# date = "2026-03-02"
# notes = "Preliminary."

# Other shapes of section. Where there are several, each segment names its own: section = "body"

{sections}
# Other kinds of segment, each to be put where the stream meets it:

{segments}
# The belt that the stream comes from, in place of velocity_m_s and slope_deg in [inlet]:

# [inlet.belt]
# velocity_m_s = 2.5
# incline_deg = 8               # uphill
# pulley_radius_m = 0.45
# belt_thickness_m = 0.015
# width_m = 1.0                 # of the belt: the depth of the stream follows the rate; or material_depth_m instead
# trough_deg = 35               # of the side rolls; 0 is a flat belt
# surcharge_deg = 15            # of the material on the running belt
# friction_deg = 25             # of the material on the belt, for one so slow that it does not throw the stream

# The belt that the stream goes to:

# [receiver]
# velocity_m_s = 3.0
# slope_deg = 0                 # downhill
# friction_deg = 30             # of the material on the belt
# at_m = [4.0, -6.0]            # any point of the belt, x forward and z up from the inlet: where the stream lands
# plan_angle_deg = 90           # between chute and belt, seen from above

# Other operating states on the same steel; the names are yours:

# [cases.surge]
# "flow.rate_t_h" = 1500

# [cases.wet]
# "liners.ceramic.friction_deg" = 32

# How uncertain numbers are, for chutecalc uncertain: plus/minus, or a distribution:

# [uncertainty]
# "liners.ceramic.friction_deg" = 2
# "flow.rate_t_h" = {{ uniform = [900, 1100] }}

# The steel stands still while operating keys vary. To have it drawn anew under each stream:

# [model]
# steel = "follows_stream"

# Where findings begin; these are the defaults:

{limits}"""
_USED = {field for _, field, _, _ in Formatter().parse(_CHUTE)}


def _commented(headers: str, examples: Mapping[str, str]) -> str:
    """Return the examples that the chute does not use as TOML comments, each below its header."""
    blocks = (headers.format(name) + text for name, text in examples.items() if name not in _USED)
    return "\n".join("".join(f"# {line}\n" for line in block.splitlines()) for block in blocks)


def _limits() -> str:
    """Return the limits that are in force by default as TOML comments."""
    entries = {f"{one.key} = {one.default:g}": one for one in LIMITS.values() if one.default is not None}
    lines = ["[limits]", *(f"{entry:<31} # {one.finding}: {one.meaning}" for entry, one in entries.items())]
    return "".join(f"# {line}\n" for line in lines)


def _starter() -> str:
    """Return the chute and the further examples as TOML text."""
    sections = {shape: table.example for shape, table in SHAPES.items()}
    segments = {kind: table.example for kind, table in KINDS.items()}
    chute = _CHUTE.format(shapes=" | ".join(SHAPES), kinds=" | ".join(KINDS), **sections, **segments)
    return chute + _FURTHER.format(
        sections=_commented("[sections.{}]\n", sections),
        segments=_commented("[[segments]]\n", segments),
        limits=_limits(),
    )


STARTER = _starter()
"""TOML text of a fall into a chamfered spoon, with comments."""
