"""Which cases are run, and which not again; without LAMMPS."""

from dataclasses import replace

import numpy as np
import pytest

from chutecalc.dem.campaign import LEVEL_ENOUGH, Campaign, Group
from chutecalc.dem.engine import RunError
from chutecalc.dem.store import Store
from chutecalc.workers import Threads
from tests.dem.beds import bed, case

SMALL = case(base=0.2, area=0.01, inclinations=(1.0,))


class Engine:
    """Makes beds at once, level where the spread is 0.3 and else tilted by half of what it is off."""

    def __init__(self, store, fails=()):
        self.cases = {}
        self.store, self.fails, self.stopped = store, fails, False

    def expect(self, *groups, spreads=(0.0, 0.3, 0.6)):
        for group in groups:
            for seed in range(group.seeds):
                self.learn(replace(group.case, seed=1 + seed))

    def learn(self, one):
        self.cases[one.name] = one

    def run(self, folder):
        one = self.cases[folder.name]
        if one.seed in self.fails:
            raise RunError("lost")
        made = bed(one, tilt=0.5 * (one.spread - 0.3))
        rows = np.column_stack([np.arange(one.count), made.positions])
        np.savetxt(folder / "bed.dump", rows, header="\n" * 8, comments="")
        (folder / "walls.txt").write_text(" ".join(map(str, [0.0, *made.forces.ravel()])))

    def stop(self):
        self.stopped = True


class RecordingStore(Store):
    """A store that tells the engine what a folder is."""

    engine: Engine

    def write(self, one):
        self.engine.learn(one)
        self.written = [*getattr(self, "written", []), one]
        return super().write(one)


@pytest.fixture
def make_campaign(tmp_path):
    def make(seeds=3, fails=()):
        store = RecordingStore(tmp_path)
        store.engine = Engine(store, fails)
        return Campaign([Group(SMALL, seeds)], store), store

    return make


def run(campaign, store, jobs=1):
    reports = []
    campaign.run(store.engine, Threads(jobs), lambda *numbers: reports.append(numbers))
    return reports


def test_the_pour_is_made_level_before_the_other_seeds_are_poured(make_campaign):
    campaign, store = make_campaign()
    reports = run(campaign, store)
    outcome = campaign.outcome(campaign.groups[0])
    assert [made.case.seed for made in outcome.beds] == [1, 2, 3]
    assert len({made.case.spread for made in outcome.beds}) == 1
    assert abs(outcome.beds[0].unevenness) <= LEVEL_ENOUGH
    assert [one.seed for one in store.written][-2:] == [2, 3]
    assert {one.seed for one in store.written[:-2]} == {1}
    assert outcome.needed == outcome.errors == ()
    assert reports[-1][0] == reports[-1][1] == len(store.written)
    assert all(done <= total for done, total in reports)


def test_a_second_call_runs_nothing_again(make_campaign):
    run(*make_campaign())
    again, store = make_campaign()
    assert run(again, store) == [(0, 0)]
    assert len(again.outcome(again.groups[0]).beds) == 3
    more, store = make_campaign(seeds=4)
    run(more, store)
    assert [one.seed for one in store.written] == [4]


def test_a_case_half_written_is_run_again(make_campaign):
    first, store = make_campaign()
    run(first, store)
    lost = first.outcome(first.groups[0]).beds[1].case
    walls = store.case_folder(lost) / "walls.txt"
    walls.write_text(walls.read_text()[:10])
    again, store = make_campaign()
    run(again, store)
    assert store.written == [lost]


def test_a_lost_case_loses_only_itself(make_campaign):
    campaign, store = make_campaign(fails=(2,))
    run(campaign, store, jobs=2)
    outcome = campaign.outcome(campaign.groups[0])
    assert [made.case.seed for made in outcome.beds] == [1, 3]
    assert len(outcome.errors) == 1
    assert "lost" in outcome.errors[0]
    whole, store = make_campaign()  # a second call tries it again
    run(whole, store)
    assert [one.seed for one in store.written] == [2]


def test_a_lost_first_case_stops_its_group(make_campaign):
    campaign, store = make_campaign(fails=(1,))
    run(campaign, store)
    outcome = campaign.outcome(campaign.groups[0])
    assert outcome.beds == outcome.needed == ()
    assert len(outcome.errors) == 1


def test_writing_goes_round_by_round(make_campaign):
    campaign, store = make_campaign()
    (first,) = campaign.write()
    assert first == SMALL
    assert {path.name for path in store.case_folder(first).iterdir()} == {"case.json", "particles.data", "in.lammps"}
    store.engine.run(store.case_folder(first))
    again, store = make_campaign()
    (second,) = again.write()
    assert second.spread > 0.0
    assert second.seed == 1


def test_an_interruption_ends_what_runs(make_campaign):
    campaign, store = make_campaign()

    def interrupt(done, total):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        campaign.run(store.engine, Threads(1), interrupt)
    assert store.engine.stopped


@pytest.mark.parametrize("file", ["walls.txt", "bed.dump"])
@pytest.mark.parametrize("word", ["nan", "inf", "1e999", "x", "\xff"])
def test_numbers_that_are_none_make_a_case_unread(tmp_path, file, word):
    store = Store(tmp_path)
    engine = Engine(store)
    engine.learn(SMALL)
    folder = store.write(SMALL)
    assert store.read(SMALL) is None
    engine.run(folder)
    assert store.read(SMALL) is not None
    *before, _ = (folder / file).read_text(encoding="utf-8").split(" ")
    (folder / file).write_text(" ".join([*before, word]), encoding="latin-1")
    assert store.read(SMALL) is None


@pytest.mark.parametrize("number", ["0", "1", "-1", "1e308"])
def test_particles_that_are_no_bed_make_a_case_unread(tmp_path, number):
    store = Store(tmp_path)
    engine = Engine(store)
    engine.learn(SMALL)
    bed = store.write(SMALL) / "bed.dump"
    engine.run(bed.parent)
    lines = bed.read_text(encoding="utf-8").splitlines()
    header, particles = lines[: -SMALL.count], lines[-SMALL.count :]
    flat = [" ".join([line.split()[0], *[number] * 3]) for line in particles]
    bed.write_text("\n".join([*header, *flat, ""]), encoding="utf-8")
    assert store.read(SMALL) is None
