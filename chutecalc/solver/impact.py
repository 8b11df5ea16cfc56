"""What happens where a stream strikes a surface: what it keeps, how hard it presses, and what that wears."""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.physics.flight import impact_velocity
from chutecalc.physics.friction import equivalent_friction
from chutecalc.physics.section import take_facet, wetted_facet
from chutecalc.physics.wall import added_friction
from chutecalc.physics.wetting import wetting
from chutecalc.solver.slide import Slide


class Impact(NamedTuple):
    """Impacts of n streams, arrays of shape (n,); 0 where a stream meets the surface along it."""

    footprint: Array
    """Length on which the stream presses, m: H/sin i, or the segment's length where that is shorter."""
    pressure: Array
    """Momentum lost over the footprint, ρ v² sin i · H/footprint, Pa: ρ v² sin² i but on a very short segment."""
    stress: Array
    """What the floor bears there, f (ρ n H + that), Pa."""
    wall_friction: Array
    """μ of the impulse, what the wall's shear stress grows by over what its normal stress does."""
    friction: Array
    """μ_e there."""
    after: Array
    """Velocity along the surface that is left, m/s."""
    wear: Array
    """Friction power per area of the floor over the footprint, W/m², where slip is the mean velocity."""


def impact(slide: Slide, place: Array, velocity: Array, incidence: Array) -> Impact:
    """The impact of a stream on a segment.

    The section has its depth and friction at the arriving velocity. The impact presses on the footprint beside what the
    stream presses with as it runs, f ρ n H, and the friction of that is the segment's own: so the impulse has
    (τ(σ + p) - τ(σ))/p. For a constant wall that is μ; with a yield locus a spoon made of many short straights tends to
    the curve with nothing else. Friction works along v cos i before and what is left after, so slip is their mean; on
    all walls it takes ½ ṁ ((v cos i)² - after²).

    Args:
        slide: the segment and the flow.
        place: where it is struck, as a share of its length, shape (n,).
        velocity: arriving, m/s.
        incidence: i, rad; 0 where the stream comes along the surface.
    """
    struck = incidence > 0.0
    zero = np.zeros(velocity.shape)
    none = Impact(zero, zero, zero, zero, zero, velocity, zero)
    if not struck.any():
        return none
    table, area = slide.facets_at(place), slide.flow / velocity
    facet = take_facet(table, np.broadcast_to(wetted_facet(table, area), velocity.shape))
    wet = wetting(facet, area, slide.equilibrium)
    sine, along = np.sin(incidence), np.maximum(velocity * np.cos(incidence), 0.0)
    footprint = np.minimum(wet.depth / np.where(struck, sine, 0.0), slide.length)
    pressure = slide.density * velocity**2 * sine * wet.depth / footprint
    running = slide.density * np.maximum(slide.normal(place, velocity**2), 0.0) * wet.depth
    wall = added_friction(slide.wall, wet.factor * running, wet.factor * pressure)
    friction = equivalent_friction(wall, wet.excess)
    after = impact_velocity(velocity, incidence, friction)
    impulse = friction * velocity * sine  # of which a stall takes no more than there is to stop
    slip = 0.5 * (along + after) * np.minimum(along / np.where(impulse > 0.0, impulse, np.inf), 1.0)
    wear = wall * wet.factor * pressure * slip
    numbers = (footprint, pressure, wet.factor * (running + pressure), wall, friction, after, wear)
    return Impact._make(np.where(struck, *pair) for pair in zip(numbers, none, strict=True))
