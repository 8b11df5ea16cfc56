"""A chute as a drawing for CAD: its steel in true arcs and lines, its stream, belts, sections and dimensions."""

from chutecalc.errors import UsageError
from chutecalc.extras import DXF, require_extra


def check_drawing(file: str) -> None:
    """Check that a drawing can be made, and that the ending of its file says what it is.

    Args:
        file: path of the drawing.

    Raises:
        UsageError: the ending is another.
        ExtraMissingError: ezdxf is not installed.
    """
    if not file.lower().endswith(".dxf"):
        raise UsageError(f"--dxf cannot draw {file}: the name must end in .dxf")
    require_extra("--dxf", DXF)
