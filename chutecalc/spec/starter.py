"""The spec to start from."""

STARTER = """\
# A chute for chutecalc. Run it:  chutecalc run chute.toml
# A number's unit is the end of its key; radius_mm = 3000 or radius_ft = 9.84 would do as well.
format = 1
title = "Fall and spoon, coal"

[flow]
rate_t_h = 1000

[material]
name = "coal"
density_kg_m3 = 800
internal_friction_deg = 55      # effective angle of internal friction
# pressure_ratio = 0.4          # instead: pressure on a vertical wall over that on the floor

[liners.ceramic]
friction_deg = 25               # wall friction angle

[sections.body]
shape = "chamfered"             # rectangular | chamfered | vee
base_m = 0.5                    # flat floor between the chamfers
chamfer_deg = 45
# chamfer_m = 0.15              # length of a chamfer, vertical walls above it; without it the chamfer has no top
# wall_height_m = 0.4           # above the floor; a deeper stream chokes the chute

[inlet]
velocity_m_s = 0.0              # where the stream enters, along slope_deg below horizontal
slope_deg = 90

[[segments]]                    # in the order in which the stream meets them
kind = "fall"                   # fall | straight | curve | hood
drop_m = 2.0

[[segments]]
name = "spoon"
kind = "curve"                  # on a floor; one that steepens is a crest
radius_m = 3.0
to_slope_deg = 0                # turns from the slope before it to this one
"""
"""TOML text of a fall into a chamfered spoon, with comments."""
