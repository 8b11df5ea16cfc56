"""What the documentation site has beside the pages in docs: hooks of MkDocs, and the gallery of standard designs."""
