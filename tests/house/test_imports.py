"""Imports go down the house only, as ARCHITECTURE.md lays it out."""

import ast
from pathlib import Path

import pytest

import chutecalc

ROOT = Path(chutecalc.__file__).parent
LEVELS = [
    {"printable", "registry", "runtime", "interrupt", "core"},
    {"errors", "physics"},
    {"extras", "design", "fields"},
    {"workers", "sections"},
    {"segments"},
    {"spec", "solver"},
    {"results"},
    {"output"},
    {"api"},
    {"studies"},
    {"dem"},
    {"glossary"},
    {"cli"},
]
LEVEL = {room: level for level, rooms in enumerate(LEVELS) for room in rooms}
FILES = sorted(path for path in ROOT.rglob("*.py") if path.parent != ROOT or path.stem not in {"__init__", "__main__"})


def room(module):
    """`spec` of `chutecalc.spec.chute_spec`; None outside the package's rooms."""
    parts = module.split(".")
    return parts[1] if parts[0] == "chutecalc" and parts[-1] not in {"chutecalc", "__version__"} else None


def imported(path):
    """Yield the modules that a file names in its imports, wherever they stand in it."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: relative import"
            yield node.module
            yield from (f"{node.module}.{name.name}" for name in node.names)
        elif isinstance(node, ast.Import):
            yield from (name.name for name in node.names)


def module_of(path):
    return ".".join(("chutecalc", *path.relative_to(ROOT).with_suffix("").parts)).removesuffix(".__init__")


@pytest.mark.parametrize("path", FILES, ids=module_of)
def test_imports_go_down(path):
    own = room(module_of(path))
    for module in imported(path):
        other = room(module)
        assert other is None or other == own or LEVEL[other] < LEVEL[own], f"{module_of(path)} imports {module}"


def test_no_circle_within_a_room():
    graph = {module_of(path): set(imported(path)) - {module_of(path)} for path in FILES}
    done = set()
    while len(done) < len(graph):
        free = {module for module, needs in graph.items() if module not in done and not (needs & graph.keys()) - done}
        assert free, f"a circle among {sorted(graph.keys() - done)}"
        done |= free


def test_every_room_has_its_level():
    assert {room(module_of(path)) for path in FILES} == LEVEL.keys()


def test_physics_knows_numpy_and_the_core_only():
    for path in (ROOT / "physics").glob("*.py"):
        for module in imported(path):
            assert module.startswith(
                ("numpy", "chutecalc.physics", "chutecalc.core", "typing", "collections", "functools")
            ), f"{path.name}: {module}"
