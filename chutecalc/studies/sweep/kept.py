"""What stays of a chamfered section while its chamfer angle varies."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from chutecalc.api.chute import Chute
from chutecalc.errors import UsageError
from chutecalc.fields.units import same_quantity
from chutecalc.physics.arrays import Array, Mask
from chutecalc.spec.chute_spec import Chamfered, ChuteSpec, Vee
from chutecalc.spec.paths import with_values

KEEP = ("base", "width", "depth")
ROUNDING = 1e-14
ANGLE = same_quantity("chamfer_deg")
GIVES = [*same_quantity("base_m"), *same_quantity("chamfer_m")]
"""Keys whose values follow where the width or the depth is kept."""


class Kept:
    """The sections whose angle a sweep varies, and what stays of them beside it."""

    def __init__(self, chute: Chute, paths: Sequence[str], keep: str = "base") -> None:
        """Checks that it can be kept.

        Args:
            chute: that is varied.
            paths: all that are varied.
            keep: ``base`` and the chamfer's length; the overall ``width`` and that length, while the base gives way; or
                the ``depth``, the chamfer's height, and the overall width, while base and length give way.

        Raises:
            UsageError: what stands against it.
        """
        self.chute = chute
        self.depth = keep == "depth"
        parts = [path.split(".") for path in paths]
        varied = [path[1] for path in parts if path[0] == "sections" and len(path) == 3 and path[2] in ANGLE]
        self.names = [] if keep == "base" else [name for name in varied if name in chute.spec.sections]
        if keep not in KEEP:
            raise UsageError(f"--keep has to be {', '.join(KEEP)}, not {keep}")
        if keep != "base" and not varied:
            raise UsageError(f"--keep {keep} says what stays while a chamfer angle varies: add beta=15:90:5")
        for name in self.names:
            section = chute.spec.sections[name]
            if not isinstance(section, Chamfered):
                what = "a vee has no base that could give way" if isinstance(section, Vee) else "it has no chamfer"
                raise UsageError(f"--keep {keep} does not go with sections.{name}: {what}")
            if section.chamfer_m is None:
                raise UsageError(f"--keep {keep} needs sections.{name}.chamfer_m, the length of the chamfer")

    def __call__(self, changes: Mapping[str, Array], count: int) -> tuple[dict[str, Array], Mask]:
        """What is put at which path, and which designs have a section, shape (count,).

        With angle β, base B and chamfer C, and β₀ that of the spec: C sin β stays for the depth, and B + 2 C cos β for
        both. Written so that nothing changes, to the last digit, at β = β₀.
        """
        possible = np.ones(count, dtype=bool)
        if not self.names:
            return dict(changes), possible
        spec = ChuteSpec.model_validate(with_values(self.chute.data, dict(changes), self.chute.source))
        put = {path: values for path, values in changes.items() if not self._gives(path)}
        for name in self.names:
            section, drawn = spec.sections[name], self.chute.spec.sections[name]
            assert isinstance(section, Chamfered)
            assert isinstance(drawn, Chamfered)
            base, chamfer = np.atleast_1d(section.base_m), np.atleast_1d(section.chamfer_m)
            angle, before = np.radians(np.atleast_1d(section.chamfer_deg)), np.radians(drawn.chamfer_deg)
            length = chamfer * (np.sin(before) / np.sin(angle)) if self.depth else chamfer
            given = base + 2.0 * chamfer * np.cos(before)
            left = base + 2.0 * (chamfer * np.cos(before) - length * np.cos(angle))
            left = np.where(np.abs(left) < ROUNDING * given, 0.0, left)  # a vee
            possible = possible & (left >= 0.0)
            put |= {f"sections.{name}.base_m": left, f"sections.{name}.chamfer_m": length}
        return put, possible

    def _gives(self, path: str) -> bool:
        """Whether what is at a path follows here."""
        parts: list[Any] = path.split(".")
        return parts[0] == "sections" and parts[1] in self.names and parts[-1] in GIVES
