"""Integrate one stream along one segment, panel by panel, up to the events that end or divide it.

The whole segment is tried as one panel first. If the error estimate refuses it, the solver takes its own steps: in the
share c while the velocity changes gently, in r = √v towards a stop or away from rest. A panel never crosses a kink of
the friction law (the top of a facet, a row of a yield locus); it is cut there, and where the stream chokes or loses
contact.
"""

import math

from chutecalc.core import (
    collocation,
    events,
    floats,
    friction,
    gauss,
    guide_surface,
    longitudinal,
    motion,
    panel,
    section,
    state,
    step_control,
)

STOP_AHEAD, REST_BEHIND = 0.8, 0.02  # of what is left: rest nearer than that takes a panel in r
STEP_DECELERATING, STEP_ACCELERATING = 0.667, 2.0  # of the distance to rest ahead or behind: longest panel in c
NEARLY_FULL, STEP_TO_FULL = 1e-7, 1.5  # of v²: a pipe so near to full takes one panel up to it, and a little beyond
STIFFNESS_LIMIT = -6.0  # ∂f/∂y times a panel's length below which the equation is stiff
BEYOND_JUMP = 0.02  # of the distance to it in r
NEXT_TO_FULL = 1e-4  # of v²: a stream that jumps so near to full has hardly any surface there
MANY = 10  # times as fast a stream has stalled if it takes as many times more panels
JUMP_PANELS, NEAR_JUMP = 100, 0.02  # so near to a jump, of v², a stream that takes more panels follows it: it counts
BEHIND = 1e-7  # share: how far behind a taper is looked at, where the stream is sure to flow
MAX_PANELS = 2000  # a bound, so that no input can hang
MOST_PANELS = MAX_PANELS  # for Python; the other is a C constant if compiled
CREEP_VELOCITY, CREEP_PANELS = 1e-3, 60  # m/s; a slower one that ends so, or takes more panels than that, has stalled


def solve_segment(stream: "state.Stream", options: "state.SolverOptions") -> None:
    """Integrate the stream from its share, y and error to where it ends; its status says how it ended."""
    initialise(stream, options)
    if stream.status == state.RUNNING:
        try_panel(stream, options, panel.FULL_SEGMENT, stream.breakpoint, options.first_pair, options.tolerance)
        if stream.try_finer and stream.status == state.RUNNING:
            try_panel(stream, options, panel.IN_SHARE, stream.breakpoint, options.second_pair, options.tolerance)
    for _ in range(MAX_PANELS):
        if stream.status != state.RUNNING:
            break
        change, jacobian = motion.rhs_and_jacobian(stream.guide, stream.facet, stream.piece, stream.share, stream.y)
        if not (
            detect_jump(stream, options, change)
            or detect_full(stream, options, change)
            or detect_stall(stream, change)
            or cross_event(stream, options, change)
        ):
            next_panel(stream, options, change, jacobian)
    if stream.status == state.RUNNING:  # beyond the choke of open walls there need be no end
        stream.status = state.UNSOLVED if stream.choke_share != stream.choke_share else state.CHOKED
    elif stream.status == state.OK and stream.y < CREEP_VELOCITY * CREEP_VELOCITY:
        stream.status = state.STALL  # as good as at rest, as it may not enter either


def initialise(stream: "state.Stream", options: "state.SolverOptions") -> None:
    """Set the branch, the breakpoint, the first step and the events that can occur on this segment."""
    stream.status, stream.attempts = state.RUNNING, 0
    stream.r_fraction, stream.r_rejected, stream.try_finer, stream.shift = 1.0, False, True, 0.0
    stream.event_target = stream.last_crossing = stream.choke_share = stream.choke_y = stream.choke_error = floats.NAN
    guide_surface.set_section(stream.guide, stream.share)
    stream.facet = (
        section.facet_of(stream.guide.facets, guide_surface.flow_area(stream.guide, stream.y))
        if stream.guide.facets.count > 1
        else 0
    )
    stream.piece = 0
    if stream.guide.pieces > 1:
        stream.piece = guide_surface.piece_of(
            stream.guide, friction.wall_stress(stream.guide, stream.facet, stream.share, stream.y)
        )
    stream.breakpoint = first_breakpoint(stream.guide, stream.share)
    stream.next_step = stream.breakpoint - stream.share
    # On all but hoods and crests weight alone presses the stream on its floor.
    stream.active_events[events.CONTACT_LOSS] = stream.guide.side < 0.0 or stream.guide.turn > 0.0
    stream.active_events[events.CHOKE] = stream.guide.first.wall_height < floats.INFINITY
    stream.active_events[events.JUMP] = stream.guide.longitudinal > 0.0
    stream.active_events[events.FACET_UP] = stream.active_events[events.FACET_DOWN] = stream.guide.facets.count > 1
    stream.active_events[events.PIECE_UP] = stream.active_events[events.PIECE_DOWN] = stream.guide.pieces > 1
    stream.has_events = False
    for event in range(events.SEGMENT_END):
        if stream.active_events[event]:
            stream.has_events = True
    if (
        stream.active_events[events.CONTACT_LOSS]
        and guide_surface.normal_acceleration(stream.guide, stream.share, stream.y)
        < -events.EVENT_TOLERANCE * stream.guide.gravity
    ):
        stream.status = state.CONTACT_LOST
    elif (
        stream.active_events[events.CHOKE]
        and state.event_function(stream, events.CHOKE, stream.share, stream.y) < -events.EVENT_TOLERANCE
    ):
        step_control.apply_event(stream, options, events.CHOKE)
    if (
        stream.status == state.RUNNING
        and stream.active_events[events.JUMP]
        and not state.event_function(stream, events.JUMP, stream.share, stream.y) > events.EVENT_TOLERANCE
    ):
        step_control.apply_event(stream, options, events.JUMP)
    if stream.status == state.RUNNING and stream.share >= 1.0:  # it has struck the end
        stream.status = state.OK


def pass_plate(stream: "state.Stream", options: "state.SolverOptions") -> None:
    """Let a stream leave a plate where it strikes it, unless it is too deep for the section there."""
    stream.status, stream.attempts = state.OK, 0
    deep = state.event_function(stream, events.CHOKE, stream.share, stream.y) < -events.EVENT_TOLERANCE
    if stream.guide.first.wall_height < floats.INFINITY and deep:
        step_control.apply_event(stream, options, events.CHOKE)


def first_breakpoint(guide: "guide_surface.Guide", share: float) -> float:
    """Return the share at which the first panel has to end: 1, or where a roof that first rises is level.

    Only there can the normal acceleration fall to 0 and rise again within a segment.
    """
    if guide.side > 0.0 or guide.turn <= 0.0:
        return 1.0
    level = -guide.entry_slope / guide.turn
    return level if share < level < 1.0 else 1.0


def detect_stall(stream: "state.Stream", change: float) -> bool:
    """Stop the stream where no panel can resolve the stall; return whether it did.

    Either rest is nearer than the least step, or the stream creeps along an equilibrium next to rest. In the second
    case the position of the stall is unknown: its error is all that is left of the segment.
    """
    if stream.y < -2.0 * state.LEAST_STEP * change:  # from twice as far the least step is short enough
        stream.status, stream.y, stream.error = state.STALL, 0.0, 2.0 * state.LEAST_STEP
        return True
    creep = CREEP_VELOCITY if stream.attempts < MANY * CREEP_PANELS else MANY * CREEP_VELOCITY
    if stream.attempts > CREEP_PANELS and stream.y < creep * creep:
        stream.status, stream.error = state.STALL, 1.0 - stream.share
        return True
    return False


def detect_jump(stream: "state.Stream", options: "state.SolverOptions", change: float) -> bool:
    """End the stream where it jumps within the least step, or has come a little beyond; return whether it did.

    No panel can resolve that. A stream with pressure along it gets neither to rest nor to a full pipe before. Where it
    jumps next to full the surface is so narrow that rounding hides the rest of the way, which counts as its error.
    One that follows the line on which streams jump has no place for its jump but this, or any further on.
    """
    if stream.guide.longitudinal == 0.0:
        return False
    jump = longitudinal.jump_ahead(stream.guide, stream.facet, stream.share, stream.y)
    approach, above = approach_rate(stream, change, jump, 0.0), 0.5 * (stream.y - jump)
    full = guide_surface.full_velocity(stream.guide)
    if full > 0.0 and jump > 0.0 and above < NEARLY_FULL * stream.y and jump - full * full < NEXT_TO_FULL * stream.y:
        stream.shift += math.fabs(floats.quotient(above, approach))
    elif stream.attempts > JUMP_PANELS and jump > 0.0 and above < NEAR_JUMP * stream.y:
        stream.shift += 1.0 - stream.share
    elif change == change and not above < -2.0 * state.LEAST_STEP * approach:
        return False
    step_control.apply_event(stream, options, events.JUMP)
    return True


def detect_full(stream: "state.Stream", options: "state.SolverOptions", change: float) -> bool:
    """Choke the stream where a pipe runs full within the least step; return whether it did.

    No panel can resolve that, nor one that starts in a full pipe. It comes before the rest that may be as near.
    """
    full = guide_surface.full_velocity(stream.guide)
    if full == 0.0 or stream.y - full * full >= 2.0 * state.LEAST_STEP * math.fabs(change):
        return False
    stream.error += 2.0 * state.LEAST_STEP
    step_control.apply_event(stream, options, events.CHOKE)
    return True


def cross_event(stream: "state.Stream", options: "state.SolverOptions", change: float) -> bool:
    """Apply an event at which the stream stands if it is moving into it; return whether it did.

    A stream that has just crossed one at this share is left alone: near an equilibrium the direction of the first
    instant is rounding noise, and only a panel can tell.
    """
    if not stream.has_events or stream.share == stream.last_crossing:
        return False
    step = 1e-6
    for event in range(events.SEGMENT_END):
        if stream.active_events[event]:
            value = state.event_function(stream, event, stream.share, stream.y)
            if value <= events.EVENT_TOLERANCE:
                by_share = state.event_function(stream, event, stream.share + step, stream.y) - value
                by_velocity = state.event_function(stream, event, stream.share, stream.y * (1.0 + step)) - value
                if by_share + by_velocity * change / stream.y < 0.0:
                    step_control.apply_event(stream, options, event)
                    return True
    return False


def next_panel(stream: "state.Stream", options: "state.SolverOptions", change: float, jacobian: float) -> None:
    """Choose and try the next panel.

    It is in r towards a stop that is near or away from a start near rest, and in c otherwise. A panel that turns out
    too long is rejected and shortened. In a pipe the velocity at which it runs full takes the place of rest: friction
    has a branch point there, (v - v_full)^(2/3), which r does not remove. Panels in c shrink with the distance to it;
    what is left of the term falls with its power 5/3, so the last few 1e-7 take one panel. With longitudinal pressure
    the jump takes the place of rest: v² falls with the root of the distance to it, and c is smooth in r.
    """
    if stream.event_target == stream.event_target:
        if stream.target_in_r:
            try_panel(stream, options, panel.IN_R, stream.event_target, options.r_pair, options.panel_tolerance)
        else:
            step_in_share(stream, options, stream.event_target, jacobian)
        return
    full = guide_surface.full_velocity(stream.guide)
    jump = longitudinal.jump_ahead(stream.guide, stream.facet, stream.share, stream.y)
    above = 0.5 * (stream.y - jump) if jump > 0.0 else stream.y - full * full
    approach = approach_rate(stream, change, jump, full)
    rest, scale = stream.breakpoint - stream.share, math.fabs(floats.quotient(above, approach))
    if full > 0.0 and jump == 0.0:
        longest = STEP_DECELERATING if above > NEARLY_FULL * stream.y else STEP_TO_FULL
        step = min(stream.next_step, (longest if approach < 0.0 else STEP_ACCELERATING) * scale)
        step_in_share(stream, options, stream.share + step if step < rest else stream.breakpoint, jacobian)
        return
    if not stream.r_rejected and change < 0.0 and scale < STOP_AHEAD * rest:
        goal = math.sqrt(slowest_on_branch(stream))
        if jump > 0.0:  # a little beyond, so that it lies inside
            start, least = math.sqrt(math.sqrt(stream.y)), math.sqrt(math.sqrt(jump))
            goal = max(goal, least - BEYOND_JUMP * (start - least))
            if full > 0.0:
                goal = max(goal, 0.5 * (least + math.sqrt(full)))
    elif not stream.r_rejected and change > 0.0 and scale < REST_BEHIND * rest:
        goal = min(math.sqrt(math.sqrt(stream.y + 0.5 * change * rest)), math.sqrt(fastest_on_branch(stream)))
    else:
        step = min(stream.next_step, (STEP_DECELERATING if approach < 0.0 else STEP_ACCELERATING) * scale)
        target = stream.share + step if step < rest else stream.breakpoint
        step_in_share(stream, options, target, jacobian)
        return
    if stream.r_fraction < 1.0:
        start = math.sqrt(math.sqrt(stream.y))
        goal = start + stream.r_fraction * (goal - start)
    try_panel(stream, options, panel.IN_R, goal, options.r_pair, options.panel_tolerance)


def approach_rate(stream: "state.Stream", change: float, jump: float, full: float) -> float:
    """Return dy/dc less that of the v² below which the stream jumps, or runs full: along a taper that changes too."""
    limit = jump if jump > 0.0 else full * full
    if not stream.guide.taper or limit == 0.0:
        return change
    before = stream.share - BEHIND
    if jump > 0.0:
        there = longitudinal.jump_ahead(stream.guide, stream.facet, before, stream.y)
    else:
        guide_surface.set_section(stream.guide, before)
        there = guide_surface.full_velocity(stream.guide) * guide_surface.full_velocity(stream.guide)
    guide_surface.set_section(stream.guide, stream.share)
    return change - (limit - there) / BEHIND


def step_in_share(stream: "state.Stream", options: "state.SolverOptions", target: float, jacobian: float) -> None:
    """Try a panel in c up to a target, collocated as a stiff equation where its length calls for it."""
    kind = panel.IN_SHARE_STIFF if jacobian * (target - stream.share) < STIFFNESS_LIMIT else panel.IN_SHARE
    try_panel(stream, options, kind, target, options.step_pair, options.panel_tolerance)


def slowest_on_branch(stream: "state.Stream") -> float:
    """Return the velocity above which the free surface stays on its facet and below the walls; 0 along a taper."""
    top = floats.INFINITY
    if stream.guide.taper:
        return 0.0
    if stream.facet + 1 < stream.guide.facets.count:
        top = stream.guide.facets.area[stream.facet + 1]
    if stream.active_events[events.CHOKE] and stream.choke_share != stream.choke_share:
        top = min(top, guide_surface.choke_area(stream.guide, stream.share))
    return floats.quotient(stream.guide.flow, top)


def fastest_on_branch(stream: "state.Stream") -> float:
    """Return the velocity up to which the free surface stays on its facet; infinite along a taper."""
    return (
        floats.INFINITY
        if stream.guide.taper
        else floats.quotient(stream.guide.flow, stream.guide.facets.area[stream.facet])
    )


def try_panel(
    stream: "state.Stream",
    options: "state.SolverOptions",
    kind: int,
    target: float,
    pair: "gauss.RulePair",
    tolerance: float,
) -> None:
    """Solve one panel, then accept it whole, accept it up to an event inside it, or reject it."""
    stream.attempts += 1
    stream.panel.facet, stream.panel.piece = stream.facet, stream.piece
    stream.panel.error = floats.INFINITY
    start = stream.share
    if kind == panel.IN_R:
        start = math.sqrt(math.sqrt(stream.y))
        if target != start:
            collocation.solve_in_r(stream.panel, stream.guide, start, target - start, stream.share, pair)
    elif target > start:
        collocation.solve_in_share(stream.panel, stream.guide, start, target - start, stream.y, pair, kind, tolerance)
    good = stream.panel.error <= tolerance
    if options.dense_output:
        good = good and stream.panel.inner_error <= options.tolerance
    stream.try_finer = not good and stream.panel.error < floats.INFINITY
    if stream.try_finer:  # by what the ellipse says the finest rules would leave
        stream.try_finer = panel.SAFETY * stream.panel.ellipse_rho ** (-2 * options.second_pair.fine.count) <= tolerance
    if not good:
        step_control.reject_step(stream, options, kind, target - start)
    elif stream.has_events or kind == panel.IN_R:
        step_control.process_events(stream, options, pair.fine, start, target)
    else:
        step_control.accept_step(stream, options, pair.fine, target, stream.panel.error)
