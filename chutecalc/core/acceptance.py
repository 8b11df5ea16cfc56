"""What a solved panel, and an event, do to a stream: it is moved on, stopped, or tried again shorter."""

import math

from chutecalc.core import events, floats, friction, gauss, panel, section, slide, state

TIRED, AGAIN = 0.1, 0.15  # of the way to its goal: the least that a panel in r tries, and the first after one in c
CLEAR = 4e-13  # beyond an event by more than it is found within
AT_END, ROUNDING = 1e-12, 1e-15  # of a panel, and of its variable: an event so near its end is at its end
CLOSE, BEYOND = 0.98, 1e-6  # of a panel: an event behind that is near its end; how far beyond an event the next goes
LEAST_SHARE, MOST_SHARE = 0.25, 0.8  # of a refused panel's length: the least and the most that is tried next
WELL_WITHIN = 10.0  # times the error of a panel's end, that its inside may have where it is cut


def judge(stream: "state.Stream", effort: "state.Effort", rule: "gauss.Rule", start: float, end: float) -> None:
    """Takes a good panel whole, up to an event inside it, or aims the next one at that event."""
    by_root, inner_error = stream.panel.by_root, stream.panel.inner_error
    cut, event, standing = floats.INFINITY, -1, -1
    for number in range(events.END + (1 if by_root else 0)):
        if number == events.END or stream.watched[number]:
            for k in range(rule.last + 1):
                at = end if k == rule.last else start + rule.knots[k] * (end - start)
                stream.margins[k] = margin_at(stream, number, at, stream.panel.knots[k])
            crossing = events.first_crossing(rule, stream.margins)
            if crossing < cut:
                cut, event = crossing, number
            last = stream.margins[rule.last]
            if standing < 0 and last <= events.LEVEL and last < stream.margins[0]:
                standing = number
    near = AT_END + ROUNDING * math.fabs(end / (end - start))
    if cut > 1.0 - near:
        cut = floats.INFINITY  # found before, and aimed at
    elif math.fabs(cut * (end - start)) <= ROUNDING * math.fabs(start):
        cut = 0.0
    if cut == 0.0:
        if stream.place == stream.crossed:
            chatter(stream, by_root, end - start)
        happen(stream, effort, event)
    elif cut == floats.INFINITY:
        accept(stream, effort, rule, end, stream.panel.error)
        if standing >= 0:
            happen(stream, effort, standing)
    elif inner_error <= WELL_WITHIN * effort.share and happens(stream, rule, event, start, end, cut):
        accept_part(stream, effort, rule, start, end, cut)
        happen(stream, effort, event)
    else:
        # Where the event is only roughly known, the next panel goes a little beyond it: then it lies inside.
        spare = 1.0 + min(BEYOND + 10.0 * inner_error, 0.01) if cut < CLOSE else 1.0
        stream.aim, stream.aim_by_root = start + cut * spare * (end - start), by_root


def margin_at(stream: "state.Stream", event: int, at: float, unknown: float) -> float:
    """How far an event is where a panel's variable and its unknown have these values."""
    if stream.panel.by_root:
        return state.margin(stream, event, unknown, at * at * at * at)
    return state.margin(stream, event, at, unknown)


def happens(stream: "state.Stream", rule: "gauss.Rule", event: int, start: float, end: float, cut: float) -> bool:
    """Whether the event is where its margin's polynomial falls to 0.

    Not at the bottom of a dip, nor where a taper bends the margin more than its polynomial can.
    """
    unknown = gauss.evaluate(rule, stream.panel.knots, 0, cut)
    off = math.fabs(margin_at(stream, event, start + cut * (end - start), unknown))
    return off <= events.LEVEL + WELL_WITHIN * stream.panel.inner_error


def accept_part(
    stream: "state.Stream", effort: "state.Effort", rule: "gauss.Rule", start: float, end: float, cut: float
) -> None:
    """Takes a panel up to an event inside it, where its polynomial is right too."""
    off, whole = stream.panel.inner_error, stream.panel.knots[rule.last] - stream.panel.knots[0]
    stream.values[0] = 1.0
    for k in range(rule.last):
        stream.values[k + 1] = stream.panel.growth[k]
    stream.panel.growth[rule.count] = gauss.evaluate(rule, stream.values, 0, cut)
    for k in range(rule.last + 1):
        stream.values[k] = gauss.evaluate(rule, stream.panel.knots, 0, cut * rule.knots[k])
    for k in range(rule.last + 1):
        stream.panel.knots[k] = stream.values[k]
    part = stream.panel.knots[rule.last] - stream.panel.knots[0]
    if stream.panel.by_root and part != 0.0:  # in r it is relative to the way of the panel, of which this is a part
        off *= math.fabs(whole / part)
    accept(stream, effort, rule, start + cut * (end - start), off)


def accept(stream: "state.Stream", effort: "state.Effort", rule: "gauss.Rule", end: float, off: float) -> None:
    """Moves the stream to the end of its panel, which is off by so much."""
    start, last, growth, off = (
        stream.panel.start,
        stream.panel.knots[rule.last],
        math.fabs(stream.panel.growth[rule.count]),
        off + stream.panel.rounding,
    )
    if effort.complete:
        keep(stream, rule, end)
    if stream.panel.by_root:
        width = math.fabs(end - start)
        fast = math.fabs(gauss.slope_at(rule, stream.panel.knots, 0))  # dc over the panel's width in r
        slow = math.fabs(gauss.slope_at(rule, stream.panel.knots, rule.last))
        carried = stream.error * start * fast / (4.0 * width)
        shift = growth * carried + off * math.fabs(last - stream.panel.knots[0]) + panel.PLACE_ROUNDING
        stream.error = shift if end == 0.0 else floats.quotient(shift * 4.0 * width, end * slow)
        stream.place, stream.y = last, end * end * end * end
        if end == 0.0:
            stream.status = state.STALL
        stream.stride = min(2.0 * stream.stride, 1.0)
    else:
        stream.error = growth * stream.error * stream.y / last + off
        stream.place, stream.y = end, last
        if end >= stream.limit:
            arrive(stream)
        else:
            # A step that was cut short by an event says nothing.
            before = stream.reach if stream.aim == stream.aim else state.LEAST_STEP
            stream.reach = max(4.0 * (end - start), before)
            if stream.tired:
                stream.stride, stream.tired = AGAIN, False
    stream.aim = floats.NAN


def keep(stream: "state.Stream", rule: "gauss.Rule", end: float) -> None:
    """Writes down a panel."""
    if stream.log.count >= stream.log.room:
        stream.log.full = True
        return
    at = state.KEPT * stream.log.count
    stream.log.kept[at], stream.log.kept[at + 1] = stream.panel.by_root, rule.count
    stream.log.kept[at + 2], stream.log.kept[at + 3] = stream.panel.facet, stream.panel.piece
    stream.log.kept[at + 4], stream.log.kept[at + 5] = stream.panel.start, end
    for k in range(rule.last + 1):
        stream.log.kept[at + 6 + k] = stream.panel.knots[k]
    stream.log.count += 1


def retreat(stream: "state.Stream", effort: "state.Effort", kind: int, step: float) -> None:
    """After a panel that was too long: a step in c instead of one in r, or as much of the step as is likely to do."""
    stream.aim = floats.NAN
    if kind == panel.ROOT:
        stream.stride *= 0.5
        stream.tired = stream.stride < TIRED
    else:
        stream.reach = max(likely(stream.panel, effort) * step, state.LEAST_STEP)


def likely(own: "panel.Panel", effort: "state.Effort") -> float:
    """The share of a refused panel's length that would have been good, by what bounds the ellipse around it.

    From the start that is at h (z + 1)/2 with z = (ρ + 1/ρ)/2; how large ρ has to be follows from the tolerance. Where
    the panel is no solution at all, rest lies inside it, about where friction as at its start would stop the stream.
    Half of it where something else was the reason.
    """
    wanted: float = (panel.SAFETY / effort.share) ** (0.5 / effort.later.fine.count)
    reach = 2.0 * own.stop
    if own.error < floats.INFINITY:
        reach = 0.5 * (own.smooth + 1.0 / own.smooth) + 1.0
    share = reach / (0.5 * (wanted + 1.0 / wanted) + 1.0)
    told = own.error < floats.INFINITY or own.stop < 1.0
    return min(max(share, LEAST_SHARE), MOST_SHARE) if told and share < 1.0 else 0.5


def chatter(stream: "state.Stream", by_root: bool, step: float) -> None:
    """A panel takes the stream back over the boundary that it has just crossed: a shorter one will tell.

    Next to a balance that does not hold, a long one lets rounding grow until it decides.
    """
    stream.reach = max(0.25 * (stream.reach if by_root else step), state.LEAST_STEP)
    if by_root:
        stream.tired = True


def arrive(stream: "state.Stream") -> None:
    """At the limit: on to the segment's end, or done."""
    if stream.limit == 1.0:
        stream.status = state.OK
        return
    stream.limit, stream.reach = 1.0, 1.0 - stream.place


def happen(stream: "state.Stream", effort: "state.Effort", event: int) -> None:
    """What an event does to a stream that stands at it."""
    stream.aim = floats.NAN
    if event == events.CONTACT:
        stream.status = state.CONTACT_LOST
    elif event == events.CHOKE:
        stream.choke_place, stream.choke_y, stream.choke_error = stream.place, stream.y, stream.error
        if not effort.complete:
            stream.status = state.CHOKED
    elif event == events.END:
        stream.place = stream.limit
        arrive(stream)
    else:
        stream.crossed = stream.place
        slide.draw(stream.way, stream.place)
        if event == events.DEEPER or event == events.SHALLOWER:
            side = 1 if event == events.DEEPER else -1
            there = section.facet_of(stream.way.facets, slide.flow_area(stream.way, stream.y) * (1.0 + side * CLEAR))
            stream.facet = beyond(stream.facet, there, side)
        else:
            side = 1 if event == events.FIRMER else -1
            pressure = friction.stress(stream.way, stream.facet, stream.place, stream.y) * (1.0 + side * CLEAR)
            stream.piece = beyond(stream.piece, slide.piece_of(stream.way, pressure), side)


def beyond(number: int, there: int, side: int) -> int:
    """The interval found on a side of the one left, and the next one at least."""
    return max(there, number + 1) if side > 0 else min(there, number - 1)
