"""Chains of segments: the cost of joints, and what is not solved again when it does not change.

    python benchmarks/chains.py [--quick] [--out FOLDER]

The chute has five segments: a hood that the stream falls off, a flight onto a straight with an impact, a curve whose
chamfers the stream fills and leaves again (kinks), and a spoon. "single arcs" are the four contact segments as chutes
of their own, entered with the streams that the chain brings to them. Ratios are taken within the rounds.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from measure import Report, in_turn, median, ratio

import chutecalc
from chutecalc.solver.chain import run_chain

SPEC: dict[str, Any] = {
    "flow": {"rate_t_h": 1500.0},
    "material": {"density_kg_m3": 850.0, "internal_friction_deg": 50.0},
    "liners": {"steel": {"friction_deg": 24.0}},
    "sections": {
        "wide": {"shape": "rectangular", "width_m": 1.0},
        "body": {"shape": "chamfered", "base_m": 0.5, "chamfer_deg": 45.0, "chamfer_m": 0.12},
    },
    "inlet": {"velocity_m_s": 3.5, "slope_deg": 10.0},
    "receiver": {"velocity_m_s": 4.0, "friction_deg": 30.0},
    "segments": [
        {"kind": "hood", "radius_m": 1.0, "from_slope_deg": 15.0, "to_slope_deg": 70.0, "section": "wide"},
        {"kind": "fall", "drop_m": 1.0},
        {"kind": "straight", "slope_deg": 62.0, "length_m": 1.5, "section": "body"},
        {"kind": "curve", "radius_m": 3.0, "to_slope_deg": 45.0, "section": "body"},
        {"kind": "curve", "radius_m": 2.0, "to_slope_deg": 30.0, "section": "body"},
    ],
}


def singles(chain: chutecalc.Chute, rate: np.ndarray) -> list[chutecalc.Chute]:
    """Return each contact segment as a chute of its own, with the streams that the chain brings to it."""
    segment_solutions, _ = run_chain(chain.design, 1e-10, dense_output=False)
    chutes = []
    for solved in segment_solutions:
        if solved.contact is not None:
            segment = {"from_slope_deg": 50.0} | SPEC["segments"][solved.number]
            segment = {key: value for key, value in segment.items() if key != "from_slope_deg" or "radius_m" in segment}
            alone = chutecalc.parse(SPEC | {"segments": [segment]})
            slope = np.degrees(solved.contact.surface.slope)
            varied = {"flow.rate_t_h": rate, "inlet.velocity_m_s": solved.entry.velocity, "inlet.slope_deg": slope}
            if "radius_m" in segment:
                varied["segments.1.from_slope_deg"] = slope
            chutes.append(alone.vary(varied))
    return chutes


def ends(chute: chutecalc.Chute) -> Any:
    """Compute the exits of a batch on one core."""
    return run_chain(chute.design, 1e-10, dense_output=False)


def main() -> None:
    """Measure and print."""
    report = Report("chains", __doc__)
    count, rounds = (2000, 1) if report.quick else (100_000, 5)
    base = chutecalc.parse(SPEC)
    rate = np.random.default_rng(1).uniform(900.0, 1500.0, count)
    chain = base.vary({"flow.rate_t_h": rate})
    arcs = singles(chain, rate)
    varied = {
        "last segment": base.vary({"segments.5.radius_m": np.linspace(1.8, 2.2, count)}),
        "receiver": base.vary({"receiver.velocity_m_s": np.linspace(3.0, 5.0, count)}),
    }
    tasks: dict[str, Callable[[], Any]] = {
        "chain of five": partial(ends, chain),
        "single arcs": lambda: [ends(arc) for arc in arcs],
        "last arc alone": partial(ends, arcs[-1]),
        "chain, last segment varies": partial(ends, varied["last segment"]),
        "chain, receiver varies": partial(ends, varied["receiver"]),
        "chain, whole solution": lambda: run_chain(chain.design, 1e-10, dense_output=True),
    }
    spent, rivals = in_turn(tasks, rounds), ("single arcs", "last arc alone")
    rows = [
        (
            name,
            1e6 * median(times) / count,
            *(ratio(times, spent[rival]) for rival in rivals),
        )
        for name, times in spent.items()
    ]
    header = (f"{count} designs", "us_a_design", "over_single_arcs", "over_last_arc")
    report.write(header, rows, ("", ".3f", ".3f", ".3f"))
    report.bars({"chains": {name: spent for name, spent, *_ in rows}}, "µs a design")


if __name__ == "__main__":
    main()
