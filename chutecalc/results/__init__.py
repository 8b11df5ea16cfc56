"""What came out: the stream along the chute, by the names of the column catalogue."""
