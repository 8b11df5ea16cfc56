"""What a sweep is asked for: variants of a chute, the columns of their rows, and the blocks they are solved in."""

import hashlib
import json
from collections.abc import Sequence
from copy import copy
from functools import cached_property
from typing import Any

from chutecalc import __version__
from chutecalc.api.batch import CHUNK
from chutecalc.api.chute import Chute
from chutecalc.api.solve import solve
from chutecalc.api.tolerance import check_tolerance
from chutecalc.errors import UsageError
from chutecalc.studies.sweep.adjustment import SectionAdjustment
from chutecalc.studies.sweep.block import TEXT, Top
from chutecalc.studies.sweep.checks import chutes_by_names, selected_columns
from chutecalc.studies.sweep.columns import own_columns
from chutecalc.studies.sweep.design_rows import at_ends
from chutecalc.studies.sweep.grid import Grid
from chutecalc.studies.sweep.parameters import AnyParameter

WHOLE, STATIONS = 1024, 262_144
"""Designs of a block that needs whole trajectories, a tenth of a gigabyte, and stations of a block, roughly.

Blocks of ends alone are one chunk of a batch.
"""


class Sweep:
    """Variants of a chute, and the columns to compute for them.

    >>> import chutecalc
    >>> import numpy as np
    >>> from chutecalc.studies.sweep.parameters import Parameter
    >>> chute = chutecalc.parse(chutecalc.STARTER)
    >>> path = "flow.rate_t_h"
    >>> sweep = Sweep(chute, [Parameter(path, (path,), np.array([500.0, 1000.0]))], columns=["exit_velocity_m_s"])
    >>> sweep.header
    ['flow.rate_t_h', 'status', 'exit_velocity_m_s']
    """

    def __init__(
        self,
        chute: Chute,
        parameters: Sequence[AnyParameter],
        parallel: bool = False,
        keep: str = "base",
        columns: Sequence[str] = (),
        top: Top | None = None,
        points: int | None = None,
        spacing: float | None = None,
        rtol: float = 1e-10,
    ) -> None:
        """Check the arguments; nothing is solved yet.

        Args:
            chute: A chute of one design.
            parameters: The parameters to vary, at least one.
            parallel: Whether their lists run side by side instead of in all combinations.
            keep: Dimension of a section that is constant while its chamfer angle varies: ``base``, ``width`` or
                ``depth``.
            columns: Names of the columns to compute, from :func:`~chutecalc.studies.sweep.columns.row_columns`,
                or of segments as :func:`~chutecalc.studies.sweep.columns.own_columns` reads them; or
                a station's columns with ``points`` or ``spacing``.
            top: The rows to select; all by default.
            points: Number of stations of each segment, as in :meth:`chutecalc.Solution.stations`; rows are stations
                then.
            spacing: Spacing of stations, m, as in :meth:`chutecalc.Solution.stations`; rows are stations then.
            rtol: Relative tolerance, as in :func:`chutecalc.solve`.

        Raises:
            UsageError: Arguments that do not go together.
            SpecError: All paths that are not in the spec and all values that are out of bounds.
        """
        check_tolerance(rtol)
        self.chute, self.rtol, self.top, self.points, self.spacing = chute, rtol, top, points, spacing
        self.parameters, self.parallel, self.keep = tuple(parameters), parallel, keep
        self.profiles = points is not None or spacing is not None
        self.grid = Grid(parameters, parallel)
        self.columns = selected_columns(columns, chute, self.profiles)
        paths = [path for parameter in self.grid.numbers for path in parameter.paths]
        self.adjustments = {
            names: SectionAdjustment(each, paths, keep) for names, each in chutes_by_names(chute, self.grid).items()
        }
        """The chutes to vary by their names, those that can be built, each with its adjusted sections."""
        if self.top and self.profiles:
            raise UsageError("--top selects designs. It cannot be used with --points or --stations")
        if self.top and self.top.column not in self.header:
            self.columns = selected_columns([*self.columns, self.top.column], chute, self.profiles)
        self.own = {} if self.profiles else own_columns(self.columns, chute)
        """Those of the columns that are of a segment, by name."""
        if self.top and self.top.column in self.texts:
            raise UsageError(f"--by needs a column of numbers, not {self.top.column}")

    def over(self, values: Sequence[Any]) -> "Sweep":
        """Return the sweep over other rows of values, which are not checked again: those out of bounds are impossible.

        Args:
            values: for each parameter an array of numbers, or of names that it has; all of one length.
        """
        other, given = copy(self), zip(self.parameters, values, strict=True)
        other.parameters = tuple(parameter._replace(values=own) for parameter, own in given)
        other.parallel, other.grid = True, Grid(other.parameters, parallel=True)
        return other

    @property
    def count(self) -> int:
        """Number of designs."""
        return self.grid.count

    @property
    def header(self) -> list[str]:
        """Names of the columns of a row."""
        return [*(parameter.name for parameter in self.parameters), "status", *self.columns]

    @property
    def texts(self) -> list[str]:
        """Names of the columns of text; all others are numbers."""
        own = (name for name, (_, column) in self.own.items() if not column.dimension)
        return [*(parameter.name for parameter in self.grid.texts), *TEXT, *own]

    @property
    def is_adjusted(self) -> bool:
        """Whether sections are adjusted, see :class:`SectionAdjustment`."""
        return any(adjustment.names for adjustment in self.adjustments.values())

    @cached_property
    def block_size(self) -> int:
        """Number of designs in a block."""
        if self.profiles:
            stations = int(solve(self.chute, self.rtol).stations(self.points, self.spacing, ["s_m"])["s_m"].size)
            return max(1, min(CHUNK, STATIONS // max(stations, 1)))
        return CHUNK if at_ends(self.columns) else WHOLE

    @property
    def block_count(self) -> int:
        """Number of blocks."""
        return -(-self.count // self.block_size)

    def identity(self) -> dict[str, Any]:
        """Return everything that determines the rows, with the version of chutecalc.

        Blocks of two sweeps are interchangeable where these are equal.
        """
        values = [hashlib.sha256(parameter.values.tobytes()).hexdigest() for parameter in self.parameters]
        library = self.chute.library
        return {
            "chutecalc": __version__,
            "spec": json.loads(json.dumps(self.chute.written)),
            "library": [library.materials, library.liners] if library else None,  # a case or a parameter may use any
            "parameters": [
                [parameter.name, list(parameter.paths), len(parameter.values), digest]
                for parameter, digest in zip(self.parameters, values, strict=True)
            ],
            "zip": self.parallel,
            "keep": self.keep,
            "columns": self.columns,
            "top": list(self.top) if self.top else None,
            "stations": [self.points, self.spacing],
            "tolerance": self.rtol,
            "block": self.block_size,
        }
