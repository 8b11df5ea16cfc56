"""Aims: which values of some keys give what is wanted."""
