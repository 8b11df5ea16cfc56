"""One stream along one segment: panel after panel, and the events that end or divide its way.

The stream first tries the whole way in one panel. Where the two rules disagree it goes on in its own steps: in c while
the velocity changes gently, in r = √v towards a stop or away from rest. A panel never crosses a kink of the friction
law (the top of a facet, a row of a yield locus): it is cut there, as where the stream chokes or loses contact.
"""

import math

from chutecalc.core import acceptance, collocation, events, floats, friction, gauss, panel, section, slide, state

STOPPING, STARTING = 0.8, 0.02  # of the way that is left: rest nearer than that ahead or behind takes a panel in r
SHY, AWAY = 0.667, 2.0  # of the distance to rest ahead or behind: as far as a panel in c may reach
STIFF = -6.0  # ∂f/∂y times a panel's length from which on the stream clings to a balance
PASSES = 2000  # a bound, so that no input can hang
MOST = PASSES  # as Python sees it
CREEP, PATIENCE = 1e-3, 60  # m/s below which a stream that needs more panels than that counts as stalled


def run(stream: "state.Stream", effort: "state.Effort") -> None:
    """Carries the stream from its place, y and error to where it ends; its status says how."""
    begin(stream, effort)
    if stream.status == state.RUNNING:
        advance(stream, effort, panel.WHOLE, stream.limit, effort.first, effort.tolerance)
        if stream.promising and stream.status == state.RUNNING:
            advance(stream, effort, panel.PLACE, stream.limit, effort.second, effort.tolerance)
    for _ in range(PASSES):
        if stream.status != state.RUNNING:
            return
        change, growth = friction.pull_and_growth(stream.way, stream.facet, stream.piece, stream.place, stream.y)
        if not (stops(stream, change) or crosses(stream, effort, change)):
            go_on(stream, effort, change, growth)
    stream.status = state.UNSOLVED


def begin(stream: "state.Stream", effort: "state.Effort") -> None:
    """Where it stands at first, and what can happen to it."""
    stream.status, stream.tried = state.RUNNING, 0
    stream.stride, stream.tired, stream.promising = 1.0, False, True
    stream.aim = stream.crossed = stream.choke_place = stream.choke_y = stream.choke_error = floats.NAN
    slide.draw(stream.way, stream.place)
    stream.facet = (
        section.facet_of(stream.way.facets, slide.flow_area(stream.way, stream.y)) if stream.way.facets.count > 1 else 0
    )
    stream.piece = 0
    if stream.way.pieces > 1:
        stream.piece = slide.piece_of(stream.way, friction.stress(stream.way, stream.facet, stream.place, stream.y))
    stream.limit = first_limit(stream.way, stream.place)
    stream.reach = stream.limit - stream.place
    stream.watched[events.CONTACT] = (
        stream.way.side < 0.0 or stream.way.turn > 0.0
    )  # all else presses on its floor by weight alone
    stream.watched[events.CHOKE] = stream.way.first.wall_height < floats.INFINITY
    stream.watched[events.DEEPER] = stream.watched[events.SHALLOWER] = stream.way.facets.count > 1
    stream.watched[events.FIRMER] = stream.watched[events.LOOSER] = stream.way.pieces > 1
    stream.eventful = False
    for event in range(events.END):
        if stream.watched[event]:
            stream.eventful = True
    if (
        stream.watched[events.CONTACT]
        and slide.normal(stream.way, stream.place, stream.y) < -events.LEVEL * stream.way.gravity
    ):
        stream.status = state.CONTACT_LOST
    elif stream.watched[events.CHOKE] and state.margin(stream, events.CHOKE, stream.place, stream.y) < -events.LEVEL:
        acceptance.happen(stream, effort, events.CHOKE)


def first_limit(way: "slide.Slide", place: float) -> float:
    """Where the first panel has to end: a roof that first rises is divided where it is level.

    There, and only there, the normal acceleration can fall to 0 and rise again within a segment.
    """
    if way.side > 0.0 or way.turn <= 0.0:
        return 1.0
    level = -way.entry_slope / way.turn
    return level if place < level < 1.0 else 1.0


def stops(stream: "state.Stream", change: float) -> bool:
    """Stalls that no panel finds: where rest is nearer than any step, or a stream clings to a balance next to it.

    Of the second no place could be told: its error is what is left of the segment.
    """
    if stream.y < -2.0 * state.LEAST_STEP * change:  # from twice as far the least step is short enough
        stream.status, stream.y, stream.error = state.STALL, 0.0, 2.0 * state.LEAST_STEP
        return True
    if stream.tried > PATIENCE and stream.y < CREEP * CREEP:
        stream.status, stream.error = state.STALL, 1.0 - stream.place
        return True
    return False


def crosses(stream: "state.Stream", effort: "state.Effort", change: float) -> bool:
    """Takes a stream that stands at an event, on its way into it, beyond it.

    Not one that has just come over one there: where it clings to a balance, which way it goes in the first instant is
    noise, and only a panel tells.
    """
    if not stream.eventful or stream.place == stream.crossed:
        return False
    step = 1e-6
    for event in range(events.END):
        if stream.watched[event]:
            here = state.margin(stream, event, stream.place, stream.y)
            if here <= events.LEVEL:
                along = state.margin(stream, event, stream.place + step, stream.y) - here
                faster = state.margin(stream, event, stream.place, stream.y * (1.0 + step)) - here
                if along + faster * change / stream.y < 0.0:
                    acceptance.happen(stream, effort, event)
                    return True
    return False


def go_on(stream: "state.Stream", effort: "state.Effort", change: float, growth: float) -> None:
    """The next panel: in r towards a stop that is near, or away from a start near rest; in c else.

    Panels that turn out too long are refused and shortened.
    """
    if stream.aim == stream.aim:
        if stream.aim_by_root:
            advance(stream, effort, panel.ROOT, stream.aim, effort.near_rest, effort.share)
        else:
            advance_by_place(stream, effort, stream.aim, growth)
        return
    rest, scale = stream.limit - stream.place, math.fabs(floats.quotient(stream.y, change))
    if not stream.tired and change < 0.0 and scale < STOPPING * rest:
        goal = math.sqrt(slowest(stream))
    elif not stream.tired and change > 0.0 and scale < STARTING * rest:
        goal = min(math.sqrt(math.sqrt(stream.y + 0.5 * change * rest)), math.sqrt(fastest(stream)))
    else:
        step = min(stream.reach, (SHY if change < 0.0 else AWAY) * scale)
        target = stream.place + step if step < rest else stream.limit
        advance_by_place(stream, effort, target, growth)
        return
    if stream.stride < 1.0:
        start = math.sqrt(math.sqrt(stream.y))
        goal = start + stream.stride * (goal - start)
    advance(stream, effort, panel.ROOT, goal, effort.near_rest, effort.share)


def advance_by_place(stream: "state.Stream", effort: "state.Effort", target: float, growth: float) -> None:
    """A panel in c, of the kind that its length asks for."""
    kind = panel.CLINGING if growth * (target - stream.place) < STIFF else panel.PLACE
    advance(stream, effort, kind, target, effort.later, effort.share)


def slowest(stream: "state.Stream") -> float:
    """The velocity from which on the surface stays on its facet, and below the wall; 0 along a taper."""
    top = floats.INFINITY
    if stream.way.taper:
        return 0.0
    if stream.facet + 1 < stream.way.facets.count:
        top = stream.way.facets.area[stream.facet + 1]
    if stream.watched[events.CHOKE] and stream.choke_place != stream.choke_place:
        top = min(top, slide.choke_area(stream.way, stream.place))
    return floats.quotient(stream.way.flow, top)


def fastest(stream: "state.Stream") -> float:
    """The velocity up to which the surface stays on its facet; infinite along a taper."""
    return (
        floats.INFINITY if stream.way.taper else floats.quotient(stream.way.flow, stream.way.facets.area[stream.facet])
    )


def advance(
    stream: "state.Stream", effort: "state.Effort", kind: int, target: float, pair: "gauss.Pair", tolerance: float
) -> None:
    """Solves one panel and takes it whole, up to an event inside it, or not at all."""
    stream.tried += 1
    stream.panel.facet, stream.panel.piece = stream.facet, stream.piece
    stream.panel.error = floats.INFINITY
    start = stream.place
    if kind == panel.ROOT:
        start = math.sqrt(math.sqrt(stream.y))
        if target != start:
            collocation.by_root(stream.panel, stream.way, start, target - start, stream.place, pair)
    elif target > start:
        collocation.by_place(stream.panel, stream.way, start, target - start, stream.y, pair, kind, tolerance)
    good = stream.panel.error <= tolerance
    if effort.complete:
        good = good and stream.panel.inner_error <= effort.tolerance
    stream.promising = not good and stream.panel.error < floats.INFINITY
    if stream.promising:  # as far as the ellipse tells what the finest rules would leave
        stream.promising = panel.SAFETY * stream.panel.smooth ** (-2 * effort.second.fine.count) <= tolerance
    if not good:
        acceptance.retreat(stream, effort, kind, target - start)
    elif stream.eventful or kind == panel.ROOT:
        acceptance.judge(stream, effort, pair.fine, start, target)
    else:
        acceptance.accept(stream, effort, pair.fine, target, stream.panel.error)
