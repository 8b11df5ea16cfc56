"""The bar for long work: nothing but on a terminal, and there the number given."""

import time

import pytest

from chutecalc.output.progress import progress, with_progress


def on_terminal(monkeypatch):
    """Standard error as a terminal's, while a test runs."""
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("NO_COLOR", "1")
    monkeypatch.setenv("COLUMNS", "100")
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)


@pytest.mark.parametrize(("slow", "pace"), [(False, "/s"), (True, "0:00:0")])
def test_what_a_terminal_shows(slow, pace, monkeypatch, capsys):
    on_terminal(monkeypatch)
    with progress("designs", slow) as report:
        for done in (300, 600, 900, 1200):
            report(done, 1200)
            time.sleep(0.02)  # longer than a tick of any clock
    shown = capsys.readouterr()
    last = shown.err[shown.err.rindex("1200/1200 designs") :]
    assert pace in last
    assert ("/s" in last) is not slow
    assert shown.out == ""


@pytest.mark.parametrize("count", [3, 50])
def test_items_come_through_with_a_bar_where_there_are_many(count, monkeypatch, capsys):
    on_terminal(monkeypatch)
    assert list(with_progress(range(count), count, "designs")) == [*range(count)]
    assert (f"{count}/{count}" in capsys.readouterr().err) is (count == 50)


def test_where_there_is_no_terminal_nothing_is_said(capsys):
    assert list(with_progress(range(50), 50, "designs")) == [*range(50)]
    assert capsys.readouterr().err == ""
