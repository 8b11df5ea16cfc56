"""Adjusts the other dimensions of a section while a sweep varies its chamfer angle: the option ``--keep``."""

from collections.abc import Mapping, Sequence

import numpy as np

from chutecalc.api.chute import Chute
from chutecalc.errors import UsageError
from chutecalc.fields.units import same_quantity
from chutecalc.physics.arrays import Array, Mask
from chutecalc.sections.registry import SHAPES
from chutecalc.spec.chute_spec import ChuteSpec
from chutecalc.spec.paths import with_values

KEEP = ("base", "width", "depth")
ANGLE = same_quantity("chamfer_deg")


class SectionAdjustment:
    """Adjusts the sections whose chamfer angle a sweep varies.

    Attributes:
        names: of the sections that are adjusted; empty for ``base``.
    """

    def __init__(self, chute: Chute, paths: Sequence[str], keep: str = "base") -> None:
        """Check that the sections can be adjusted.

        Args:
            chute: that is varied.
            paths: key paths of all numbers that are varied.
            keep: what stays as it is: ``base`` and the chamfer's length; the overall ``width`` and that length, while
                the base is adjusted; or the ``depth`` of the chamfer and the overall width, while both are adjusted.

        Raises:
            UsageError: ``keep`` is not known, no chamfer angle is varied, or a section has no such dimensions.
        """
        self.chute, self.keep = chute, keep
        parts = [path.split(".") for path in paths]
        varied = [path[1] for path in parts if path[0] == "sections" and len(path) == 3 and path[2] in ANGLE]
        self.names = [] if keep == "base" else [name for name in varied if name in chute.spec.sections]
        if keep not in KEEP:
            raise UsageError(f"--keep must be {', '.join(KEEP)}, not {keep}")
        takes = " or ".join(shape for shape, table in SHAPES.items() if table.adjustable)
        if keep != "base" and not varied:
            if not any(section.adjustable for section in chute.spec.sections.values()):
                raise UsageError(f"--keep {keep} needs a section of shape {takes}, and the spec has none. Remove it.")
            raise UsageError(f"--keep {keep} applies while a chamfer angle varies. Add one, such as beta=15:90:5.")
        for name in self.names:
            section = chute.spec.sections[name]
            if not section.adjustable:
                raise UsageError(
                    f"--keep {keep} cannot be used with sections.{name}: its shape is {section.shape}, not {takes}"
                )
            for key in section.adjustable:
                if getattr(section, key) is None:
                    raise UsageError(f"--keep {keep} needs sections.{name}.{key}. Add it to the spec.")

    def apply(self, changes: Mapping[str, Array], count: int) -> tuple[dict[str, Array], Mask]:
        """Return the changes with the adjusted dimensions, and the mask of designs whose section can be built.

        Args:
            changes: key path to values in the units of the path, shape (1,) or (count,).
            count: number of designs.
        """
        possible = np.ones(count, dtype=bool)
        if not self.names:
            return dict(changes), possible
        spec = ChuteSpec.model_validate(with_values(self.chute.data, dict(changes), self.chute.source))
        put = {path: values for path, values in changes.items() if not self._is_adjusted(path)}
        for name in self.names:
            values, can_be = spec.sections[name].adjusted(self.chute.spec.sections[name], self.keep)
            possible = possible & can_be
            put |= {f"sections.{name}.{key}": value for key, value in values.items()}
        return put, possible

    def _is_adjusted(self, path: str) -> bool:
        """Return whether the number at a path is adjusted, and so is not varied itself."""
        table, *name, key = path.split(".")
        if table != "sections" or name[0] not in self.names:
            return False
        return any(key in same_quantity(each) for each in self.chute.spec.sections[name[0]].adjustable)
