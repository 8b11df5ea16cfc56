"""Judges random cases on the command line: so many of them, each from its seed."""

import argparse
from collections import Counter
from functools import partial
from multiprocessing import Pool
from typing import Any


def main(judged: Any, what: str, arguments: list[str] | None = None) -> int:
    """Judge the cases of some seeds, and print each that is wrong with its seed.

    Args:
        judged: returns a verdict and what is wrong, from a seed.
        what: the command does.
        arguments: of the command line.
    """
    parser = argparse.ArgumentParser(description=what)
    parser.add_argument("cases", type=int)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args(arguments)
    of = range(options.first, options.first + options.cases)
    counts: Counter[str] = Counter()
    with Pool(options.jobs) as pool:
        for seed, (verdict, wrong) in zip(of, pool.imap(partial(_judged, judged), of, chunksize=5), strict=True):
            counts[verdict] += 1
            if wrong:
                print(f"seed {seed}: {verdict}", *wrong[:6], sep="\n  ", flush=True)
            if seed % 100 == 99:
                print(seed + 1, dict(counts), flush=True)
    print(dict(counts))
    return int(counts["wrong"] + counts["not solved"] > 0)


def _judged(judged: Any, seed: int) -> tuple[str, list[str]]:
    """Judge a case; one that the solver gives up is told apart."""
    try:
        return judged(seed)
    except RuntimeError as error:
        return "not solved", [str(error)]
