"""Command lines of the grammar, run in this process and judged."""

import io
import os
import signal
import sys
import time
from collections.abc import Iterator
from contextlib import chdir, contextmanager, suppress
from itertools import chain, pairwise
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple
from unittest import mock

from hypothesis import strategies as st

from chutecalc.cli import main
from tests.robustness.hostile import FORGED, PATHS, WORDS, contents, seeds, value, word
from tests.robustness.written import READERS, check_lines

LONGEST = 60
"""Seconds after which a command hangs."""
DOCUMENTED = {0, 1, 2, 3}
"""Statuses that a command may end with where nothing hinders it from writing."""
COPIES = {"freeze", "place", "new"}
"""Commands whose output is the text of a spec, as it is."""
NAMES = ("x.toml", "=x.toml", "a b.toml", f"x\n{FORGED}.toml", "\x1b[2J.toml", "\udcff.toml", "石炭.toml", "x$5$.toml")
PIPE = "pipe.toml"
OTHERS = ("-", "missing.toml", ".", PIPE, "/dev/zero", "x.baseline.toml", "", "chute-library.toml", "no/x.toml")
DATA = ("", "--csv -", "--json -", "--csv x.csv", "--json x.json", "--parquet x.parquet", "--xlsx x.xlsx")
CHANGES = (
    "--band",
    "--sensitivity",
    "--points 3",
    "--units us",
    "--strict",
    "--case wet",
    "--columns depth_m",
    "--library x.toml",
)
PICTURES = ("--plot x.svg", "--plot x.png", "--plot x.pdf", "--dxf x.dxf", "--report x.html")
STUDIES = ("beta", "delta=20:60:5", "beta=0:90:1e-9", "beta=x", "beta=", "--base=1e5", "--area=nan", "--keep=depth")
SEARCHES = ("aim", "optimise", "uncertain")
SEARCHED = (
    *("--target exit_velocity_m_s=4", "--target x=nan", "--minimise exit_velocity_m_s", "--maximise exit_depth_m"),
    *("--subject max_depth_m<=0.3", "--limit exit_x_m", "--points 3", "--samples 64", "--write", "--take 2"),
    *("--margins", "--seed 9999999999999999999999", "--columns status,no"),
)
BEDS = ("--area 1000 --diameter 1e-4", "--area 0.05", "--beta 1:90:1e-9", "--read no", "--slice 1e300")
ENDS = ("1", "4", "#3", "1e299", "1e-299", "0", "-1")
STRAY = (*WORDS, "-(", "--x", "--set", "-csv", "--csv", "--points", "--", "-h")


class Line(NamedTuple):
    """A command line with what it reads."""

    arguments: list[str]
    name: str
    content: bytes
    closed: bool
    """Whether standard input is closed."""


path = st.sampled_from(("radius", "rate", "beta", *PATHS))
ends = st.lists(st.one_of(st.sampled_from(ENDS), value), min_size=1, max_size=3)
varied = st.builds(lambda name, mark, parts: f"{name}={mark.join(parts)}", path, st.sampled_from(":,"), ends)
changed = st.builds("--set={}={}".format, st.sampled_from(PATHS), value)
settings = st.one_of(st.just([]), st.just([]), st.lists(changed, max_size=2))
data = st.sampled_from(DATA).map(str.split)
pictures = st.integers(0, 9).flatmap(lambda k: st.just([]) if k else st.sampled_from(PICTURES).map(str.split))


def _commands(spec: str) -> st.SearchStrategy[list[str]]:
    """Return command lines about a spec."""
    changes = st.sampled_from(CHANGES).map(str.split)
    run = st.builds(lambda *parts: ["run", spec, *chain.from_iterable(parts)], data, changes, settings, pictures)
    check = st.sampled_from(("--junit x.xml", "--junit -", "--update", *DATA)).map(str.split)
    words = st.sampled_from(("explain", "limits", "columns", "schema", "new"))
    searched = st.lists(st.sampled_from(SEARCHED).map(str.split), max_size=3).map(lambda each: [*chain(*each)])
    return st.one_of(
        *[run] * 4,
        st.builds(lambda where, options: ["check", where, *options], st.sampled_from((spec, ".")), check),
        st.builds(lambda one, options: ["sweep", spec, one, *options], varied, data),
        st.builds(lambda study, options: ["sweep", study, *options], st.sampled_from(STUDIES), data),
        st.builds(lambda kind, one, options: [kind, spec, one, *options], st.sampled_from(SEARCHES), varied, searched),
        st.builds(lambda one: ["place", spec, "spoon", f"x={one}"], value),
        st.sampled_from(
            [["freeze", spec], ["place", spec, "spoon", "incidence=10", "--write"], ["run", spec], ["check"]]
        ),
        st.sampled_from(BEDS).map(lambda options: ["dem", *options.split(), "--write", "cases"]),
        st.builds(lambda command, one: [command, one], words, word),
    )


@st.composite
def command_lines(draw: st.DrawFn) -> Line:
    """Draw a command line."""
    name = draw(st.sampled_from(NAMES[:1] * 6 + NAMES))
    arguments = draw(_commands(draw(st.sampled_from((name,) * 60 + OTHERS))))
    if draw(st.integers(0, 15)) == 0:
        arguments.insert(draw(st.integers(0, len(arguments))), draw(st.sampled_from(STRAY)))
    fit = [each.replace("\x00", "") for each in arguments]  # no process can be given one
    right = st.sampled_from(seeds()).map(str.encode)  # the options alone are hostile
    content = draw(st.one_of(contents, right) if name == NAMES[0] else contents)
    return Line(fit, name, content, closed=draw(st.integers(0, 19)) == 0)


class Outcome(NamedTuple):
    """What a command did."""

    status: int
    out: str
    err: str
    seconds: float


def run(line: Line) -> Outcome:
    """Run a command in the folder that is the current one, where its files are."""
    out, err = (io.TextIOWrapper(io.BytesIO(), encoding="utf-8") for _ in range(2))
    given = None if line.closed else io.TextIOWrapper(io.BytesIO(line.content), encoding="utf-8")
    start = time.perf_counter()
    with mock.patch.multiple(sys, stdin=given, stdout=out, stderr=err), _limited():
        status = main(line.arguments)
        out.flush()
        err.flush()
    texts = (stream.buffer.getvalue().decode("utf-8") for stream in (out, err))  # type: ignore[attr-defined]
    return Outcome(status, *texts, time.perf_counter() - start)


@contextmanager
def _limited() -> Iterator[None]:
    """End what hangs."""

    def end(*_: object) -> None:
        raise TimeoutError(f"longer than {LONGEST} s")  # main turns it into status 74

    if not hasattr(signal, "SIGALRM"):
        yield
        return
    before = signal.signal(signal.SIGALRM, end)
    signal.alarm(LONGEST)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


@contextmanager
def folder(line: Line) -> Iterator[Path]:
    """Enter a folder with the spec of a command, or a named pipe that looks like one."""
    with TemporaryDirectory() as name, chdir(name):
        with suppress(OSError, UnicodeError):  # where no file can have such a name
            Path(line.name).write_bytes(line.content)
        if PIPE in line.arguments:
            with suppress(OSError, AttributeError):
                os.mkfifo(PIPE)
        yield Path(name)


def judge(line: Line) -> Outcome:
    """Run a command and hold what it says and writes against what users are promised."""
    with folder(line) as here:
        found = run(line)
        assert found.status in DOCUMENTED, (found.status, found.err)
        assert "Traceback" not in found.out + found.err, found.err
        out = "" if COPIES & {*line.arguments} else found.out.replace("\r\n", "\n")  # CSV has both
        for text in (out, found.err):
            check_lines(text)
        if found.status == 2:
            assert found.err.strip(), "no message"
        standard = next((form for form in ("csv", "json", "junit") if _goes_to_standard(line.arguments, form)), "")
        if standard and found.status < 2:
            READERS["xml" if standard == "junit" else standard](found.out.encode())
        for file in here.glob("x.*"):
            if file.suffix[1:] in READERS and file.is_file():
                READERS[file.suffix[1:]](file.read_bytes())
        return found


def _goes_to_standard(arguments: list[str], form: str) -> bool:
    return "-h" not in arguments and any(pair == (f"--{form}", "-") for pair in pairwise(arguments))
