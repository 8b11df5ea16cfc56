"""``chutecalc sweep beta`` without a spec: the friction study of the paper."""

from collections.abc import Sequence

from chutecalc.cli.outputs import Outputs
from chutecalc.errors import ExitStatus
from chutecalc.studies.friction.study import AREA, BASE, CHAMFERS, INTERNAL_FRICTIONS, WALL_FRICTION


def run_friction_study(
    outputs: Outputs,
    beta: Sequence[float] = CHAMFERS,
    delta: Sequence[float] = INTERNAL_FRICTIONS,
    keep: str = "base",
    phi: float = WALL_FRICTION,
    base: float = BASE,
    area: float = AREA,
) -> int:
    """Compute the study, print it, and write the files asked for.

    Args:
        outputs: files, and the units of what is printed and drawn.
        beta: chamfer angles, deg.
        delta: effective angles of internal friction, deg.
        keep: what stays constant while the chamfer angle varies: ``base``, ``width`` or ``depth``.
        phi: wall friction angle, deg.
        base: width between square corners, m.
        area: flow area, m².

    Returns:
        The exit status.

    Raises:
        UsageError: a value is out of its range, or outputs do not fit together.
        OutputError: a file cannot be opened.
        ExtraMissingError: an optional library is not installed.
    """
    from chutecalc.studies.friction.report import print_study, study_dataset
    from chutecalc.studies.friction.study import FrictionStudy

    outputs.check()
    study = FrictionStudy(beta, delta, keep, phi, base, area)
    outputs.write(study_dataset(study))
    if outputs.plot:
        from chutecalc.studies.friction.plot import draw_study

        outputs.draw(draw_study(study, outputs.units))
    if not outputs.to_standard_output:
        from chutecalc.output.table import Printer

        print_study(Printer(outputs.units), study)
    return ExitStatus.OK
