"""Many variants of one chute, a row each."""
