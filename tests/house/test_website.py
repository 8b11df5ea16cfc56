"""The documentation site has what there is. `nox -s docs` builds it, and fails where a link leads nowhere."""

import re
from pathlib import Path

import pytest

from tests.conftest import ROOT
from website.api import markdown
from website.gallery import Drawn, designs, draw, index, page, status
from website.links import with_site_links

NAV = re.findall(r"^ +- .*?([\w/]+\.md)$", (ROOT / "mkdocs.yml").read_text(encoding="utf-8"), re.MULTILINE)


def specs():
    found = (path.relative_to(ROOT / "specs") for path in (ROOT / "specs").rglob("*.toml"))
    return {path.with_suffix("").as_posix() for path in found if not path.name.endswith(".baseline.toml")}


def test_every_page_is_in_the_navigation_once():
    pages = {path.relative_to(ROOT / "docs").as_posix() for path in (ROOT / "docs").rglob("*.md")} - {"README.md"}
    assert pages <= set(NAV)
    assert len(NAV) == len(set(NAV))


def test_every_standard_design_is_in_the_gallery():
    assert len(designs()) == len({each.name for each in designs()})
    assert {each.name for each in designs()} == specs()
    text = index(designs(), {each.name: Drawn("status ok", b"") for each in designs()})
    for name in specs():
        assert f"]({name}.svg)" in text
        assert f"]({name}.md)" in text


def test_a_design_is_shown_with_its_picture_its_report_and_its_file():
    one = next(each for each in designs() if each.name == "fails/choke")
    drawn = draw(one)
    assert drawn.picture.startswith(b"<?xml")
    assert status(drawn) == "choke"
    text = page(one, drawn)
    for part in (one.title, "(choke.svg)", "$ chutecalc run specs/fails/choke.toml\n", "failure choke", "[flow]\n"):
        assert part in text
    assert "Status choke." in index([one], {one.name: drawn})


@pytest.mark.parametrize(
    ("link", "source", "here", "shown"),
    [
        ("docs/spec.md#steel", "README.md", "index.md", "spec.md#steel"),
        ("../CONTRIBUTING.md#set-up", "docs/verification.md", "verification.md", "contributing.md#set-up"),
        ("../specs/vee.toml", "docs/spec.md", "spec.md", "specs/vee.md"),
        ("../../specs/README.md", "docs/howto/ci.md", "howto/ci.md", "../specs/index.md"),
        ("../aiming.md#optima", "docs/howto/ci.md", "howto/ci.md", "../aiming.md#optima"),
        ("fails/stall.svg", "specs/index.md", "specs/index.md", "fails/stall.svg"),
        ("#below", "docs/spec.md", "spec.md", "#below"),
        ("mailto:x", "docs/spec.md", "spec.md", "mailto:x"),
    ],
)
def test_links_of_a_code_host_become_links_of_the_site(link, source, here, shown):
    fenced = f"\n```text\n[code]({link})\n```\n"
    assert with_site_links(f"See [this]({link}).{fenced}", here, source) == f"See [this]({shown}).{fenced}"


@pytest.mark.parametrize(
    ("docstring", "shown"),
    [
        ("See :func:`chutecalc.solve`.", "See `chutecalc.solve`."),
        ("Add.\n\n>>> 1 + 1\n2\n\nMore.", "Add.\n\n```pycon\n>>> 1 + 1\n2\n```\n\nMore."),
    ],
)
def test_docstrings_become_markdown(docstring, shown):
    assert markdown(docstring) == shown


def test_nothing_is_loaded_from_elsewhere():
    for path in [ROOT / "mkdocs.yml", *(ROOT / "docs" / "assets").iterdir(), *Path(ROOT, "website").glob("*.py")]:
        assert not re.search(r"https?://(?!\S*w3\.org)", path.read_text(encoding="utf-8")), path
