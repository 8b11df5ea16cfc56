"""Mutation testing: small faults put into the code at random, and whether any test notices them.

    python -m tests.mutation --count 350 --seed 7 --rooms physics solver --jobs 2 --json out.json
    python -m tests.mutation --only chutecalc/physics/belt.py:40:12:number:0.0

Tests are run once to record which of them reach which line (`reach`); that is kept in `.mutation` until files change.
Then each mutant (`mutants`) has only the tests that reach it, fastest first, until one fails, in a copy of the project
and a process of its own, forked from one that has loaded all but the project (`process`). What survives is a hole in
the tests, unless `tests/mutation_accepted.txt` says why not. Seed, count and source give the same mutants; the status
is 1 where any is left over.
"""
