"""Groups of options of ``chutecalc sweep``."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING

import typer

from chutecalc.cli.options import OptionGroup
from chutecalc.cli.outputs import Outputs
from chutecalc.errors import UsageError

if TYPE_CHECKING:
    from chutecalc.studies.sweep.block import Top
    from chutecalc.studies.sweep.sweep import Sweep

MOST_DRAWN = 1_000_000
"""Most designs that a picture or a chart shows."""
STUDY = "Friction study only"
"""Heading of its options in the help."""


class Keep(StrEnum):
    """What stays constant while the chamfer angle varies."""

    BASE = "base"
    WIDTH = "width"
    DEPTH = "depth"


@dataclass(frozen=True, eq=False)
class BestOptions(OptionGroup):
    """Which rows are the best."""

    top: int | None = typer.Option(None, min=1, metavar="N", help="Report only the N best rows, by --by.")
    by: str | None = typer.Option(None, metavar="COLUMN:max|min", help="What is best, e.g. exit_velocity_m_s:max.")

    def read(self) -> Top | None:
        """Return the choice of rows, or None for all rows."""
        from chutecalc.studies.sweep.block import Top

        if self.top is None and self.by is None:
            return None
        if self.by is None:
            raise UsageError("--top needs --by, such as --by exit_velocity_m_s:max.")
        if self.top is None:
            raise UsageError("--by needs --top, such as --top 10.")
        name, _, direction = self.by.rpartition(":")
        if not name or direction not in ("max", "min"):
            raise UsageError(f"--by takes COLUMN:max or COLUMN:min, such as exit_velocity_m_s:max, not {self.by}.")
        return Top(self.top, name, direction == "max")


@dataclass(frozen=True, eq=False)
class StudyOptions(OptionGroup):
    """Inputs of the friction study beside its angles."""

    phi: float | None = typer.Option(
        None, metavar="DEG", help="Wall friction angle. Default: 25.", rich_help_panel=STUDY
    )
    base: float | None = typer.Option(
        None, metavar="M", help="Width between square corners. Default: 0.5.", rich_help_panel=STUDY
    )
    area: float | None = typer.Option(None, metavar="M2", help="Flow area. Default: 0.05.", rich_help_panel=STUDY)

    def inputs(self) -> dict[str, float]:
        """Return the inputs that were given, by their names."""
        return {name: value for name, value in vars(self).items() if value is not None}


class SweepOutputs(Outputs):
    """Outputs of a sweep."""

    picture = "lines over one parameter, or contours over two"
    charted = "two columns over one parameter"
    has_units = True

    def check_drawn(self, sweep: Sweep) -> None:
        """Check that a picture or a chart can show the rows.

        Args:
            sweep: what is asked for.

        Raises:
            UsageError: it cannot.
        """
        option, most = ("--chart", 1) if self.chart else ("--plot", 2)
        if not (self.plot or self.chart):
            return
        if sweep.profiles or sweep.top:
            raise UsageError(f"{option} shows all designs: remove --points, --stations or --top")
        varied = [parameter.name for parameter in sweep.parameters if len(parameter.values) > 1]
        if not varied or (len(varied) > most and not sweep.parallel):
            raise UsageError(
                f"{option} needs {'one parameter' if most == 1 else 'one or two parameters'} of several values,"
                f" not {len(varied)}"
            )
        if sweep.count > MOST_DRAWN:
            raise UsageError(f"{option} shows at most {MOST_DRAWN:,} designs, not {sweep.count:,}")
