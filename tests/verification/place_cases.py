"""Placed segments of random scenes against brute grids of starts and slopes, which know no closed form.

python -m tests.verification.place_cases 10000    compares so many, and prints each that is wrong with its seed
"""

import re

import numpy as np

import chutecalc
from chutecalc.errors import UsageError
from tests.verification.judging import main

HEAD = {
    "flow": {"rate_t_h": 800.0},
    "material": {"density_kg_m3": 850.0, "internal_friction_deg": 45.0},
    "liners": {"wall": {"friction_deg": 22.0}},
    "sections": {"body": {"shape": "rectangular", "width_m": 0.9}},
}
SIDES = {"hood": -1.0, "plate": -1.0, "curve": 1.0, "straight": 1.0}
WITHIN = 1e-9
"""Incidence, degrees, and share within which a written spec must do what was asked."""


NEAR = 0.01
"""Distance along the surface within which the grid has a strike where it is wanted, m."""
RESOLVED = 0.1
"""What the grid resolves of an incidence, degrees: a shift by ``NEAR`` turns an arc of 0.5 m by a degree, but with its
start, so that the incidence changes by what the stream turns on that way, and by the spacing of slopes, 0.0005°."""


def scene(random):
    """Return a random spec with a fall and one segment, and a random wish for that."""
    kind = str(random.choice(list(SIDES)))
    table = {"name": "one", "kind": kind}
    if kind in ("hood", "curve"):
        table |= {"radius_m": random.uniform(0.5, 5.0), "to_slope_deg": random.uniform(-20.0, 90.0)}
    else:
        table |= {"length_m": random.uniform(0.3, 3.0), "slope_deg": random.uniform(0.0, 90.0)}
    if kind in ("hood", "curve") and random.random() < 0.5:
        table["from_slope_deg"] = random.uniform(-60.0, min(80.0, table["to_slope_deg"]))
    inlet = {"velocity_m_s": random.uniform(0.5, 6.0), "slope_deg": random.uniform(-40.0, 80.0)}
    wish = {"share": float(random.choice([0.0, random.uniform(0.0, 0.9)]))}
    if random.random() < 0.8:
        wish["incidence"] = random.uniform(0.0, 40.0)
    if "incidence" not in wish or random.random() < 0.7:
        place = "x" if random.random() < 0.5 else "z"
        wish[place] = random.uniform(-0.5, 4.0) * (1.0 if place == "x" else -1.0)
    return HEAD | {"inlet": inlet, "segments": [{"kind": "fall", "onto_next": True}, table]}, wish


def struck(spec):
    """Return how the stream first meets the last segment of a spec: its share, incidence, x and z, or None."""
    solution = chutecalc.solve(chutecalc.parse(spec), 1e-12)
    solved = next(each for each in solution.trajectory.segment_solutions if each.number == 1)
    arrival = solved.contact.arrival
    if not np.isfinite(arrival.share[0]):
        return None
    entry = solved.entry
    return arrival.share[0], np.degrees(arrival.incidence[0]), entry.x[0], entry.z[0]


def missing_slope(table):
    return table["kind"] in ("hood", "curve") and "from_slope_deg" not in table


def grid_misses(data, wish):
    """Return how near the incidence of a wish can be had on a fine grid of starts and slopes, without closed forms.

    A second grid lies about the best of the first.
    """
    table, inlet = data["segments"][1], data["inlet"]
    downward = inlet["velocity_m_s"] * np.sin(np.radians(inlet["slope_deg"]))
    free = "incidence" in wish and ("x" in wish or "z" in wish)
    ends = table.get("to_slope_deg", 90.0)
    low, high = 0.0 if table["kind"] == "straight" else -89.9, ends - 1e-6 if table["kind"] == "hood" else 90.0
    slopes = np.linspace(low, high, 400) if free else np.array([table.get(slope_key(table), np.nan)])
    times = np.linspace(0.0, 4.0, 4001)
    if "x" in wish or "z" in wish:
        forward = inlet["velocity_m_s"] * np.cos(np.radians(inlet["slope_deg"]))
        x, z = forward * times, -downward * times - 0.5 * 9.80665 * times**2
        off = x - wish["x"] if "x" in wish else np.where(downward + 9.80665 * times >= 0.0, wish["z"] - z, np.nan)
        near = np.flatnonzero((off[:-1] <= 0.0) & (off[1:] > 0.0))
        times = times[near] + 1e-3 * off[near] / (off[near] - off[near + 1])
    if not len(times) or high <= low:
        return np.inf
    slope, time, best = tried(data, wish, slopes, times)
    if not best < 5.0:
        return best
    slopes = np.clip(np.linspace(slope - 0.5, slope + 0.5, 2001), low, high) if free else slopes
    times = times if len(times) == 1 else np.maximum(np.linspace(time - 0.002, time + 0.002, 2001), 0.0)
    return tried(data, wish, slopes, times)[2]


def slope_key(table):
    return "from_slope_deg" if table["kind"] in ("hood", "curve") else "slope_deg"


def tried(data, wish, slopes, times):
    """Return the slope and time of the strike, of all combinations, whose incidence is nearest, and how near it is."""
    table, inlet = data["segments"][1], data["inlet"]
    arc, key = table["kind"] in ("hood", "curve"), slope_key(table)
    begins, time = (each.ravel() for each in np.meshgrid(slopes, times))
    forward, downward = (inlet["velocity_m_s"] * f(np.radians(inlet["slope_deg"])) for f in (np.cos, np.sin))
    x, z = forward * time, -downward * time - 0.5 * 9.80665 * time**2
    turn = np.radians(table["to_slope_deg"] - begins) if arc else np.zeros(len(begins))
    length = table["radius_m"] * np.abs(turn) if arc else np.full(len(begins), table["length_m"])
    slope = np.radians(begins) + turn * (wish["share"] * (np.arange(400)[:, None] + 0.5) / 400)  # midpoint rule
    step = length * wish["share"] / 400
    starts = x - (np.cos(slope) * step).sum(axis=0), z + (np.sin(slope) * step).sum(axis=0)
    first = table | {key: min(10.0, table.get("to_slope_deg", 90.0) - 1.0), "start_m": [0.0, 0.0]}
    chute = chutecalc.parse(HEAD | {"inlet": inlet, "segments": [data["segments"][0], first]})
    changes = {"segments.one.start_m.1": starts[0], "segments.one.start_m.2": starts[1], f"segments.one.{key}": begins}
    solution = chutecalc.solve(chute.vary(changes))
    arrival = next(each for each in solution.trajectory.segment_solutions if each.number == 1).contact.arrival
    close = np.abs(arrival.share - wish["share"]) * length < NEAR
    off = np.abs(np.degrees(arrival.incidence) - wish.get("incidence", np.degrees(arrival.incidence)))
    off = np.where(close & np.isfinite(off), off, np.inf)
    return begins[off.argmin()], time[off.argmin()], off.min()


def nearest(data, wish, message):
    """Return how near the incidence of a wish can be had, as a message says; infinite where it is not to be had."""
    table = data["segments"][1]
    if found := re.search(r"the nearest is an incidence of (?:less than |more than )?([\d.]+)°", message):
        return abs(float(found[1]) - wish["incidence"])
    if found := re.search(r"the nearest is a share of ([\d.e-]+)", message):
        longest = table.get("length_m", table.get("radius_m", 0.0) * np.pi)
        return 0.0 if (wish["share"] - float(found[1])) * longest < 2 * NEAR else np.inf
    return np.inf


def judge(seed):
    """Return how a random scene ends, and what is wrong: it must do what was asked, or no grid may find a place."""
    random = np.random.default_rng(seed)
    data, wish = scene(random)
    table = data["segments"][1]
    if missing_slope(table) and not {"incidence"} < wish.keys() - {"share"}:
        return "no slope", []  # the spec does not tell it, and the wish does not either
    try:
        placement = chutecalc.place(data, {"one": wish})
    except UsageError as error:
        possible = grid_misses(data, wish) <= min(nearest(data, wish, str(error)), 2 * RESOLVED) - RESOLVED
        return ("wrong", [f"the grid finds a place: {error}"]) if possible else ("refused", [])
    found = struck(placement.text)
    if found is None:
        return "wrong", ["it is not struck"]
    share, incidence, x, z = found
    grazing = max(np.radians(incidence), 1e-4)  # the places are written to 1e-12 m
    off = {"share": share - wish["share"], "x": x - wish.get("x", x), "z": z - wish.get("z", z)}
    wrong = [f"{name} is off by {by}" for name, by in off.items() if abs(by) > WITHIN / grazing]
    if abs(incidence - wish.get("incidence", incidence)) > np.degrees(WITHIN):
        wrong.append(f"the incidence is {incidence}, not {wish['incidence']}")
    return ("wrong", wrong) if wrong else ("placed", [])


if __name__ == "__main__":
    raise SystemExit(main(judge, "Compares placed segments of random scenes with brute grids."))
