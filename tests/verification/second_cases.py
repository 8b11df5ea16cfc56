"""Random chutes for the second solver, and how its answers are held against chutecalc's."""

import copy
import json
from math import isfinite, isnan, nan
from typing import Any, NamedTuple

import numpy as np

import chutecalc
from tests import seeds
from tests.verification.second_slide import UndecidedError
from tests.verification.second_solver import Result, Stream, solve

KINDS = ["straight", "straight", "curve", "curve", "curve", "hood", "plate", "fall"]


class Maker:
    """Chutes of moderate size, with some extremes, each given by a seed."""

    def __init__(self, seed: int) -> None:
        self.random = seeds.generator(7, seed)

    def maybe(self, chance: float) -> bool:
        return bool(self.random.random() < chance)

    def number(self, low: float, high: float) -> float:
        return float(np.exp(self.random.uniform(np.log(low), np.log(high))))

    def angle(self, low: float, high: float) -> float:
        return float(self.random.uniform(low, high))

    def pick(self, *choices: Any) -> Any:
        return choices[self.random.integers(len(choices))]

    def section(self) -> dict[str, Any]:
        shape = self.pick("rectangular", "chamfered", "vee", "circular", "facets")
        data: dict[str, Any] = {"shape": shape}
        if shape == "rectangular":
            data["width_m"] = self.number(0.2, 1.5)
        elif shape == "circular":
            data["radius_m"] = self.number(0.15, 1)
        elif shape == "facets":
            slopes = np.sort(self.random.uniform(3, 85, self.random.integers(1, 4)))
            facets = [{"length_m": self.number(0.05, 0.4), "slope_deg": float(slope)} for slope in slopes]
            if self.maybe(0.7):
                facets[0]["slope_deg"] = 0.0
                facets.append({"length_m": self.number(0.05, 0.4), "slope_deg": self.angle(85, 90)})
            data["facets"] = facets
        else:
            data["chamfer_deg"] = 90.0 if shape == "chamfered" and self.maybe(0.1) else self.angle(15, 80)
            if shape == "chamfered":
                data["base_m"] = self.number(0.1, 1)
            if self.maybe(0.6):
                data["chamfer_m"] = self.number(0.05, 0.5)
        if self.maybe(0.3):
            data["wall_height_m"] = self.number(0.15, 1.5)
        return data

    def narrowed(self, section: dict[str, Any]) -> dict[str, Any]:
        other = copy.deepcopy(section)
        for table in [other, *other.get("facets", [])]:
            for key, value in table.items():
                if key in ("chamfer_deg", "slope_deg"):
                    table[key] = min(90.0, value * self.angle(0.95, 1.05))
                elif isinstance(value, float):
                    table[key] = value * self.angle(0.6, 1.1)
        if "facets" in other:
            slopes = sorted(facet["slope_deg"] for facet in other["facets"])
            other["facets"] = [f | {"slope_deg": a} for f, a in zip(other["facets"], slopes, strict=True)]
        return other

    def liner(self) -> dict[str, Any]:
        kind = self.random.integers(10)
        if kind < 5:
            return {"friction_deg": self.angle(10, 35)}
        if kind < 6:
            return {"own_material": True}
        rows = self.random.integers(2, 5)
        normal = np.cumsum(np.exp(self.random.uniform(-1.5, 1.5, rows)))
        shear = np.cumsum(np.diff(normal, prepend=0) * self.random.uniform(0.1, 0.8, rows))
        shear += self.maybe(0.3) * self.angle(0, 0.3)
        return {"yield_locus_kpa": [[float(one), float(other)] for one, other in zip(normal, shear, strict=True)]}

    def segment(self, slope: float) -> tuple[dict[str, Any], float]:
        kind = self.pick(*KINDS)
        if kind == "fall":
            table = {"drop_m": self.number(0.1, 5)} if self.maybe(0.8) else {"run_m": self.number(0.1, 3)}
            return {"kind": kind} | table, min(slope + 15, 90)
        data: dict[str, Any] = {"kind": kind}
        data["section"] = ["body", "other"] if self.maybe(0.25) else self.pick("body", "body", "other")
        data["liner"] = self.pick("wall", "wall", "second")
        near = float(np.clip(slope + self.random.normal(0, 20), 0, 89))
        if kind in ("straight", "plate"):
            if self.maybe(0.4) and kind == "straight":
                near = float(np.clip(slope, 0, 90))
            data["slope_deg"] = near
            size = self.pick("length_m", "length_m", "drop_m", "run_m")
            size = "length_m" if not 5 < near < 85 else size
            return data | {size: self.number(0.2, 6)}, near
        data["radius_m"] = self.number(0.4, 12)
        first = slope
        if self.maybe(0.5):
            first = float(np.clip(slope + self.random.normal(0, 15), -80, 89))
            data["from_slope_deg"] = first
        if kind == "hood":
            to = self.angle(min(first + 5, 89), 90)
        else:
            to = self.angle(-15, max(first, -10)) if self.maybe(0.75) else self.angle(min(first, 85), 89)
        data["to_slope_deg"] = to
        return data, to

    def chute(self) -> dict[str, Any]:
        body = self.section()
        slope = float(self.random.choice([90.0, self.angle(-20, 85)]))
        data: dict[str, Any] = {
            "flow": {"rate_t_h": self.number(50, 4000)},
            "material": {"density_kg_m3": self.number(500, 2500), "internal_friction_deg": self.angle(25, 65)},
            "liners": {"wall": self.liner(), "second": self.liner()},
            "sections": {"body": body, "other": self.narrowed(body)},
            "inlet": {"velocity_m_s": self.number(0.3, 10), "slope_deg": slope},
            "model": {"friction_law": self.pick("paper", "equilibrium")},
        }
        if self.maybe(0.15):
            data["material"]["pressure_ratio"] = self.angle(0.3, 0.9)
        segments = []
        if self.maybe(0.25):
            slope = self.angle(-15, 15)
            data["inlet"] = {
                "belt": {
                    "velocity_m_s": self.number(0.8, 6),
                    "incline_deg": -slope,
                    "pulley_radius_m": self.number(0.2, 0.8),
                    "belt_thickness_m": self.angle(0, 0.03),
                    "material_depth_m": self.angle(0, 0.3),
                }
            }
        if self.maybe(0.3):
            segments.append({"kind": "fall", "drop_m": self.number(0.2, 5)})
            slope = min(slope + 25, 90)
        for _ in range(self.random.integers(1, 5)):
            segment, slope = self.segment(slope)
            segments.append(segment)
        if self.maybe(0.15):
            self.put_anywhere(segments)
        data["segments"] = segments
        if self.maybe(0.4):
            data["receiver"] = {
                "velocity_m_s": self.number(0.5, 8),
                "slope_deg": self.angle(-15, 20),
                "friction_deg": self.angle(10, 35),
            }
            if self.maybe(0.5):
                data["receiver"] |= {"at_m": [self.angle(-2, 4), self.angle(-15, -2)]}
            if self.maybe(0.5):
                data["receiver"] |= {"plan_angle_deg": self.angle(-120, 120)}
        for segment in segments:
            if segment["kind"] != "fall" and self.maybe(0.4):
                segment["may_be_passed"] = True
        return data

    def put_anywhere(self, segments: list[dict[str, Any]]) -> None:
        number = int(self.random.integers(len(segments)))
        if segments[number]["kind"] == "fall":
            return
        segments[number]["start_m"] = [self.angle(-0.5, 2), self.angle(-3, 0.3)]
        if segments[number]["kind"] in ("curve", "hood"):
            segments[number].setdefault("from_slope_deg", min(segments[number]["to_slope_deg"] + 30, 89))
        segments.insert(number, {"kind": "fall", "onto_next": True})


class ClosedMaker(Maker):
    """Chutes of pipes and boxes: bends, crests at speed, hoods, mouths that a stream falls into, open ends."""

    def section(self) -> dict[str, Any]:
        if self.maybe(0.15):
            return super().section()
        if self.maybe(0.6):
            return {"shape": "pipe", "radius_m": self.number(0.15, 0.8)}
        return {"shape": "box", "width_m": self.number(0.2, 1.5), "height_m": self.number(0.2, 1.0)}

    def narrowed(self, section: dict[str, Any]) -> dict[str, Any]:
        if self.maybe(0.3):
            return copy.deepcopy(section)
        return super().narrowed(section)

    def segment(self, slope: float) -> tuple[dict[str, Any], float]:
        data, to = super().segment(slope)
        if data["kind"] == "plate" and self.maybe(0.8):
            data["kind"] = "straight"
        if data["kind"] == "straight" and self.maybe(0.4):
            to = data["slope_deg"] = float(np.clip(slope, 5, 85))
            data = {key: data[key] for key in ("kind", "section", "liner", "slope_deg")}
            data["length_m"] = self.number(0.2, 6)
        if data["kind"] == "curve" and self.maybe(0.5):
            data.pop("from_slope_deg", None)
            data["to_slope_deg"] = to = self.angle(min(slope + 5, 84), 89) if slope < 84 else self.angle(0, 60)
        if data["kind"] == "fall":
            data = {"kind": "fall", "drop_m": self.number(0.02, 2)}
        return data, to

    def chute(self) -> dict[str, Any]:
        data = super().chute()
        data["flow"]["rate_t_h"] = self.number(20, 1500)
        if self.maybe(0.5):  # another body, open or closed, that no segment tapers to
            data["sections"]["apart"] = self.section()
            for segment in data["segments"]:
                if segment.get("section") == "other" and self.maybe(0.5):
                    segment["section"] = "apart"
        return data


def case(seed: int, maker: type[Maker] = Maker) -> tuple[dict[str, Any], chutecalc.Chute]:
    """Return the first chute of this seed that is a chute: some draws are faults of geometry."""
    drawing = maker(seed)
    for _ in range(100):
        data = drawing.chute()
        try:
            chute = chutecalc.parse(data)
            chutecalc.solve(chute, rtol=1e-4)  # a hood may not steepen from where a stream falls into it
            return data, chute
        except chutecalc.SpecError:
            continue
    raise AssertionError(f"seed {seed} draws no chute")


def theirs_of(chute: chutecalc.Chute, rtol: float = 1e-10) -> dict[str, Any]:
    """Return what chutecalc says, as plain numbers."""

    def plain(table: dict[str, Any]) -> dict[str, float]:
        return {key: float(value[0]) for key, value in table.items()}

    solution = chutecalc.solve(chute, rtol=rtol)
    return {
        "status": str(solution.status[0]),
        "exit_velocity": float(solution.exit_velocity[0]),
        "error": float(solution.error_estimate[0]),
        "receiver": plain(solution.receiver or {}),
        "segments": [
            {
                "status": str(segment.status[0]),
                "entry": plain(segment.entry),
                "exit": plain(segment.exit),
                "impact": plain(segment.impact),
            }
            for segment in solution.segments
        ],
    }


def ours_of(data: dict[str, Any]) -> dict[str, Any]:
    """Solve a spec with the second solver."""
    return summary(solve(data))


def summary(result: Result) -> dict[str, Any]:
    """Return a result of the second solver in the words of chutecalc."""
    segments = []
    for segment in result.segments:
        impact = segment.impacts[0] if segment.impacts else (nan, nan, nan)
        segments.append(
            {
                "status": segment.status,
                "entry": _ends(segment, segment.entry, 0),
                "exit": _ends(segment, segment.exit, 1),
                "impact": dict(
                    zip(("incidence_deg", "velocity_before_m_s", "velocity_after_m_s"), impact, strict=True)
                ),
            }
        )
    return {
        "status": result.status,
        "exit_velocity": result.exit.v if result.exit else nan,
        "receiver": result.receiver,
        "segments": segments,
    }


def _ends(segment: Any, stream: Stream | None, which: int) -> dict[str, float]:
    if stream is None:
        return {}
    out = {
        "s_m": stream.s,
        "x_m": stream.x,
        "z_m": stream.z,
        "slope_deg": float(np.degrees(stream.slope)),
        "velocity_m_s": stream.v,
    }
    setting = (segment.first, segment.setting)[which]
    if setting is not None and stream.v > 0:
        u = (segment.begin, segment.end)[which]
        out["depth_m"] = setting.load(u, stream.v).depth
        # on a plate nothing slides: what is reported there is the friction of the impact
        struck = segment.plate and segment.impacts
        out["equivalent_friction"] = segment.struck if struck else setting.equivalent(u, stream.v)
    return out


class Difference(NamedTuple):
    """A number that both solvers have."""

    name: str
    ours: float
    theirs: float
    off: float
    """Their difference over its scale."""


def differences(ours: dict[str, Any], theirs: dict[str, Any]) -> list[Difference]:
    """Return every number that both have."""
    out = []

    def add(name: str, one: float, other: float, scale: float = 1.0) -> None:
        if isnan(one) and isnan(other):
            return
        off = 0.0 if one == other else abs(one - other) / max(abs(one), abs(other), scale)
        out.append(Difference(name, one, other, np.inf if isnan(off) else off))

    add("exit velocity", ours["exit_velocity"], theirs["exit_velocity"], 1e-3)
    for k, (one, other) in enumerate(zip(ours["segments"], theirs["segments"], strict=True)):
        for end in ("entry", "exit"):
            for key, value in one[end].items():
                scale = 90.0 if key == "slope_deg" else 1e-3 if key == "velocity_m_s" else 1.0
                scale = 1e-2 if key == "depth_m" else scale
                add(f"{k + 1} {end} {key}", value, other[end][key], scale)
        for key, value in one["impact"].items():
            add(f"{k + 1} impact {key}", value, other["impact"].get(key, nan), 90.0 if "deg" in key else 1e-3)
    for key, value in ours["receiver"].items():
        if key in theirs["receiver"] and isfinite(value):
            add(f"receiver {key}", value, theirs["receiver"][key], 1e-3)
    return out


def outcome(answer: dict[str, Any]) -> tuple[str, ...]:
    return answer["status"], *(segment["status"] for segment in answer["segments"])


PROMISE = 1e-10  # chutecalc's default rtol
SLACK = 10  # a chute's few segments, each with its own error, and numbers that change a few times faster than v does
NUDGE = 1e-8
CREEP = 1e-3  # m/s, slower than that chutecalc may call a stall


def judge(seed: int, maker: type[Maker] = Maker) -> tuple[str, list[str]]:
    """Return how one random chute compares: same, edge, creep, undecided or wrong; and what is wrong."""
    data, chute = case(seed, maker)
    return compare(data, theirs_of(chute))


def told(seed: int, maker: type[Maker] = Maker) -> tuple[str, list[str]]:
    """As `judge`, with the spec of what is wrong, and a line for what else is not the same."""
    verdict, wrong = judge(seed, maker)
    if verdict == "wrong":
        return verdict, [*wrong[:5], json.dumps(case(seed, maker)[0])]
    return verdict, wrong if wrong or verdict == "same" else ["not compared"]


def compare(data: dict[str, Any], theirs: dict[str, Any]) -> tuple[str, list[str]]:
    """As `judge`, of a given chute.

    What chutecalc promises is 1e-10. Numbers that differ by more than ten times that are held against how
    ill-conditioned the chute is: ten times what a change of 1e-10 at the inlet does to them. A different outcome is
    right only where a change of 1e-9 at the inlet gives it here as well.
    """
    try:
        ours = ours_of(data)
        if outcome(ours) != outcome(theirs):
            for share in (NUDGE / 10, -NUDGE / 10):
                if outcome(ours_of(nudged(data, share))) == outcome(theirs):
                    return "edge", []
            return "wrong", [f"outcome: here {outcome(ours)}, chutecalc {outcome(theirs)}"]
        found = differences(ours, theirs)
        off = {one.name: one for one in found if one.off > SLACK * PROMISE}
        if not off:
            return "same", []
        if creeps(ours, theirs, off):
            return "creep", []
        moved = [ours_of(nudged(data, share)) for share in (NUDGE, -NUDGE)]
        if any(outcome(one) != outcome(ours) for one in moved):
            return "edge", []
        turns = {one.name: one.off * PROMISE / NUDGE for one in differences(*moved)}
    except UndecidedError:
        return "undecided", []
    wrong = [
        f"{name}: here {one.ours!r}, chutecalc {one.theirs!r}, off by {one.off:.1e}"
        for name, one in off.items()
        if not one.off <= SLACK * (PROMISE + turns.get(name, 0.0))
    ]
    return ("wrong" if wrong else "same"), wrong


def creeps(ours: dict[str, Any], theirs: dict[str, Any], off: dict[str, Any]) -> bool:
    """Return whether chutecalc called a stream stalled that creeps a few more millimetres before it is."""
    last = [k for k, segment in enumerate(theirs["segments"]) if segment["status"] == "stall"]
    if not last or not all(name.startswith(f"{last[0] + 1} exit") for name in off):
        return False
    one, other = (answer["segments"][last[0]]["exit"] for answer in (ours, theirs))
    return 0 < other["velocity_m_s"] <= CREEP and 0 <= one["s_m"] - other["s_m"] < 0.01


def nudged(data: dict[str, Any], share: float) -> dict[str, Any]:
    """Return the chute with its inlet's velocity changed by this share."""
    changed = copy.deepcopy(data)
    inlet = changed["inlet"].get("belt", changed["inlet"])
    inlet["velocity_m_s"] *= 1 + share
    return changed
