"""What follows from the varied numbers of a chute, recorded once so that compiled code can repeat it with others."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Protocol

import numpy as np

from chutecalc.api.parameter import Parameter
from chutecalc.api.tape import Tape, Traced, run_recipe
from chutecalc.core.replay import Recipe
from chutecalc.core.single_design import SingleDesignSolver
from chutecalc.design import Design
from chutecalc.errors import SpecError
from chutecalc.physics.arrays import Array
from chutecalc.solver.chain import run_ends, single_design_solver
from chutecalc.solver.chain_input import DesignRows, first_varied_segment, layout_of, row_columns
from chutecalc.solver.options import solver_options
from chutecalc.solver.segment_solution import Ends
from chutecalc.solver.steel import Steel, enters_vertically, follows_stream, with_steel
from chutecalc.spec.build import build
from chutecalc.spec.chute_spec import ChuteSpec
from chutecalc.spec.operating import is_operating


class VariedChute(Protocol):
    """What a function needs of its chute, see :class:`chutecalc.api.chute.Chute`."""

    spec: ChuteSpec
    design: Design

    @property
    def drawing(self) -> "VariedChute":
        """The chute at its design point."""

    def vary(self, changes: Mapping[str, Any]) -> Any:
        """Return variants.

        Args:
            changes: values by spec path, in the unit of the path.
        """

    def steel_for(self, *states: Design) -> Steel:
        """Return where segments are drawn that follow the stream.

        Args:
            states: other states of the chute, which are to run on that steel.
        """

    @property
    def function(self) -> Any:
        """Makes the function again, in another process."""


class Recording:
    """The way from varied numbers to the solver's row of numbers, and what the outputs need beside it.

    Its records are of one thread at a time.
    """

    def __init__(
        self,
        chute: VariedChute,
        spec: ChuteSpec,
        parameters: Sequence[Parameter],
        rtol: float,
        exit_needs: tuple[bool, bool],
        direct: bool,
    ) -> None:
        """Build the chute once and record what follows from the parameters.

        Args:
            chute: of one design.
            spec: a copy of its spec, into which varied values are put meanwhile.
            parameters: the numbers of that spec that are varied.
            rtol: relative error allowed to the velocity, dimensionless.
            exit_needs: what the solver works out at the exit, see :func:`chutecalc.results.exits.exit_needs`.
            direct: whether the outputs need nothing but the end of the stream.
        """
        self._chute, self._parameters, self._rtol, self._needs = chute, parameters, rtol, exit_needs
        self._layout, self._restart = layout_of(chute.design), 0
        self._design, self._leaves = chute.design, dict[int, int]()
        self._recipe: Recipe | None = None
        self.single_design: SingleDesignSolver | None = None
        """Solves one design after the other, if the outputs are ``direct``; None where nothing could be recorded."""
        steel = self._steel()
        if steel is None or chute.design.segments[-1].may_end_elsewhere:
            return
        before = [parameter.value for parameter in parameters]
        try:
            self._write(Tape(), spec, steel, direct)
        except (AttributeError, TypeError, ValueError):
            pass  # something that a tape cannot record
        finally:
            for parameter, value in zip(parameters, before, strict=True):
                parameter.set_value(value)

    @property
    def holds(self) -> bool:
        """Whether something was recorded."""
        return self._recipe is not None

    def replayed(self, rows: Array) -> Array | None:
        """Return the recorded numbers for other varied ones; None where the recording does not hold for all designs.

        Args:
            rows: varied numbers of each design, in the units of their paths.
        """
        return None if self._recipe is None else run_recipe(self._recipe, rows)

    def solved(self, known: Array) -> tuple[Design, Ends] | None:
        """Return designs and their ends; None where one has a curve that is not tangent to its stream.

        Args:
            known: from :meth:`replayed`.
        """
        try:
            ends = run_ends(self._layout, DesignRows(known, [], self._restart), self._rtol, *self._needs)
        except SpecError:
            return None
        return _filled(self._design, known, self._leaves), ends

    def _steel(self) -> Steel | None:
        """Return the steel on which all calls run; none where each draws it anew; None where that needs a solution."""
        chute, drawing = self._chute, self._chute.drawing
        paths = [parameter.path for parameter in self._parameters]
        if all(is_operating(path) for path in paths):
            return drawing.steel_for()
        redrawn_only = drawing is chute and not any(is_operating(path) for path in paths)
        vertical = not any(path.startswith("inlet.") for path in paths)
        vertical = vertical and enters_vertically(drawing.design) and enters_vertically(chute.design)
        return {} if redrawn_only or not follows_stream(drawing.design, vertical) else None

    def _write(self, tape: Tape, spec: ChuteSpec, steel: Steel, direct: bool) -> None:
        """Record on a tape what leads to the solver's row of numbers, and what the outputs need beside it."""
        given = [tape.new_variable(parameter.value_in_unit) for parameter in self._parameters]
        for parameter, value in zip(self._parameters, given, strict=True):
            converted = np.multiply(parameter.to_first_unit(value), 1.0)
            if not parameter.accepts(converted):
                raise ValueError("no value for the spec")
            parameter.set_value(converted)
        stands = spec.model.steel == "fixed" and all(is_operating(parameter.path) for parameter in self._parameters)
        design = with_steel(build(spec, self._chute.drawing.design if stands else None), steel)
        columns, _, begins = row_columns(design)
        varied = [number for number, column in enumerate(columns) if isinstance(column, Traced)]
        self._restart = first_varied_segment(design, begins, varied[0]) if varied else 0
        leaves = {} if direct else {leaf.slot: leaf for leaf in _leaves(design)}
        self._leaves = {slot: len(columns) + number for number, slot in enumerate(leaves)}
        self._recipe = tape.recipe([*columns, *leaves.values()])
        self._design = self._design if direct else design
        if direct:
            alone = tape.recipe(columns, width=1)
            self.single_design = single_design_solver(
                self._layout, alone, solver_options(self._rtol, dense_output=False), *self._needs
            )


def _leaves(item: Any) -> Iterator[Traced]:
    """Yield the traced numbers in a record."""
    if isinstance(item, Traced):
        yield item
    elif isinstance(item, tuple):
        for part in item:
            yield from _leaves(part)


def _filled(item: Any, known: Array, leaves: Mapping[int, int]) -> Any:
    """Return a record with its traced numbers replaced by their values."""
    if not leaves:
        return item
    if isinstance(item, Traced):
        return known[:, leaves[item.slot]]
    if isinstance(item, tuple):
        parts = [_filled(each, known, leaves) for each in item]
        return type(item)(*parts) if hasattr(item, "_fields") else tuple(parts)
    return item
