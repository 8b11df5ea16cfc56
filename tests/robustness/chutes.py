"""Random chutes from the whole admissible space and its edges, each told by a seed."""

from typing import Any

import numpy as np

from tests.conftest import spec


def random_chute(seed: int) -> dict[str, Any]:
    """A spec's tables. Some are not admissible together: those have to be told as faults."""
    random = np.random.default_rng(seed)
    return _Maker(random).chute()


class _Maker:
    def __init__(self, random: np.random.Generator) -> None:
        self.random = random

    def maybe(self, chance: float) -> bool:
        return bool(self.random.random() < chance)

    def quantity(self, low: float, high: float) -> float:
        """Over many decades, or at an end."""
        if self.maybe(0.15):
            return float(self.random.choice([low, high]))
        return float(np.exp(self.random.uniform(np.log(low), np.log(high))))

    def angle(self) -> float:
        if self.maybe(0.5):
            return float(self.random.choice([1e-6, 30, 45, 89.999999, 90.0]))
        return float(self.random.uniform(1e-6, 90))

    def anywhere(self) -> float:
        return float(self.random.uniform(-89.9, 90))

    def section(self) -> dict[str, Any]:
        shape = str(self.random.choice(["rectangular", "chamfered", "vee", "circular", "facets"]))
        data: dict[str, Any] = {"shape": shape}
        if shape == "rectangular":
            data["width_m"] = self.quantity(0.01, 5)
        elif shape == "circular":
            data["radius_m"] = self.quantity(0.02, 3)
        elif shape == "facets":
            slopes = np.sort(self.random.uniform(0, 90, self.random.integers(1, 5)))
            slopes[0] *= not self.maybe(0.3)
            slopes[-1] = 90.0 if self.maybe(0.2) else slopes[-1]
            data["facets"] = [{"length_m": self.quantity(0.001, 1), "slope_deg": float(slope)} for slope in slopes]
        else:
            data["chamfer_deg"] = self.angle()
            if shape == "chamfered":
                data["base_m"] = 0.0 if self.maybe(0.2) else self.quantity(1e-6, 5)
            if self.maybe(0.5):
                data["chamfer_m"] = self.quantity(1e-4, 3)
        if self.maybe(0.4):
            data["wall_height_m"] = self.quantity(0.01, 3)
        return data

    def changed(self, section: dict[str, Any]) -> dict[str, Any]:
        """A section that it may taper to."""
        limits = {"chamfer_deg": 90.0}
        changed = {
            key: min(value * float(np.exp(self.random.uniform(-0.7, 0.7))), limits.get(key, np.inf))
            for key, value in section.items()
            if isinstance(value, float)
        }
        sides = [side | {"length_m": side["length_m"] * self.quantity(0.5, 2)} for side in section.get("facets", [])]
        return section | changed | ({"facets": sides} if sides else {})

    def liner(self) -> dict[str, Any]:
        kind = self.random.integers(3)
        if kind == 0:
            return {"friction_deg": float(self.random.uniform(0, 60))}
        if kind == 1:
            return {"own_material": True, "slip_ratio": float(self.random.uniform(0.1, 1))}
        rows = self.random.integers(2, 5)
        normal = np.cumsum(np.exp(self.random.uniform(-3, 2, rows)))
        shear = np.cumsum(np.exp(self.random.uniform(-3, 1, rows)) * (self.random.random(rows) > 0.1))
        return {"yield_locus_kpa": [[float(one), float(other)] for one, other in zip(normal, shear, strict=True)]}

    def segment(self) -> dict[str, Any]:
        kind = str(self.random.choice(["straight", "curve", "curve", "hood", "plate", "fall"]))
        if kind == "fall":
            return {"kind": kind} | (
                {"drop_m": self.quantity(0.001, 20)} if self.maybe(0.7) else {"run_m": self.quantity(0.01, 5)}
            )
        data: dict[str, Any] = {"kind": kind, "section": "body"}
        if self.maybe(0.4):
            data["section"] = ["body", "other"]
        if kind in ("straight", "plate"):
            slope = float(self.random.choice([0, 90])) if self.maybe(0.1) else float(self.random.uniform(0, 90))
            return data | {"slope_deg": slope, "length_m": self.quantity(0.01, 50)}
        data |= {"radius_m": self.quantity(0.05, 500), "to_slope_deg": self.anywhere()}
        return data | ({"from_slope_deg": self.anywhere()} if self.maybe(0.4) else {})

    def chute(self) -> dict[str, Any]:
        body = self.section()
        inlet: dict[str, Any] = {"velocity_m_s": self.quantity(1e-6, 100), "slope_deg": self.anywhere()}
        data = spec(
            flow={"rate_t_h": self.quantity(0.001, 50_000)},
            material={
                "density_kg_m3": self.quantity(100, 6000),
                "internal_friction_deg": float(self.random.uniform(0, 89)),
            },
            liners={"wall": self.liner()},
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
            }
        if self.maybe(0.3):
            data["receiver"] = {
                "velocity_m_s": self.quantity(0.1, 10),
                "slope_deg": float(self.random.uniform(-20, 30)),
                "friction_deg": float(self.random.uniform(0, 40)),
            }
        if self.maybe(0.3):
            self.place(data["segments"])
        return data

    def place(self, segments: list[dict[str, Any]]) -> None:
        """Puts a flight onto one of the segments."""
        number = int(self.random.integers(len(segments)))
        if segments[number]["kind"] == "fall":
            return
        segments[number]["start_m"] = [float(self.random.uniform(0, 3)), float(self.random.uniform(-3, 1))]
        if segments[number]["kind"] in ("curve", "hood"):
            segments[number].setdefault("from_slope_deg", self.anywhere())
        segments.insert(number, {"kind": "fall", "onto_next": True})
