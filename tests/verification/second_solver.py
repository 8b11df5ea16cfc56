"""A second solver of whole chutes, written from the formulas alone, to hold the first one against.

`solve` takes a spec's tables in the metric keys and gives what becomes of the stream. From the command line,
`python -m tests.verification.second_solver 20000 --first 0` compares that many random chutes.
"""

from dataclasses import dataclass, field
from math import acos, atan2, cos, degrees, exp, hypot, inf, nan, radians, sin, sqrt, tan
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from tests.verification.second_flights import Flight, Landing, Surface, horizon, landing
from tests.verification.second_roofs import Mouth, Tube, height_of
from tests.verification.second_sections import Friction, atan_slope
from tests.verification.second_slide import Setting, UndecidedError, slide

EQUAL = radians(1e-6)
DEEPEST = 2000.001
LEAPS = 50


@dataclass
class Stream:
    """Where the stream is, and how it moves."""

    s: float
    x: float
    z: float
    v: float
    slope: float


@dataclass
class Segment:
    """What became of one segment; the numbers are nan where it was not reached."""

    name: str
    status: str = "not_reached"
    entry: Stream | None = None
    exit: Stream | None = None
    impacts: list[tuple[float, float, float]] = field(default_factory=list)  # incidence, before, after
    begin: float = 0.0  # how far along the drawn segment its entry and exit are
    end: float = 0.0
    setting: Setting | None = None  # of the wall that it leaves
    first: Setting | None = None  # of the wall that it enters on
    struck: float = nan  # μ_e of its first impact
    plate: bool = False


@dataclass
class Result:
    """A chute's outcome."""

    status: str = "ok"
    segments: list[Segment] = field(default_factory=list)
    exit: Stream | None = None
    receiver: dict[str, float] = field(default_factory=dict)


class _FailedError(Exception):
    pass


def inlet_of(data: dict[str, Any], g: float) -> Stream:
    """Return where the stream starts: given, or from a belt's pulley."""
    inlet = data["inlet"]
    x, z = inlet.get("at_m", (0.0, 0.0))
    if "belt" not in inlet:
        return Stream(0.0, x, z, inlet["velocity_m_s"], radians(inlet["slope_deg"]))
    belt = inlet["belt"]
    incline = radians(belt.get("incline_deg", 0.0))
    outside = belt["pulley_radius_m"] + belt.get("belt_thickness_m", 0.0)
    radius = outside + belt.get("material_depth_m", 0.0) / 2
    speed = belt["velocity_m_s"]
    angle = -incline
    if speed**2 / (g * radius) < cos(incline):  # held round the pulley
        turning = speed * radius / outside
        speed = min(turning, sqrt(g * radius * cos(incline)))  # it leaves when it has got so fast
        if turning**2 / (g * radius) < cos(incline):
            angle = acos(speed**2 / (g * radius))
    return Stream(0.0, x + radius * sin(angle), z + radius * cos(angle), speed, angle)


class Solver:
    """One chute, followed from the inlet on."""

    def __init__(self, data: dict[str, Any]) -> None:
        self.data = data
        flow, material = data["flow"], data["material"]
        self.g = flow.get("gravity_m_s2", 9.80665)
        self.density = material["density_kg_m3"]
        self.rate = flow["rate_t_h"] / 3.6 / self.density
        delta = material.get("internal_friction_deg")
        self.delta = None if delta is None else radians(delta)
        ratio = material.get("pressure_ratio")
        self.ratio = (1 - sin(self.delta)) / (1 + sin(self.delta)) if ratio is None else ratio  # type: ignore[arg-type]
        self.model = data.get("model", {})
        self.law = self.model.get("friction_law", "paper")
        self.result = Result()
        self.stream = self.inlet = inlet_of(data, self.g)
        self.flight: Flight | None = None  # while nothing carries the stream
        self.took_off = self.stream
        self.since = 0.0  # of the flight's time, spent inside closed segments that it has flown through
        self.inside = False  # whether it has just come out of one, or comes along the wall opposite to a drawn one
        self.opposite = 0  # side of the wall opposite to a drawn one, if the stream comes along such a wall
        self.onto: Segment | None = None
        # where the next segment is drawn from
        self.x, self.z, self.slope = self.stream.x, self.stream.z, self.stream.slope

    def run(self) -> Result:
        tables = self.data["segments"]
        counts: dict[str, int] = {}
        for table in tables:
            kind = table["kind"]
            counts[kind] = counts.get(kind, 0) + 1
            self.result.segments.append(Segment(table.get("name", kind), plate=kind == "plate"))
        try:
            for number, (table, segment) in enumerate(zip(tables, self.result.segments, strict=True)):
                if table["kind"] == "fall":
                    self.fall(table, segment, number)
                elif table["kind"] != "plate" and self.heights(table) is not None:
                    self.tube(table, segment, number)
                else:
                    self.surface(table, segment, number)
            struck = tables[-1]["kind"] == "plate" and self.result.segments[-1].status == "ok"
            self.placed = "at_m" in self.data.get("receiver", {})
            if self.flight is not None and not struck and not self.placed:
                self.nothing_catches()
            self.receive()
            through = tables[-1]["kind"] not in ("fall", "plate") and self.heights(tables[-1]) is not None
            passed = self.result.segments[-1].status == "passed" and not through
            self.result.exit = self.left_steel() if passed else self.stream
        except _FailedError as failure:
            self.result.status = str(failure)
        for fall, after, table in zip(self.result.segments, self.result.segments[1:], tables, strict=False):
            if table.get("onto_next") and after.status == "passed":
                fall.status = "passed"  # with what it leads to
        return self.result

    def left_steel(self) -> Stream:
        """Return the stream where it left the last wall that it touched, or at the inlet."""
        kinds = [table["kind"] for table in self.data["segments"]]
        walls = [each.exit for each, kind in zip(self.result.segments, kinds, strict=True) if kind != "fall"]
        return next((each for each in reversed(walls) if each is not None), self.inlet)

    def nothing_catches(self) -> None:
        last = self.result.segments[-1]
        if last.status == "contact_lost":
            raise _FailedError("contact_lost")
        last.status = "missed"
        raise _FailedError("missed")

    # flights

    def fly(self, touch: int = 0) -> None:
        stream = self.stream
        self.took_off, self.since, self.opposite = stream, 0.0, 0
        self.flight = Flight(
            stream.x, stream.z, stream.v * cos(stream.slope), -stream.v * sin(stream.slope), self.g, touch
        )
        if abs(stream.slope - radians(90)) < 1e-15:
            self.flight.vx = 0.0

    def fall(self, table: dict[str, Any], segment: Segment, number: int) -> None:
        self.inside = False
        if self.flight is None:
            self.fly()
        flight = self.flight
        assert flight is not None
        if table.get("onto_next"):
            self.onto = segment  # reached where the next one catches the stream
            return
        if "drop_m" in table:
            t = flight.fallen_to(self.z - table["drop_m"])
        else:
            t = flight.carried_to(self.x + table["run_m"])
        if t is None or self.z - flight.at(t)[1] > DEEPEST:
            segment.status = "missed"
            raise _FailedError("missed")
        segment.status, segment.entry = "ok", self.took_off
        x, z = flight.at(t)
        vx, vz = flight.velocity(t)
        self.stream = Stream(self.took_off.s + flight.path(t), x, z, sqrt(vx * vx + vz * vz), atan_slope(vx, vz))
        segment.exit = self.stream
        self.flight = None
        self.x, self.z, self.slope = x, z, self.stream.slope

    # surfaces

    def draw(self, table: dict[str, Any]) -> Surface:
        """Return the drawn line or arc, and where the next one starts."""
        self.x, self.z = table.get("start_m", (self.x, self.z))
        kind = table["kind"]
        side = -1 if kind in ("hood", "plate") else 1
        if kind in ("straight", "plate"):
            slope = radians(table["slope_deg"])
            if "length_m" in table:
                length = table["length_m"]
            else:
                length = table["drop_m"] / abs(sin(slope)) if "drop_m" in table else table["run_m"] / cos(slope)
            surface = Surface(self.x, self.z, slope, 0.0, length, side)
        else:
            slope = radians(table["from_slope_deg"]) if "from_slope_deg" in table else self.slope
            turn = slope - radians(table["to_slope_deg"])
            radius = table["radius_m"]
            surface = Surface(self.x, self.z, slope, (1 if turn > 0 else -1) / radius, abs(turn) * radius, side)
        self.x, self.z = surface.at(surface.length)
        self.slope = surface.slope_at(surface.length)
        return surface

    def setting(self, table: dict[str, Any], surface: Surface) -> Setting:
        sections, liners = self.data["sections"], self.data["liners"]
        names = table.get("section", next(iter(sections)))
        first, last = names if isinstance(names, list) else (names, names)
        liner = liners[table.get("liner", next(iter(liners)))]
        return Setting(
            surface,
            (sections[first], sections[last]),
            Friction(liner, self.delta),
            self.ratio,
            self.law,
            self.rate,
            self.density,
            self.g,
            self.model.get("momentum_factor", 1.0),
            self.model.get("longitudinal_pressure_ratio", 0.0),
        )

    def surface(self, table: dict[str, Any], segment: Segment, number: int) -> None:
        self.inside = False
        surface = self.draw(table)
        setting = segment.setting = self.setting(table, surface)
        u, along = 0.0, False
        if self.opposite:
            self.fly()
        came = self.stream, self.flight
        if self.flight is None:
            turn = surface.side * (self.stream.slope - surface.slope)
            along = abs(turn) <= EQUAL
            if along:
                self.stream = Stream(self.stream.s, surface.x, surface.z, self.stream.v, surface.slope)
            elif turn > 0:
                self.strike(segment, 0.0, turn)
            else:
                self.fly(touch=1)
        for _ in range(LEAPS):
            if self.flight is not None:
                met, passed = landing(self.flight, surface)
                self.flight.touch = 0
                onto, self.onto = self.onto, None
                if met is not None and onto is not None:
                    self.lands(onto, surface, met)
                if met is None:
                    if segment.status == "contact_lost":
                        if passed == inf:
                            self.beyond(number)
                        return
                    self.pass_by(table, segment, number)
                    return
                self.land(segment, surface, met)
                u, along = met.u, met.incidence <= EQUAL and segment.entry is None
            if along and table["kind"] == "hood" and setting.press(u, self.stream.v) < 0 and not self.returns(surface):
                segment.impacts.clear()
                self.stream, self.flight = came
                if self.flight is None:
                    self.fly()
                self.pass_by(table, segment, number)
                return
            self.settle(segment, setting, u)
            along, segment.status = False, "ok"
            if table["kind"] == "plate":
                segment.exit = self.stream
                segment.end = u
                if setting.chokes(u, self.stream.v):
                    segment.status = "choke"
                    raise _FailedError("choke")
                self.fly(touch=2)
                assert self.flight is not None
                self.flight.touch = 0
                return
            if setting.press(u, self.stream.v) < 0:
                self.lose(segment, u, touch=2)
                continue
            how, u = self.run_along(segment, u)
            if how == "end":
                return
            self.lose(segment, u, touch=3)
        raise UndecidedError("strikes the same surface again and again")

    def settle(self, segment: Segment, setting: Setting, u: float) -> None:
        """Note where the stream first is on the segment's wall; one that the impact has stopped has stalled there."""
        if segment.entry is None:
            segment.entry, segment.begin, segment.first = self.stream, u, setting
        if self.stream.v == 0:
            segment.exit = self.stream
            segment.status = "stall"
            raise _FailedError("stall")

    def returns(self, surface: Surface) -> bool:
        """Return whether the stream, which starts along a surface, meets it again if it flies."""
        kept = self.took_off, self.since, self.opposite, self.flight
        self.fly(touch=2)
        assert self.flight is not None
        met, _ = landing(self.flight, surface)
        self.took_off, self.since, self.opposite, self.flight = kept
        return met is not None

    def run_along(self, segment: Segment, u: float) -> tuple[str, float]:
        """Slides from u along the segment's wall, to its end or to where contact is lost."""
        setting = segment.setting
        assert setting is not None
        if setting.chokes(u, self.stream.v):
            how, v = "choke", self.stream.v
        else:
            slid = slide(setting, u, self.stream.v)
            how, v = slid.how, slid.v
            x, z = setting.surface.at(slid.u)
            s = self.stream.s + slid.u - u
            u = slid.u
            self.stream = Stream(s, x, z, v, setting.surface.slope_at(u))
        segment.exit, segment.end = self.stream, u
        if how in ("stall", "choke"):
            segment.status = how
            raise _FailedError(how)
        return how, u

    def pass_by(self, table: dict[str, Any], segment: Segment, number: int) -> None:
        last = number + 1 == len(self.result.segments)
        if not table.get("may_be_passed") or (last and "at_m" not in self.data.get("receiver", {})):
            segment.status = "missed"
            raise _FailedError("missed")
        segment.status = "passed"

    # closed sections

    def heights(self, table: dict[str, Any]) -> tuple[float, float] | None:
        """Return D at both ends of a closed segment."""
        sections = self.data["sections"]
        names = table.get("section", next(iter(sections)))
        first, last = names if isinstance(names, list) else (names, names)
        one, other = height_of(sections[first]), height_of(sections[last])
        return None if one is None or other is None else (one, other)

    def tube(self, table: dict[str, Any], segment: Segment, number: int) -> None:
        heights = self.heights(table)
        assert heights is not None
        end = self.x, self.z
        tube = Tube(self.draw(table), heights)
        joined = self.inside and hypot(end[0] - tube.mouth.x, end[1] - tube.mouth.z) < 1e-9
        self.inside = False
        settings = [self.setting(table, wall) for wall in tube.walls]
        on, u = 0, 0.0
        if self.opposite and not tube.continues(self.stream.x, self.stream.z, self.opposite):
            self.fly()
        left: int | None = None
        if self.flight is None:
            on = int(self.opposite != 0)
            wall, segment.setting = tube.walls[on], settings[on]
            turn = wall.side * (self.stream.slope - wall.slope)
            if abs(turn) <= EQUAL:
                self.stream = Stream(self.stream.s, wall.x, wall.z, self.stream.v, wall.slope)
            elif turn > 0:
                self.strike(segment, 0.0, turn)
            else:
                self.fly(touch=1)
                left = on
        if not joined:
            self.since = 0.0
        if self.flight is not None:
            entered = 0.0 if left is not None else tube.entered(self.flight, self.since, joined)
            joined = joined and left is None and entered == self.since
            if entered is None:
                self.onto = None
                self.pass_by(table, segment, number)
                return
            self.fits(segment, settings[0], tube.mouth, 0.0, left is not None)
            self.since = entered
        self.opposite = 0
        for _ in range(LEAPS):
            if self.flight is not None:
                on, met, t = tube.next(self.flight, left, self.since, joined)
                self.flight.touch = 0
                onto, self.onto = self.onto, None
                if met is None:
                    self.fits(segment, settings[0], tube.exit, tube.walls[0].length)
                if on < 0:
                    self.falls_back(table, segment, number)
                    return
                if met is None:
                    self.through(segment, number, t)
                    return
                segment.setting = settings[on]
                if onto is not None:
                    self.lands(onto, tube.walls[on], met)
                self.land(segment, tube.walls[on], met)
                u = met.u
            setting = segment.setting = settings[on]
            self.settle(segment, setting, u)
            segment.status = "ok"
            left, joined = on, False
            if setting.press(u, self.stream.v) < -1e-14:  # but upright
                self.lose(segment, u, touch=2)
                continue
            how, u = self.run_along(segment, u)
            if how == "end":
                self.opposite = on and setting.surface.side
                self.inside = on > 0
                return
            self.lose(segment, u, touch=3)
        raise UndecidedError("goes from wall to wall again and again")

    def fits(self, segment: Segment, setting: Setting, mouth: Mouth, u: float, begins: bool = False) -> None:
        """A stream in flight through a mouth needs no more than all of it."""
        flight = self.flight
        assert flight is not None
        crossed = mouth.crossed(flight, horizon(flight, setting.surface))
        times = [0.0] if begins else [t for t, forwards, _ in crossed if forwards]
        if times and setting.chokes(u, hypot(*flight.velocity(times[0]))):
            self.onto = None
            segment.status = "choke"
            raise _FailedError("choke")

    def falls_back(self, table: dict[str, Any], segment: Segment, number: int) -> None:
        """The stream leaves through the mouth that it came in through."""
        if segment.status != "contact_lost":
            self.pass_by(table, segment, number)
        elif number + 1 == len(self.result.segments) and "at_m" not in self.data.get("receiver", {}):
            raise _FailedError("contact_lost")

    def through(self, segment: Segment, number: int, t: float) -> None:
        """The stream leaves through the exit in flight; at the last segment the chute ends there."""
        flight = self.flight
        assert flight is not None
        if segment.status != "contact_lost":
            segment.status = "passed"
        self.since, self.inside = t, True
        if number + 1 == len(self.result.segments):
            (x, z), (vx, vz) = flight.at(t), flight.velocity(t)
            self.stream = Stream(self.took_off.s + flight.path(t), x, z, sqrt(vx * vx + vz * vz), atan_slope(vx, vz))
            self.flight = None

    def beyond(self, number: int) -> None:
        """The stream never comes past the surface that it left: what follows is not tried."""
        segments = self.result.segments
        if number + 1 == len(segments):
            if "at_m" in self.data.get("receiver", {}):
                return
            raise _FailedError("contact_lost")

    def lose(self, segment: Segment, u: float, touch: int) -> None:
        segment.exit, segment.end = self.stream, u
        segment.status = "contact_lost"
        self.fly(touch=touch)

    def lands(self, fall: Segment, surface: Surface, met: Landing) -> None:
        x, z = surface.at(met.u)
        slope = surface.slope_at(met.u) + surface.side * met.incidence
        fall.status, fall.entry = "ok", self.took_off
        fall.exit = Stream(self.took_off.s + met.flown, x, z, met.speed, slope)

    def land(self, segment: Segment, surface: Surface, met: Landing) -> None:
        x, z = surface.at(met.u)
        self.stream = Stream(self.took_off.s + met.flown, x, z, met.speed, surface.slope_at(met.u))
        self.flight = None
        self.strike(segment, met.u, met.incidence)

    def strike(self, segment: Segment, u: float, incidence: float) -> None:
        setting = segment.setting
        assert setting is not None
        v = self.stream.v
        mu = setting.at_impact(u, v, incidence)
        after = max(v * (cos(incidence) - mu * sin(incidence)), 0.0)
        segment.struck = segment.struck if segment.impacts else mu
        segment.impacts.append((degrees(incidence), v, after))
        x, z = setting.surface.at(u)
        self.stream = Stream(self.stream.s, x, z, after, setting.surface.slope_at(u))

    def receive(self) -> None:
        table = self.data.get("receiver")
        if table is None:
            return
        belt, slope, mu = table["velocity_m_s"], radians(table["slope_deg"]), tan(radians(table["friction_deg"]))
        plan = radians(table.get("plan_angle_deg", 0.0))
        # x along the chute, y aside, z up; the belt's plane holds its heading and the level line across it
        heading = np.array([cos(slope) * cos(plan), cos(slope) * sin(plan), -sin(slope)])
        aside = np.array([-sin(plan), cos(plan), 0.0])
        normal = np.cross(heading, aside)
        stream = np.array([cos(self.stream.slope), 0.0, -sin(self.stream.slope)]) * self.stream.v
        if self.placed:
            away = np.array([self.stream.x - table["at_m"][0], 0.0, self.stream.z - table["at_m"][1]])
            times = np.roots([-0.5 * self.g * normal[2], stream @ normal, away @ normal])
            if away @ normal < 0:
                raise _FailedError("missed")
            stream = stream - np.array([0.0, 0.0, self.g * times.max()])
        along, across, beside = float(stream @ heading), abs(float(stream @ normal)), -float(stream @ aside)
        bracket = (mu if belt > along else -mu) * cos(slope) + sin(slope)
        gain = belt**2 - along**2
        reached = (belt - along) * bracket > 0
        length = gain / (2 * self.g * bracket) if reached else (inf if gain else 0.0)
        if beside:
            length = slipping(along, beside, belt, mu * self.g * cos(slope), self.g * sin(slope))
        self.result.receiver = {
            "velocity_along_m_s": along,
            "velocity_into_m_s": across,
            "velocity_across_m_s": beside,
            "velocity_ratio": along / belt,
            "impact_pressure_kpa": self.density * across**2 / 1e3,
            "wear_w_m2": mu * self.density * across**2 * sqrt((belt - along) ** 2 + beside**2),
            "acceleration_length_m": length,
            "acceleration_power_kw": self.rate * self.density * belt * (belt - along) / 1e3,
            "matching_slope_deg": nan,
        }


def slipping(along: float, across: float, belt: float, brake: float, pull: float) -> float:
    """Integrate the slip of a stream on a belt until there is none; return how far along the belt that is."""
    if brake <= abs(pull):
        return inf

    first = hypot(along - belt, across)

    def rates(fallen: float, state: np.ndarray) -> list[float]:
        """With the logarithm of the slip falling at an even rate: its angle, and the way along the belt."""
        slip, slowing = first * exp(-fallen), brake - pull * cos(state[0])
        return [-pull * sin(state[0]) / slowing, (belt + slip * cos(state[0])) * slip / slowing]

    found = solve_ivp(rates, (0, 40), [atan2(across, along - belt), 0.0], "DOP853", rtol=1e-12, atol=1e-14)
    return float(found.y[1, -1])


def solve(data: dict[str, Any]) -> Result:
    """Solve the stream of this chute."""
    return Solver(data).run()


def main(arguments: list[str] | None = None) -> int:
    """Compares random chutes and prints each disagreement with its seed and its spec."""
    import argparse
    from functools import partial

    from tests.verification.judging import main as judged
    from tests.verification.second_cases import ClosedMaker, Maker, told

    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--closed", action="store_true")
    options, rest = parser.parse_known_args(arguments)
    what = f"{main.__doc__} With --closed pipes and boxes."
    return judged(partial(told, maker=ClosedMaker if options.closed else Maker), what, rest)


if __name__ == "__main__":
    raise SystemExit(main())
