"""Hooks of MkDocs: pages that are not in docs, links of the site, and nothing from elsewhere."""

import logging
import re
from functools import cache

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

from website import gallery
from website.api import api, formulas
from website.gallery import ROOT
from website.links import ELSEWHERE, with_site_links

LOG = logging.getLogger("mkdocs.hooks.website")
LOADED = re.compile(r"""<(?:script|img|iframe)[^>]* src=["']https?:[^>]*>|<link[^>]* href=["']https?:[^>]*>""")
"""What a browser would load from elsewhere."""


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
    return with_site_links(markdown, here, here if page.file.generated_by else f"docs/{here}")


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
