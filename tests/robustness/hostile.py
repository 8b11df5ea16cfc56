"""Hostile specs and command lines: a grammar of what people, programs and attackers may give."""

from functools import cache

from hypothesis import strategies as st

import chutecalc
from tests.conftest import ROOT

FORGED = "42 designs: 42 ok"
"""What some texts would add as a line of their own."""
WORDS = (
    "",
    "coal",
    "石炭 – الفحم",
    "cost $5% or $6",
    "$\\frac{1}{$",
    "a^b_c{}",
    "\x1b]0;x\x07",
    f"x\n{FORGED}",
    "\x9b31m",
    "\u202ereversed",
    "\ufeff\ufffe\x00",
    "=cmd()",
    "+1+cmd|' /C calc'!A0",
    "@SUM(1)",
    "\tx",
    "</text><script>alert(1)</script>",
    "]]>&amp;&",
    "{{ 7 * 7 }}{% raw %}",
    "%%d ^J",
    "../../etc/passwd",
    "`id`; $(id)",
    "x" * 3000,
    "\U0001f469\u200d\U0001f52c",
    "'''\"\"\"",
)
"""Text that means something to a terminal, a spreadsheet, a browser, a drawing or a shell."""
NUMBERS = (
    *("0", "-0.0", "1", "-3", "0.5", "45", "90", "89.99999999", "1000", "nan", "-inf", "inf"),
    *("1e308", "-1e308", "1e-308", "5e-324", "1e-5", "1e9", "9" * 40, "9" * 41, "1" + "0" * 5000, "0." + "3" * 30),
    *("0.3", "2", "5", "20", "30", "60", "600"),
    *("1,5", "1'000", "1 000", "3 m", "30°", "0x1F", "1e", "1979-05-27", "--1", "５"),
)
KEYS = (
    *("é", "a b", "é.b"),
    *("title", "name", "kind", "shape", "use", "source", "liner", "section", "radius_m", "radius_mm", "slope_deg"),
    *(
        "drop_m",
        "velocity_m_s",
        "rate_t_h",
        "at_m",
        "onto_next",
        "to_slope_deg",
        "length_m",
        "friction_deg",
        "é",
        "a b",
    ),
    *(f'"x\\n{FORGED}"', '"\\u001b[2J"', '"=a"', '""', '"flow.rate_t_h"', "a" * 300, ".".join("a" * 80), "a.b.c"),
)
HEADERS = (
    *("[flow]", "[[segments]]", "[segments]", "[cases.wet]", "[uncertainty]", "[receiver]", "[inlet.belt]", "[limits]"),
    *("[liners.steel]", "[sections.body]", "[model]", "[project]", "[[", "[ ]", "[é]", "[a.b.c.d]", "[flow", "{", "]"),
)
LINES = (
    *("", "= 1", "key", "key = ", "- item", "// comment", "<<<<<<< HEAD", "a: 1", "```", "]]", "}", '"', "'''", '"""'),
    *(
        "a = [[[[[[1]]]]]]",
        "a = " + "[" * 60,
        "a = {b = {c = 1}}",
        "[\n[" + " " * 2400,
        "a = " + "{b=" * 60,
        "a." * 3000,
    ),
    *('cases.wet."flow.rate_t_h" = 1e5', 'uncertainty."flow.rate_t_h" = 5', "\x00", "a = 1 # \x1b[2J", "a = '\x1b[2J'"),
)
PATHS = (
    *("segments." + "9" * 5000 + ".x", "segments.1", "flow"),
    *(
        "flow.rate_t_h",
        "segments.1.drop_m",
        "segments.spoon.radius_m",
        "segments.99.x",
        "segments." + "9" * 5000 + ".x",
    ),
    *("title", "material.name", "sections.body.chamfer_deg", "model.steel", "", ".", "a" * 500, ".".join("b" * 2000)),
    *("inlet.belt.velocity_m_s", "limits.max_velocity_m_s", "segments", "cases.wet", f"x\n{FORGED}", "\x1b[2J"),
)

word, number = st.sampled_from(WORDS), st.sampled_from(NUMBERS)


def _quoted(text: str) -> str:
    """Return text as TOML has it in double quotes."""
    plain = text.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + "".join(each if each.isprintable() else f"\\u{ord(each):04X}" for each in plain) + '"'


value = st.one_of(
    number,
    word.map(_quoted),
    word.map(lambda text: f"'{text}'"),
    st.sampled_from(["true", "false", "[]", "{}", "[1, 2]", "[[0, 1], [5, 4]]", "{plus_minus = 3}", "none", "-", "~5"]),
    st.floats().map(str),
    st.text(max_size=12),
)


@cache
def seeds() -> list[str]:
    """Return texts to begin with: the starter, and standard designs."""
    names = ("belt_hood_spoon", "rock_box", "placed_by_stream", "transfer_90")  # with a belt, cases, uncertainty
    return [chutecalc.STARTER, *((ROOT / "specs" / f"{name}.toml").read_text(encoding="utf-8") for name in names)]


@st.composite
def spec_texts(draw: st.DrawFn) -> str:
    """Draw the text of a spec: one that is right, with some of its lines changed."""
    lines = draw(st.sampled_from(seeds())).split("\n")
    for _ in range(draw(st.sampled_from((0, 0, 0, 1, 1, 1, 2, 3)))):
        at = draw(st.integers(0, len(lines) - 1))
        key, equals, _ = lines[at].partition(" = ")
        change = draw(st.sampled_from(("value", "value", "value", "key", "line", "header", "delete", "double", "cut")))
        if change == "value":
            lines[at] = f"{key if equals else draw(st.sampled_from(KEYS))} = {draw(value)}"
        elif change == "key":
            lines[at] = f"{draw(st.sampled_from(KEYS))} = {draw(value)}"
        elif change == "line":
            lines.insert(at, draw(st.one_of(st.sampled_from(LINES), st.text(max_size=30))))
        elif change == "header":
            lines.insert(at, draw(st.sampled_from(HEADERS)))
        elif change == "delete":
            del lines[at : at + draw(st.integers(1, 3))]
        elif change == "double":
            lines.insert(at, lines[at])
        else:
            text = "\n".join(lines)
            begin = draw(st.integers(0, len(text)))
            lines = (text[:begin] + text[begin + draw(st.integers(0, 40)) :]).split("\n")
        lines = lines or [""]
    return "\n".join(lines)


def _as_bytes(drawn: tuple[str, str]) -> bytes:
    """Return a text in some encoding, right or wrong."""
    text, way = drawn
    if way == "crlf":
        return text.replace("\n", "\r\n").encode()
    if way == "byte":
        return text.encode()[:200] + b"\xff" + text.encode()[200:]
    return text.encode(way)


encodings = st.sampled_from(("utf-8",) * 12 + ("utf-8-sig", "utf-16", "crlf", "byte"))
texts = st.integers(0, 19).flatmap(lambda k: spec_texts() if k else st.text(max_size=200))
contents = st.tuples(texts, encodings).map(_as_bytes)
"""Contents of spec files."""
