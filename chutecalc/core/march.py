"""One stream along one segment: panel after panel, and the events that end or divide its way.

The stream first tries the whole way in one panel. Where the two rules disagree it goes on in its own steps: in c while
the velocity changes gently, in r = √v towards a stop or away from rest. A panel never crosses a kink of the friction
law (the top of a facet, a row of a yield locus): it is cut there, as where the stream chokes or loses contact.
"""

import math
from array import array

from chutecalc.core import events, floats, gauss, panel, section, slide

OK, STALL, CHOKED, CONTACT_LOST = range(4)
RUNNING, UNSOLVED = -1, -2

LEAST_STEP = 1e-14  # of the segment, so that every step is one
TIRED, AGAIN = 0.1, 0.15  # of the way to its goal: the least that a panel in r tries, and the first after one in c
CLEAR = 4e-13  # beyond an event by more than it is found within
STOPPING, STARTING = 0.5, 0.02  # of the way that is left: rest nearer than that ahead or behind takes a panel in r
SHY, AWAY = 0.667, 2.0  # of the distance to rest ahead or behind: as far as a panel in c may reach
STIFF = -6.0  # ∂f/∂y times a panel's length from which on the stream clings to a balance
PASSES = 2000  # a bound, so that no input can hang
CREEP, PATIENCE = 1e-3, 60  # m/s below which a stream that needs more panels than that counts as stalled
AT_END, ROUNDING = 1e-12, 1e-15  # of a panel, and of its variable: an event so near its end is at its end
CLOSE, BEYOND = 0.98, 1e-6  # of a panel: an event behind that is near its end; how far beyond an event the next goes
WELL_WITHIN = 10.0  # times the error of a panel's end, that its inside may have where it is cut
KEPT = 32  # numbers of a panel that is kept
PANEL, GAVE_UP, MOST = KEPT, UNSOLVED, PASSES  # as Python sees them; the others are C constants where compiled


class Effort:
    """How hard to work, and the rules for it."""

    def __init__(self, first: "gauss.Pair", second: "gauss.Pair", later: "gauss.Pair", near_rest: "gauss.Pair") -> None:
        self.first, self.second = first, second
        """For the whole stretch in one panel; the second where the first does not solve it."""
        self.later, self.near_rest = later, near_rest
        """For panels of a stretch that neither solves; in r."""
        self.tolerance = self.share = self.inner_tolerance = 0.0
        """Error that one panel over the whole stretch may have, relative in v²; each of several (in r: of the way);
        and inside a panel, where errors are shown but not handed on."""
        self.complete = False
        """Keep the panels, right at every place and not at the ends alone; go on past a choke."""


class Stream:
    """Where a stream stands on its segment."""

    def __init__(self, way: "slide.Slide", room: int) -> None:
        self.way = way
        self.panel = panel.Panel()
        self.margins, self.values = floats.zeros(gauss.MOST), floats.zeros(gauss.MOST)
        self.kept = floats.zeros(KEPT * max(room, 1))
        """Panels, one after the other: by root, nodes, facet, piece, start, end, knots."""
        self.room = room
        self.panels = 0
        self.full = False
        """There was no room for a panel."""
        self.watched = array("i", [0] * 7)
        """Which events can happen on this segment at all."""
        self.eventful = False
        self.place = self.y = self.error = 0.0
        """c, v², and its relative error; after a stall, of the place."""
        self.status = RUNNING
        self.facet = self.piece = 0
        self.limit = self.reach = self.stride = 1.0
        """Where the panels have to end; the next step in c; the share of the way to its goal that one in r takes."""
        self.aim = floats.NAN
        """Where an event has fixed the end of the next panel, in c or in r."""
        self.aim_by_root = False
        self.hopeful = True
        """The last panel was a solution, if not a good one, and by its ellipse the finest rules may make it one."""
        self.tried = 0
        """How many panels, also such as were refused."""
        self.tired = False
        """Panels in r failed since the last one in c."""
        self.crossed = floats.NAN
        """Where the friction law's branch last changed."""
        self.choke_place = self.choke_y = self.choke_error = floats.NAN


def run(stream: Stream, effort: Effort) -> None:
    """Carries the stream from its place, y and error to where it ends; its status says how."""
    begin(stream, effort)
    if stream.status == RUNNING:
        advance(stream, effort, panel.WHOLE, stream.limit, effort.first, effort.tolerance)
        if stream.hopeful and stream.status == RUNNING:
            advance(stream, effort, panel.PLACE, stream.limit, effort.second, effort.tolerance)
    for _ in range(PASSES):
        if stream.status != RUNNING:
            return
        change, growth = pull_here(stream)
        if not (stops(stream, change) or crosses(stream, effort, change)):
            go_on(stream, effort, change, growth)
    stream.status = UNSOLVED


def begin(stream: Stream, effort: Effort) -> None:
    """Where it stands at first, and what can happen to it."""
    stream.status, stream.tried, stream.full = RUNNING, 0, False
    stream.stride, stream.tired, stream.hopeful = 1.0, False, True
    stream.aim = stream.crossed = stream.choke_place = stream.choke_y = stream.choke_error = floats.NAN
    slide.draw(stream.way, stream.place)
    stream.facet = (
        section.facet_of(stream.way.facets, slide.flow_area(stream.way, stream.y)) if stream.way.facets.count > 1 else 0
    )
    stream.piece = 0
    if stream.way.pieces > 1:
        stream.piece = slide.piece_of(stream.way, slide.stress(stream.way, stream.facet, stream.place, stream.y))
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
        stream.status = CONTACT_LOST
    elif stream.watched[events.CHOKE] and margin(stream, events.CHOKE, stream.place, stream.y) < -events.LEVEL:
        happen(stream, effort, events.CHOKE)


def first_limit(way: "slide.Slide", place: float) -> float:
    """Where the first panel has to end: a roof that first rises is divided where it is level.

    There, and only there, the normal acceleration can fall to 0 and rise again within a segment.
    """
    if way.side > 0.0 or way.turn <= 0.0:
        return 1.0
    level = -way.entry_slope / way.turn
    return level if place < level < 1.0 else 1.0


def pull_here(stream: Stream) -> tuple[float, float]:
    """dy/dc where the stream stands, and its derivative to y."""
    slope = stream.way.entry_slope + stream.way.turn * stream.place
    unit = 2.0 * stream.way.length * stream.way.gravity
    friction = stream.way.slopes[stream.piece]
    slide.draw(stream.way, stream.place)
    forcing, growth, _, _ = slide.linearised(
        stream.way,
        stream.facet,
        stream.piece,
        slide.flow_area(stream.way, stream.y),
        stream.y / unit,
        math.sin(slope),
        friction * stream.way.side * math.cos(slope),
        -2.0 * stream.way.side * stream.way.turn * friction,
    )
    return forcing * unit + growth * stream.y, growth


def stops(stream: Stream, change: float) -> bool:
    """Stalls that no panel finds: where rest is nearer than any step, or a stream clings to a balance next to it.

    Of the second no place could be told: its error is what is left of the segment.
    """
    if stream.y < -2.0 * LEAST_STEP * change:  # from twice as far the least step is short enough
        stream.status, stream.y, stream.error = STALL, 0.0, 2.0 * LEAST_STEP
        return True
    if stream.tried > PATIENCE and stream.y < CREEP * CREEP:
        stream.status, stream.error = STALL, 1.0 - stream.place
        return True
    return False


def crosses(stream: Stream, effort: Effort, change: float) -> bool:
    """Takes a stream that stands at an event, on its way into it, beyond it.

    Not one that has just come over one there: where it clings to a balance, which way it goes in the first instant is
    noise, and only a panel tells.
    """
    if not stream.eventful or stream.place == stream.crossed:
        return False
    step = 1e-6
    for event in range(events.END):
        if stream.watched[event]:
            here = margin(stream, event, stream.place, stream.y)
            if here <= events.LEVEL:
                along = margin(stream, event, stream.place + step, stream.y) - here
                faster = margin(stream, event, stream.place, stream.y * (1.0 + step)) - here
                if along + faster * change / stream.y < 0.0:
                    happen(stream, effort, event)
                    return True
    return False


def margin(stream: Stream, event: int, place: float, y: float) -> float:
    """How far an event is; a choke happens once."""
    if event == events.CHOKE and stream.choke_place == stream.choke_place:
        return 1.0
    return events.margin(stream.way, stream.facet, stream.piece, event, place, y, stream.limit)


def go_on(stream: Stream, effort: Effort, change: float, growth: float) -> None:
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


def advance_by_place(stream: Stream, effort: Effort, target: float, growth: float) -> None:
    """A panel in c, of the kind that its length asks for."""
    kind = panel.CLINGING if growth * (target - stream.place) < STIFF else panel.PLACE
    advance(stream, effort, kind, target, effort.later, effort.share)


def slowest(stream: Stream) -> float:
    """The velocity from which on the surface stays on its facet, and below the wall; 0 along a taper."""
    top = floats.INFINITY
    if stream.way.taper:
        return 0.0
    if stream.facet + 1 < stream.way.facets.count:
        top = stream.way.facets.area[stream.facet + 1]
    if stream.watched[events.CHOKE] and stream.choke_place != stream.choke_place:
        top = min(top, slide.choke_area(stream.way, stream.place))
    return floats.quotient(stream.way.flow, top)


def fastest(stream: Stream) -> float:
    """The velocity up to which the surface stays on its facet; infinite along a taper."""
    return (
        floats.INFINITY if stream.way.taper else floats.quotient(stream.way.flow, stream.way.facets.area[stream.facet])
    )


def advance(stream: Stream, effort: Effort, kind: int, target: float, pair: "gauss.Pair", tolerance: float) -> None:
    """Solves one panel and takes it whole, up to an event inside it, or not at all."""
    stream.tried += 1
    stream.panel.facet, stream.panel.piece = stream.facet, stream.piece
    stream.panel.error = floats.INFINITY
    start = stream.place
    if kind == panel.ROOT:
        start = math.sqrt(math.sqrt(stream.y))
        if target != start:
            panel.by_root(stream.panel, stream.way, start, target - start, stream.place, pair)
    elif target > start:
        panel.by_place(stream.panel, stream.way, start, target - start, stream.y, pair, kind)
    good = stream.panel.error <= tolerance
    if effort.complete:
        good = good and stream.panel.inner_error <= effort.inner_tolerance
    stream.hopeful = not good and stream.panel.error < floats.INFINITY
    if stream.hopeful:  # as far as the ellipse tells what the finest rules would leave
        stream.hopeful = panel.SAFETY * stream.panel.smooth ** (-2 * effort.second.fine.count) <= tolerance
    if not good:
        retreat(stream, kind, target - start)
    elif stream.eventful or kind == panel.ROOT:
        judge(stream, effort, pair.fine, start, target)
    else:
        accept(stream, effort, pair.fine, target, stream.panel.error)


def judge(stream: Stream, effort: Effort, rule: "gauss.Rule", start: float, end: float) -> None:
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


def margin_at(stream: Stream, event: int, at: float, unknown: float) -> float:
    """How far an event is where a panel's variable and its unknown have these values."""
    if stream.panel.by_root:
        return margin(stream, event, unknown, at * at * at * at)
    return margin(stream, event, at, unknown)


def happens(stream: Stream, rule: "gauss.Rule", event: int, start: float, end: float, cut: float) -> bool:
    """Whether the event is where its margin's polynomial falls to 0.

    Not at the bottom of a dip, nor where a taper bends the margin more than its polynomial can.
    """
    unknown = gauss.evaluate(rule, stream.panel.knots, 0, cut)
    off = math.fabs(margin_at(stream, event, start + cut * (end - start), unknown))
    return off <= events.LEVEL + WELL_WITHIN * stream.panel.inner_error


def accept_part(stream: Stream, effort: Effort, rule: "gauss.Rule", start: float, end: float, cut: float) -> None:
    """Takes a panel up to an event inside it, where its polynomial is right too."""
    stream.values[0] = 1.0
    for k in range(rule.last):
        stream.values[k + 1] = stream.panel.growth[k]
    stream.panel.growth[rule.count] = gauss.evaluate(rule, stream.values, 0, cut)
    for k in range(rule.last + 1):
        stream.values[k] = gauss.evaluate(rule, stream.panel.knots, 0, cut * rule.knots[k])
    for k in range(rule.last + 1):
        stream.panel.knots[k] = stream.values[k]
    accept(stream, effort, rule, start + cut * (end - start), stream.panel.inner_error)


def accept(stream: Stream, effort: Effort, rule: "gauss.Rule", end: float, off: float) -> None:
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
            stream.status = STALL
        stream.stride = min(2.0 * stream.stride, 1.0)
    else:
        stream.error = growth * stream.error * stream.y / last + off
        stream.place, stream.y = end, last
        if end >= stream.limit:
            arrive(stream)
        else:
            # A step that was cut short by an event says nothing.
            before = stream.reach if stream.aim == stream.aim else LEAST_STEP
            stream.reach = max(4.0 * (end - start), before)
            if stream.tired:
                stream.stride, stream.tired = AGAIN, False
    stream.aim = floats.NAN


def keep(stream: Stream, rule: "gauss.Rule", end: float) -> None:
    """Writes down a panel."""
    if stream.panels >= stream.room:
        stream.full = True
        return
    at = KEPT * stream.panels
    stream.kept[at], stream.kept[at + 1] = stream.panel.by_root, rule.count
    stream.kept[at + 2], stream.kept[at + 3] = stream.panel.facet, stream.panel.piece
    stream.kept[at + 4], stream.kept[at + 5] = stream.panel.start, end
    for k in range(rule.last + 1):
        stream.kept[at + 6 + k] = stream.panel.knots[k]
    stream.panels += 1


def retreat(stream: Stream, kind: int, step: float) -> None:
    """After a panel that was too long: a step in c instead of one in r, or half the step."""
    stream.aim = floats.NAN
    if kind == panel.ROOT:
        stream.stride *= 0.5
        stream.tired = stream.stride < TIRED
    else:
        stream.reach = max(0.5 * step, LEAST_STEP)


def chatter(stream: Stream, by_root: bool, step: float) -> None:
    """A panel takes the stream back over the boundary that it has just crossed: a shorter one will tell.

    Next to a balance that does not hold, a long one lets rounding grow until it decides.
    """
    stream.reach = max(0.25 * (stream.reach if by_root else step), LEAST_STEP)
    if by_root:
        stream.tired = True


def arrive(stream: Stream) -> None:
    """At the limit: on to the segment's end, or done."""
    if stream.limit == 1.0:
        stream.status = OK
        return
    stream.limit, stream.reach = 1.0, 1.0 - stream.place


def happen(stream: Stream, effort: Effort, event: int) -> None:
    """What an event does to a stream that stands at it."""
    stream.aim = floats.NAN
    if event == events.CONTACT:
        stream.status = CONTACT_LOST
    elif event == events.CHOKE:
        stream.choke_place, stream.choke_y, stream.choke_error = stream.place, stream.y, stream.error
        if not effort.complete:
            stream.status = CHOKED
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
            pressure = slide.stress(stream.way, stream.facet, stream.place, stream.y) * (1.0 + side * CLEAR)
            stream.piece = beyond(stream.piece, slide.piece_of(stream.way, pressure), side)


def beyond(number: int, there: int, side: int) -> int:
    """The interval found on a side of the one left, and the next one at least."""
    return max(there, number + 1) if side > 0 else min(there, number - 1)
