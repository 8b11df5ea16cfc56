"""Many variants of a chute in all the states that it has to serve, for aims, optimisers and samples."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from chutecalc.api.chute import Chute
from chutecalc.output.dataset import Block
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.sweep.block import joined
from chutecalc.studies.sweep.parameters import AnyParameter
from chutecalc.studies.sweep.solved_blocks import solve_blocks
from chutecalc.studies.sweep.sweep import Sweep
from chutecalc.studies.sweep.text_parameter import TextParameter, case_parameter
from chutecalc.workers import Pool, Threads

DESIGN_ALONE = (DESIGN_POINT,)


class Variants:
    """Variants of a chute, as rows of a sweep whose lists run side by side.

    >>> import chutecalc
    >>> from chutecalc.studies.sweep.parameters import read_parameters
    >>> chute = chutecalc.parse(chutecalc.STARTER)
    >>> variants = Variants(chute, read_parameters(["radius=1:4:1"], chute), ["exit_velocity_m_s"])
    >>> variants([np.array([2.0, 3.0])])["exit_velocity_m_s"].round(3).tolist()
    [[5.603, 6.222]]
    """

    def __init__(
        self,
        chute: Chute,
        parameters: Sequence[AnyParameter],
        columns: Sequence[str],
        states: Sequence[str] = DESIGN_ALONE,
        rtol: float = 1e-10,
        pool: Pool | None = None,
    ) -> None:
        """Take what varies and what to compute.

        Args:
            chute: a chute of one design.
            parameters: what varies, as :func:`chutecalc.studies.sweep.parameters.read_parameters` returns it; their
                values are the ones that are checked, and are not solved.
            columns: names of columns, as for :class:`chutecalc.studies.sweep.sweep.Sweep`.
            states: names of operating states of the spec, ``design`` for the spec as written.
            rtol: relative tolerance, as in :func:`chutecalc.solve`.
            pool: where they are solved; threads, one for each core, by default. Values do not depend on it.

        Raises:
            UsageError: there is no such column or state.
            SpecError: a path is not in the spec, or a value is out of bounds.
        """
        self.chute, self.parameters, self.rtol, self.pool = chute, tuple(parameters), rtol, pool or Threads()
        self.states = tuple(states)
        first = [
            each if isinstance(each, TextParameter) else each._replace(values=each.values[[0, -1]])
            for each in self.parameters
        ]
        by_case = [] if self.states == DESIGN_ALONE else [case_parameter(",".join(self.states), chute)]
        self.sweep = Sweep(chute, [*by_case, *first], columns=columns, rtol=rtol)
        self.columns = list(self.sweep.columns)

    def __call__(self, values: Sequence[Any]) -> Block:
        """Solve variants.

        Args:
            values: for each parameter an array of numbers, or of names that it has, shape (variants,). A value out of
                its bounds makes a variant impossible.

        Returns:
            ``status`` and the columns by name, each of shape (states, variants): NaN where a variant fails.
        """
        states = [] if self.states == DESIGN_ALONE else [np.repeat(self.states, len(values[0]))]
        sweep = self.sweep.over([*states, *(np.tile(own, len(self.states)) for own in values)])
        block = joined([block for _, block in solve_blocks(sweep, range(sweep.block_count), self.pool)])
        return {name: block[name].reshape(len(self.states), -1) for name in ("status", *self.columns)}
