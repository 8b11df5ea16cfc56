"""Standard designs held to what once came out of them."""
