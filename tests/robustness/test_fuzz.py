"""Whatever a spec or a command line says: a result, or faults to correct. Never a traceback, a hang, a forged line."""

import copy
import tomllib
import warnings

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given
from hypothesis import strategies as st

import chutecalc
from chutecalc.spec.parse import decode
from tests.conftest import BASE, spec
from tests.robustness.commands import DOCUMENTED, command_lines, judge
from tests.robustness.faults import check_faults
from tests.robustness.hostile import contents
from tests.seeds import fuzzed

junk = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.floats(),
    st.text(max_size=8),
    st.lists(st.integers(), max_size=2),
    st.dictionaries(st.text(max_size=4), st.integers(), max_size=2),
)
STARTER = tomllib.loads(chutecalc.STARTER)


def locations(data, location=()):
    """Yield every location in nested tables."""
    yield location
    items = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for key, value in items:
        yield from locations(value, (*location, key))


def put(data, location, value):
    changed = copy.deepcopy(data)
    here = changed
    for item in location[:-1]:
        here = here[item]
    here[location[-1]] = value
    return changed


def check(data):
    """Parse and solve; faults must say where, what and how to correct it, and a solution must say how it ends."""
    try:
        solution = chutecalc.solve(chutecalc.parse(data))
    except chutecalc.SpecError as error:
        check_faults(error, data)
        return None
    assert solution.status[0] in {"ok", "stall", "choke", "contact_lost", "missed"}
    return solution


@fuzzed()
@given(st.sampled_from([location for location in locations(STARTER) if location]), junk)
def test_junk_anywhere_in_a_spec(location, value):
    check(put(STARTER, location, value))


@fuzzed()
@given(
    st.sampled_from([location for location in locations(STARTER) if location and isinstance(location[-1], str)]),
    st.text(max_size=10),
)
def test_a_key_misspelt(location, name):
    changed = copy.deepcopy(STARTER)
    here = changed
    for item in location[:-1]:
        here = here[item]
    here[name] = here.pop(location[-1])
    solution = check(changed)
    assert solution is None or name == location[-1] or location[:-1] in {("liners",), ("sections",)}


def judge_content(content: bytes) -> str:
    """Read and solve the content of a file, and return how that ends."""
    try:
        solution = check(decode(content, "x.toml"))
    except chutecalc.SpecError as error:  # of its encoding
        check_faults(error, content)
        return "refused"
    return "solved" if solution else "refused"


@fuzzed(200)
@given(contents)
def test_any_content_of_a_file(content):
    assert judge_content(content) in ("solved", "refused")


@fuzzed(60, suppress=(HealthCheck.data_too_large,))
@given(command_lines())
def test_any_command_line(line):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # as a command does
        assert judge(line).status in DOCUMENTED


def quantity(low, high):
    """Numbers over the admissible range, its edges and many decades."""
    spread = st.floats(np.log(low), np.log(high)).map(lambda x: float(np.clip(np.exp(x), low, high)))
    return st.one_of(spread, st.sampled_from([low, high]))


angle = st.one_of(st.floats(0.1, 90.0), st.sampled_from([0.1, 30.0, 45.0, 89.999999, 90.0]))
section = st.one_of(
    st.fixed_dictionaries({"shape": st.just("rectangular"), "width_m": quantity(0.01, 5.0)}),
    st.fixed_dictionaries(
        {"shape": st.just("chamfered"), "base_m": st.one_of(st.just(0.0), quantity(1e-3, 5.0)), "chamfer_deg": angle},
        optional={"chamfer_m": quantity(1e-3, 3.0), "wall_height_m": quantity(0.01, 3.0)},
    ),
    st.fixed_dictionaries({"shape": st.just("vee"), "chamfer_deg": angle}, optional={"chamfer_m": quantity(1e-3, 3.0)}),
)
slope = st.one_of(st.floats(0.0, 90.0), st.sampled_from([0.0, 90.0]))
anywhere = st.floats(-89.9, 90.0)
segment = st.one_of(
    st.fixed_dictionaries({"kind": st.just("straight"), "slope_deg": slope, "length_m": quantity(0.01, 50.0)}),
    st.fixed_dictionaries(
        {"kind": st.sampled_from(["curve", "hood"]), "radius_m": quantity(0.05, 500.0), "to_slope_deg": anywhere},
        optional={"from_slope_deg": anywhere},
    ),
    st.fixed_dictionaries({"kind": st.just("fall"), "drop_m": quantity(0.001, 20.0)}),
)
chutes = st.fixed_dictionaries(
    {
        "flow": st.fixed_dictionaries({"rate_t_h": quantity(0.001, 50_000.0)}),
        "material": st.fixed_dictionaries(
            {"density_kg_m3": quantity(100.0, 6000.0), "internal_friction_deg": st.floats(0.0, 89.0)}
        ),
        "liners": st.fixed_dictionaries({"wall": st.fixed_dictionaries({"friction_deg": st.floats(0.0, 60.0)})}),
        "sections": st.fixed_dictionaries({"body": section}),
        "inlet": st.fixed_dictionaries({"velocity_m_s": quantity(1e-3, 100.0), "slope_deg": anywhere}),
        "segments": st.lists(segment, min_size=1, max_size=4),
    }
)


@fuzzed()
@given(chutes)
def test_any_admissible_chute(data):
    solution = check(data)
    assume(solution is not None)  # Hypothesis draws others for those, and fails where most are refused
    status = solution.status[0]
    assert np.isfinite(solution.exit_velocity[0]) == (status == "ok")
    failures = [finding for finding in solution.findings() if finding.severity == "failure"]
    assert ["missed" if finding.code == "passed_by" else finding.code for finding in failures] == (
        [] if status == "ok" else [status]
    )
    table = solution.stations(points=7)
    reached = np.isfinite(table["s_m"][0])
    if not reached.any():  # flew off at the inlet
        assert (status, len(failures)) == ("missed", 1)
        return
    velocity, s = table["velocity_m_s"][0][reached], table["s_m"][0][reached]
    assert np.isfinite(velocity).all()
    assert (velocity >= 0.0).all()
    assert (np.diff(s) >= -1e-9 * max(1.0, s[-1])).all()
    depth, friction = table["depth_m"][0][reached], table["equivalent_friction"][0][reached]
    assert not (depth < 0.0).any()
    assert not (friction < np.tan(np.radians(data["liners"]["wall"]["friction_deg"])) * (1 - 1e-12)).any()
    energy = 0.5 * velocity**2 + 9.80665 * table["z_m"][0][reached]
    assert (np.diff(energy) <= 1e-9 * (1.0 + np.abs(energy[:-1]))).all()  # nothing but gravity drives


@pytest.mark.parametrize("rate", [0.001, 50_000.0])
@pytest.mark.parametrize("velocity", [0.1, 100.0])
@pytest.mark.parametrize("radius", [0.05, 500.0])
@pytest.mark.parametrize("angle", [0.1, 89.999999, 90.0])
@pytest.mark.parametrize("base", [0.0, 0.5])
def test_the_corners_of_the_admissible_space(rate, velocity, radius, angle, base):
    shape = {"shape": "chamfered", "base_m": base, "chamfer_deg": angle}
    data = spec(
        flow={"rate_t_h": rate},
        sections={"body": shape},
        inlet={"velocity_m_s": velocity, "slope_deg": 80.0},
        segments=[{"kind": "curve", "radius_m": radius, "to_slope_deg": 20.0}],
    )
    solution = check(data)
    deep = angle == 90.0 and rate > 1.0 and velocity < 1.0  # where it enters
    assert (solution is None) == (deep or (base == 0.0 and angle > 89.0))
    if solution is not None and solution.status[0] == "ok":
        assert 0.0 < solution.exit_velocity[0] < 200.0
    assert BASE["flow"]["rate_t_h"] == 1000.0
