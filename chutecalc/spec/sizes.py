"""The sizes of what a chute file gives besides its segments: what is taken, and what is plausible, with the reasons."""

from chutecalc.fields.plausible import Plausible

FLOWS = Plausible(
    *(0.001, 0.05, 50_000.0, 1e6),
    *("a trickle", "more than any belt carries"),
    *("is grain by grain, no stream", "is more than all the belts of a mine carry"),
)
WEIGHS = Plausible(
    *(0.01, 1.0, 25.0, 2000.0),
    *("weaker than on the Moon", "stronger than on any planet"),
    *("is as good as weightless", "is stronger than in any centrifuge with a model"),
)
DENSE = Plausible(
    *(2.0, 100.0, 7000.0, 25_000.0),
    *("lighter than sawdust", "denser than any ore"),
    *("is nearly as light as air", "is denser than any metal"),
)
COARSE = Plausible(
    *(1e-6, 5e-5, 2.0, 20.0),
    *("as fine as dust", "larger than any crusher takes"),
    *("is finer than smoke", "is as large as a house"),
)
RATIO = Plausible(
    0.001, 0.05, 1.0, 1.0, "next to nothing", "more than all of it", "is as good as none", "is more than all of it"
)
SHEARED = Plausible(
    *(1.0, 1.0, 1.5, 2.0),
    *("less than a uniform profile has", "more than any profile that rests on the floor has"),
    *("is less than a uniform profile has", "is more than any profile has"),
)
PRESSES = Plausible(
    *(0.0, 0.005, 200.0, 1e4),
    *("less than a millimetre of material weighs", "more than any chute bears"),
    too_large="is more than any steel bears",
)
LINES = Plausible(
    *(1e-6, 0.0005, 0.5, 5.0),
    *("as thin as paint", "thicker than any liner"),
    *("is thinner than paint", "is thicker than any chute"),
)
WEARS = Plausible(
    *(1e-15, 1e-9, 1.0, 1e6),
    *("less than any liner loses", "softer than any liner"),
    *("is no wear", "is worn away at once"),
)
TURNS = Plausible(
    0.0, 1.0, 180.0, 180.0, "no angle to speak of", "more than half a turn", too_large="is more than half a turn"
)
RUNS = Plausible(
    *(0.001, 0.01, 40.0, 200.0),
    *("hardly a motion", "faster than a stream in any chute"),
    *("is as good as at rest", "is faster than any stream, of a flight through all of a mine too"),
)
