"""``freeze``: the bytes of the file that it writes."""

import io
import sys
from codecs import BOM_UTF8

import pytest

from chutecalc.cli import main

HEAD = """\
title = "Eßlingen"
flow.rate_t_h = 1000
material = {density_kg_m3 = 800, internal_friction_deg = 50}
liners.wall.friction_deg = 25
sections.body = {shape = "rectangular", width_m = 0.8}
inlet = {velocity_m_s = 3.0, slope_deg = 0.0}

[[segments]]
kind = "fall"
"""
SPOON = '\n# the spoon\n[[segments]]\nkind = "curve"\nradius_m = 2.0\nto_slope_deg = 20'
BEFORE = f"{HEAD}run_m = 1.0\n{SPOON}"
AFTER = f"{HEAD}onto_next = true\n{SPOON}\nstart_m = [1.0, -0.544813888889]\nfrom_slope_deg = 47.456010483798"


@pytest.mark.parametrize("mark", [b"", BOM_UTF8], ids=["", "mark"])
@pytest.mark.parametrize("line_end", ["\n", "\r\n"], ids=["LF", "CRLF"])
@pytest.mark.parametrize("last", ["", "\n", "\n# the end", "\n\n"])
def test_the_file_stays_as_it_was_in_every_other_byte(tmp_path, monkeypatch, capfdbinary, mark, line_end, last):
    def content(text):
        return mark + (text + last).replace("\n", line_end).encode()

    file, frozen = tmp_path / "chute.toml", tmp_path / "frozen.toml"
    file.write_bytes(content(BEFORE))
    assert main(["freeze", str(file), "-o", str(frozen)]) == 0
    assert frozen.read_bytes() == content(AFTER)
    assert main(["freeze", str(file)]) == 0
    assert capfdbinary.readouterr().out == content(AFTER)
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(content(BEFORE))))
    assert main(["freeze", "-"]) == 0
    assert capfdbinary.readouterr().out == content(AFTER)


def test_of_mixed_line_ends_the_first_counts(tmp_path):
    file, frozen = tmp_path / "chute.toml", tmp_path / "frozen.toml"
    file.write_bytes(BEFORE.encode().replace(b"\n", b"\r\n", 3))
    assert main(["freeze", str(file), "-o", str(frozen)]) == 0
    assert frozen.read_bytes() == AFTER.encode().replace(b"\n", b"\r\n")
