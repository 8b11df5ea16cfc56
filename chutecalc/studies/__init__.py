"""Studies: many sections or designs, and what to learn of them."""
