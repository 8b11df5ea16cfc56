"""From a numeric description to the stream along it."""
