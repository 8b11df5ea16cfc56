"""A sweep that was killed once all its blocks were stored, for all tests of what is done to them."""

import pytest

from chutecalc.cli import main
from chutecalc.studies.sweep import sweep as rows_of
from chutecalc.studies.sweep.block_store import BlockStore
from tests.cli.sweep.commands import SPOON

SWEEP = ["sweep", "radius=2:4:#4", "phi=20:24:#5", SPOON]


@pytest.fixture
def stopped(tmp_path, monkeypatch, capsys):
    """Return the path of a file whose blocks are all stored, and what the file is to be."""
    monkeypatch.setattr(rows_of, "WHOLE", 4)
    target = tmp_path / "rows.csv"
    with monkeypatch.context() as patch:
        patch.setattr(BlockStore, "remove", lambda self: None)
        assert main([*SWEEP, "--csv", str(target)]) == 0
    whole = target.read_bytes()
    target.unlink()
    capsys.readouterr()
    return target, whole
