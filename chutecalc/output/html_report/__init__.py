"""The report of a chute as a page of its own, for a client to read, print and sign."""
