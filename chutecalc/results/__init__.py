"""Results: the stream along the chute by the names of the column catalogue, and findings about it."""
