"""What is read of a user, and how much of it: limits that hold before anything is built, and time that grows alike."""

import os
import socket
import time
from pathlib import Path

import pytest

import chutecalc
from chutecalc.cli.specs import read_setting, read_settings
from chutecalc.errors import SHOWN, Fault, UsageError
from chutecalc.printable import LONGEST_LINE, abbreviated, printable
from chutecalc.spec.bounded import DEEPEST, DIGITS, LONGEST_KEY, LONGEST_TEXT, MOST, excess
from chutecalc.spec.reader import LARGEST, read_bytes
from chutecalc.spec.slips import LONGEST


def nested(depth):
    return "a = " + "[" * depth + "]" * depth


@pytest.mark.parametrize(
    ("text_of", "most", "words"),
    [
        (lambda count: f"a = {'1' * count}", DIGITS, "a number of 41 digits"),
        (lambda count: f"a = 0.{'1' * count}", DIGITS, "a number of 41 digits"),
        (lambda count: f"{'k' * count} = 1", LONGEST_KEY, "a word of 201 characters"),
        (lambda count: f'"{"k" * (count - 2)}" = 1', LONGEST_KEY, "a key of 201 characters"),
        (lambda count: f'"{"k" * (count - 2)}".b = 1', LONGEST_KEY, "a key of 201 characters"),
        (lambda count: f"a = '{'k' * (count - 2)}'", LONGEST_TEXT, "a text of 10,001 characters"),
        (lambda count: f'a = """{"k" * (count - 6)}"""', LONGEST_TEXT, "a text of 10,001 characters"),
        (nested, DEEPEST, "nested more than 50 deep"),
        (lambda count: "a" + ".a" * count + " = 1", DEEPEST, "nested more than 50 deep"),
        (lambda count: "[a" + ".a" * (count - 1) + "]", DEEPEST, "nested more than 50 deep"),
        (lambda count: "#" * count, LARGEST, "larger than 10 MB"),
    ],
)  # fmt: skip
def test_a_part_is_refused_from_its_limit_on(text_of, most, words):
    assert excess(text_of(most)) is None
    fault = excess(text_of(most + 1))
    assert fault is not None
    assert words in fault.problem
    assert len(fault.text("x.toml")) < 200


def test_the_limits_of_depth_are_those_of_what_is_open():
    assert excess(nested(DEEPEST)) is None
    assert excess("\n".join([nested(DEEPEST), "a.b.c = 1.5"] * 30)) is None
    assert excess("a = [\n" + "[1.5, 2.5],  # [[[\n" * 5000 + "]") is None
    assert excess("a = '[[[[' # " + "[" * 100) is None
    assert excess("x = 1\n" * 4 + nested(DEEPEST + 1)).line == 5
    assert excess("a.a = {b.b = " * 12 + "1" + "}" * 12) is None  # four levels each, but for the last
    assert "deep" in excess("a.a = {b.b = " * 17 + "1" + "}" * 17).problem
    assert "1,000,000 words and marks" in excess("a," * (MOST // 2 + 1)).problem


@pytest.mark.parametrize(
    "text",
    [
        "[\n[" + " " * 300_000,
        "a = 1" + " " * 300_000 + "x",
        "a" + " " * 300_000,
        "a . " * 20 + " " * 300_000 + "= 1 1",
        '"' * 300_000,
        "[" + " " * 300_000 + "x" + " " * 300_000,
        "a = '" + "\\" * 9000 + "\n",
        "a = " + "1, " * 100_000,
        "= " * 150_000,
        "#" * 300_000 + "\n= 1",
        "a = 1 //" + " " * 300_000 + "/",
        "\n" * 300_000 + "x",
        "a = [\n" + "#\n" * 150_000,
        "[[a]]\n" * 40_000 + "x",
    ],
    ids=range(14),
)
def test_no_text_takes_the_square_of_its_length(text):
    start = time.perf_counter()
    with pytest.raises(chutecalc.SpecError) as caught:
        chutecalc.parse(text)
    assert time.perf_counter() - start < 8.0
    assert len(str(caught.value).split("\n")[0]) <= LONGEST_LINE


def test_slips_are_looked_for_in_lines_of_a_usual_length():
    with pytest.raises(chutecalc.SpecError, match="Write radius_m = 3"):
        chutecalc.parse("radius_m = 3 m")
    with pytest.raises(chutecalc.SpecError, match="is not valid TOML"):
        chutecalc.parse("radius_m = 3 m" + " " * LONGEST + "x")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no named pipes")
def test_only_files_are_read(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    os.mkfifo("pipe.toml")
    os.symlink("/dev/zero", "zero.toml")
    with socket.socket(socket.AF_UNIX) as own:
        own.bind("socket.toml")
        for name, kind in (("pipe", "a named pipe"), ("zero", "a device"), ("socket", "a socket")):
            with pytest.raises(chutecalc.SpecError, match=f"^{name}.toml: is {kind}, not a file"):
                chutecalc.load(f"{name}.toml")


def test_no_more_is_read_than_allowed(tmp_path):
    file = tmp_path / "large.toml"
    with file.open("wb") as stream:
        stream.truncate(LARGEST + 1)
    with pytest.raises(chutecalc.SpecError, match="is larger than 10 MB"):
        read_bytes(file)
    assert len(read_bytes(file, LARGEST + 1)) == LARGEST + 1


@pytest.mark.parametrize("name", ["a\0b", "x" * 3000])
def test_names_that_no_file_can_have(name):
    with pytest.raises(chutecalc.SpecError, match="cannot be read"):
        read_bytes(Path(name))


@pytest.mark.parametrize(
    ("setting", "words"),
    [
        ("a=" + "1" * 5000, "has a number of 5,000 digits"),
        ("a=" + "[" * 1000, "is nested more than 50 deep"),
        ("a='" + "x" * 20_000 + "'", "has a text of 20,002 characters"),
    ],
)
def test_values_of_set_have_the_same_limits(setting, words):
    with pytest.raises(UsageError, match=words) as caught:
        read_setting(setting)
    assert len(str(caught.value)) < 2 * SHOWN + 200


def test_a_value_of_set_is_one_value():
    assert read_setting("title=1\nflow.rate_t_h = 2") == ("title", "1\nflow.rate_t_h = 2")


def test_a_key_is_set_once():
    assert read_settings(["a=1", "b=1"]) == {"a=1": ("a", 1), "b=1": ("b", 1)}
    for texts in (["a=1", "a=2"], ["a=1", " a = 1"], ["a=1", "a=1"]):
        with pytest.raises(UsageError, match=f"--set {texts[0]} and --set {texts[1]} are of the same key"):
            read_settings(texts)


def test_text_is_made_printable():
    text = "é石\u200d\u3000\xa0 \x1b\x9b\x7f\n\t\u202e\u2028\ud800\ufffe\U000e0001"
    shown = printable(text)
    assert shown == "é石\u200d\u3000\xa0 \\x1b\\x9b\\x7f\\n\\t\\u202e\\u2028\\ud800\\ufffe\\U000e0001"
    assert printable(shown) == shown
    assert printable("a\n\x00", keep="\n") == "a\n\\x00"
    assert abbreviated("x" * 10, 10) == "x" * 10
    assert abbreviated("x" * 11, 10) == "xxxxx…xxxx"


def test_messages_are_lines_of_a_bounded_length():
    fault = Fault("k\n" * 5000, "is wrong\nforged", "write " + "y" * 9000, "v" * 9000, 3)
    for text in (fault.text("x\n.toml"), str(UsageError("a\nb", "z" * 9000)).split("\n")[1]):
        assert text.isprintable()
        assert len(text) <= LONGEST_LINE
    assert str(UsageError("a\nb", "c")) == "a\\nb\nc"
