"""Hooks of MkDocs: pages that are not in docs, and links as a code host has them, turned into those of the site.

A page keeps the links that work where its file is read. Here each is resolved to a file of the project, and written
anew as the way from page to page.
"""

import logging
import posixpath
import re
from functools import cache

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

from website import gallery
from website.api import api, formulas
from website.gallery import ROOT

ELSEWHERE = {
    "README.md": "index.md",
    "docs/README.md": "contents.md",
    "CHANGELOG.md": "changelog.md",
    "CONTRIBUTING.md": "contributing.md",
    "ARCHITECTURE.md": "architecture.md",
    "LICENSE": "licence.md",
    "CITATION.cff": "CITATION.cff",
    "specs": "specs/index.md",
    "specs/README.md": "specs/index.md",
    "specs/fails": "specs/index.md",
    "specs/paper": "specs/index.md",
}
"""Where files and folders of the project are on the site, if not in docs or specs."""
LOG = logging.getLogger("mkdocs.hooks.website")
LOADED = re.compile(r"""<(?:script|img|iframe)[^>]* src=["']https?:[^>]*>|<link[^>]* href=["']https?:[^>]*>""")
"""What a browser would load from elsewhere."""
LINK = re.compile(r"(\]\()(?![a-z]+:|#)([^)\s#]+)")
FENCE = re.compile(r"^(```.*?^```)$", re.DOTALL | re.MULTILINE)


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add what is not in docs.

    Args:
        files: what MkDocs has found.
        config: of the site.
    """
    beside = files.get_file_from_path("README.md")  # of docs; MkDocs would make it the home page
    if beside is not None:
        files.remove(beside)
    for there, content in _made().items():
        files.append(File.generated(config, there, content=content))
    return files


@cache
def _made() -> dict[str, str | bytes]:
    """Return what is not in docs, by its path on the site; once while `mkdocs serve` runs, since drawing takes time."""
    chosen = gallery.designs()
    pictures = gallery.draw_all(chosen)
    return {
        **{there: (ROOT / name).read_bytes() for name, there in ELSEWHERE.items() if (ROOT / name).is_file()},
        **{f"specs/{one.name}.md": gallery.page(one, pictures[one.name]) for one in chosen},
        **{f"specs/{one.name}.svg": pictures[one.name].picture for one in chosen},
        "specs/index.md": gallery.index(chosen, pictures),
        "licence.md": f"# Licence\n\n{(ROOT / 'LICENSE').read_text(encoding='utf-8')}",
        "api.md": api(),
        "formulas.md": formulas(),
    }


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Turn links to files of the project into links of the site.

    Args:
        markdown: text of the page.
        page: where it is.
        config: of the site.
        files: of the site.
    """
    here = page.file.src_uri
    sources = {there: name for name, there in ELSEWHERE.items() if (ROOT / name).is_file()}
    source = sources.get(here, here if page.file.generated_by else f"docs/{here}")
    parts = FENCE.split(markdown)  # every other one is a block of code
    parts[::2] = [LINK.sub(lambda link: link[1] + linked(link[2], source, here), part) for part in parts[::2]]
    return "".join(parts)


def linked(link: str, source: str, here: str) -> str:
    """Return a link of the site.

    >>> linked("../specs/vee.toml", "docs/spec.md", "spec.md")
    'specs/vee.md'
    >>> linked("docs/spec.md", "README.md", "index.md")
    'spec.md'

    Args:
        link: as the page of the project has it, without anchor.
        source: path of that page in the project.
        here: path of the page on the site.
    """
    target = posixpath.normpath(posixpath.join(posixpath.dirname(source), link))
    if target.startswith("specs/") and target.endswith(".toml"):
        there = target.removesuffix(".toml") + ".md"
    else:
        there = ELSEWHERE.get(target, target.removeprefix("docs/"))
    return posixpath.relpath(there, posixpath.dirname(here) or ".")


def on_post_page(output: str, page: Page, config: MkDocsConfig) -> str:
    """Warn of what a page would load from elsewhere.

    Args:
        output: the page, as HTML.
        page: which it is.
        config: of the site.
    """
    for found in LOADED.findall(output):
        LOG.warning("%s loads from elsewhere: %s", page.file.src_uri, found)
    return output
