"""``chutecalc sweep beta`` without a spec: the friction study of the paper."""

from collections.abc import Iterable
from typing import Any

from chutecalc.cli.outputs import Outputs
from chutecalc.errors import ExitStatus, UsageError

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


def read_angles(arguments: Iterable[str]) -> dict[str, Any]:
    """Return the angles of the study that arguments of a command give, in degrees, by their short names.

    Args:
        arguments: such as ``beta`` or ``delta=30,40``.

    Raises:
        UsageError: another parameter, or one twice.

    >>> read_angles(["delta=30,40"])
    {'delta': [30.0, 40.0]}
    """
    from chutecalc.studies.friction.study import ANGLE_RANGES
    from chutecalc.studies.sweep.parameters import split_argument

    angles: dict[str, Any] = {}
    for argument in arguments:
        name = argument.partition("=")[0].strip()
        if name not in ANGLE_RANGES:
            raise UsageError(f"{argument}: without a spec only beta and delta can vary. Add a spec (.toml)")
        if name in angles:
            raise UsageError(f"{name} is given twice: remove one of them")
        angles[name] = split_argument(argument, ANGLE_RANGES)[1].tolist()
    return angles
