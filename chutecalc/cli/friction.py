"""``chutecalc sweep beta`` without a spec: the paper's friction study."""

from collections.abc import Sequence
from contextlib import ExitStack

from chutecalc.errors import ExitStatus
from chutecalc.studies.friction.study import AREA, BASE, CHAMFERS, INTERNAL_FRICTIONS, WALL_FRICTION


def run_friction_study(
    beta: Sequence[float] = CHAMFERS,
    delta: Sequence[float] = INTERNAL_FRICTIONS,
    keep: str = "base",
    phi: float = WALL_FRICTION,
    base: float = BASE,
    area: float = AREA,
    csv: str | None = None,
    json: str | None = None,
    plot: str | None = None,
    units: str = "metric",
) -> int:
    """Works out the study, prints it, and writes the files asked for.

    Args:
        beta, delta: chamfer angles and angles of internal friction, deg.
        keep: ``base``, ``width`` or ``depth``.
        phi: wall friction angle, deg.
        base: width between square corners, m.
        area: flow area, m².
        csv, json, plot: files to write; ``-`` is standard output, for one of the first two.
        units: of what is printed and drawn, ``metric`` or ``us``.

    Returns:
        The exit status.

    Raises:
        UsageError: a value out of its range, or outputs that do not fit together.
        OutputError: a file that cannot be opened.
        ExtraMissingError: a picture is asked for without Matplotlib.
    """
    from chutecalc.output.files import check_targets, open_whole
    from chutecalc.studies.friction.study import FrictionStudy

    check_targets([csv, json, plot], [])
    if plot:
        from chutecalc.output.plots.save import picture_format

        picture_format(plot)
    with ExitStack() as outputs:
        csv_stream = outputs.enter_context(open_whole(csv))
        json_stream = outputs.enter_context(open_whole(json))
        plot_stream = outputs.enter_context(open_whole(plot, "wb"))
        study = FrictionStudy(beta, delta, keep, phi, base, area)
        if csv_stream:
            from chutecalc.studies.friction.report import write_study_csv

            write_study_csv(csv_stream, study)
        if json_stream:
            from chutecalc.studies.friction.report import write_study_json

            write_study_json(json_stream, study)
        if plot and plot_stream:
            from chutecalc.output.plots.save import save
            from chutecalc.studies.friction.plot import draw_study

            save(draw_study(study, units), plot_stream, picture_format(plot))
    if "-" not in (csv, json):
        from chutecalc.output.table import Printer
        from chutecalc.studies.friction.report import print_study

        print_study(Printer(units), study)
    return ExitStatus.OK
