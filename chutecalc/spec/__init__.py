"""The spec of a chute: read, checked, and turned once into numbers."""
