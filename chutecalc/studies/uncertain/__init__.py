"""How sure the answer is: uncertain numbers of a spec, the spread of what comes out, and which of them matter."""
