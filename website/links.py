"""Links as a code host has them, turned into those of the site.

A page keeps the links that work where its file is read. Here each is resolved to a file of the project, and written
anew as the way from page to page.
"""

import posixpath
import re

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
LINK = re.compile(r"(\]\()(?![a-z]+:|#)([^)\s#]+)")
FENCE = re.compile(r"^(```.*?^```)$", re.DOTALL | re.MULTILINE)


def with_site_links(markdown: str, here: str, source: str) -> str:
    """Return the text of a page with links of the site.

    Args:
        markdown: text of the page.
        here: its path on the site.
        source: its path in the project, if it is not one of those elsewhere.
    """
    source = next((name for name, there in ELSEWHERE.items() if there == here and "." in name), source)
    parts = FENCE.split(markdown)  # every other one is a block of code
    parts[::2] = [LINK.sub(lambda link: link[1] + linked(link[2], source, here), part) for part in parts[::2]]
    return "".join(parts)


def linked(link: str, source: str, here: str) -> str:
    """Return a link of the site.

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
