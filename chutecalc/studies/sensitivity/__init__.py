"""How much each number of a spec changes what comes out."""
