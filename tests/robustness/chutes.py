"""Random chutes of everything that a spec may say, each given by a seed.

Tables, keys and the ends of their numbers are read from the models of the spec, so a new shape, a new key or another
bound is drawn at once. What goes together is chosen here.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple

import numpy as np
import tomli_w

import chutecalc
from chutecalc.fields.quantity import Quantity
from chutecalc.fields.table import Table
from chutecalc.sections.faceted import Facet
from chutecalc.sections.registry import SHAPES
from chutecalc.segments.registry import KINDS
from chutecalc.spec.chute_spec import Flow, Inlet, Liner, Material, Model, Receiver
from chutecalc.spec.inlet_belt import Belt
from chutecalc.spec.limits import Limits
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


def draws(*seed: int) -> Iterator[Drawn]:
    """Yield chutes of one seed, without end. Some are not admissible and must have faults."""
    for data in random_specs(*seed):
        with noting_spec(data):
            yield drawn(data)


def random_specs(*seed: int) -> Iterator[dict[str, Any]]:
    """Specs of one seed, without end, as they are drawn."""
    drawing = Maker(seeds.generator(*seed))
    while True:
        yield drawing.chute()


def drawn(data: dict[str, Any]) -> Drawn:
    """Read and solve a spec. Some faults show only in the solver, where a hood takes the slope of a falling stream."""
    try:
        return Drawn(data, chutecalc.solve(chutecalc.parse(data)), None)
    except chutecalc.SpecError as error:
        return Drawn(data, None, error)


USUAL = {
    "rate_t_h": (50.0, 3000.0),
    "density_kg_m3": (500.0, 3000.0),
    "internal_friction_deg": (20.0, 70.0),
    "friction_deg": (5.0, 30.0),
    "gravity_m_s2": (9.7, 9.9),
    "width_m": (0.3, 1.5),
    "height_m": (0.2, 1.0),
    "wall_height_m": (0.2, 1.0),
    "base_m": (0.2, 1.0),
    "chamfer_m": (0.05, 0.5),
    "drop_m": (0.1, 3.0),
    "run_m": (0.1, 1.0),
    "length_m": (0.1, 5.0),
    "slope_deg": (20.0, 70.0),
    "to_slope_deg": (0.0, 80.0),
    "from_slope_deg": (20.0, 90.0),
    "velocity_m_s": (0.3, 8.0),
    "incline_deg": (-20.0, 20.0),
    "pulley_radius_m": (0.2, 0.6),
    "material_depth_m": (0.01, 0.4),
    "roll_m": (0.1, 0.5),
    "surcharge_deg": (1.0, 35.0),
    "pressure_ratio": (0.1, 1.0),
    "longitudinal_pressure_ratio": (0.01, 1.0),
}
"""Ends of numbers in a usual chute, where they are closer than what is plausible."""


class Maker:
    """Draws chutes: half as they are built, most of the others ending at their first segment."""

    def __init__(self, random: np.random.Generator) -> None:
        self.random, self.usual = random, False

    def maybe(self, chance: float) -> bool:
        return bool(self.random.random() < chance)

    def between(self, low: float, high: float) -> float:
        """Evenly in the logarithm, or evenly where an end is 0 or less."""
        if low <= 0.0:
            return float(self.random.uniform(low, high))
        return float(np.exp(self.random.uniform(np.log(low), np.log(high))))

    def number(self, key: str, quantity: Quantity) -> float:
        """Within what is usual in a usual chute; else anywhere in the bounds, at them, or just inside."""
        sizes = quantity.plausible
        if self.usual:
            return self.between(*USUAL.get(key, (sizes.low, sizes.high)))
        low = quantity.bounds.get("ge", quantity.bounds.get("gt"))
        high = quantity.bounds.get("le", quantity.bounds.get("lt"))
        if self.maybe(0.08):
            return float(self.random.choice([end for name, end in quantity.bounds.items() if name in ("ge", "le")]))
        if self.maybe(0.04):
            return float(self.random.choice([np.nextafter(low if low else sizes.least, high), np.nextafter(high, low)]))
        if quantity.dimension == "angle":
            near = self.between(1e-9, 1.0)
            return float(self.random.choice([high - near, max(low, near), *self.random.uniform(low, high, 6)]))
        size = self.between(sizes.least or 1e-3 * sizes.low, high)
        return -size if low < 0.0 and self.maybe(0.5) else size

    def some(self, table: type[Table], *without: str, chance: float = 0.3) -> dict[str, Any]:
        """The numbers that a table needs, and some of those that it may have."""
        return {
            key: [self.number(key, one) for _ in range(2)] if one.shape else self.number(key, one)
            for key, one in table.quantities().items()
            if key not in without and (table.model_fields[key].is_required() or self.maybe(chance))
        }

    def section(self) -> dict[str, Any]:
        shape = str(self.random.choice(list(SHAPES)))
        data = {"shape": shape} | self.some(SHAPES[shape])
        if shape == "facets":
            sides = [self.some(Facet) for _ in range(self.random.integers(1, 5))]
            slopes = sorted(side["slope_deg"] for side in sides)
            data["facets"] = [side | {"slope_deg": slope} for side, slope in zip(sides, slopes, strict=True)]
        return data

    def changed(self, section: dict[str, Any]) -> dict[str, Any]:
        """Return a section that it may taper to."""
        bounds = {key: one.bounds for key, one in SHAPES[section["shape"]].quantities().items()}

        def other(key: str, value: float) -> float:
            factor = float(np.exp(self.random.uniform(-0.7, 0.7)))
            return min(max(value * factor, bounds[key].get("ge", 0.0)), bounds[key]["le"]) if value else value

        sides = [side | {"length_m": min(side["length_m"] * 1.5, 100.0)} for side in section.get("facets", [])]
        numbers = {key: other(key, value) for key, value in section.items() if key in bounds}
        return section | numbers | ({"facets": sides} if sides else {})

    def liner(self) -> dict[str, Any]:
        return self.some(Liner, "friction_deg", "yield_locus_kpa") | self.friction()

    def friction(self) -> dict[str, Any]:
        kind = self.random.integers(3)
        if kind == 0:
            return {"friction_deg": self.number("friction_deg", Liner.quantities()["friction_deg"])}
        if kind == 1:
            return {"own_material": True}
        rows, wide = self.random.integers(2, 5), 0 if self.usual else 4
        normal = np.cumsum(np.exp(self.random.uniform(-3 - wide, 2 + wide, rows)))
        rise = np.exp(self.random.uniform(-3 - wide, 1 + wide, rows)) * (self.random.random(rows) > 0.1)
        rise[1:] = np.minimum(rise[1:], 11.0 * np.diff(normal))  # steeper ones are refused
        shear = np.cumsum(rise)
        return {"yield_locus_kpa": [[float(one), float(other)] for one, other in zip(normal, shear, strict=True)]}

    def segment(self) -> dict[str, Any]:
        rare = [kind for kind in KINDS if kind not in ("straight", "curve", "fall")]
        kinds = ["straight", "curve", "curve", "fall", *([] if self.usual and self.maybe(0.8) else rare)]
        kind = str(self.random.choice(kinds))
        measures = [key for key in ("length_m", "length_m", "drop_m", "run_m") if key in KINDS[kind].quantities()]
        data = {"kind": kind} | self.some(KINDS[kind], "start_m", *measures)
        if measures:
            key = str(self.random.choice(measures))
            data[key] = self.number(key, KINDS[kind].quantities()[key])
        if not KINDS[kind].guides:
            return data
        data |= {"liner": "other" if self.maybe(0.2) else "wall"}
        data["section"] = ["body", "other"] if self.maybe(0.3) else "body"
        data |= {"may_be_passed": True} if self.maybe(0.1) else {}
        if kind == "straight":
            data["slope_deg"] = abs(data["slope_deg"])
        if kind == "hood" and "from_slope_deg" in data:  # a roof has to steepen
            data["from_slope_deg"], data["to_slope_deg"] = sorted((data["from_slope_deg"], data["to_slope_deg"]))
        return data

    def inlet(self) -> dict[str, Any]:
        place = {"at_m": self.place()} if self.maybe(0.1) else {}
        if self.maybe(0.7):
            return place | self.some(Inlet, "at_m", chance=1.0)
        if self.maybe(0.5):
            return place | {"belt": self.some(Belt, "width_m", "roll_m", "trough_deg", "surcharge_deg")}
        loaded = self.some(Belt, "material_depth_m", "roll_m", chance=1.0)
        loaded |= {} if self.maybe(0.7) else {"roll_m": loaded["width_m"] * float(self.random.uniform(0.1, 0.9))}
        return place | {"belt": loaded}

    def place(self) -> list[float]:
        """A point not far below the inlet, or anywhere."""
        if self.usual or self.maybe(0.7):
            return [float(self.random.uniform(-1, 3)), float(self.random.uniform(-10, 1))]
        at = Inlet.quantities()["at_m"]
        return [self.number("at_m", at), self.number("at_m", at)]

    def limits(self) -> dict[str, Any]:
        limits = self.some(Limits, "min_velocity_ratio", "max_velocity_ratio")
        return limits | ({"min_velocity_ratio": 0.5, "max_velocity_ratio": 2.0} if self.maybe(0.3) else {})

    def material(self) -> dict[str, Any]:
        return self.some(Material) | self.some(Material, "lump_m", "pressure_ratio", chance=1.0)

    def chute(self) -> dict[str, Any]:
        self.usual = self.maybe(0.5)
        body = self.section()
        model = {
            "friction_law": str(self.random.choice(["paper", "equilibrium"])),
            "steel": "follows_stream" if self.maybe(0.2) else "fixed",
        }
        data = spec(
            flow=self.some(Flow, chance=0.1),
            material=self.material(),
            liners={"wall": self.liner(), "other": self.liner()},
            sections={"body": body, "other": self.changed(body)},
            model=model | self.some(Model, chance=0.15),
            segments=[self.segment() for _ in range(self.random.integers(1, 5))],
        )
        data["inlet"] = self.inlet()
        if self.maybe(0.4):
            data["receiver"] = self.some(Receiver, "at_m") | ({"at_m": self.place()} if self.maybe(0.5) else {})
            if 0.01 < data["receiver"]["velocity_m_s"] < 99.0:
                data["uncertainty"] = {"receiver.velocity_m_s": 1e-3}  # checked, and felt by no solution
        if self.maybe(0.3):
            self.put_anywhere(data["segments"])
        if self.maybe(0.2):
            data["limits"] = self.limits()
        if self.maybe(0.1):
            data["cases"] = {"other": {f"flow.{key}": value for key, value in self.some(Flow).items()}}
            if "friction_deg" in data["liners"]["wall"]:
                data["cases"]["other"]["liners"] = {"wall": {"friction_deg": 20.0}}
        return data

    def put_anywhere(self, segments: list[dict[str, Any]]) -> None:
        """Puts a flight onto one of the segments."""
        number = 0 if self.usual else int(self.random.integers(len(segments)))
        kind = KINDS[segments[number]["kind"]]
        if not kind.guides:
            return
        segments[number]["start_m"] = self.place()
        if "from_slope_deg" in kind.quantities() and "from_slope_deg" not in segments[number]:
            end = segments[number]["to_slope_deg"]
            segments[number]["from_slope_deg"] = end - 10.0 if end > 0.0 else end + 10.0
        segments.insert(number, {"kind": "fall", "onto_next": True})
