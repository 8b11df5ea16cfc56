"""All files are written by one module: it holds them, writes them whole, and names them where that fails."""

import ast

import pytest

from tests.house.test_imports import FILES, module_of

WRITERS = {
    "chutecalc.output.files",
    "chutecalc.output.locks",
    "chutecalc.output.scratch",  # folders for temporary files, which it removes
    "chutecalc.cli.streams",  # the null device, in place of a stream that is closed
    "chutecalc.dem.engine",  # what LAMMPS prints, while it prints
}
METHODS = {"write_text", "write_bytes", "touch", "mkdtemp", "mkstemp", "NamedTemporaryFile", "TemporaryFile", "fdopen"}
METHODS |= {"replace", "rename"}


def writes(path):
    """Yield the calls of a file that write one. `str.replace` has two arguments and more than `os` before it."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if not isinstance(node, ast.Call):
            continue
        function = node.func
        name = function.id if isinstance(function, ast.Name) else getattr(function, "attr", "")
        owner = getattr(getattr(function, "value", None), "id", "")
        mode = [arg.value for arg in node.args if isinstance(arg, ast.Constant) and isinstance(arg.value, str)]
        if (
            (name == "open" and any(set(text) & set("wax+") and len(text) <= 3 for text in mode))
            or (name in METHODS and (name not in {"replace", "rename"} or owner == "os"))
            or (name in {"savez", "save", "savefig"} and node.args and isinstance(node.args[0], ast.Constant))
        ):
            yield ast.unparse(node)


@pytest.mark.parametrize("path", FILES, ids=module_of)
def test_no_other_module_writes_a_file(path):
    assert module_of(path) in WRITERS or not list(writes(path))
