"""Letters of pictures: fonts that have them, and what stands in place of those that do not print."""

from functools import cache

from matplotlib import font_manager
from matplotlib.figure import Figure
from matplotlib.text import Text

from chutecalc.printable import printable

WIDE_FONTS = {
    *(f"Noto Sans {script}" for script in ("Arabic", "CJK JP", "CJK KR", "CJK SC", "CJK TC", "Devanagari", "Thai")),
    *("Droid Sans Fallback", "Source Han Sans SC", "WenQuanYi Micro Hei", "WenQuanYi Zen Hei"),
    *("Malgun Gothic", "Microsoft JhengHei", "Microsoft YaHei", "Nirmala UI", "SimHei", "Yu Gothic"),
    *("Arial Unicode MS", "Hiragino Sans", "PingFang SC"),
}
"""Fonts of Linux, Windows and macOS for scripts that the default font lacks."""


@cache
def wide_fonts() -> list[str]:
    """Return the fonts of this computer that have letters which the default one lacks."""
    return sorted(WIDE_FONTS & set(font_manager.fontManager.get_font_names()))


def make_printable(figure: Figure) -> None:
    """Put escape sequences in place of what does not print in the text of a figure.

    Args:
        figure: the figure.
    """
    for text in figure.findobj(Text):
        assert isinstance(text, Text)
        text.set_text(printable(text.get_text(), keep="\n"))
