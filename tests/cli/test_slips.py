"""Slips on the command line: files that are not there, and values that options do not take."""

import inspect
from importlib import import_module
from typing import get_args

import pytest
from typer.models import OptionInfo

from chutecalc.cli import COMMANDS, main


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("spoonn.toml", "there is no such file. Did you mean {}/spoon.toml?"),
        ("spoon", "there is no such file. Did you mean {}/spoon.toml?"),
        ("belt.toml", "there is no such file. Check the name, or create one with chutecalc new."),
    ],
)
def test_a_file_that_does_not_exist(arguments, message, tmp_path, capsys):
    (tmp_path / "spoon.toml").write_text("")
    (tmp_path / "spoonn.baseline.toml").write_text("")
    assert main(["run", str(tmp_path / arguments)]) == 2
    assert capsys.readouterr().err == f"{tmp_path / arguments}: {message.format(tmp_path)}\n"


def test_what_is_no_file_but_an_option(capsys):
    assert main(["run", "a.toml", "radius=2", "\N{EN DASH}csv"]) == 2
    assert "To change a key write --set radius=2." in (shown := capsys.readouterr().err)
    assert "If it is an option, write --csv, with two minus signs." in shown


def options():
    """Every option of every command that takes a value which is not text."""
    for name in COMMANDS:
        command = getattr(import_module(f"chutecalc.cli.{name}"), name)
        for parameter in inspect.signature(command, eval_str=True).parameters.values():
            kinds = {parameter.annotation, *get_args(parameter.annotation)}
            if isinstance(parameter.default, OptionInfo) and not {str, bool} & kinds:
                yield name, next(iter(parameter.default.param_decls or ()), f"--{parameter.name.replace('_', '-')}")


@pytest.mark.parametrize("value", ["x?", "1e999", "nan", "1,5"])
@pytest.mark.parametrize(("name", "option"), list(options()))
def test_a_value_that_an_option_does_not_take_is_explained(name, option, value, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    status = main([name, "a.toml", "radius=1:2", option, value])
    shown = capsys.readouterr().err
    assert status == 2
    assert "Value error" not in shown
    if value == "x?":
        assert shown.startswith(f"chutecalc: {option} must be ")
        assert shown.endswith("not x?.\n")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--"], "give a command: new, run, sweep"),
        (["--", "limits", "x"], "x is more than the command takes. For example: chutecalc limits"),
        (["--", "run"], "SPEC is missing. For example: chutecalc run chute.toml"),
        (["--", "-x"], "there is no option -x. chutecalc --help lists the options"),
        (["-x"], "there is no option -x. chutecalc --help lists the options"),
    ],
)
def test_what_stands_before_a_command(capsys, arguments, message):
    assert main(arguments) == 2
    assert message in capsys.readouterr().err
