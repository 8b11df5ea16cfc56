"""What the user writes: read, checked, and turned once into numbers."""
