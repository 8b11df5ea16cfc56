"""A shape of section and a kind of segment is one file: found by itself, and spelt nowhere else."""

import ast
import sys
from importlib import import_module
from pathlib import Path

import pytest

import chutecalc
from chutecalc.design import Contact
from chutecalc.fields.registry import variants
from chutecalc.sections.base import Section
from chutecalc.sections.registry import SHAPES
from chutecalc.segments.base import Segment
from chutecalc.segments.registry import KINDS
from tests.conftest import chute

ROOT = Path(chutecalc.__file__).parent
SHAPE = '''
from typing import Literal

from chutecalc.sections.base import Section


class Own(Section):
    """A shape."""

    shape: Literal["{}"]
'''


@pytest.mark.parametrize("tables", [SHAPES, KINDS], ids=["sections", "segments"])
def test_each_variant_has_a_module_of_its_own_with_an_example(tables):
    modules = [table.__module__ for table in tables.values()]
    assert len(modules) == len(set(modules))
    assert modules == sorted(modules)
    for name, table in tables.items():
        assert f'= "{name}"' in table.example
        assert table.__doc__
        assert table.build not in (Section.build, Segment.build)


def test_nothing_else_spells_a_kind_or_a_shape():
    names = {*SHAPES, *KINDS}
    paths = [path for path in ROOT.rglob("*.py") if path.parent.name not in {"sections", "segments", "core"}]
    spelt = [
        f"{path}:{node.lineno} spells {node.value!r}"
        for path in paths
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Constant) and node.value in names
    ]
    assert paths
    assert spelt == []


def test_a_new_module_is_a_new_variant_and_two_of_one_name_are_refused(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(tmp_path)
    package = tmp_path / "shapes_of_a_test"
    package.mkdir()
    (package / "__init__.py").touch()
    (package / "one.py").write_text(SHAPE.format("own"), encoding="utf-8")
    try:
        found = variants(import_module(package.name), Section, "shape")
        assert [(shape, table.__module__) for shape, table in found.items()] == [("own", "shapes_of_a_test.one")]
        (package / "two.py").write_text(SHAPE.format("own"), encoding="utf-8")
        with pytest.raises(
            ValueError, match=r"'own' is registered twice, in shapes_of_a_test.one and in shapes_of_a_test.two"
        ):
            variants(sys.modules[package.name], Section, "shape")
    finally:
        for name in [name for name in sys.modules if name.startswith(package.name)]:
            del sys.modules[name]


def test_only_a_plate_deflects():
    slopes = {"slope_deg": 40.0, "length_m": 1.0}
    for kind, deflects in (("plate", True), ("straight", False)):
        (segment,) = chute(segments=[{"kind": kind} | slopes]).design.segments
        assert isinstance(segment, Contact)
        assert (segment.deflects, segment.radius) == (deflects, None)
