"""Input of LAMMPS: the particles, and the script that pours them, waits for rest and writes the forces of the walls."""

import math

from chutecalc.dem.case import DENSITY, GRAVITY, POURS, Case
from chutecalc.physics.arrays import Array

PARTICLES, SCRIPT, LOG, BED, WALLS = "particles.data", "in.lammps", "log.lammps", "bed.dump", "walls.txt"
"""The files of a case. ``walls.txt`` is written last: a case that has it is complete."""
RESTING = 1e-9
"""Kinetic energy of a particle over m g d at which a run ends: a hundredth of the limit of the check ``rest``."""
SETTLING = 4.0
"""Longest time for a bed to come to rest, s under 1 g."""
CALMING = 0.3
"""Terminal speed of the drag that brings a poured bed to rest, m/s."""
RAISING = 0.1
"""Time in which the body force is raised, s."""


def particles_text(case: Case, positions: Array) -> str:
    """Write the particles as a data file of LAMMPS.

    Args:
        case: The case, which gives their size and the bounds.
        positions: Centres, m, shape (particles, 3), from :func:`chutecalc.dem.pour.column`.

    Returns:
        The text of ``particles.data``.

    >>> from chutecalc.dem.pour import column
    >>> case = Case(base=0.2, lengths=(), inclinations=(), area=0.01, friction=0.75, pour="rain", seed=1)
    >>> particles_text(case, column(case)).splitlines()[2:4]
    ['449 atoms', '1 atom types']
    """
    d = case.diameter
    far = 0.5 * float(case.trough.wetting(2.0 * case.area).width[0]) + 2.0 * d
    rows = "\n".join(f"{n} 1 {d:g} {DENSITY:g} {x:.9g} {y:.9g} {z:.9g}" for n, (x, y, z) in enumerate(positions, 1))
    return (
        f"particles before the pour, SI\n\n{len(positions)} atoms\n1 atom types\n"
        f"{-far:.9g} {far:.9g} xlo xhi\n0 {case.slice:.9g} ylo yhi\n{-d:.9g} {positions[-1, 2] + 5 * d:.9g} zlo zhi\n\n"
        f"Atoms # sphere\n\n{rows}\n"
    )


def script_text(case: Case, top: float) -> str:
    """Write the input script of a case.

    Contacts are ``gran/hooke/history``; walls have no friction; particles do not rotate.

    Args:
        case: The case.
        top: Height of the highest particle, m, which sets how long the pour lasts.

    Returns:
        The text of ``in.lammps``.

    >>> case = Case(base=0.2, lengths=(), inclinations=(), area=0.01, friction=0.75, pour="rain", seed=1)
    >>> [line for line in script_text(case, top=0.5).splitlines() if line.startswith("region wall0")]
    ['region wall0 plane 0 0 0 0 0 1']
    """
    d, mass, step = case.diameter, case.mass, case.time_step
    contact = f"{case.stiffness:.9g} NULL {{damping:.9g}} NULL {{friction:g}} 1 limit_damping"
    between = contact.format(damping=case.damping(0.5 * mass), friction=case.friction)
    on_wall = contact.format(damping=case.damping(mass), friction=0.0)
    planes = [
        f"region wall{n} plane {wall.foot[0]:.9g} 0 {wall.foot[1]:.9g} {wall.normal[0]:.15g} 0 {wall.normal[1]:.15g}\n"
        f"fix wall{n} all wall/gran/region hooke/history {on_wall} region wall{n} contacts\n"
        f"compute across{n} all reduce sum f_wall{n}[2]\n"
        f"compute up{n} all reduce sum f_wall{n}[4]"
        for n, wall in enumerate(case.trough.walls)
    ]
    sums = [f"c_{axis}{n}" for n in range(len(planes)) for axis in ("across", "up")]
    speed = POURS[case.pour].speed
    poured = GRAVITY * case.body_force
    falling = math.isfinite(speed)
    drag = f"fix drag all viscous {mass * poured / speed:.9g}\nvelocity all set 0 0 {-speed:g}" if falling else ""
    lasts = top / speed if falling else math.sqrt(2.0 * top / poured)
    lines = [
        "# A bed of spheres in a trough without wall friction; SI. Written by chutecalc.",
        "units si",
        "newton off",
        "atom_style sphere",
        "boundary f p f",
        "comm_modify vel yes",
        f"read_data {PARTICLES}",
        f"neighbor {0.3 * d:g} bin",
        "neigh_modify delay 0",
        f"pair_style gran/hooke/history {between}",
        "pair_coeff * *",
        f"timestep {step:.9g}",
        "# the walls, each with its force on the particles",
        *planes,
        "# nve, not nve/sphere: the particles do not rotate",
        "fix move all nve",
        f"variable motion equal ke/{case.count}",
        "thermo 2000",
        f"thermo_style custom step atoms ke v_motion {' '.join(sums)}",
        "# pour",
        f"fix weight all gravity {poured:.9g} vector 0 0 -1",
        drag,
        f"run {math.ceil(lasts / step)}",
        "# rest",
        *_rest(case, poured),
    ]
    if case.raised_to:
        lines += [
            "# raise the body force",
            f"variable pull equal ramp({poured:.9g},{case.acceleration:.9g})",
            "fix weight all gravity v_pull vector 0 0 -1",
            f"run {math.ceil(RAISING / step)}",
            f"fix weight all gravity {case.acceleration:.9g} vector 0 0 -1",
            *_rest(case, case.acceleration),
        ]
    printed = " ".join(f"$({name}:%.15g)" for name in ("v_motion", *sums))
    lines += [
        "run 0",
        f"write_dump all custom {BED} id x y z modify sort id format float %.9g",
        f'print "{printed}" file {WALLS}',
    ]
    return "\n".join(line for line in lines if line) + "\n"


def _rest(case: Case, acceleration: float) -> list[str]:
    """Return the commands that bring the bed to rest by drag, for a limited time."""
    resting = RESTING * case.mass * acceleration * case.diameter
    return [
        f"fix drag all viscous {case.mass * acceleration / CALMING:.9g}",
        f"fix rest all halt 100 v_motion < {resting:.9g} error continue message no",
        f"run {math.ceil(SETTLING * math.sqrt(GRAVITY / acceleration) / case.time_step)}",
        "unfix rest",
    ]
