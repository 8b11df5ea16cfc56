"""Output: tables, data files, charts and pictures. Nothing here computes results."""
