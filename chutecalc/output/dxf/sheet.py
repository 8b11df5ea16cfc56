"""The drawing that everything is put on: millimetres, x to the right and heights upwards, from the spec's origin."""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from ezdxf.colors import BYLAYER
from ezdxf.document import Drawing
from ezdxf.enums import TextEntityAlignment as Align
from ezdxf.filemanagement import new
from ezdxf.units import MM

from chutecalc.output.dxf.layers import LAYERS, LINETYPES, TEXT, Layer
from chutecalc.output.dxf.points import PER_METRE, Point, place
from chutecalc.output.dxf.room import Room
from chutecalc.output.plots.flights import Line
from chutecalc.physics.arrays import Mask
from chutecalc.physics.surface import Surface, centre
from chutecalc.printable import printable

VERSION = "R2010"
"""Oldest AutoCAD that reads the drawing."""
FONT = "arial.ttf"
SMALL, NORMAL, LARGE = 2.5, 3.5, 5.0
"""Heights of text, mm on paper."""
STYLE = "CHUTE"
"""Name of the styles of text and of dimensions."""
IN_CIRCLE = 360.0
WIDE = 0.8
"""Width of a letter over its height, at most."""


class Sheet:
    """A drawing of a scale: the steel is true to size, text and arrows are as large as they are on paper."""

    def __init__(self, scale: float) -> None:
        """Begin a drawing.

        Args:
            scale: drawing units in a millimetre on paper, 25 for 1:25.
        """
        self.scale = scale
        self.document: Drawing = new(VERSION, units=MM)
        self.document.ezdxf_metadata()["CREATED_BY_EZDXF"] = "chutecalc"  # instead of the date
        self.space = self.document.modelspace()
        self.room = Room(scale)
        header = self.document.header
        header["$MEASUREMENT"], header["$LTSCALE"], header["$DIMSCALE"] = 1, scale, scale
        header["$LWDISPLAY"] = 1
        for name, (meaning, pattern) in LINETYPES.items():
            self.document.linetypes.add(name, [sum(map(abs, pattern)), *pattern], description=meaning)
        self.document.styles.add(STYLE, font=FONT)
        self._dimension_style()
        for layer in LAYERS:
            self.add_layer(layer)

    def _dimension_style(self) -> None:
        """Add the style of dimensions: a decimal at most, text above the line."""
        style: Any = self.document.dimstyles.new(STYLE)
        numbers = {
            "dimtxt": SMALL,
            "dimasz": SMALL,
            "dimexe": 1.25,
            "dimexo": 1.0,
            "dimgap": 0.8,
        }
        decimals = {"dimdec": 1, "dimadec": 1, "dimzin": 8, "dimazin": 2, "dimdsep": ord("."), "dimlunit": 2}
        places = {"dimtad": 1, "dimtih": 0, "dimtoh": 0, "dimtmove": 1, "dimcen": 0.0, "dimtofl": 0}
        colours = dict.fromkeys(("dimclrd", "dimclre", "dimclrt"), BYLAYER)
        style.update_dxf_attribs(
            {**numbers, **decimals, **places, **colours, "dimtxsty": STYLE, "dimscale": self.scale}
        )

    def add_layer(self, layer: Layer) -> None:
        """Add a layer.

        Args:
            layer: as it is to be drawn.
        """
        added = self.document.layers.add(
            layer.name, color=layer.colour, linetype=layer.linetype, lineweight=layer.weight
        )
        added.description = layer.holds
        if not layer.shown:
            added.freeze()

    def paper(self, length: float) -> float:
        """Return the drawing units of a length on paper.

        Args:
            length: mm on paper.
        """
        return length * self.scale

    def surface(self, surface: Surface, layer: Layer) -> None:
        """Draw a surface of one design as what it is, a line or an arc.

        Args:
            surface: the surface.
            layer: on which it goes.
        """
        ends = place(surface, 0.0), place(surface, 1.0)
        if surface.turn[0] == 0.0:
            self.line(*ends, layer)
            return
        x, z, radius = (float(each[0]) * PER_METRE for each in centre(surface))
        first, last = (float(np.degrees(np.arctan2(end[1] - z, end[0] - x))) for end in ends)
        counterclockwise = surface.turn[0] < 0.0
        angles = (first, last) if counterclockwise else (last, first)
        if radius > 0.0:
            start, end = (angle % IN_CIRCLE for angle in angles)
            self.space.add_arc((x, z), radius, start, end, dxfattribs={"layer": layer.name})

    def line(self, first: Point, last: Point, layer: Layer) -> None:
        """Draw a line.

        Args:
            first, last: its ends, mm.
            layer: on which it goes.
        """
        self.space.add_line(first, last, dxfattribs={"layer": layer.name})

    def lines(self, path: Line, layer: Layer) -> None:
        """Draw a path as polylines, each as long as the path is known.

        Args:
            path: x and z, m, shape (2, points); NaN where it is not known.
            layer: on which it goes.
        """
        known: Mask = np.all(np.isfinite(path), axis=0)
        for piece in np.split(np.arange(known.size), np.flatnonzero(np.diff(known)) + 1):
            if known[piece[0]] and len(piece) > 1 and np.ptp(path[:, piece], axis=1).any():
                self.polyline([(x, z, 0.0) for x, z in (path[:, piece] * PER_METRE).T.tolist()], layer)

    def polyline(
        self,
        points: Iterable[Sequence[float]],
        layer: Layer,
        closed: bool = False,
        linetype: str = "BYLAYER",
    ) -> None:
        """Draw a polyline.

        Args:
            points: x, y and bulge, which is the tangent of a quarter of the angle of an arc; mm and dimensionless.
            layer: on which it goes.
            closed: whether it ends where it begins.
            linetype: other than that of the layer.
        """
        look = {"layer": layer.name, "linetype": linetype}
        self.space.add_lwpolyline(points, format="xyb", close=closed, dxfattribs=look)

    def text(
        self, words: str, at: Point, height: float = SMALL, align: Align = Align.LEFT, layer: Layer = TEXT
    ) -> None:
        """Write a line of text.

        Args:
            words: any text.
            at: where, mm.
            height: mm on paper.
            align: which point of the text is there.
            layer: on which it goes.
        """
        look = {"layer": layer.name, "style": STYLE}
        written = self.space.add_text(plain(words), height=self.paper(height), dxfattribs=look)
        written.set_placement(at, align=align)

    def note(self, words: str, at: Point, towards: Point, height: float = SMALL) -> None:
        """Write a line of text beside a point, clear of what is there.

        Args:
            words: any text.
            at: the point, mm.
            towards: direction from the point in which it is to stand, of any length; it turns where there is no room.
            height: mm on paper.
        """
        half = 0.5 * WIDE * self.paper(height) * len(words), 0.6 * self.paper(height)
        self.text(words, self.room.take(at, towards, half), height, Align.MIDDLE_CENTER)


def plain(words: str) -> str:
    r"""Return text in one line as a drawing holds it, in which no letter commands anything.

    Args:
        words: any text.

    >>> plain("50 %%d\n2^3")
    '50 %%%%%%d 2^ 3'
    """
    line = printable(words.replace("\n", " "))
    return line.replace("^", "^ ").replace("%%", "%%%%%%")
