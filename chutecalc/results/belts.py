"""The stream where it leaves the belt that it comes from, and what it does to the belt that it goes to."""

import numpy as np

from chutecalc.design import Design
from chutecalc.physics.belt import discharge, loading
from chutecalc.results.trajectory import Numbers

SQUARE = 1e-9
"""The cosine of the angle between stream and belt below which no velocity along it comes of the stream's."""


def entering(design: Design) -> Numbers:
    """The stream where it enters, each of length 1 or n; from a belt also v²/(g r) and its lower edge."""
    x, z = design.inlet_position
    numbers = {
        "x_m": x,
        "z_m": z,
        "slope_deg": np.degrees(design.inlet_slope),
        "velocity_m_s": design.inlet_velocity,
    }
    if design.belt is not None:
        belt = design.belt
        middle = discharge(belt.velocity, belt.incline, belt.lower_radius, belt.middle_radius, design.gravity)
        reach = belt.lower_radius / belt.middle_radius
        numbers["discharge_froude"] = middle.froude
        numbers["lower_edge_x_m"] = belt.centre[0] + middle.x * reach
        numbers["lower_edge_z_m"] = belt.centre[1] + middle.z * reach
    return numbers


TAKEN = ("velocity_m_s", "slope_deg")
"""Columns at the exit that this takes."""


def received(design: Design, end: Numbers) -> Numbers:
    """What the stream does to the belt, by its columns at the exit; empty where there is no belt."""
    if design.receiver is None:
        return {}
    belt, velocity, slope = design.receiver, end["velocity_m_s"], np.radians(end["slope_deg"])
    onto = loading(velocity, slope, *belt, design.density, design.mass_rate, design.gravity)
    aside = np.cos(slope - belt.slope)
    with np.errstate(all="ignore"):
        turn = np.arccos(np.where(velocity >= belt.velocity, belt.velocity / velocity, np.nan))
        return {
            "velocity_along_m_s": onto.velocity_along,
            "velocity_across_m_s": onto.velocity_across,
            "velocity_ratio": onto.velocity_ratio,
            "impact_pressure_kpa": onto.impact_pressure / 1000.0,
            "wear_w_m2": onto.wear,
            "acceleration_length_m": onto.acceleration_length,
            "acceleration_power_kw": onto.acceleration_power / 1000.0,
            "landed_velocity_m_s": onto.velocity_after_impact,
            "landed_acceleration_length_m": onto.length_after_impact,
            "matching_slope_deg": np.degrees(belt.slope + np.where(slope >= belt.slope, turn, -turn)),
            "matching_velocity_m_s": np.where(aside <= SQUARE, np.inf, belt.velocity / aside),
        }
