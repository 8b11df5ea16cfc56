"""The stream where it enters a chute, and the belt that it comes from."""

import numpy as np

from chutecalc.design import Belt, Design
from chutecalc.physics.arrays import Array, Numbers
from chutecalc.physics.head_pulley import Discharge, discharge, slide_start

INLET_NUMBERS = {
    "x_m": "horizontal position",
    "z_m": "height",
    "slope_deg": "slope of the stream below horizontal",
    "velocity_m_s": "velocity of the stream",
    "discharge_froude": "v²/(g r) on the pulley",
    "lower_edge_x_m": "horizontal position of the lower edge of the stream",
    "lower_edge_z_m": "height of the lower edge of the stream",
    "load_area_m2": "area of the load on the belt",
    "load_width_m": "width of the load on the belt",
    "material_depth_m": "depth of the load on the belt",
    "belt_fill": "area of the load over the largest",
    "roll_m": "length of the middle roll",
    "held_slope_deg": "slope of a stream that the belt holds to the end",
    "held_velocity_m_s": "velocity of a stream that the belt holds to the end",
    "frictionless_slope_deg": "slope of a stream that slides without friction from the start",
    "frictionless_velocity_m_s": "velocity of a stream that slides without friction from the start",
    "slide_start_deg": "angle on the pulley at which the stream begins to slide",
}
"""All numbers at an inlet, with their meanings."""


def inlet_numbers(design: Design) -> Numbers:
    """Return the stream at the inlet by column name.

    Args:
        design: the chutes.

    Returns:
        Arrays of length 1 or n; from a belt also v²/(g r), the position of the stream's lower edge, the load on a belt
        whose width is given, and the bounds of how a stream leaves that goes round the pulley.
    """
    x, z = design.inlet_position
    numbers = {
        "x_m": x,
        "z_m": z,
        "slope_deg": np.degrees(design.inlet_slope),
        "velocity_m_s": design.inlet_velocity,
    }
    return numbers if design.belt is None else numbers | _belt_numbers(design.belt, design.gravity)


def leaves_belt(belt: Belt, radius: Array, gravity: Array, friction: Array | None) -> Discharge:
    """Return how a line of the stream leaves the belt.

    Args:
        belt: that the stream comes from.
        radius: of the line on the pulley, m, shape (1,) or (designs,).
        gravity: g, m/s².
        friction: angle of the material on the belt, rad; None for a stream that the belt holds to the end.
    """
    return discharge(belt.velocity, belt.incline, belt.lower_radius, radius, gravity, friction)


def _belt_numbers(belt: Belt, gravity: Array) -> Numbers:
    """Return what is known of the belt beside the stream that is solved."""
    lower = leaves_belt(belt, belt.lower_radius, gravity, belt.friction)
    held = leaves_belt(belt, belt.middle_radius, gravity, None)
    numbers = {
        "discharge_froude": held.froude,
        "lower_edge_x_m": belt.centre[0] + lower.x,
        "lower_edge_z_m": belt.centre[1] + lower.z,
    }
    if belt.load is not None:
        numbers |= {
            "load_area_m2": belt.load.area,
            "load_width_m": belt.load.width,
            "material_depth_m": belt.load.depth,
            "belt_fill": belt.load.fill,
            "roll_m": belt.load.roll,
        }
    return numbers | _bounds(belt, held, gravity) if held.carried.any() else numbers


def _bounds(belt: Belt, held: Discharge, gravity: Array) -> Numbers:
    """Return how a stream leaves that the belt holds to the end, and one that slides without friction from the start.

    What happens lies in between. NaN where the stream does not go round the pulley.
    """
    smooth = leaves_belt(belt, belt.middle_radius, gravity, np.zeros(1))
    numbers = {
        "held_slope_deg": np.degrees(held.slope),
        "held_velocity_m_s": held.velocity,
        "frictionless_slope_deg": np.degrees(smooth.slope),
        "frictionless_velocity_m_s": smooth.velocity,
    }
    if belt.friction is not None:
        froude = np.where(held.carried, held.froude, 0.0)
        numbers["slide_start_deg"] = np.degrees(slide_start(froude, belt.incline, belt.friction))
    return {name: np.where(held.carried, values, np.nan) for name, values in numbers.items()}
