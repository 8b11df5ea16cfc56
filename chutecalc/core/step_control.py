"""Accept or reject a solved panel, locate events inside it, and choose the length of the next one."""

import math

from chutecalc.core import events, floats, friction, gauss, guide_surface, motion, panel, section, state

LEAST_R_FRACTION, FIRST_R_FRACTION = 0.1, 0.15  # of the distance to the goal in r: smallest, and first after one in c
BRANCH_CLEARANCE = 4e-13  # how far beyond an event the branch is read: more than the event's own tolerance
END_TOLERANCE, ROUNDING = 1e-12, 1e-15  # of a panel, and of its variable: an event so near its end is at its end
NEAR_END, OVERSHOOT = 0.98, 1e-6  # of a panel: an event past this is near its end; how far past an event the next goes
MIN_FACTOR, MAX_FACTOR = 0.25, 0.8  # of a rejected panel's length: bounds of the next
JUMP_ITERATIONS = 3  # of Newton's method for the velocity of a jump
UNRESOLVED = 1.5  # least steps: where a panel no longer than that is rejected, no shorter one will do
INNER_ERROR_FACTOR = 10.0  # times the tolerance of a panel's end: error allowed inside where it is cut


def process_events(
    stream: "state.Stream", options: "state.SolverOptions", rule: "gauss.Rule", start: float, end: float
) -> None:
    """Accept a good panel whole, accept it up to the first event inside it, or aim the next panel at that event."""
    in_r, inner_error = stream.panel.in_r, stream.panel.inner_error
    cut, event, event_at_end = floats.INFINITY, -1, -1
    for number in range(events.SEGMENT_END + (1 if in_r else 0)):
        if number == events.SEGMENT_END or stream.active_events[number]:
            for k in range(rule.last + 1):
                at = end if k == rule.last else start + rule.knots[k] * (end - start)
                stream.event_values[k] = event_value_at(stream, number, at, stream.panel.solution[k])
            crossing = events.first_crossing(rule, stream.event_values)
            if crossing < cut:
                cut, event = crossing, number
            last = stream.event_values[rule.last]
            if event_at_end < 0 and last <= events.EVENT_TOLERANCE and last < stream.event_values[0]:
                event_at_end = number
    near = END_TOLERANCE + ROUNDING * math.fabs(end / (end - start))
    if cut > 1.0 - near:
        cut = floats.INFINITY  # the panel was aimed at it
    elif math.fabs(cut * (end - start)) <= ROUNDING * math.fabs(start):
        cut = 0.0
    if cut == 0.0:
        if stream.share == stream.last_crossing:
            shorten_after_chatter(stream, in_r, end - start)
        apply_event(stream, options, event)
    elif cut == floats.INFINITY:
        accept_step(stream, options, rule, end, stream.panel.error)
        if event_at_end >= 0:
            apply_event(stream, options, event_at_end)
    elif inner_error <= INNER_ERROR_FACTOR * options.panel_tolerance and event_confirmed(
        stream, rule, event, start + cut * (end - start), cut
    ):
        accept_until(stream, options, rule, start, end, cut)
        apply_event(stream, options, event)
    else:
        # The event is known roughly only: the next panel ends a little beyond it, so that it lies inside.
        overshoot = 1.0 + min(OVERSHOOT + 10.0 * inner_error, 0.01) if cut < NEAR_END else 1.0
        stream.event_target, stream.target_in_r = start + cut * overshoot * (end - start), in_r


def event_value_at(stream: "state.Stream", event: int, at: float, unknown: float) -> float:
    """Return the value of an event function for given values of the panel's variable and its unknown."""
    if stream.panel.in_r:
        return state.event_function(stream, event, unknown, at * at * at * at)
    return state.event_function(stream, event, at, unknown)


def event_confirmed(stream: "state.Stream", rule: "gauss.Rule", event: int, at: float, cut: float) -> bool:
    """Return whether the event function itself is 0 where its polynomial is, and no other has crossed 0 before.

    It is not 0 at the bottom of a dip, or where a taper bends an event function more than its polynomial can follow.
    """
    unknown = gauss.evaluate(rule, stream.panel.solution, 0, cut)
    allowed = events.EVENT_TOLERANCE + INNER_ERROR_FACTOR * stream.panel.inner_error
    for number in range(events.SEGMENT_END):
        if stream.active_events[number] and event_value_at(stream, number, at, unknown) < -allowed:
            return False
    return math.fabs(event_value_at(stream, event, at, unknown)) <= allowed


def accept_until(
    stream: "state.Stream", options: "state.SolverOptions", rule: "gauss.Rule", start: float, end: float, cut: float
) -> None:
    """Accept a panel up to an event inside it, where its polynomial is accurate too."""
    off, whole = stream.panel.inner_error, stream.panel.solution[rule.last] - stream.panel.solution[0]
    stream.work[0] = 1.0
    for k in range(rule.last):
        stream.work[k + 1] = stream.panel.sensitivity[k]
    stream.panel.sensitivity[rule.count] = gauss.evaluate(rule, stream.work, 0, cut)
    for k in range(rule.last + 1):
        stream.work[k] = gauss.evaluate(rule, stream.panel.solution, 0, cut * rule.knots[k])
    for k in range(rule.last + 1):
        stream.panel.solution[k] = stream.work[k]
    part = stream.panel.solution[rule.last] - stream.panel.solution[0]
    if stream.panel.in_r and part != 0.0:  # in r it is relative to the panel's length, of which this is a part
        off *= math.fabs(whole / part)
    accept_step(stream, options, rule, start + cut * (end - start), off)


def accept_step(
    stream: "state.Stream", options: "state.SolverOptions", rule: "gauss.Rule", end: float, off: float
) -> None:
    """Move the stream to the end of its panel and carry its error along; ``off`` is the error that the panel adds."""
    start, last, sensitivity, off = (
        stream.panel.start,
        stream.panel.solution[rule.last],
        math.fabs(stream.panel.sensitivity[rule.count]),
        off + stream.panel.rounding,
    )
    if options.dense_output:
        store_panel(stream, rule, end)
    if stream.panel.in_r:
        width = math.fabs(end - start)
        start_slope = math.fabs(gauss.derivative_at(rule, stream.panel.solution, 0))  # dc over the panel's width in r
        end_slope = math.fabs(gauss.derivative_at(rule, stream.panel.solution, rule.last))
        carried = stream.error * start * start_slope / (4.0 * width)
        shift = sensitivity * carried + off * math.fabs(last - stream.panel.solution[0]) + panel.SHARE_ROUNDING
        stream.shift = shift
        stream.error = shift if end == 0.0 else floats.quotient(shift * 4.0 * width, end * end_slope)
        stream.share, stream.y = last, end * end * end * end
        if end == 0.0:
            stream.status = state.STALL
        stream.r_fraction = min(2.0 * stream.r_fraction, 1.0)
    else:
        stream.shift = stream.error = sensitivity * stream.error * stream.y / last + off
        stream.share, stream.y = end, last
        if end >= stream.breakpoint:
            reach_breakpoint(stream)
        else:
            # A step that an event cut short says nothing about the next.
            previous = stream.next_step if stream.event_target == stream.event_target else state.LEAST_STEP
            stream.next_step = max(4.0 * (end - start), previous)
            if stream.r_rejected:
                stream.r_fraction, stream.r_rejected = FIRST_R_FRACTION, False
    stream.event_target = floats.NAN


def store_panel(stream: "state.Stream", rule: "gauss.Rule", end: float) -> None:
    """Append the panel to the store for dense output."""
    if stream.store.count >= stream.store.capacity:
        stream.store.full = True
        return
    at = state.PANEL_SIZE * stream.store.count
    stream.store.panels[at], stream.store.panels[at + 1] = stream.panel.in_r, rule.count
    stream.store.panels[at + 2], stream.store.panels[at + 3] = stream.panel.facet, stream.panel.piece
    stream.store.panels[at + 4], stream.store.panels[at + 5] = stream.panel.start, end
    for k in range(rule.last + 1):
        stream.store.panels[at + 6 + k] = stream.panel.solution[k]
    stream.store.count += 1


def reject_step(stream: "state.Stream", options: "state.SolverOptions", kind: int, step: float) -> None:
    """Shorten the next step after a rejected panel: a smaller fraction in r, or a shorter step in c."""
    stream.event_target = floats.NAN
    if kind == panel.IN_R:
        stream.r_fraction *= 0.5
        stream.r_rejected = stream.r_fraction < LEAST_R_FRACTION
    elif step < UNRESOLVED * state.LEAST_STEP:
        end_here(stream, options)
    else:
        stream.next_step = max(shrink_factor(stream.panel, options) * step, state.LEAST_STEP)


def end_here(stream: "state.Stream", options: "state.SolverOptions") -> None:
    """End a stream that not even the least step resolves: it jumps, runs full or comes to rest within that.

    Where pressure along the stream meets a pipe that runs full, both the bracket and the width of the surface fall to
    0 at once, and neither can be told from the other.
    """
    stream.shift += 2.0 * state.LEAST_STEP
    if stream.guide.longitudinal > 0.0:
        apply_event(stream, options, events.JUMP)
    elif guide_surface.full_velocity(stream.guide) > 0.0:
        stream.error += 2.0 * state.LEAST_STEP
        apply_event(stream, options, events.CHOKE)
    elif not motion.rhs_any_branch(stream.guide, stream.share, stream.y) > 0.0:
        stream.status, stream.y, stream.error = state.STALL, 0.0, 2.0 * state.LEAST_STEP
    else:
        stream.next_step = state.LEAST_STEP


def shrink_factor(trial: "panel.Panel", options: "state.SolverOptions") -> float:
    """Return the fraction of a rejected panel's length that would have met the tolerance, from the ellipse around it.

    A panel of length h that starts at the same share has the ellipse h (z + 1)/2 with z = (ρ + 1/ρ)/2, and the
    tolerance gives the ρ that is needed. Where the panel has no solution, rest lies inside it, about where friction
    frozen at the start would stop the stream. The factor is one half where there was another reason.
    """
    needed_rho: float = (panel.SAFETY / options.panel_tolerance) ** (0.5 / options.step_pair.fine.count)
    reach = 2.0 * trial.stop_share
    if trial.error < floats.INFINITY:
        reach = 0.5 * (trial.ellipse_rho + 1.0 / trial.ellipse_rho) + 1.0
    factor = reach / (0.5 * (needed_rho + 1.0 / needed_rho) + 1.0)
    informative = trial.error < floats.INFINITY or trial.stop_share < 1.0
    return min(max(factor, MIN_FACTOR), MAX_FACTOR) if informative and factor < 1.0 else 0.5


def shorten_after_chatter(stream: "state.Stream", in_r: bool, step: float) -> None:
    """Shorten the step after a panel that led back across the boundary just crossed.

    Next to an unstable equilibrium a long panel lets rounding grow until it decides the direction.
    """
    stream.next_step = max(0.25 * (stream.next_step if in_r else step), state.LEAST_STEP)
    if in_r:
        stream.r_rejected = True


def reach_breakpoint(stream: "state.Stream") -> None:
    """Continue from the breakpoint to the segment's end, or finish there."""
    if stream.breakpoint == 1.0:
        stream.status = state.OK
        return
    stream.breakpoint, stream.next_step = 1.0, 1.0 - stream.share


def apply_event(stream: "state.Stream", options: "state.SolverOptions", event: int) -> None:
    """Change the stream's status or branch as an event at its share demands."""
    stream.event_target = floats.NAN
    if event == events.CONTACT_LOSS:
        stream.status = state.CONTACT_LOST
    elif event == events.CHOKE:
        full = guide_surface.full_velocity(stream.guide)
        if full > 0.0 and stream.attempts > 0:  # it did not enter overfull, so that is its velocity
            stream.y = full * full
        stream.choke_share, stream.choke_y, stream.choke_error = stream.share, stream.y, stream.error
        if not options.dense_output or stream.guide.first.closed:  # between open walls it may rise further
            stream.status = state.CHOKED
    elif event == events.JUMP:
        jump(stream)
    elif event == events.SEGMENT_END:
        stream.share = stream.breakpoint
        reach_breakpoint(stream)
    else:
        stream.last_crossing = stream.share
        guide_surface.set_section(stream.guide, stream.share)
        if event == events.FACET_UP or event == events.FACET_DOWN:
            side = 1 if event == events.FACET_UP else -1
            there = section.facet_of(
                stream.guide.facets, guide_surface.flow_area(stream.guide, stream.y) * (1.0 + side * BRANCH_CLEARANCE)
            )
            stream.facet = next_interval(stream.facet, there, side)
        else:
            side = 1 if event == events.PIECE_UP else -1
            pressure = friction.wall_stress(stream.guide, stream.facet, stream.share, stream.y) * (
                1.0 + side * BRANCH_CLEARANCE
            )
            stream.piece = next_interval(stream.piece, guide_surface.piece_of(stream.guide, pressure), side)


def next_interval(number: int, there: int, side: int) -> int:
    """Return the interval found on one side, or the neighbour on that side if it is nearer."""
    return max(there, number + 1) if side > 0 else min(there, number - 1)


def jump(stream: "state.Stream") -> None:
    """End the stream where the bracket of longitudinal pressure is 0, with the error of the velocity of that place.

    Next to it a place known to 1e-14 says little of the velocity, but there the bracket does.
    """
    step, error = 1e-6, stream.error
    by_share = by_velocity = 0.0
    for _ in range(JUMP_ITERATIONS if stream.attempts > 0 else 0):  # not where it enters beyond the jump
        value = state.event_function(stream, events.JUMP, stream.share, stream.y)
        by_share = state.event_function(stream, events.JUMP, stream.share + step, stream.y) - value
        by_velocity = state.event_function(stream, events.JUMP, stream.share, stream.y * (1.0 + step)) - value
        change = step * floats.quotient(value, by_velocity)
        if change > -0.5 and change < 0.5:
            stream.y *= 1.0 - change
        error = math.fabs(floats.quotient(by_share, by_velocity)) * stream.shift + events.EVENT_TOLERANCE
    stream.status, stream.error = state.JUMPED, error
    if stream.choke_share != stream.choke_share:
        stream.choke_share, stream.choke_y, stream.choke_error = stream.share, stream.y, error
