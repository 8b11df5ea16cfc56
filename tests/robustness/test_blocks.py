"""Whatever is done to the blocks of an interrupted sweep: it is found and said, and the file is the same."""

import io
import json
import os
import shutil

import numpy as np
import pytest

from chutecalc.cli import main
from chutecalc.cli.sweep_run import SweepRun
from chutecalc.spec.reader import LARGEST
from chutecalc.studies.sweep import sweep as rows_of
from chutecalc.studies.sweep.block_store import BlockStore
from chutecalc.studies.sweep.stored_block import DamagedError, packed, unpacked
from tests import seeds
from tests.robustness.conftest import SWEEP
from tests.robustness.written import check_lines

BLOCKS = 5


def block(target, number):
    return target.with_name("rows.csv.part") / f"{number:08d}.npz"


def without(path):
    path.unlink()


def short(path):
    path.write_bytes(path.read_bytes()[:-9])


def empty(path):
    path.write_bytes(b"")


def other_bit(path):
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 4
    path.write_bytes(content)


def other_head(path):
    path.write_bytes(path.read_bytes().replace(b'"rows": 4', b'"rows": 3', 1))


def no_head(path):
    path.write_bytes(path.read_bytes().partition(b"\n")[2])


def nested(path):
    path.write_bytes(b"[" * 100_000)


def nothing_but_numbers(path):
    path.write_bytes(b"1\n2")


def old_form(path):
    stream = io.BytesIO()
    np.savez(stream, x_m=np.zeros(4))
    path.write_bytes(stream.getvalue())


def of_another_place(path):
    shutil.copy(path.with_name("00000000.npz"), path)


def of_another_sweep(path):
    line, _, content = path.read_bytes().partition(b"\n")
    path.write_bytes(json.dumps(json.loads(line) | {"sweep": "0" * 64}).encode() + b"\n" + content)


def pipe(path):
    path.unlink()
    os.mkfifo(path)


def longer(path):
    path.write_bytes(path.read_bytes() + bytes(10_000))


def less_than_nothing(path):
    path.write_bytes(path.read_bytes().replace(b'"bytes": ', b'"bytes": -', 1))


def link_that_leads_nowhere(path):
    path.unlink()
    path.symlink_to("none")


DAMAGES = [without, short, empty, other_bit, other_head, no_head, nested, nothing_but_numbers, old_form]
DAMAGES += [of_another_place, of_another_sweep, pipe, longer, less_than_nothing, link_that_leads_nowhere]


@pytest.mark.parametrize("damage", DAMAGES, ids=lambda each: each.__name__)
def test_a_damaged_block_is_said_and_solved_again(damage, stopped, capsys):
    if damage is pipe and not hasattr(os, "mkfifo"):
        damage = without
    target, whole = stopped
    damage(block(target, 2))
    assert main([*SWEEP, "--csv", str(target), "--resume"]) == 0
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith(f"chutecalc: {target}.part/00000002.npz ")
    assert line.endswith(": it is solved again")
    assert target.read_bytes() == whole
    assert [path.name for path in target.parent.iterdir()] == ["rows.csv"]


def test_swapped_blocks_are_found(stopped, capsys):
    target, whole = stopped
    one, other = block(target, 1), block(target, 3)
    contents = one.read_bytes(), other.read_bytes()
    other.write_bytes(contents[0])
    one.write_bytes(contents[1])
    assert main([*SWEEP, "--csv", str(target), "--resume"]) == 0
    assert capsys.readouterr().err.count("is another block: it is solved again") == 2
    assert target.read_bytes() == whole


def test_blocks_that_vanish_while_others_are_solved_are_solved_again(stopped, capsys, monkeypatch):
    target, whole = stopped
    block(target, 4).unlink()
    save = BlockStore.save

    def vanishing(self, number, rows):
        save(self, number, rows)
        block(target, 1).unlink()

    monkeypatch.setattr(BlockStore, "save", vanishing)
    assert main([*SWEEP, "--csv", str(target), "--resume"]) == 0
    assert "00000001.npz is missing: it is solved again" in capsys.readouterr().err
    assert target.read_bytes() == whole


def test_any_bytes_anywhere(stopped, capsys):
    target, whole = stopped
    folder = target.with_name("rows.csv.part")
    kept = target.with_name("kept")
    shutil.copytree(folder, kept)
    for number in range(seeds.times(30)):
        draw = seeds.generator(19, number)
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(kept, folder)
        path = draw.choice(sorted(folder.glob("*")))
        content = bytearray(path.read_bytes())
        at = int(draw.integers(len(content)))
        content[at : at + int(draw.integers(40))] = draw.bytes(int(draw.integers(40)))
        path.write_bytes(content)
        status = main([*SWEEP, "--csv", str(target), "--resume"])
        told = capsys.readouterr().err
        if path.name == "sweep.json":
            assert status == 0 or (status == 2 and ("cannot be read" in told or "another sweep" in told)), told
        else:
            assert status == 0, told
        if status == 0:
            assert target.read_bytes() == whole
            target.unlink()


@pytest.mark.parametrize("text", ["", "[]", "3", '"x"', "null", "{", "[" * 5000, '{"x": 1}', "9" * 5000])
def test_what_says_which_sweep_it_is_may_be_anything(stopped, capsys, text):
    target, _ = stopped
    (target.with_name("rows.csv.part") / "sweep.json").write_text(text, encoding="utf-8")
    assert main([*SWEEP, "--csv", str(target), "--resume"]) == 2
    assert "rows.csv.part" in capsys.readouterr().err
    assert not target.exists()


def test_what_others_have_put_there_stays(stopped):
    target, _ = stopped
    mine = target.with_name("rows.csv.part") / "mine.txt"
    mine.write_text("mine", encoding="utf-8")
    assert main([*SWEEP, "--csv", str(target), "--resume"]) == 0
    assert [path.name for path in mine.parent.iterdir()] == ["mine.txt"]


def test_names_of_stores_are_shown_as_they_are_in_no_terminal(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(rows_of, "WHOLE", 4)
    command = [*SWEEP, "--csv", "r\x1b[2J"]
    with monkeypatch.context() as patch:
        patch.setattr(BlockStore, "remove", lambda self: None)
        assert main(command) == 0
    (tmp_path / "r\x1b[2J.part/00000000.npz").unlink()
    capsys.readouterr()
    assert main([*command, "--resume"]) == 0
    err = capsys.readouterr().err
    assert "r\\x1b[2J.part/00000000.npz is missing: it is solved again" in err
    check_lines(err)


@pytest.mark.parametrize("whole", [False, True])
def test_a_link_in_place_of_a_block_is_never_followed(whole, stopped, capsys):
    target, rows = stopped
    other = target.with_name("spec.toml")
    mine = block(target, 2).read_bytes() if whole else b"mine"
    other.write_bytes(mine)
    block(target, 2).unlink()
    block(target, 2).symlink_to("../spec.toml")
    assert main([*SWEEP, "--csv", str(target), "--resume"]) == 0
    assert "00000002.npz is no file: it is solved again" in capsys.readouterr().err
    assert (other.read_bytes(), target.read_bytes()) == (mine, rows)
    assert sorted(path.name for path in target.parent.iterdir()) == ["rows.csv", "spec.toml"]


@pytest.mark.parametrize("number", [2, BLOCKS - 1])
def test_a_folder_in_place_of_a_block_is_said_before_anything_is_solved(number, stopped, capsys, monkeypatch):
    target, whole = stopped
    block(target, 0).unlink()
    block(target, number).unlink()
    block(target, number).mkdir()
    with monkeypatch.context() as patch:
        patch.setattr(BlockStore, "save", None)
        assert main([*SWEEP, "--csv", str(target), "--resume"]) == 2
    assert f"{block(target, number)} is a folder in the place of a block: remove it" in capsys.readouterr().err
    block(target, number).rmdir()
    assert main([*SWEEP, "--csv", str(target), "--resume"]) == 0
    assert target.read_bytes() == whole


def test_no_more_is_read_than_a_block_has():
    class Endless(io.BytesIO):
        def read(self, size=-1):
            asked.append(size)
            return super().read(size)

    asked, content = [], b"".join(packed({"x_m": np.zeros(4)}, 0, "a digest"))
    for stored in (content + bytes(100), bytes(100), content.replace(b'"bytes": ', b'"bytes": -')):
        with pytest.raises(DamagedError, match="is damaged"):
            unpacked(Endless(stored), 0, "a digest", 4)
    assert all(0 <= size <= len(content) for size in asked)


def test_what_says_which_sweep_it_is_has_a_size(stopped, capsys):
    target, _ = stopped
    path = target.with_name("rows.csv.part") / "sweep.json"
    path.write_bytes(path.read_bytes() + b" " * (LARGEST + 1))
    assert main([*SWEEP, "--csv", str(target), "--resume"]) == 2
    assert "sweep.json cannot be read: remove" in capsys.readouterr().err


@pytest.mark.parametrize("moment", ["_write", "_needed", "_fill"])
def test_interrupted_at_any_moment_it_says_how_to_continue(moment, stopped, capsys, monkeypatch):
    target, whole = stopped

    def interrupt(*_, **__):
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(SweepRun, moment, interrupt)
        assert main([*SWEEP, "--csv", str(target), "--resume"]) == 130
    assert f"chutecalc: --resume continues from {target}.part" in capsys.readouterr().err.splitlines()
    assert main([*SWEEP, "--csv", str(target), "--resume"]) == 0
    assert target.read_bytes() == whole
