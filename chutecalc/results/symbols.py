"""The symbols of formulas."""

from typing import NamedTuple


class Symbol(NamedTuple):
    """A symbol of formulas."""

    symbol: str
    """As formulas have it; two that go together have a comma between."""
    unit: str
    """As people write it; empty for a number without one."""
    meaning: str
    source: str = ""
    """Publication that defines it; empty where it is chutecalc's own."""


# fmt: off
SYMBOLS = (
    Symbol("A", "m²", "flow area, Q/v", "Paper Eq 7"),
    Symbol("a", "°",
           "slope of the stream below horizontal: 0 is level, 90 falls straight down", "90° - θ of Paper Eq 1"),
    Symbol("α_m", "", "momentum factor, ∫u² dA/(A v²) for a velocity profile u"),
    Symbol("a_b", "°", "slope of the receiving belt below horizontal"),
    Symbol("B", "m", "width of the centre section", "Paper Eq 2"),
    Symbol("b", "m", "greatest width of the stream"),
    Symbol("b_s", "m", "width of the free surface"),
    Symbol("β", "°", "inclination of a chamfer to the centre section", "Paper Eq 4"),
    Symbol("C", "m", "wetted length of one chamfer", "Paper Eq 3"),
    Symbol("χ", "", "what friction on inclined walls adds: μ_e = μ (1 + χ)"),
    Symbol("δ", "°", "effective angle of internal friction", "Paper Eq 4"),
    Symbol("e", "", "share by which the rain of the discrete-element check is denser at the walls"),
    Symbol("f", "", "factor by which a friction law raises hydrostatic wall pressures"),
    Symbol("F", "N", "force of the stream on the steel; F_x along the chute, F_z upwards"),
    Symbol("Fr", "", "Froude number, v/√(n A/b_s)"),
    Symbol("g", "m/s²", "gravity", "Paper Eq 1"),
    Symbol("H", "m", "flow depth, normal to the centre section", "Paper Eq 2"),
    Symbol("i", "°", "angle of incidence between a stream and the surface that it strikes"),
    Symbol("K", "",
           "pressure on a wall over that on the centre section at the same depth, cos²ψ + K_v sin²ψ", "Paper Eq 4"),
    Symbol("K_v", "", "the same for a vertical wall, (1 - sin δ)/(1 + sin δ)", "Paper Eq 2"),
    Symbol("K_l", "", "pressure along the stream over that on the centre section at the same depth"),
    Symbol("κ", "1/m", "curvature, -da/ds: positive where a surface flattens"),
    Symbol("L", "m", "length of a chamfer"),
    Symbol("L_i", "m", "length of surface that an impact strikes"),
    Symbol("l", "m", "wetted length of a wall"),
    Symbol("m", "", "share of the weight that hydrostatic wall pressures do not carry", "N_m/N of Paper Eq 6"),
    Symbol("ṁ", "kg/s", "mass rate"),
    Symbol("μ", "", "wall friction, τ/σ; tan φ for a constant angle", "Paper Eq 2"),
    Symbol("μ_e", "",
           "equivalent friction: friction on all walls over the weight on the centre section", "Paper Eq 2, 11"),
    Symbol("μ_p", "", "friction between particles of the discrete-element check"),
    Symbol("N", "N/m", "weight of the stream on a unit length, ρ g A", "Paper Eq 8"),
    Symbol("N_t", "N/m", "sum of all normal loads on walls", "Paper Eq 6"),
    Symbol("n", "m/s²", "acceleration that presses the stream against its surface: ±(g cos a + α_m κ v²)"),
    Symbol("N_WR", "", "wear number, n/g on an arc", "Roberts (2003)"),
    Symbol("φ", "°", "wall friction angle", "Paper, section 6"),
    Symbol("p", "kPa", "pressure on a wall", "σ_c, σ_z of Paper Eq 4"),
    Symbol("ψ", "°", "inclination of any wall to the centre section"),
    Symbol("Q", "m³/s", "volume rate, ṁ/ρ"),
    Symbol("R", "m", "radius of a curve", "Paper Eq 1"),
    Symbol("r", "m", "radius of a round section"),
    Symbol("r_s", "", "slip velocity at the wall over mean velocity"),
    Symbol("r_b", "", "velocity along the receiving belt over that of the belt"),
    Symbol("ρ", "kg/m³", "bulk density", "Paper Eq 5"),
    Symbol("s", "m", "distance along the stream", "Paper Eq 1"),
    Symbol("σ, τ", "Pa", "normal and shear stress on a wall"),
    Symbol("t", "s", "time since the inlet"),
    Symbol("v", "m/s", "mean velocity of the stream", "Paper Eq 1"),
    Symbol("v_b, v_n", "m/s", "velocity of the stream along the receiving belt, and into it"),
    Symbol("V, V_b", "m/s", "velocity of a belt, and of the receiving one"),
    Symbol("v_c", "m/s", "critical velocity, below which friction slows the stream"),
    Symbol("w", "W/m²", "wear: friction power per area of a wall"),
    Symbol("x, z", "m", "horizontal position along the chute, and height"),
    Symbol("ζ", "m", "depth below the free surface"),
)
# fmt: on
"""Every symbol, in the order of the alphabet."""
