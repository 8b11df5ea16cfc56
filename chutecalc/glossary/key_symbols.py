"""Which keys of a spec give the symbols of formulas."""

OF_KEYS = {
    "velocity_m_s": "v",
    "slope_deg": "a",
    "to_slope_deg": "a",
    "from_slope_deg": "a",
    "base_m": "B",
    "chamfer_deg": "β",
    "chamfer_m": "L",
    "radius_m": "R",
    "rate_t_h": "ṁ",
    "gravity_m_s2": "g",
    "friction_deg": "φ",
    "density_kg_m3": "ρ",
    "internal_friction_deg": "δ",
    "pressure_ratio": "K_v",
    "sections.facets.slope_deg": "ψ",
    "sections: circular.radius_m": "",
    "sections: pipe.radius_m": "",
    "inlet.belt.velocity_m_s": "",
    "receiver.velocity_m_s": "",
    "receiver.slope_deg": "",
    "receiver.friction_deg": "",
}
"""Symbols of keys by their name, or by table and name where the key has another symbol there, or none."""
