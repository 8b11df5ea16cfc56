"""No file holds what belongs to one machine."""

import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
MACHINE = re.compile(r"/(?:home|Users|root|opt|mnt|work)/|[A-Z]:\\|index-url|\bpypi\.", re.IGNORECASE)

WIDTH = 120


def committed():
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=False)
    if listed.returncode:
        pytest.skip("not a clone: git does not list files here")
    return [ROOT / name for name in listed.stdout.split("\n") if name]


def test_no_file_names_a_machine_or_a_registry():
    own = Path(__file__)
    for path in committed():
        if path != own and path.is_file():
            assert not MACHINE.search(path.read_text(encoding="utf-8")), path


def test_lines_fit_and_end_clean():
    for path in committed():
        if path.suffix in {".md", ".toml", ".py"}:
            text = path.read_text(encoding="utf-8")
            assert not text or text.endswith("\n"), path
            assert "\t" not in text, path
            assert not re.search(r" +$", text, re.MULTILINE), path


def prose(text):
    """The lines of a Markdown page without code blocks and tables, with links as they are shown."""
    text = re.sub(r"^```.*?^```$", "", text, flags=re.DOTALL | re.MULTILINE)
    text = re.sub(r"!?\[([^]]*)\]\([^)]+\)", r"\1", text)
    return [line for line in text.splitlines() if not line.startswith("|")]


def test_prose_fits():
    for path in committed():
        if path.suffix == ".md":
            for line in prose(path.read_text(encoding="utf-8")):
                assert len(line) <= WIDTH, f"{path}: {line}"
