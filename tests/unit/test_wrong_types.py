"""Functions called with what is not theirs: an error of chutecalc says what they take."""

import io

import pytest

import chutecalc

SPOON = chutecalc.parse(chutecalc.STARTER)
SOLVED = chutecalc.solve(SPOON)
RADIUS = "segments.spoon.radius_m"


def nested(levels):
    table = {}
    for _ in range(levels):
        table = {"a": table}
    return table


def shared(times):
    table = {"a": 1}
    for _ in range(times):
        table = {"a": table, "b": table}
    return table


def endless():
    table = {}
    table["a"] = table
    return table


CALLS = {
    "load 1": (lambda: chutecalc.load(1), "path must be the path of a TOML file, not 1"),
    "load with a library 1": (lambda: chutecalc.parse(chutecalc.STARTER, library=1), "library must be the path"),
    "parse 1": (lambda: chutecalc.parse(1), "spec: is 1. Give TOML text or a table"),
    "parse what is deep": (lambda: chutecalc.parse(nested(10**5)), "spec: is nested more than 50 deep"),
    "parse what has no end": (lambda: chutecalc.parse(endless()), "spec: is nested more than 50 deep"),
    "parse with changes 1": (lambda: chutecalc.parse(chutecalc.STARTER, changes=1), "give values by path, .*, not 1"),
    "vary None": (lambda: SPOON.vary(None), "give values by path, .*, not None"),
    "vary 1": (lambda: SPOON.vary({1: 2}), r"give values by path, .*, not \{1: 2\}"),
    "put what is deep": (lambda: SPOON.put({"flow.rate_t_h": nested(10**5)}), "spec: is nested more than 50 deep"),
    "a file's columns": (lambda: chutecalc.exits(SPOON, columns=1), "columns must be a list of names, not 1"),
    "columns of bytes": (lambda: SOLVED.stations(columns=[b"s_m"]), "columns must be a list of names"),
    "jobs": (lambda: chutecalc.exits(SPOON, jobs="2"), "jobs must be a whole number, 1 or more, not '2'"),
    "points": (lambda: SOLVED.stations(2.5), "points must be a whole number from 2 to 2,000,000, not 2.5"),
    "a sensitivity of 1": (lambda: chutecalc.sensitivity(SPOON, column=1), "column must be the name of one"),
    "a spacing of text": (lambda: SOLVED.stations(spacing="1"), "spacing must be a length"),
    "limits of no double": (lambda: SPOON.function({RADIUS: (1, 10**400)}), "must be two numbers"),
    "what is shared forty times": (lambda: chutecalc.parse(shared(40)), "has more than"),
    "aim 1": (lambda: chutecalc.aim(SPOON, 1, {}), "give bounds by path, .*, not 1"),
    "aim at 1": (lambda: chutecalc.aim(SPOON, {RADIUS: (1, 4)}, 1), "give wanted values by column, .*, not 1"),
    "optimise 1": (
        lambda: chutecalc.optimise(SPOON, 1, minimise="exit_velocity_m_s"),
        "give bounds by path, .*, not 1",
    ),
    "place 1": (lambda: chutecalc.place(1, {"spoon": {}}), "place takes TOML text, a table or a chute, not 1"),
    "place what has no end": (lambda: chutecalc.place(endless(), {"spoon": {}}), "is nested more than 50 deep"),
    "place with wishes 1": (lambda: chutecalc.place(SPOON, 1), "place takes segments with their wishes"),
    "report 1": (lambda: chutecalc.write_report("never.html", 1), "give a chute from chutecalc.load or"),
}
OF_CHUTES = (
    *(chutecalc.solve, chutecalc.exits, chutecalc.solve_cases, chutecalc.solve_band, chutecalc.freeze),
    *(chutecalc.uncertain, chutecalc.sensitivity),
)


@pytest.mark.parametrize("name", CALLS)
def test_an_error_says_what_is_taken(name):
    call, message = CALLS[name]
    with pytest.raises(chutecalc.ChutecalcError, match=message):
        call()


@pytest.mark.parametrize("function", OF_CHUTES, ids=lambda function: function.__name__)
@pytest.mark.parametrize("given", [None, 1, chutecalc.STARTER, io.StringIO()], ids=lambda given: type(given).__name__)
def test_what_takes_a_chute_says_so(function, given):
    with pytest.raises(chutecalc.UsageError, match="give a chute from"):
        function(given)
