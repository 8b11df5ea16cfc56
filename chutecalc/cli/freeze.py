"""``chutecalc freeze``: write a spec with every place and slope of its steel explicit."""

import typer

from chutecalc.cli.options import LIBRARY
from chutecalc.output.files import open_whole
from chutecalc.output.held import reserve
from chutecalc.output.targets import STANDARD_STREAM, check_targets

EXAMPLES = ("chutecalc freeze chute.toml -o frozen.toml", "chutecalc freeze chute.toml")
PAGE = "spec.md#steel"


def freeze(
    spec: str = typer.Argument(..., metavar="SPEC", help="TOML file; - for standard input."),
    output: str = typer.Option(STANDARD_STREAM, "--output", "-o", metavar="FILE", help="File to write. Default: -."),
    library: str | None = LIBRARY,
) -> int:
    """Write a spec in which the steel no longer depends on the stream.

    What the stream places, start_m after a fall and from_slope_deg of a curve, is written as it is drawn at the design
    point. Comments and line ends stay. The chute remains the same; from then on, edits of the flow leave its steel
    where it is.
    """
    from chutecalc.api.freeze import freeze as frozen
    from chutecalc.cli.specs import read_with_content
    from chutecalc.spec.parse import encode

    check_targets({"--output": output}, [spec, library])
    reserve(output)
    chute, content = read_with_content(spec, library=library)
    frozen_content = encode(frozen(chute), like=content)
    with open_whole(output, "wb") as stream:
        stream.write(frozen_content)
    return 0
