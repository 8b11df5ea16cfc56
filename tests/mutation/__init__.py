"""Mutation testing: put small faults into the code at random and report those that no test notices.

    python -m tests.mutation --count 350 --seed 7 --rooms physics solver --jobs 2 --json out.json
    python -m tests.mutation --only chutecalc/physics/belt.py:40:12:number:0.0

Tests are run once to record which of them reach which line (`reach`); `.mutation` has the record until files change.
Then each mutant (`mutants`) runs only the tests that reach it, fastest first, until one fails, in a copy of the project
and a process of its own, forked from one that has loaded all but the project (`process`). A mutant that survives
shows a hole in the tests, unless `tests/mutation_accepted.txt` gives a reason. The same seed, count and source give the
same mutants; the status is 1 if any survives.
"""
