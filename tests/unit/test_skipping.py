"""What a scene does not need is not done: counted, not timed."""

import numpy as np
import pytest

import chutecalc
from chutecalc.core.records import FIELDS
from chutecalc.design import Status
from chutecalc.results.stream_column import StreamColumn
from chutecalc.solver import chain, contact_profile
from chutecalc.solver.chain import run_chain
from chutecalc.solver.panels import Panels
from chutecalc.studies.sweep.design_rows import design_rows
from tests.conftest import ROOT

CHAIN = {
    "flow": {"rate_t_h": 1000.0},
    "material": {"density_kg_m3": 800.0, "internal_friction_deg": 45.0},
    "liners": {"steel": {"friction_deg": 22.0}},
    "sections": {"body": {"shape": "chamfered", "base_m": 0.5, "chamfer_deg": 45.0}},
    "inlet": {"velocity_m_s": 3.0, "slope_deg": 60.0},
    "receiver": {"velocity_m_s": 3.0, "friction_deg": 30.0},
    "segments": [
        {"kind": "straight", "slope_deg": 60.0, "length_m": 1.0},
        {"kind": "fall", "drop_m": 1.0},
        {"kind": "curve", "radius_m": 3.0, "from_slope_deg": 65.0, "to_slope_deg": 30.0},
    ],
}


@pytest.fixture
def panels(monkeypatch):
    """Return how many panels have been tried by each design of each stretch."""
    tried = []
    solve = chain.batch_call.solve

    def counting(chute, *arguments):
        done = solve(chute, *arguments)
        segment_solutions = np.asarray(chute.solutions).reshape(-1, len(FIELDS))[: chute.count]
        on_surfaces = segment_solutions[segment_solutions[:, FIELDS.index("segment")] != 1]  # that one is a fall
        tried.extend(on_surfaces[:, FIELDS.index("attempts")].astype(int).tolist())
        return done

    monkeypatch.setattr(chain.batch_call, "solve", counting)
    return tried


def test_a_design_whose_first_pair_agrees_is_not_refined(panels):
    radii = np.linspace(2.0, 4.0, 500)
    run_chain(chutecalc.parse(CHAIN).vary({"segments.3.radius_m": radii}).design, 1e-10, dense_output=False)
    assert panels == [1] * (1 + 500)  # the straight once for all, the curve once for each


def test_a_stall_takes_few_panels(panels):
    """The whole segment, some panels in c as long as rejected ellipses allow, one in r; halving takes one more."""
    stalls = CHAIN | {"inlet": {"velocity_m_s": 2.0, "slope_deg": 60.0}, "segments": [CHAIN["segments"][2]]}
    many = chutecalc.parse(stalls).vary({"liners.steel.friction_deg": np.linspace(45.0, 60.0, 50)})
    assert (run_chain(many.design, 1e-10, dense_output=False)[1].status == Status.STALL).all()
    assert np.mean(panels) < 5.2


def test_what_comes_before_the_varied_segment_is_solved_once(panels):
    many = chutecalc.parse(CHAIN).vary({"segments.3.radius_m": np.linspace(2.0, 4.0, 500)})
    segment_solutions, _ = run_chain(many.design, 1e-10, dense_output=False)
    assert [solved.exit.velocity.shape for solved in segment_solutions] == [(1,), (1,), (500,)]


def test_a_varied_receiver_solves_the_chute_once(panels):
    many = chutecalc.parse(CHAIN).vary({"receiver.velocity_m_s": np.linspace(2.0, 4.0, 500)})
    solution = chutecalc.solve(many)
    assert panels == [1, 1]
    assert solution.receiver["velocity_ratio"].shape == (500,)
    assert len(set(solution.receiver["velocity_ratio"])) == 500


def test_exits_keep_nothing_of_the_way():
    segment_solutions, _ = run_chain(chutecalc.parse(CHAIN).design, 1e-10, dense_output=False)
    assert all(solved.contact.panels.store.size == 0 for solved in segment_solutions if solved.contact)


def test_columns_that_are_not_asked_for_are_not_worked_out(monkeypatch):
    def never(*arguments):
        raise AssertionError("worked out")

    monkeypatch.setattr(contact_profile.profile, "tabulate_wall_loads", never)
    monkeypatch.setattr(contact_profile.critical_velocity, "critical_velocities", never)
    monkeypatch.setattr(Panels, "times", never)
    solution = chutecalc.solve(chutecalc.parse(CHAIN))
    table = solution.stations(columns=("velocity_m_s", "depth_m"))
    assert list(table) == ["velocity_m_s", "depth_m"]
    assert np.isfinite(solution.exit_velocity).all()


def test_extremes_and_impacts_take_no_other_columns(monkeypatch):
    """They once sampled every column along the stream: a sweep of a million took five times as long."""
    asked, values = [], StreamColumn.values
    monkeypatch.setattr(StreamColumn, "values", lambda self, *at: asked.append(self.name) or values(self, *at))
    rows = design_rows(chutecalc.parse(CHAIN), 1, ["exit_slope_deg", "min_velocity_m_s", "max_impact_wear_w_m2"], 1e-10)
    assert rows["max_impact_wear_w_m2"] > 0.0
    assert set(asked) == {"slope_deg", "velocity_m_s"}


def test_threads_and_chunks_do_not_change_a_digit(monkeypatch):
    many = chutecalc.parse(CHAIN).vary({"segments.3.radius_m": np.linspace(2.0, 4.0, 100)})
    whole = chutecalc.exits(many, jobs=1)
    monkeypatch.setattr("chutecalc.api.batch.CHUNK", 16)
    parts = chutecalc.exits(many, jobs=4)
    for name, values in whole.exit.items():
        assert (parts.exit[name] == values).all()
    assert (parts.receiver["velocity_ratio"] == whole.receiver["velocity_ratio"]).all()
    assert (parts.status == whole.status).all()


def test_exits_agree_with_the_whole_solution():
    many = chutecalc.parse(CHAIN).vary({"segments.3.radius_m": np.linspace(2.0, 4.0, 20)})
    ends, whole = chutecalc.exits(many, 1e-12), chutecalc.solve(many, 1e-12)
    assert np.abs(ends.exit["velocity_m_s"] / whole.exit_velocity - 1.0).max() < 2e-12
    assert np.abs(ends.exit["depth_m"] / whole.exit_depth - 1.0).max() < 2e-12
    assert (ends.status == whole.status).all()


@pytest.mark.parametrize("columns", [("time_s",), ("no_such",)])
def test_columns_that_an_exit_does_not_have(columns):
    with pytest.raises(chutecalc.UsageError, match="no column"):
        chutecalc.exits(chutecalc.parse(CHAIN), columns=columns)


def test_an_unknown_column_is_refused_in_the_same_words_everywhere():
    spoon = chutecalc.parse(chutecalc.STARTER)
    solution = chutecalc.solve(spoon)
    for where, ask in (
        ("at the exit", lambda names: solution.exit_columns(names)),
        ("at a station", lambda names: solution.stations(columns=names)),
        ("at an exit alone; for time, use solve", lambda names: chutecalc.exits(spoon, columns=names)),
    ):
        with pytest.raises(chutecalc.UsageError) as caught:
            ask(["s_m", "depth", "nope"])
        assert str(caught.value) == (
            f"there is no column depth, nope {where}. Did you mean depth_m? `chutecalc columns` lists all"
        )
    with pytest.raises(chutecalc.UsageError, match="there is no column segment at the exit"):
        solution.exit_columns("segment")


def test_edges_are_flown_for_those_who_ask(monkeypatch):
    """The inlet, exits and columns of sweeps do without; findings and edges solve each edge once."""
    solved = []

    def counting(*arguments, **options):
        solved.append(arguments)
        return run_chain(*arguments, **options)

    monkeypatch.setattr("chutecalc.results.landings.run_chain", counting)
    chute = chutecalc.load(ROOT / "specs" / "troughed_belt_hood.toml")
    chutecalc.exits(chute)
    solution = chutecalc.solve(chute)
    assert solution.inlet["material_depth_m"][0] > 0.0
    assert np.isfinite(solution.exit_velocity).all()
    assert not solved
    solution.findings()
    assert [edge.name for edge in solution.edges] == ["lower", "middle", "upper", "free"]
    assert len(solved) == 3  # the middle is the stream itself
