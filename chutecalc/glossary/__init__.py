"""Every word of specs, tables and findings, explained from the catalogues that define it."""
