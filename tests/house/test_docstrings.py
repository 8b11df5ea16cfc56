"""Docstrings of the package: what each has to say, and that its references lead somewhere.

python -m tests.house.test_docstrings            prints how many functions describe their arguments and show an example
python -m tests.house.test_docstrings MODULE...  prints what is wrong with the docstrings of modules
"""

import ast
import importlib
import inspect
import re
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

import chutecalc

ROOT = Path(chutecalc.__file__).parent

NO_VERB = {
    *("a", "all", "an", "as", "by", "each", "every", "for", "from", "how", "if", "in", "it", "its", "no", "of", "one"),
    *(
        "some",
        "that",
        "the",
        "their",
        "these",
        "they",
        "this",
        "to",
        "what",
        "where",
        "whether",
        "which",
        "who",
        "with",
    ),
}
"""Words with which no summary of a function begins. Verbs in another mood than the imperative are found by Ruff."""
UNIT = re.compile(
    r"(?<![\w.'’])(?:mm|m[²³]?(?:/s[²³]?|²/s²)?|m³/s|1/(?:m|s|rad)|s|ms|rad|deg|degrees|°|[kM]?Pa|kg(?:/m³|/s)?|t/h"
    r"|k?W(?:/m²)?|N(?:/m)?|J|in g|SI|%)(?!\w)"
)
NO_UNIT = re.compile(
    r"\b(?:seconds|bytes|inches|points|characters|percent|ratios?|shares?|fractions?|coefficients?|tangents?|tan|sin|cos"
    r"|dimensionless|relative|numbers?|counts?|signs?|units?|as in|see)\b|:(?:func|meth|class|attr|data):`",
    re.IGNORECASE,
)
"""Words that name a unit, say that there is none, or refer to it."""
LONE_UNIT = re.compile(r"(?:m|m/s|m/s²|m²|m³|s|kg|kg/s|rad|deg|n|j|pa|kpa|w|w/m²|°)\.", re.IGNORECASE)
NUMERIC = re.compile(r"\b(?:float|Array|Values|NDArray|ArrayLike)\b")
BY_NAME = re.compile(r"\b(?:Callable|Mapping|dict|Literal)\b")
"""Types of what holds numbers of several units, by their names."""
ENTRY = re.compile(r"(\*{0,2}\w+(?:, \*{0,2}\w+)*)(?: \([^)]*\))?:(?: |$)")
REFERENCE = re.compile(r":(?:func|class|meth|data|mod|attr|exc):`([^`]+)`")
SECTIONS = ("Args:", "Returns:", "Raises:", "Yields:", "Attributes:", "Example:", "Examples:", "Note:", "Notes:")


class Item(NamedTuple):
    """A public function, method, property or class."""

    name: str
    node: ast.AST
    doc: str
    parent: ast.ClassDef | None

    @property
    def is_class(self):
        return isinstance(self.node, ast.ClassDef)

    @property
    def is_property(self):
        return not self.is_class and any(
            "property" in name or name.endswith(".setter") for name in decorators(self.node)
        )

    @property
    def arguments(self):
        """Return the arguments that callers give, with their annotations."""
        if self.is_class:
            made = [node for node in self.node.body if isinstance(node, ast.FunctionDef) and node.name == "__init__"]
            return arguments_of(made[0])[1:] if made else []
        found = arguments_of(self.node)
        static = "staticmethod" in decorators(self.node)
        return found[1:] if self.parent is not None and not static else found

    @property
    def described(self):
        """Descriptions of arguments by name."""
        text = self.doc
        if self.is_class:
            for node in self.node.body:
                if isinstance(node, ast.FunctionDef) and node.name == "__init__":
                    text += "\n\n" + (ast.get_docstring(node) or "")
        return entries(text)


def decorators(node):
    return [ast.unparse(decorator) for decorator in node.decorator_list]


def arguments_of(node):
    given = node.args
    found = [*given.posonlyargs, *given.args, *([given.vararg] if given.vararg else []), *given.kwonlyargs]
    found += [given.kwarg] if given.kwarg else []
    return [(one.arg, ast.unparse(one.annotation) if one.annotation else "") for one in found]


def is_command(node):
    """Return whether Typer makes a command of it: its arguments are described by their help."""
    given = [*node.args.defaults, *node.args.kw_defaults, *(one.annotation for one in node.args.args)]
    return any("typer." in ast.unparse(part) for part in given if part)


def entries(doc):
    """Return the entries of all ``Args:`` sections, by argument."""
    found, current, within = {}, (), False
    for line in doc.splitlines():
        text = line.strip()
        if text in SECTIONS or (text and not line.startswith(" ")):
            within = text == "Args:"
        elif within and text:
            entry = ENTRY.match(text) if line.startswith("    ") and not line.startswith("     ") else None
            if entry:
                current = [name.strip("* ") for name in entry[1].split(",")]
                found |= dict.fromkeys(current, "")
            for name in current:
                found[name] += " " + text
    return found


def module_of(path):
    return ".".join(("chutecalc", *path.relative_to(ROOT).with_suffix("").parts)).removesuffix(".__init__")


FILES = {module_of(path): path for path in sorted(ROOT.rglob("*.py"))}


@cache
def tree(module):
    return ast.parse(FILES[module].read_text(encoding="utf-8"))


def items(module):
    """Yield what is public in a module, with methods."""
    for node in tree(module).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.name.startswith("_"):
            yield Item(node.name, node, ast.get_docstring(node) or "", None)
            for method in node.body if isinstance(node, ast.ClassDef) else ():
                public = isinstance(method, ast.FunctionDef) and not method.name.startswith("_")
                if public and "overload" not in decorators(method):
                    yield Item(f"{node.name}.{method.name}", method, ast.get_docstring(method) or "", node)


def faults_of(item):
    """Yield what is wrong with one docstring."""
    summary, _, rest = item.doc.partition("\n")
    if not item.doc:
        yield "has no docstring"
        return
    if not summary.endswith(".") or (rest.strip() and not rest.startswith("\n")):
        yield "its summary is not one line that ends with a period"
    if summary.startswith("The same"):
        yield "its summary begins with 'The same'"
    if LONE_UNIT.fullmatch(summary):
        yield "its summary is a unit alone"
    if item.is_property:
        if NUMERIC.search(returned := returns(item.node)) and not BY_NAME.search(returned) and not has_unit(item.doc):
            yield "names no unit"
        return
    if not item.is_class:
        if summary.split()[0].strip("`,.").lower() in NO_VERB:
            yield f"its summary begins with {summary.split()[0]!r}, not with a verb"
        if is_command(item.node):
            return
    described = item.described
    for name, annotation in item.arguments:
        if name not in described:
            yield f"Args has no {name}"
        elif NUMERIC.search(annotation) and not BY_NAME.search(annotation) and not has_unit(described[name]):
            yield f"Args names no unit of {name}"


def has_unit(text):
    """Return whether a description names a unit, or says that there is none."""
    return bool(UNIT.search(text) or NO_UNIT.search(text))


def returns(node):
    return ast.unparse(node.returns) if node.returns else ""


@cache
def moods():
    """Lines whose docstring begins with a verb that is no imperative, by file: Ruff's D401."""
    options = ["--isolated", "--no-cache", "--select", "D401", "--output-format", "concise"]
    done = subprocess.run([sys.executable, "-m", "ruff", "check", *options, ROOT], capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    found = {}
    for line in done.stdout.splitlines():
        if match := re.match(r"(.+?):(\d+):\d+: D401 (.*)", line):
            found.setdefault(Path(match[1]).resolve(), []).append((int(match[2]), match[3]))
    return found


def strings(module):
    """Yield all docstrings of a module, also of attributes and private names, with the class of each."""

    def visit(node, parent):
        for child in ast.iter_child_nodes(node):
            if (
                isinstance(child, ast.Expr)
                and isinstance(child.value, ast.Constant)
                and isinstance(child.value.value, str)
            ):
                yield child.value.value, parent
            yield from visit(child, child.name if isinstance(child, ast.ClassDef) else parent)

    yield from visit(tree(module), None)


def references(module):
    """References in docstrings, with the class in which each stands."""
    for text, parent in strings(module):
        for name in REFERENCE.findall(text):
            yield re.sub(r"\s+", "", name).removeprefix("~"), parent


def resolves(name, module, parent=None):
    """Return whether a reference names something, as seen from a module and a class in it."""
    candidates = [name, f"{module}.{name}"] + ([f"{module}.{parent}.{name}"] if parent else [])
    return any(found(candidate) for candidate in candidates)


def found(name):
    """Return whether a dotted name can be imported."""
    parts = name.split(".")
    for count in range(len(parts), 0, -1):
        try:
            thing = importlib.import_module(".".join(parts[:count]))
        except ImportError:
            continue
        for number, part in enumerate(parts[count:]):
            if hasattr(thing, part):
                thing = getattr(thing, part)
            elif inspect.isclass(thing):
                return part in fields(thing)
            else:  # what is compiled without a name at run time
                return not number and part in compiled_names(".".join(parts[:count]))
        return True
    return False


def fields(thing):
    """Attributes of instances that a class declares or sets in its __init__."""
    declared = {name for base in thing.__mro__ for name in getattr(base, "__annotations__", {})}
    made = thing.__dict__.get("__init__")
    try:
        return declared | set(re.findall(r"self\.(\w+)", inspect.getsource(made))) if made else declared
    except (OSError, TypeError):
        return declared


def compiled_names(module):
    if not module.startswith("chutecalc.core") or module not in FILES:
        return set()
    return {node.name for node in tree(module).body if isinstance(node, ast.FunctionDef | ast.ClassDef)}


@cache
def faults(module):
    """Return all that is wrong with the docstrings of a module."""
    found_faults = [
        f"{name}: leads nowhere" for name, parent in references(module) if not resolves(name, module, parent)
    ]
    if not module.startswith("chutecalc.core"):
        found_faults += [f"{item.name}: {fault}" for item in items(module) for fault in faults_of(item)]
        lines = {item.node.body[0].lineno: item.name for item in items(module)}
        moods_of = moods().get(FILES[module].resolve(), [])
        found_faults += [f"{lines[line]}: {fault}" for line, fault in moods_of if line in lines]
    return found_faults


@pytest.mark.parametrize("module", FILES)
def test_docstrings(module):
    assert not faults(module), "\n".join(faults(module))


SAMPLE = '''
def area(width: float, depth: Array, name: str, factor: float = 1.0) -> float:
    """{}

    Args:
        width, depth: Of the stream, m.
        name: Any.
        {}
    """
'''


@pytest.mark.parametrize(
    ("summary", "entry", "fault"),
    [
        ("Compute the area.", "factor: A ratio.", None),
        ("Compute the area", "factor: A ratio.", "period"),
        ("The area.", "factor: A ratio.", "not with a verb"),
        ("The same, of all.", "factor: A ratio.", "The same"),
        ("M².", "factor: A ratio.", "a unit alone"),
        ("Compute the area.", "factor: Of safety.", "names no unit of factor"),
        ("Compute the area.", "other: A ratio.", "Args has no factor"),
    ],
)
def test_each_fault_is_found(summary, entry, fault):
    node = ast.parse(SAMPLE.format(summary, entry)).body[0]
    found_faults = list(faults_of(Item("area", node, ast.get_docstring(node), None)))
    assert found_faults == [] if fault is None else any(fault in one for one in found_faults)


def test_references_that_lead_nowhere_are_found():
    assert resolves("chutecalc.physics.pressure.pressure_ratio", "chutecalc")
    assert resolves("pressure_ratio", "chutecalc.physics.pressure")
    assert not resolves("chutecalc.physics.section.excess_friction", "chutecalc")
    assert not resolves("chutecalc.physics.nothing", "chutecalc")


def counts():
    """Return how many public functions there are, have arguments, describe them all, and show an example."""
    functions = [item for module in FILES if not module.startswith("chutecalc.core") for item in items(module)]
    functions = [item for item in functions if not item.is_class and not item.is_property and not is_command(item.node)]
    taking = [item for item in functions if item.arguments]
    described = [item for item in taking if {name for name, _ in item.arguments} <= item.described.keys()]
    return len(functions), len(taking), len(described), sum(">>>" in item.doc for item in functions)


def main(arguments):
    if arguments:
        for module in arguments:
            print("\n".join(f"{module}: {fault}" for fault in faults(module)))
    else:
        functions, taking, described, shown = counts()
        print(
            f"{described} of {taking} public functions with arguments describe them ({100 * described / taking:.0f} %)"
        )
        print(f"{shown} of {functions} public functions show an example ({100 * shown / functions:.0f} %)")


if __name__ == "__main__":
    main(sys.argv[1:])
