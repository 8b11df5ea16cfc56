"""What README.md and the pages in docs show is what happens."""

import os
import re
import shutil
import subprocess
import sys

import pytest

import chutecalc
from chutecalc.cli import COMMANDS
from chutecalc.design.status import Status
from chutecalc.errors import ExitStatus
from chutecalc.output.formats import output_formats
from chutecalc.results.findings import CRITERIA
from chutecalc.sections.registry import SHAPES
from chutecalc.segments.registry import KINDS
from tests.house.test_imports import LEVEL
from tests.pages import LESSONS, PAGES, ROOT, STORIES, blocks, console, program, renewed, spec, workplace

README = (ROOT / "README.md").read_text(encoding="utf-8")
FINDINGS = (ROOT / "docs" / "findings.md").read_text(encoding="utf-8")
LINKING = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md"), *STORIES, ROOT / "specs" / "README.md"])


def each(language):
    """Return the blocks of all pages in a language, with names that identify them."""
    found = [(page, number, block) for page in PAGES for number, block in enumerate(blocks(page, language), 1)]
    return [pytest.param(page, block, id=f"{page.stem}-{number}") for page, number, block in found]


@pytest.fixture(autouse=True)
def elsewhere():
    with workplace():
        yield


@pytest.mark.parametrize(("page", "block"), each("console"))
def test_commands_print_what_is_shown(page, block):
    commands = re.findall(r"^\$ (.*)$", block.text, re.MULTILINE)
    assert all(command.startswith("chutecalc ") or command == "echo $?" for command in commands)
    shown = console(block.text)
    assert shown == block.text, f"{page.name}: python -m tests.pages writes its examples anew"


@pytest.mark.parametrize("page", STORIES, ids=lambda page: page.stem)
def test_stories_go_as_they_are_told(page):
    assert renewed(page) == page.read_text(encoding="utf-8"), "python -m tests.pages writes its examples anew"


def test_a_lesson_needs_at_most_five_commands():
    for page in LESSONS:
        commands = [line for block in blocks(page, "console") for line in block.text.splitlines() if line[:2] == "$ "]
        assert len([each for each in commands if each.startswith("$ chutecalc")]) <= 5, page.name


@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page, "python")], ids=lambda page: page.stem)
def test_programs_print_what_is_shown(page):
    names = {"__name__": "page"}
    for block in blocks(page, "python"):
        assert program(block.text, names) == (block.printed or ""), block.text


@pytest.mark.parametrize(("page", "block"), each("toml"))
def test_specs_are_specs(page, block):
    data = spec(block.text, blocks(page, "toml")[0].text)
    assert chutecalc.solve(chutecalc.parse(data)).status[0] == "ok"


def test_every_block_is_run_or_says_by_its_language_why_not():
    run, told = {"console", "python", "toml", "text"}, {"sh", "yaml", "json", "lua"}  # as tests/pages.py says
    for page in LINKING:
        openings = re.findall(r"^```(.*)\n(?:.*\n)*?```$", page.read_text(encoding="utf-8"), re.MULTILINE)
        assert {*openings} <= run | told, page.name


def test_every_command_has_its_help_on_the_page_of_commands():
    page = (ROOT / "docs" / "commands.md").read_text(encoding="utf-8")
    assert re.findall(r"^## (\S+)$", page, re.MULTILINE) == list(COMMANDS)
    assert re.findall(r"^\$ (.*)$", page, re.MULTILINE)[1:] == [f"chutecalc {name} --help" for name in COMMANDS]


def test_the_workflow_for_ci_runs_the_lines_for_a_ci_job():
    page = (ROOT / "docs" / "howto" / "ci.md").read_text(encoding="utf-8")
    (lines,) = re.findall(r"^```sh\n(.*?)^```$", (ROOT / "docs" / "checks.md").read_text(encoding="utf-8"), re.S | re.M)
    assert re.findall(r"- run: (.*)$", page, re.MULTILINE) == lines.splitlines()


def test_other_commands_name_files_that_exist():
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        for block in re.findall(r"^```sh\n(.*?)^```$", text, re.DOTALL | re.MULTILINE):
            for name in re.findall(r"specs/\S+\.toml", block):
                assert (ROOT / name).is_file(), name


@pytest.mark.skipif(sys.platform == "win32", reason="programs are elsewhere in a venv there")
def test_the_lines_for_a_ci_job_pass_and_fail(tmp_path):
    page = (ROOT / "docs" / "checks.md").read_text(encoding="utf-8")
    (lines,) = re.findall(r"^```sh\n(.*?)^```$", page, re.DOTALL | re.MULTILINE)
    assert lines.count("\n") == 3
    for name in ("vee.toml", "vee.baseline.toml", "fails/stall.toml", "fails/stall.baseline.toml"):
        target = tmp_path / "specs" / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes((ROOT / "specs" / name).read_bytes())

    source = tmp_path / "source"  # uncompiled: the session `package` of noxfile.py compiles one
    shutil.copytree(ROOT / "chutecalc", source / "chutecalc", ignore=shutil.ignore_patterns("*.so", "*.pyd"))
    for name in ("pyproject.toml", "setup.py", "compiling.py", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, source / name)

    def job(script):
        options = {
            "cwd": tmp_path,
            "env": os.environ | {"CHUTECALC": str(source), "CHUTECALC_COMPILE": "0", "PIP_COMPILE": "0"},
        }
        return subprocess.run(["bash", "-euo", "pipefail", "-c", script], capture_output=True, text=True, **options)

    first = job(lines)
    assert (first.returncode, first.stdout) == (0, "2 designs: 2 ok\n"), first.stderr
    assert (tmp_path / "check.xml").is_file()
    spec = tmp_path / "specs" / "vee.toml"
    spec.write_text(
        spec.read_text(encoding="utf-8").replace("friction_deg = 18", "friction_deg = 18.1"), encoding="utf-8"
    )
    again = job(lines.splitlines()[-1])
    assert again.returncode == 1
    assert again.stdout.startswith("specs/vee.toml: edited (tolerance 1e-09)\n")


def anchors(page):
    titles = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


@pytest.mark.parametrize("page", LINKING, ids=lambda page: f"{page.parent.name}-{page.stem}")
def test_links_lead_somewhere(page):
    text = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    for target, _, anchor in (link.partition("#") for link in re.findall(r"\]\((?!https?:)([^)\s]+)\)", text)):
        file = page.parent / target if target else page
        assert file.exists(), target
        assert not anchor or anchor in anchors(file), f"{target}#{anchor}"


def test_every_page_and_picture_is_linked():
    docs = ROOT / "docs"
    index = re.findall(r"\]\(([^)#]+)", (docs / "README.md").read_text(encoding="utf-8"))
    assert {path.relative_to(docs).as_posix() for path in docs.rglob("*.md")} - {"README.md"} <= set(index)
    shown = {
        (page.parent / target).resolve()
        for page in LINKING
        for target in re.findall(r"!\[[^]]*\]\(([^)]+)\)", page.read_text(encoding="utf-8"))
    }
    for folder in ("figures", "benchmarks", "dem"):
        assert {path.resolve() for path in (ROOT / "docs" / folder).glob("*.svg")} <= shown


def test_every_finding_is_described():
    table = re.findall(r"^\| \[`([a-z_]+)`\]\(#[a-z_]+\) \| (?:failure|warning|note)", FINDINGS, re.MULTILINE)
    sections = re.findall(r"^### ([a-z_]+)$", FINDINGS, re.MULTILINE)
    assert len(table) == len(set(table))
    assert table == sections
    assert {criterion.code for criterion in CRITERIA} == set(table)


def first_words(page, heading):
    """The first word in backticks of each row of the table below this heading, with the others of the row."""
    text = (ROOT / "docs" / page).read_text(encoding="utf-8")
    table = text[text.index(heading) :].split("\n\n")[0]
    rows = [re.findall(r"`([^`]+)`", row) for row in table.splitlines()[2:]]
    return [(first, rest) for first, *rest in rows]


def test_every_shape_of_a_section_is_described():
    rows = first_words("spec.md", "| shape | keys |")
    assert sorted(shape for shape, _ in rows) == sorted(SHAPES)
    for shape, keys in rows:
        assert set(keys) == SHAPES[shape].model_fields.keys() - {"shape", "wall_height_m"}, shape


def test_every_kind_of_segment_is_described():
    rows = first_words("spec.md", "| kind | keys | what it is |")
    assert sorted(kind for kind, _ in rows) == sorted(KINDS)


def test_every_output_format_is_described():
    rows = first_words("running.md", "| option | writes |")
    options = [option.removesuffix(" FILE") for option, _ in rows]
    assert sorted(options) == sorted(f"--{name}" for name in output_formats())


def test_every_exit_status_is_described():
    page = (ROOT / "docs" / "running.md").read_text(encoding="utf-8")
    table = page[page.index("| status | meaning |") :].split("\n\n")[0]
    shown = re.findall(r"^\| (\d+) \| (.*) \|$", table, re.MULTILINE)
    assert shown == [(str(int(status)), status.meaning) for status in ExitStatus]


def test_every_status_of_a_design_is_described():
    rows = [status for status, _ in first_words("running.md", "| status | meaning |\n| --- | --- |\n| `ok`")]
    assert rows == [*Status.LABELS[:5], "passed", "not_reached", Status.IMPOSSIBLE_LABEL]
    assert {*rows} == {*Status.LABELS, Status.IMPOSSIBLE_LABEL}


def test_architecture_lists_every_room():
    page = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")
    rooms = re.findall(r"^\| (\d+) \| `([a-z]+)(?:/|\.py)` \|", page, re.M)
    assert len(rooms) == len(set(rooms))
    assert {(int(level), room) for level, room in rooms} == {(level, room) for room, level in LEVEL.items()}


def test_readme_is_short():
    assert len(README.splitlines()) < 130


def test_every_version_is_the_same():
    assert f"version: {chutecalc.__version__}\n" in (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert f"## {chutecalc.__version__}" in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
