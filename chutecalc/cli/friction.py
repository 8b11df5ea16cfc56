"""``chutecalc sweep beta`` without a spec: the friction study of the paper."""

from typing import Any

from chutecalc.cli.outputs import Outputs
from chutecalc.errors import ExitStatus

ARGUMENTS = {
    "beta": "chamfer_deg",
    "delta": "internal_friction_deg",
    "keep": "keep",
    "phi": "wall_friction_deg",
    "base": "base_m",
    "area": "area_m2",
}
"""Arguments of :class:`chutecalc.studies.friction.study.FrictionStudy`, by the names of parameters and options."""


def run_friction_study(outputs: Outputs, **inputs: Any) -> int:
    """Compute the study, print it, and write the files asked for.

    Args:
        outputs: files, and the units of what is printed and drawn.
        **inputs: arguments of the study by the keys of ``ARGUMENTS``; those left out have its defaults.

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
    study = FrictionStudy(**{ARGUMENTS[name]: value for name, value in inputs.items()})
    outputs.write(study_dataset(study))
    if outputs.plot:
        from chutecalc.studies.friction.plot import draw_study

        outputs.draw(draw_study(study, outputs.units))
    if not outputs.to_standard_output:
        from chutecalc.output.printer import Printer

        print_study(Printer(outputs.units), study)
    return ExitStatus.OK
