"""Groups of options of ``chutecalc dem``."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING

import typer

from chutecalc.cli.options import DASK, JOBS, OptionGroup
from chutecalc.errors import UsageError

if TYPE_CHECKING:
    from chutecalc.cli.outputs import Outputs
    from chutecalc.dem.request import PourPlan


@dataclass(frozen=True, eq=False)
class TroughOptions(OptionGroup):
    """Troughs, where no spec has them."""

    beta: str | None = typer.Option(None, metavar="DEG", help="Chamfer angles, such as 30,45. Default: 15:90:15.")
    base: float | None = typer.Option(
        None, min=0, max=100, metavar="M", help="Width of the floor, 0 for a vee. Default: 0.5."
    )
    chamfer: float | None = typer.Option(None, min=1e-3, metavar="M", help="Length of a chamfer. Default: no end.")
    area: str | None = typer.Option(
        None, metavar="M2", help="Flow areas of the beds, m², separated by commas. Default: 0.05."
    )
    delta: float | None = typer.Option(None, min=0, max=89, metavar="DEG", help="Compare with this δ too.")

    @property
    def given(self) -> bool:
        """Whether there is any."""
        return any(value is not None for value in vars(self).values())


@dataclass(frozen=True, eq=False)
class PourOptions(OptionGroup):
    """Particles, and how they are poured."""

    particle_friction: str = typer.Option("0.75,0.9", metavar="LIST", help="Friction coefficients between particles.")
    pour: str = typer.Option("rain", metavar="LIST", help="gentle (0.3 m/s), rain (1 m/s), freefall; or all.")
    seeds: int = typer.Option(1, min=1, max=100, metavar="N", help="Number of beds of each kind, for the scatter.")
    body_force: str = typer.Option("1", metavar="G", help="Body forces while pouring, in g.")
    raise_to: float = typer.Option(
        0.0, min=0, max=100, metavar="G", help="After the bed is at rest, raise the body force to this, in g."
    )
    diameter: float = typer.Option(0.01, min=1e-4, max=1, metavar="M", help="Diameter of the particles.")
    slice_: float = typer.Option(0.05, "--slice", min=1e-3, max=10, metavar="M", help="Length of the periodic trough.")

    def read(self) -> PourPlan:
        """Return the numbers that the options list."""
        from chutecalc.dem.request import PourPlan, numbers, pours

        frictions = numbers(self.particle_friction, "--particle-friction", 0.0, 10.0)
        forces = numbers(self.body_force, "--body-force", 0.01, 100.0)
        return PourPlan(
            frictions=frictions,
            pours=pours(self.pour),
            seeds=self.seeds,
            body_forces=forces,
            raised_to=self.raise_to,
            diameter=self.diameter,
            slice=self.slice_,
        )


@dataclass(frozen=True, eq=False)
class CaseOptions(OptionGroup):
    """Folders of cases."""

    cases: str = typer.Option("dem-cases", metavar="DIR", help="Folder of the cases. A second call continues there.")
    write: str | None = typer.Option(None, metavar="DIR", help="Only write the next cases, to run on a cluster.")
    read: str | None = typer.Option(None, metavar="DIR", help="Only report the cases that were run there.")

    def check(self, outputs: Outputs) -> None:
        """Check that the options fit together.

        Args:
            outputs: the other outputs of the command.

        Raises:
            UsageError: they do not.
        """
        if self.write is not None and self.read is not None:
            raise UsageError("--write and --read are two steps: give --write first, then --read in a second call")
        if self.write is not None and (outputs.files or outputs.plot):
            raise UsageError("--write runs nothing, so there are no results to write: remove the other outputs")
        for option, folder in (("--write", self.write), ("--cases", self.cases)):
            if folder is not None and os.path.lexists(folder) and not os.path.isdir(folder):
                raise UsageError(f"{option} {folder}: is no folder, and the cases need one. Give another name")
        if self.read is not None and not os.path.isdir(self.read):
            raise UsageError(f"--read {self.read}: no such folder. Give the one that --write or --cases named")

    @property
    def folder(self) -> str:
        """The folder to use."""
        return self.write or self.read or self.cases


@dataclass(frozen=True, eq=False)
class EngineOptions(OptionGroup):
    """How LAMMPS runs."""

    jobs: int | None = JOBS
    dask: str | None = DASK
    mpi: int = typer.Option(1, min=1, max=10_000, metavar="N", help="Processes of each case, through mpirun.")
    lmp: str = typer.Option("lmp", metavar="PROGRAM", help="Executable of LAMMPS.")
