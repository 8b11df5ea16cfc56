"""``run --report``: what the page says, that it needs nothing else, and how it looks in a browser and in print."""

import hashlib
import re
import shutil
import subprocess
from html.parser import HTMLParser
from pathlib import Path

import pypdf
import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.spec.chute_spec import Project
from tests.conftest import ROOT

TRANSFER = ROOT / "specs/transfer_90.toml"
STALL = ROOT / "specs/fails/stall.toml"
PAPER = [str(ROOT / f"specs/paper/r{radius}_d55_chamfered.toml") for radius in (2, 3)]
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
QUIET = [
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--hide-scrollbars"),
    *("--disable-background-networking", "--disable-component-update", "--disable-sync"),
]
in_browser = pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed")


class Page(HTMLParser):
    """The text of a page, its tags, and whether they close in order."""

    EMPTY = ("meta", "br", "link", "input", "img")

    def __init__(self, text):
        super().__init__()
        self.tags, self.open, self.words = [], [], []
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        if tag not in self.EMPTY:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if self.open and self.open[-1] != "style":
            self.words.append(data)

    @property
    def text(self):
        return re.sub(r"\s+", " ", " ".join(self.words))

    @property
    def ids(self):
        return [attributes["id"] for _, attributes in self.tags if "id" in attributes]


def report(tmp_path, *arguments, status=0, ending="html"):
    file = tmp_path / f"report.{ending}"
    assert main(["run", *map(str, arguments), "--report", str(file)]) == status
    return file


def browse(tmp_path, *arguments):
    """Run Chromium with a profile of its own and return what it prints."""
    command = [CHROMIUM, *QUIET, f"--user-data-dir={tmp_path / 'profile'}", *arguments]
    return subprocess.run(command, check=True, timeout=120, capture_output=True, text=True).stdout


def structure(element):
    """Yield the elements of a PDF's structure."""
    element = element.get_object()
    if isinstance(element, dict):
        yield element
        kids = element.get("/K", []).get_object() if "/K" in element else []
        for kid in kids if isinstance(kids, list) else [kids]:
            yield from structure(kid)


def page_of(tmp_path, *arguments, status=0):
    return Page(report(tmp_path, *arguments, status=status).read_text(encoding="utf-8"))


def test_the_page_has_what_a_client_looks_for(tmp_path, capsys):
    page, solution = page_of(tmp_path, TRANSFER), chutecalc.solve(chutecalc.load(TRANSFER))
    assert [attributes["id"] for tag, attributes in page.tags if tag == "h2"] == [
        *("result", "findings", "inputs", "steel", "stream", "cases", "receiver", "forces", "worked", "band"),
        *("assumptions", "references"),
    ]
    assert hashlib.sha256(TRANSFER.read_bytes()).hexdigest() in page.text
    assert f"exit velocity {solution.exit_velocity[0]:.3f} m/s" in page.text
    for finding in solution.findings():
        assert finding.code in page.text
        assert finding.message() in page.text
    for words in ("thickness_mm 25 mm", "spoon curve C D 81.00 30.00 3.560 4.000 5.101 -0.974", "5 of 5 get through"):
        assert words in page.text


def test_the_page_stands_alone_and_is_tagged(tmp_path, capsys):
    text = report(tmp_path, TRANSFER).read_text(encoding="utf-8")
    page = Page(text)
    assert not [tag for tag, _ in page.tags if tag in ("script", "link", "img", "iframe")]
    sources = [value for _, attributes in page.tags for name, value in attributes.items() if name in ("src", "href")]
    assert all(source.startswith(("#", "data:")) for source in sources)
    assert len(page.ids) == len(set(page.ids))
    labels = [attributes[name] for _, attributes in page.tags for name in ("aria-labelledby",) if name in attributes]
    assert labels
    assert set(labels) <= set(page.ids)
    uses = [attributes["xlink:href"][1:] for tag, attributes in page.tags if tag == "use"]
    clips = re.findall(r"url\(#([^)]+)\)", text)
    assert set(uses) | set(clips) <= set(page.ids)
    inside = [page.tags[number + 1][0] for number, (tag, _) in enumerate(page.tags) if tag == "svg"]
    assert inside == ["title"] * 3
    assert ("html", {"lang": "en"}) in page.tags


def test_text_of_users_is_text(tmp_path, capsys):
    hostile = "</style><script>alert(1)</script>\" & ' \\ {{ 7 * 7 }}"
    quoted = '"' + hostile.replace("\\", "\\\\").replace('"', '\\"') + '"'
    file = tmp_path / "hostile.toml"
    project = "".join(f"{key} = {quoted}\n" for key in Project.model_fields)
    text = TRANSFER.read_text(encoding="utf-8")
    text = re.sub("title = .*", lambda _: f"title = {quoted}", text, count=1)
    file.write_text(text.replace("[flow]", f"[project]\n{project}\n[flow]", 1), encoding="utf-8")
    page = page_of(tmp_path, file)
    assert not [tag for tag, _ in page.tags if tag == "script"]
    assert page.text.count(hostile) == 11  # the page's title, its heading, the title block, and a picture's title


def test_a_chute_that_fails_says_so_and_is_worked_where_it_fails(tmp_path, capsys):
    page = page_of(tmp_path, STALL, "--units", "us", status=1)
    assert "status stall" in page.text
    assert ("p", {"class": "outcome fails"}) in page.tags
    assert "where the stream enters the segment on which it ends" in page.text
    assert "661.387 short tons/h" in page.text
    assert page.text.count("26.59 ft") >= 2


def test_changed_keys_are_in_the_title_block(tmp_path, capsys):
    page = page_of(tmp_path, PAPER[0], "--set", "flow.rate_t_h=900")
    assert "Changed for this report flow.rate_t_h=900" in page.text
    assert "flow.rate_t_h 900 t/h" in page.text


def test_entries_of_a_library_are_shown_as_solved(tmp_path, capsys):
    library = tmp_path / "chute-library.toml"
    library.write_text('[materials."wet coal"]\ndensity_kg_m3 = 950\ninternal_friction_deg = 58\nsource = "test 7"\n')
    file = tmp_path / "spoon.toml"
    text = Path(PAPER[0]).read_text(encoding="utf-8")
    file.write_text(re.sub(r"\[material\]\n(.+\n)+", '[material]\nuse = "wet coal"\n', text), encoding="utf-8")
    page = page_of(tmp_path, file)
    assert f"Library {library}" in page.text
    assert "material.density_kg_m3 950 kg/m³" in page.text


def test_several_specs_are_compared(tmp_path, capsys):
    page = page_of(tmp_path, *PAPER)
    assert "Comparison of 2 chutes" in page.text
    start = page.text.index("What differs in the inputs")
    differs = page.text[start : page.text.index("Streams", start)]
    assert "segments.spoon.radius_m 2 m 3 m" in differs
    assert "flow.rate_t_h" not in differs
    assert len(page.ids) == len(set(page.ids))
    for file in PAPER:
        assert hashlib.sha256(Path(file).read_bytes()).hexdigest() in page.text


def test_the_same_report_is_the_same_bytes(tmp_path, capsys):
    first = report(tmp_path, PAPER[0]).read_bytes()
    assert report(tmp_path, PAPER[0]).read_bytes() == first


@pytest.mark.parametrize(
    ("target", "words"),
    [("report.doc", ".html or .pdf"), ("-", ".html or .pdf"), ("no/folder/report.html", "cannot be written")],
)
def test_what_cannot_be_written_is_told_before_solving(target, words, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("chutecalc.api.solve.run_chain", lambda *_: 1 / 0)
    assert main(["run", PAPER[0], "--report", target]) == 2
    assert words in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("library", "ending"), [("jinja2", "html"), ("matplotlib", "html"), ("weasyprint", "pdf")])
def test_a_missing_library_is_named(library, ending, tmp_path, monkeypatch, capsys):
    from importlib.util import find_spec

    monkeypatch.setattr("chutecalc.extras.find_spec", lambda name: None if name == library else find_spec(name))
    assert main(["run", PAPER[0], "--report", str(tmp_path / f"report.{ending}")]) == 3
    assert library in capsys.readouterr().err.lower()


def test_the_pdf_is_tagged_and_has_its_text(tmp_path, capsys):
    document = pypdf.PdfReader(report(tmp_path, STALL, status=1, ending="pdf"))
    root = document.trailer["/Root"]
    assert root["/MarkInfo"]["/Marked"]
    assert root["/Lang"] == "en"
    text = " ".join(page.extract_text() for page in document.pages)
    assert "page 1 of" in text
    texts = [element["/Alt"] for element in structure(root["/StructTreeRoot"]) if element.get("/S") == "/Figure"]
    assert len(texts) == 3
    assert all("from the side" in text or "along the stream" in text for text in texts)
    assert "status stall" in text


@in_browser
def test_a_browser_prints_it(tmp_path, capsys):
    printed = tmp_path / "printed.pdf"
    page = report(tmp_path, TRANSFER)
    run = [CHROMIUM, *QUIET, f"--user-data-dir={tmp_path / 'profile'}"]
    subprocess.run(
        [*run, "--no-pdf-header-footer", f"--print-to-pdf={printed}", page.as_uri()], check=True, timeout=120
    )
    document = pypdf.PdfReader(printed)
    text = " ".join(each.extract_text() for each in document.pages)
    assert 5 <= len(document.pages) <= 14
    assert "The formulas with their numbers" in text
    assert "page 2 of" in text


@in_browser
@pytest.mark.parametrize("width", [1200, 500])
def test_nothing_is_wider_than_the_screen(width, tmp_path, capsys):
    page = report(tmp_path, TRANSFER)
    measure = "<script>document.title = `${document.documentElement.scrollWidth} ${innerWidth}`</script>"
    measured = tmp_path / "measured.html"
    measured.write_text(page.read_text(encoding="utf-8").replace("</body>", f"{measure}</body>"), encoding="utf-8")
    dumped = browse(tmp_path, f"--window-size={width},900", "--dump-dom", measured.as_uri())
    needed, given = map(int, re.search(r"<title>(\d+) (\d+)</title>", dumped).groups())
    assert needed <= given


@pytest.mark.parametrize(
    "spec",
    [
        chutecalc.STARTER.replace("friction_deg = 25", "friction_deg = 0 "),
        re.sub(r"\[\[segments\]\]\nname = \"spoon\"\n(.+\n)+", "", chutecalc.STARTER),
    ],
    ids=["without friction", "a fall alone"],
)
def test_what_has_no_friction_or_no_steel_has_a_report(spec, tmp_path, capsys):
    file = tmp_path / "odd.toml"
    file.write_text(spec, encoding="utf-8")
    assert "status ok" in page_of(tmp_path, file).text


def test_a_comparison_tells_the_cases(tmp_path, capsys):
    choked = tmp_path / "choked.toml"
    text = TRANSFER.read_text(encoding="utf-8")
    choked.write_text(text + '\n[cases.Choked]\n"flow.rate_t_h" = 9000\n', encoding="utf-8")
    page = page_of(tmp_path, TRANSFER, choked, "--set", "sections.spoon.wall_height_m=0.4", status=1)
    assert re.search(r"B : status ok.*?5 of 6 get through", page.text)
    assert "failure choke Choked: spoon" in page.text
    alone = page_of(tmp_path, TRANSFER, choked, "--case", "surge")
    assert "What each gives in the case surge" in alone.text


def test_the_digest_is_that_of_the_file(tmp_path, capsys):
    file = tmp_path / "windows.toml"
    file.write_bytes(b"\xef\xbb\xbf" + chutecalc.STARTER.replace("\n", "\r\n").encode())
    assert hashlib.sha256(file.read_bytes()).hexdigest() in page_of(tmp_path, file).text


def test_a_program_that_changed_keys_is_said(tmp_path):
    chute, file = chutecalc.parse(chutecalc.STARTER), tmp_path / "report.html"
    chutecalc.write_report(str(file), chute.put({"flow.rate_t_h": 500}))
    assert "keys that a program has changed" in Page(file.read_text(encoding="utf-8")).text
    chutecalc.write_report(str(file), chute)
    assert "keys that a program has changed" not in Page(file.read_text(encoding="utf-8")).text
