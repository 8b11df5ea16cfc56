"""Showing what came out. Nothing here computes."""
