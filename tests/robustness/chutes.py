"""Random chutes from the whole admissible space and its edges, each given by a seed."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple

import numpy as np
import tomli_w

import chutecalc
from chutecalc.spec.limits import LIMITS
from tests import seeds
from tests.conftest import spec


class Drawn(NamedTuple):
    """A spec's tables, and what comes of them: a solution, or faults."""

    data: dict[str, Any]
    solution: chutecalc.Solution | None
    error: chutecalc.SpecError | None


@contextmanager
def noting_spec(data: dict[str, Any]) -> Iterator[None]:
    """Add the spec to any error raised inside."""
    try:
        yield
    except Exception as error:
        error.add_note(
            f"The spec, to save in tests/robustness/found once the fault is corrected.\n\n{tomli_w.dumps(data)}"
        )
        raise


def draws(*seed: int, maker: "type[Maker] | None" = None) -> Iterator[Drawn]:
    """Yield chutes of one seed, without end. Some are not admissible and must have faults."""
    for data in random_specs(*seed, maker=maker):
        with noting_spec(data):
            yield drawn(data)


def random_specs(*seed: int, maker: "type[Maker] | None" = None) -> Iterator[dict[str, Any]]:
    """Specs of one seed, without end, as they are drawn."""
    drawing = (maker or Maker)(seeds.generator(*seed))
    while True:
        yield drawing.chute()


def drawn(data: dict[str, Any]) -> Drawn:
    """Read and solve a spec. Some faults show only in the solver, where a hood takes the slope of a falling stream."""
    try:
        return Drawn(data, chutecalc.solve(chutecalc.parse(data)), None)
    except chutecalc.SpecError as error:
        return Drawn(data, None, error)


class Maker:
    """Draws chutes."""

    def __init__(self, random: np.random.Generator) -> None:
        self.random = random
        self.usual = False
        """Whether this chute is one as they are built: most of the others end at their first segment."""

    def maybe(self, chance: float) -> bool:
        return bool(self.random.random() < chance)

    def quantity(self, low: float, high: float, usual: tuple[float, float] | None = None) -> float:
        """Over many decades, or at an end; within what is usual in a usual chute."""
        if self.usual and usual:
            low, high = usual
        elif self.maybe(0.15):
            return float(self.random.choice([low, high]))
        return float(np.exp(self.random.uniform(np.log(low), np.log(high))))

    def perhaps(self, chance: float, **quantities: tuple[float, float]) -> dict[str, float]:
        """Keys that a spec may leave out."""
        return {key: self.quantity(*ends) for key, ends in quantities.items() if self.maybe(chance)}

    def angle(self) -> float:
        if self.maybe(0.5):
            return float(self.random.choice([1e-6, 30, 45, 89.999999, 90.0]))
        return float(self.random.uniform(1e-6, 90))

    def anywhere(self, low: float = -89.9, high: float = 90.0) -> float:
        """Return a slope."""
        return float(self.random.uniform(*((low, high) if self.usual else (-89.9, 90.0))))

    def section(self) -> dict[str, Any]:
        shape = str(self.random.choice(["rectangular", "chamfered", "vee", "circular", "facets"]))
        data: dict[str, Any] = {"shape": shape}
        if shape == "rectangular":
            data["width_m"] = self.quantity(0.01, 5, (0.3, 1.5))
        elif shape == "circular":
            data["radius_m"] = self.quantity(0.02, 3, (0.2, 1.0))
        elif shape == "facets":
            slopes = np.sort(self.random.uniform(0, 90, self.random.integers(1, 5)))
            slopes[0] *= not self.maybe(0.3)
            slopes[-1] = 90.0 if self.maybe(0.2) else slopes[-1]
            data["facets"] = [
                {"length_m": self.quantity(0.001, 1, (0.05, 0.5)), "slope_deg": float(slope)} for slope in slopes
            ]
        else:
            data["chamfer_deg"] = self.angle()
            if shape == "chamfered":
                data["base_m"] = 0.0 if self.maybe(0.2) else self.quantity(1e-6, 5, (0.2, 1.0))
            if self.maybe(0.5):
                data["chamfer_m"] = self.quantity(1e-4, 3, (0.05, 0.5))
        if self.maybe(0.4):
            data["wall_height_m"] = self.quantity(0.01, 3, (0.2, 1.0))
        return data

    def changed(self, section: dict[str, Any]) -> dict[str, Any]:
        """Return a section that it may taper to."""
        limits = {"chamfer_deg": 90.0}
        changed = {
            key: min(value * float(np.exp(self.random.uniform(-0.7, 0.7))), limits.get(key, np.inf))
            for key, value in section.items()
            if isinstance(value, float)
        }
        sides = [side | {"length_m": side["length_m"] * self.quantity(0.5, 2)} for side in section.get("facets", [])]
        return section | changed | ({"facets": sides} if sides else {})

    def liner(self) -> dict[str, Any]:
        return self.friction() | ({"slip_ratio": float(self.random.uniform(0.1, 1))} if self.maybe(0.3) else {})

    def friction(self) -> dict[str, Any]:
        kind = self.random.integers(3)
        if kind == 0:
            return {"friction_deg": float(self.random.uniform(0, 30 if self.usual else 60))}
        if kind == 1:
            return {"own_material": True}
        rows = self.random.integers(2, 5)
        normal = np.cumsum(np.exp(self.random.uniform(-3, 2, rows)))
        shear = np.cumsum(np.exp(self.random.uniform(-3, 1, rows)) * (self.random.random(rows) > 0.1))
        return {"yield_locus_kpa": [[float(one), float(other)] for one, other in zip(normal, shear, strict=True)]}

    def segment(self) -> dict[str, Any]:
        roofs = [] if self.usual and self.maybe(0.8) else ["hood", "plate"]
        kind = str(self.random.choice(["straight", "curve", "curve", "fall", *roofs]))
        if kind == "fall":
            return {"kind": kind} | (
                {"drop_m": self.quantity(0.001, 20, (0.1, 3.0))}
                if self.maybe(0.7)
                else {"run_m": self.quantity(0.01, 5, (0.1, 1.0))}
            )
        data: dict[str, Any] = {"kind": kind, "section": "body", "liner": "other" if self.maybe(0.2) else "wall"}
        if self.maybe(0.4):
            data["section"] = ["body", "other"]
        if kind in ("straight", "plate"):
            slope = (
                float(self.random.choice([0, 90]))
                if self.maybe(0.1)
                else self.anywhere(20.0, 70.0)
                if self.usual
                else float(self.random.uniform(0, 90))
            )
            slope = -slope if kind == "plate" and slope < 90 and self.maybe(0.2) else slope
            measures = [name for name, none in (("drop_m", 0), ("run_m", 90)) if slope != none and slope >= 0]
            measure = str(self.random.choice(measures)) if measures and self.maybe(0.2) else "length_m"
            return data | {"slope_deg": slope, measure: self.quantity(0.01, 50, (0.1, 5.0))}
        data |= {"radius_m": self.quantity(0.05, 500, (0.5, 10.0)), "to_slope_deg": self.anywhere(0.0, 80.0)}
        if not self.maybe(0.4):
            return data
        data["from_slope_deg"] = self.anywhere(20.0, 90.0)
        if kind == "hood" and self.maybe(0.7):  # a roof has to steepen
            ends = sorted((data["from_slope_deg"], data["to_slope_deg"]))
            data["from_slope_deg"], data["to_slope_deg"] = ends
        return data

    def chute(self) -> dict[str, Any]:
        self.usual = self.maybe(0.5)
        body = self.section()
        inlet: dict[str, Any] = {
            "velocity_m_s": self.quantity(1e-6, 100, (1.0, 8.0)),
            "slope_deg": self.anywhere(20.0, 90.0),
        }
        data = spec(
            flow={"rate_t_h": self.quantity(0.001, 50_000, (50.0, 3000.0))}
            | self.perhaps(0.1, gravity_m_s2=(0.5, 100)),
            material={
                "density_kg_m3": self.quantity(100, 6000, (500.0, 3000.0)),
                "internal_friction_deg": float(self.random.uniform(0, 89)),
            }
            | self.perhaps(0.1, pressure_ratio=(0.01, 1)),
            liners={"wall": self.liner(), "other": self.liner()},
            sections={"body": body, "other": self.changed(body)},
            model={"friction_law": str(self.random.choice(["paper", "equilibrium"]))},
            segments=[self.segment() for _ in range(self.random.integers(1, 5))],
        )
        data["inlet"] = inlet
        if self.maybe(0.3):
            data["inlet"] = {
                "belt": {
                    "velocity_m_s": self.quantity(0.1, 8),
                    "incline_deg": float(self.random.uniform(-20, 20)),
                    "pulley_radius_m": self.quantity(0.1, 1),
                    "material_depth_m": float(self.random.uniform(0, 0.4)),
                }
                | self.perhaps(0.3, belt_thickness_m=(0.001, 0.05))
            }
        if self.maybe(0.1):
            data["inlet"]["at_m"] = [float(self.random.uniform(-5, 5)), float(self.random.uniform(-5, 20))]
        if self.maybe(0.3):
            data["receiver"] = {
                "velocity_m_s": self.quantity(0.1, 10),
                "slope_deg": float(self.random.uniform(-20, 30)),
                "friction_deg": float(self.random.uniform(0, 40)),
            }
        if self.maybe(0.3):
            self.put_anywhere(data["segments"])
        return data

    def put_anywhere(self, segments: list[dict[str, Any]]) -> None:
        """Puts a flight onto one of the segments."""
        number = 0 if self.usual else int(self.random.integers(len(segments)))
        if segments[number]["kind"] == "fall":
            return
        right, up = (0.3, -0.5) if self.usual else (3, 1)
        segments[number]["start_m"] = [float(self.random.uniform(0, right)), float(self.random.uniform(-3, up))]
        if segments[number]["kind"] in ("curve", "hood"):
            segments[number].setdefault("from_slope_deg", self.anywhere(20.0, 90.0))
        segments.insert(number, {"kind": "fall", "onto_next": True})


class LimitMaker(Maker):
    """Draws chutes with lumps, liners that wear, and limits of their own."""

    def chute(self) -> dict[str, Any]:
        data = super().chute()
        data["material"] |= self.perhaps(0.7, lump_m=(1e-4, 1.0))
        for liner in data["liners"].values():
            liner |= self.perhaps(0.7, thickness_m=(0.001, 0.2), wear_mm3_per_j=(1e-8, 1.0))
        ends = dict.fromkeys(LIMITS, (0.01, 10.0))
        ends |= {"min_velocity_ratio": (0.1, 0.9), "max_velocity_ratio": (1.0, 3.0)}
        data["limits"] = self.perhaps(0.5, **ends)
        return data


class SceneMaker(Maker):
    """Draws chutes whose steel, receiving belt and operating states are told."""

    def chute(self) -> dict[str, Any]:
        data = super().chute()
        for segment in data["segments"]:
            if segment["kind"] != "fall" and self.maybe(0.5):
                segment["may_be_passed"] = True
        if self.maybe(0.2):
            data["model"]["steel"] = "follows_stream"
        data["model"] |= self.perhaps(0.3, momentum_factor=(1.0, 2.0), longitudinal_pressure_ratio=(1e-3, 1.0))
        data["receiver"] = {
            "velocity_m_s": self.quantity(0.1, 10),
            "friction_deg": float(self.random.uniform(0, 40)),
            "at_m": [float(self.random.uniform(-3, 5)), float(self.random.uniform(-60, 0))],
            "plan_angle_deg": float(self.random.uniform(-180, 180)),
        }
        if self.maybe(0.5):
            data["cases"] = {
                "other": {
                    "flow.rate_t_h": self.quantity(1, 5000),
                    "liners": {"wall": self.friction()} if self.maybe(0.3) else {},
                }
            }
        data["uncertainty"] = {"receiver.velocity_m_s": 0.1}  # checked, and felt by nothing that is solved
        return data


class ClosedMaker(Maker):
    """Draws chutes of pipes and boxes."""

    def section(self) -> dict[str, Any]:
        if self.maybe(0.6):
            return {"shape": "pipe", "radius_m": self.quantity(0.02, 3, (0.2, 1.0))}
        return {
            "shape": "box",
            "width_m": self.quantity(0.01, 5, (0.3, 1.5)),
            "height_m": self.quantity(0.01, 3, (0.2, 1.0)),
        }


class BeltMaker(Maker):
    """Draws chutes that a belt feeds: one whose width is given, and on which a slow stream may slide."""

    def chute(self) -> dict[str, Any]:
        data = super().chute()
        belt: dict[str, Any] = {
            "velocity_m_s": self.quantity(0.05, 8, (0.3, 5.0)),
            "incline_deg": float(self.random.uniform(-40, 25)),
            "pulley_radius_m": self.quantity(0.1, 1, (0.2, 0.6)),
            "width_m": self.quantity(0.1, 4, (0.6, 2.4)),
            "trough_deg": 0.0 if self.maybe(0.2) else float(self.random.uniform(0, 60)),
            "surcharge_deg": 0.0 if self.maybe(0.05) else float(self.random.uniform(0.1, 40)),
        }
        belt |= self.perhaps(0.3, roll_m=(0.05, 1)) | self.perhaps(0.5, friction_deg=(1e-6, 89))
        data["inlet"] = {"belt": belt} | {key: data["inlet"][key] for key in ("at_m",) if key in data["inlet"]}
        return data


MAKERS = (Maker, SceneMaker, ClosedMaker, BeltMaker, LimitMaker)
"""All that draw chutes, each with cases of its own. For a new shape or kind add a class derived from ``Maker``."""
