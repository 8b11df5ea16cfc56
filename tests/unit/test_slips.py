"""Slips that people make in a spec: each message says what, where, and what to write instead."""

import pytest

import chutecalc
from chutecalc.cli.specs import read_setting
from chutecalc.errors import UsageError

SPOON = """\
title = "Spoon"

[material]
density_kg_m3 = 800
internal_friction_deg = 55

[flow]
rate_t_h = 1000

[liners.wall]
friction_deg = 25

[sections.body]
shape = "rectangular"
width_m = 0.9

[inlet]
velocity_m_s = 0
slope_deg = 90

[[segments]]
kind = "fall"
drop_m = 2.0

[[segments]]
name = "spoon"
kind = "curve"
radius_m = 3
to_slope_deg = 0
"""
RADIUS, KIND, RATE, SLOPE, TITLE = "radius_m = 3", 'kind = "curve"', "rate_t_h = 1000", "to_slope_deg = 0", '"Spoon"'
FRICTION, FALL, SECOND = "friction_deg = 25\n", '[[segments]]\nkind = "fall"', "[[segments]]\nname"
NO_KEY = "keys have letters a to z, digits, - and _. "
NOT_ONE = "must be one number. Write one number; how uncertain it is goes into [uncertainty]."
ALONE = "must be a number alone: its unit is in the name of the key. "
SMALL = "is not a key of this table: keys are in small letters. "
SLIPS = [  # what is written, what stands there instead, and how the message goes on after the name of the file
    # numbers
    (
        RADIUS,
        "radius_m = 2,0",
        "28: segments.2.radius_m = 2,0 is not a number: the decimal mark is a point. Write radius_m = 2.0.",
    ),
    (
        "width_m = 0.9",
        "width_m = 0,9  # wide",
        "15: sections.body.width_m = 0,9 is not a number: the decimal mark is a point. Write width_m = 0.9.",
    ),
    (
        "velocity_m_s = 0\n",
        "velocity_m_s = 0\nat_m = 3.0, -4.0\n",
        "19: inlet.at_m = 3.0, -4.0 is several numbers, which must be in brackets. Write at_m = [3.0, -4.0].",
    ),
    (
        "velocity_m_s = 0\n",
        "velocity_m_s = 0\nat_m = 0,2; -0,6\n",
        "19: inlet.at_m = 0,2; -0,6 is several numbers, which must be in brackets, with decimal points."
        " Write at_m = [0.2, -0.6].",
    ),
    (RATE, "rate_t_h = 1'000", "8: flow.rate_t_h = 1'000 is not a number as TOML writes it. Write rate_t_h = 1000."),
    (RATE, "rate_t_h = 1 000", "8: flow.rate_t_h = 1 000 is not a number as TOML writes it. Write rate_t_h = 1000."),
    (
        RATE,
        "rate_t_h = 1,000",
        "a comma is no part of one. Write rate_t_h = 1000, or with a decimal point 1.000.",
    ),
    (
        RATE,
        "rate_t_h = 1,000.5",
        "8: flow.rate_t_h = 1,000.5 is not a number as TOML writes it. Write rate_t_h = 1000.5.",
    ),
    (
        RATE,
        "rate_t_h = 1.000,5",
        "8: flow.rate_t_h = 1.000,5 is not a number as TOML writes it. Write rate_t_h = 1000.5.",
    ),
    (
        RATE,
        "rate_t_h = 1.000.000",
        "8: flow.rate_t_h = 1.000.000 is not a number as TOML writes it. Write rate_t_h = 1000000.",
    ),
    (
        SLOPE,
        "to_slope_deg = \N{MINUS SIGN}10",
        "29: segments.2.to_slope_deg = \N{MINUS SIGN}10 has a dash that is not a minus sign. Write to_slope_deg = -10.",
    ),
    (SLOPE, "to_slope_deg = \N{EN DASH}10", "Write to_slope_deg = -10."),
    (SLOPE, "to_slope_deg = 45°", f"29: segments.2.to_slope_deg = 45° {ALONE}Write to_slope_deg = 45."),
    (SLOPE, "to_slope_deg = 45 deg", f"{ALONE}Write to_slope_deg = 45."),
    (RADIUS, "radius_m = 3 m", f"28: segments.2.radius_m = 3 m {ALONE}Write radius_m = 3."),
    (RADIUS, "radius_m = 3.5m", f"{ALONE}Write radius_m = 3.5."),
    (RADIUS, 'radius_m = 118"', f"{ALONE}Write radius_m = 118."),
    (
        RADIUS,
        'radius_m = "3"',
        'segments.2.radius_m = "3" must be a number, at least 0.001 m and at most 2000 m. Write 3, the number alone.',
    ),
    (RADIUS, 'radius_m = "3 m"', "Write 3, the number alone."),
    (RADIUS, "radius_m = 90%", "must be a number alone. Write radius_m = 0.9 if a share is meant, or 90."),
    (RADIUS, "radius_m = 1/2", "must be one number. Write radius_m = 0.5."),
    (RADIUS, "radius_m = 1/0", "is not valid TOML"),
    (RADIUS, "radius_m = .5", "needs a digit before the point. Write radius_m = 0.5."),
    (RADIUS, "radius_m = 3.", "is not a number as TOML writes it. Write radius_m = 3.0."),
    (RADIUS, "radius_m = 03", "is not a number as TOML writes it. Write radius_m = 3."),
    (RATE, "rate_t_h = ~1000", NOT_ONE),
    (FRICTION, "friction_deg = 25±2\n", NOT_ONE),
    (FRICTION, "friction_deg = 20-30\n", NOT_ONE),
    (RADIUS, "radius_m = nan", "must be finite and at least 0.001 m and at most 2000 m. Write a finite number."),
    # text and truth
    (KIND, "kind = curve", '27: segments.2.kind = curve must be in quotes if it is text. Write kind = "curve".'),
    (KIND, 'kind = "curve', 'is in quotes that do not close. Write kind = "curve".'),
    (KIND, 'kind = curve"', 'Write kind = "curve".'),
    (KIND, "kind = “curve”", 'kind = “curve” is in quotes that TOML does not know. Write kind = "curve".'),
    (KIND, "kind = „curve“", 'Write kind = "curve".'),
    (KIND, "kind = ‘curve’", 'Write kind = "curve".'),
    (KIND, "kind = «curve»", 'Write kind = "curve".'),
    (TITLE, "Coal chute 3", '1: title = Coal chute 3 must be in quotes if it is text. Write title = "Coal chute 3".'),
    (
        TITLE,
        '"chutes\\Ulm"',
        "has a backslash in double quotes; single quotes take it. Write title = 'chutes\\Ulm'.",
    ),
    (TITLE, '"Spoon\nlong"', '1: title = "Spoon is in quotes that do not close.'),
    (TITLE, "2026-01-01", "1: title = 2026-01-01 must be text in quotes. Put quotes around it."),
    (
        SLOPE,
        f"{SLOPE}\nmay_be_passed = True",
        "30: segments.2.may_be_passed = True must be true or false, in small letters. Write may_be_passed = true.",
    ),
    (SLOPE, f"{SLOPE}\nmay_be_passed = no", "Write may_be_passed = false."),
    (SLOPE, f'{SLOPE}\nmay_be_passed = "true"', "must be true or false. Write one of these without quotes."),
    # what is missing, and what is too much
    (RADIUS, "radius_m =", "28: segments.2.radius_m has no value. Write a value, or delete the line."),
    (RADIUS, "radius_m = # todo", "has no value."),
    (RADIUS, "radius_m", "28: radius_m has no value. Write radius_m = and its value, or [radius_m] for a table."),
    (RADIUS, "radius_m = null", "is no value. Write a value, or delete the line."),
    (RADIUS, "radius_m = ?", "is no value. Write a value, or delete the line."),
    (RADIUS, "radius_m 3", "28: radius_m has no = between key and value. Write radius_m = 3."),
    (KIND, "kind: curve", '27: kind has : between key and value. Write kind = "curve".'),
    (RADIUS, "radius_m := 3", "has := between key and value. Write radius_m = 3."),
    (RADIUS, "radius_m == 3", "has two equals signs. Write radius_m = 3."),
    (RADIUS, "radius_m = 3;", "has something behind it that is not TOML. Write radius_m = 3."),
    (RADIUS, "radius_m = 3,", "has something behind it that is not TOML. Write radius_m = 3."),
    (RADIUS, "radius_m = 3 // m", "has something behind it; comments begin with #. Write radius_m = 3."),
    (RATE, f"{RATE}, gravity_m_s2 = 9.8", "has another key in its line. Write each key on a line of its own."),
    (RATE, f"{RATE} gravity_m_s2 = 9.8", "has another key in its line. Write each key on a line of its own."),
    ("[flow]", "// the flow\n[flow]", "7: a comment begins with #. Write # the flow."),
    ("[flow]", "; the flow\n[flow]", "7: a comment begins with #. Write # the flow."),
    ("[flow]", "-- the flow\n[flow]", "7: a comment begins with #. Write # the flow."),
    (
        "drop_m = 2.0",
        "drop_m = 2.0\nat_m = [1, 2\nx = 3",
        "24: segments.1.at_m is a list without an end. Close it with ].",
    ),
    (
        "drop_m = 2.0",
        "drop_m = 2.0\nat_m = [1,5; 2]",
        "is not a list as TOML writes it. Write it such as [1.5, 2.5], with decimal points.",
    ),
    (f"[flow]\n{RATE}", f"flow = {{ {RATE},\n gravity_m_s2 = 9.8 }}", "must end in its line."),
    ("[flow]", "[flow]\nx = {a = 1,}", "is not a table as TOML writes it."),
    (TITLE, '"""Spoon', '1: title is a text without an end. Close it with """.'),
    # keys
    (RADIUS, "radius m = 3", f"28: radius m is not a key: {NO_KEY}Write radius_m = 3."),
    (RADIUS, "“radius_m” = 3", f"is not a key: {NO_KEY}Write radius_m = 3."),
    (RADIUS, "μ = 3", f"is not a key: {NO_KEY}Use a key in letters a to z, such as radius_m."),
    (
        RADIUS,
        "radius_m\N{NO-BREAK SPACE}= 3",
        "has a character that does not show, U+00A0. Delete it, or type the line anew.",
    ),
    (RADIUS, "radius_m =\N{NO-BREAK SPACE}3", "has a character that does not show, U+00A0."),
    (RADIUS, "\N{ZERO WIDTH SPACE}radius_m = 3", "has a character that does not show, U+200B."),
    (RADIUS, "Radius_m = 3", f"28: segments.2.Radius_m = 3 {SMALL}Write radius_m."),
    (RADIUS, "radius_MM = 3000", f"{SMALL}Write radius_mm."),
    (RATE, "Rate_T_H = 1000", f"8: flow.Rate_T_H = 1000 {SMALL}Write rate_t_h."),
    (RADIUS, "radius-m = 3", "28: segments.2.radius-m = 3 is not a key of this table. Did you mean radius_m?"),
    (
        RADIUS,
        f"{RADIUS}\n{SLOPE}\nradius_m = 4",
        "30: segments.2.radius_m is given twice, first in line 28. Keep one of the two.",
    ),
    (
        'title = "Spoon"',
        f'{RATE}\ntitle = "Spoon"',
        "1: rate_t_h = 1000 is not a key of this table. Put it below [flow].",
    ),
    # words that are chosen from a list
    (KIND, 'kind = "Hood"', '27: segments.2.kind = "Hood" is not a known kind. Did you mean hood?'),
    (KIND, 'kind = "STRAIGHT"', "is not a known kind. Did you mean straight?"),
    (KIND, 'kind = "Spoon"', "is not a known kind. Use curve: a spoon or crest is a curve."),
    (KIND, 'kind = "elbow"', "is not a known kind. Use one of curve, fall, hood, plate, straight."),
    (
        '"rectangular"',
        '"Rectangular"',
        '14: sections.body.shape = "Rectangular" is not a known shape. Did you mean rectangular?',
    ),
    ('"rectangular"', '"Pipe"', "is not a known shape. Did you mean pipe?"),
    # tables
    (FALL, FALL[1:].replace("]]", "]"), "21: [segments] is one table, and there are several. Write [[segments]]."),
    (SECOND, "[segments]\nname", "25: [segments] is one table, and there are several. Write [[segments]]."),
    (
        FALL,
        FALL.replace("[[segments]]", "[[segments]"),
        "21: [[segments] is not the header of a table: its brackets do not match. Write [[segments]].",
    ),
    (FALL, FALL.replace("[[segments]]", "[ [segments] ]"), "its brackets do not match. Write [[segments]]."),
    (FALL, FALL.replace("[[segments]]", "[[Segments]]"), f"21: Segments {SMALL}Write segments."),
    ("[flow]", "[flow", "7: [flow is not the header of a table: its brackets do not match. Write [flow]."),
    ("[flow]", "flow]", "its brackets do not match. Write [flow]."),
    ("[flow]", "[[flow]]", "7: flow must be a table, and is a list. Write [flow], in single brackets."),
    (
        "[sections.body]",
        "[[sections.body]]",
        "13: sections.body must be a table, and is a list. Write [sections.body], in single brackets.",
    ),
    ("[flow]", "[Flow]", f"7: Flow {SMALL}Write flow."),
    (
        "[liners.wall]",
        "[flow]\ngravity_m_s2 = 9.8\n\n[liners.wall]",
        "10: the table [flow] is given twice, first in line 7. Put all its keys below one of the two headers.",
    ),
    (
        "[inlet]",
        '[sections.body]\nshape = "vee"\n\n[inlet]',
        "17: the table [sections.body] is given twice, first in line 13.",
    ),
    (
        "[liners.wall]",
        "[liners.gummi_für]",
        "10: [liners.gummi_für] is not the header of a table. Use letters a to z, digits, - and _ in its name.",
    ),
    ("[liners.wall]", "[liners]", "must be a table. Put it under a name of your choice: [liners.NAME]."),
    ("[inlet]\nvelocity_m_s = 0\nslope_deg = 90\n", "", "inlet is missing. Add a header [inlet]."),
    # other formats
    (RADIUS, "=======", "28: ======= is the mark of a merge that was not finished. Keep one of the two versions."),
    (SPOON, "", "spec: is empty. Run chutecalc new, which writes one to start from."),
    (SPOON, '{\n  "flow": {"rate_t_h": 1000}\n}\n', "1: this is JSON, and a spec is TOML."),
    (SPOON, "flow: \n  rate_t_h: 1000\n", "1: this is YAML, and a spec is TOML."),
    (SPOON, '<?xml version="1.0"?>\n<chute/>\n', "1: this is XML, and a spec is TOML."),
    (SPOON, f"```toml\n{SPOON}```\n", "1: this is Markdown, and a spec is TOML."),
    (
        SPOON,
        "kind,radius_m\nhood,3\n",
        "1: kind,radius_m is not TOML. Write key = value, a header such as [flow], or # before a comment.",
    ),
]


@pytest.mark.parametrize(("old", "new", "words"), SLIPS, ids=[" ".join(slip[1].split())[:40] for slip in SLIPS])
def test_a_slip(old, new, words):
    assert old in SPOON
    with pytest.raises(chutecalc.SpecError) as caught:
        chutecalc.parse(SPOON.replace(old, new, 1))
    lines = str(caught.value).splitlines()
    assert any(line.removeprefix("spec:").startswith(words) if words[0].isdigit() else words in line for line in lines)
    assert "Value error" not in str(caught.value)


def test_all_that_is_no_slip():
    plain = chutecalc.parse(SPOON).data
    spaced = SPOON.replace(" = ", "\t=\t").replace("\n", "  # a comment, with 'quotes\n")
    assert chutecalc.parse(spaced).data == plain
    assert chutecalc.parse("\ufeff".encode().decode("utf-8-sig") + SPOON).data == plain


SETTINGS = [
    ("flow.rate_t_h=1,5", "the decimal mark is a point. Write --set flow.rate_t_h=1.5."),
    ("flow.rate_t_h=1 000", "is not a number as TOML writes it. Write --set flow.rate_t_h=1000."),
    ("inlet.at_m=[1,5; 2]", "is not a list as TOML writes it."),
    ("inlet.at_m=[1, 2", "is a list without an end. Close it with ]."),
    ('title="Coal', 'Write --set title="Coal".'),
    ("title=“Coal”", 'Write --set title="Coal".'),
    ("segments.2.to_slope_deg=\N{EN DASH}10", "Write --set segments.2.to_slope_deg=-10."),
]


@pytest.mark.parametrize(("setting", "words"), SETTINGS, ids=[setting for setting, _ in SETTINGS])
def test_a_slip_in_a_setting(setting, words):
    with pytest.raises(UsageError) as caught:
        read_setting(setting)
    assert str(caught.value).startswith(f"--set {setting} ")
    assert words in str(caught.value)


@pytest.mark.parametrize("text", ["Coal", "Coal, 3 m", "3 m chute", "true story", "−"])
def test_text_needs_no_quotes_in_a_setting(text):
    assert read_setting(f"title={text}") == ("title", text)
