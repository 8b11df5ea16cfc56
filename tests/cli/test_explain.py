"""`explain`, completion by the shell, and what every help has."""

import re
import subprocess
import sys

import pytest

from chutecalc.cli import COMMANDS, main
from chutecalc.glossary.tables import spec_tables
from chutecalc.glossary.words import entries
from chutecalc.results.finding_columns import ALL_COLUMNS
from chutecalc.results.findings import CRITERIA
from chutecalc.spec.limits import LIMITS
from chutecalc.studies.sweep.columns import row_columns
from tests.conftest import ROOT
from tests.house.test_readme import anchors


def explained(word, capsys, status=0):
    assert main(["explain", word]) == status
    printed = capsys.readouterr()
    return re.sub(r"\s+", " ", printed.err if status else printed.out)


def test_every_word_of_every_catalogue_is_explained():
    words = {entry.word for entry in entries()}
    every = {key for table in spec_tables() for key, _ in table.described()} | {*ALL_COLUMNS} | {*row_columns()}
    assert every <= words
    assert {criterion.code for criterion in CRITERIA} | {*LIMITS} <= words
    assert {table.kind_or_shape or table.path.rpartition(".")[2] for table in spec_tables()} - {""} <= words


def test_every_entry_has_a_meaning_and_a_page_that_exists():
    known = {}
    for entry in entries():
        assert entry.meaning, entry
        page, _, anchor = dict(entry.facts)["docs"].partition("#")
        known.setdefault(page, anchors(ROOT / page))
        assert not anchor or anchor in known[page], entry


def test_a_key_has_unit_bounds_range_default_and_source(capsys):
    text = explained("segments.spoon.radius_mm", capsys)
    assert text.startswith("radius_mm: radius of the guiding surface")
    for part in (
        "stands in segments: curve, segments: hood",
        "symbol R",
        "unit mm (also radius_m, radius_in, radius_ft)",
        "must be at least 1 mm and at most 2,000,000 mm because less is no longer than a grain, more is longer than",
        "usual 10 mm to 300,000 mm; less is shorter than a finger is wide",
        "default none: it must be given",
        "source Paper Eq 1",
        "docs docs/spec.md#segments",
    ):
        assert part in text
    assert 'must be "paper" or "equilibrium" default "paper"' in explained("friction_law", capsys)
    assert "default 9.80665 m/s²" in explained("gravity_m_s2", capsys)


def test_a_path_tells_keys_of_the_same_name_apart(capsys):
    assert "mean velocity" in explained("velocity_m_s", capsys)
    text = explained("inlet.belt.velocity_m_s", capsys)
    assert text.count("velocity_m_s:") == 1
    assert "velocity of the belt" in text
    assert "stands in liners" in explained("liners.ceramic.friction_deg", capsys)


def test_columns_findings_limits_statuses_symbols_and_options(capsys):
    text = explained("froude", capsys)
    assert "formula v/√(n A/b_s)" in text
    assert "read by slow_stream" in text
    assert "limit min_froude reads froude docs docs/findings.md#slow_stream" in explained("slow_stream", capsys)
    text = explained("min_froude", capsys)
    assert "default 2 finding slow_stream source chutecalc" in text
    assert "least on guiding surfaces" in explained("min_velocity_m_s", capsys)
    assert "segments.SEGMENT.max_depth_m" in explained("segments.spoon.max_depth_m", capsys)
    assert "the design cannot be built" in explained("impossible", capsys)
    assert "equivalent friction" in explained("μ_e", capsys)
    assert 'written [[segments]] with kind = "curve" needs radius_m, to_slope_deg' in explained("curve", capsys)
    for word in ("--strict", "strict"):
        assert "among options of run" in explained(word, capsys)


def test_other_words_are_looked_for_and_misspelt_ones_get_close_ones(capsys):
    text = explained("wear", capsys)
    assert "slip_ratio keys of a spec" in text
    assert "max_wear_w_m2" not in text, "what is made from a column goes with it"
    assert "Did you mean radius_m" in explained("radus_m", capsys, 2)
    assert explained("qqq", capsys, 2).startswith("chutecalc: there is no word qqq. `chutecalc explain` lists")


def test_without_a_word_it_lists_the_catalogues(capsys):
    assert main(["explain"]) == 0
    out = capsys.readouterr().out
    assert re.search(rf"^limits of findings +{len(LIMITS)} ", out, re.MULTILINE)
    assert re.search(rf"^commands +{len(COMMANDS)} ", out, re.MULTILINE)


@pytest.mark.parametrize("command", COMMANDS)
def test_every_help_has_two_examples_and_says_where_the_documentation_is(command, capsys):
    assert main([command, "--help"]) == 0
    out = capsys.readouterr().out
    examples = out[out.index("Examples:") : out.index("Documentation:")]
    assert examples.count(f"\n    chutecalc {command}") >= 1
    assert examples.count("\n    chutecalc ") >= 2
    page, anchor = re.search(r"docs/([a-z]+\.md)#?(\S*) in the source", out).groups()
    assert not anchor or anchor in anchors(ROOT / "docs" / page)


@pytest.mark.parametrize(
    ("line", "offered"),
    [
        ("chutecalc swe", {"sweep"}),
        ("chutecalc run --plo", {"--plot"}),
        ("chutecalc new --example belt", {"belt_hood_spoon"}),
        ("chutecalc explain slow", {"slow_stream"}),
    ],
)
def test_the_shell_completes_commands_options_and_words(line, offered):
    environment = {
        "_CHUTECALC_COMPLETE": "complete_bash",
        "COMP_WORDS": line,
        "COMP_CWORD": str(len(line.split()) - 1),
        "PYTHONPATH": str(ROOT),
    }
    arguments = [sys.executable, "-m", "chutecalc"]
    run = subprocess.run(arguments, capture_output=True, text=True, check=True, env=environment)
    assert set(run.stdout.split()) == offered


def test_a_shell_that_asks_in_a_wrong_way_is_told_nothing():
    environment = {"_CHUTECALC_COMPLETE": "complete_bash", "PYTHONPATH": str(ROOT)}  # without the words
    arguments = [sys.executable, "-m", "chutecalc"]
    run = subprocess.run(arguments, capture_output=True, text=True, check=False, env=environment)
    assert (run.returncode, run.stdout, run.stderr) == (1, "", "")


def test_the_script_for_the_shell_falls_back_to_file_names():
    arguments = [sys.executable, "-m", "chutecalc", "--show-completion", "bash"]
    run = subprocess.run(arguments, capture_output=True, text=True, check=True, cwd=ROOT)
    assert "complete -o default -F _chutecalc_completion chutecalc" in run.stdout


@pytest.mark.parametrize(
    ("word", "words"),
    [
        ("sections.body.shape", '"rectangular"'),
        ("segments.1.kind", '"hood"'),
        ("cases.wet.flow.rate_t_h", "mass rate"),
        ("uncertainty.liners.wall.friction_deg", "wall friction angle"),
    ],
)
def test_paths_of_a_spec_are_explained(word, words, capsys):
    assert main(["explain", word]) == 0
    assert words in capsys.readouterr().out
