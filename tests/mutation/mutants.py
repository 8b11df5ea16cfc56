"""Make the mutants of a source file: each is a small replacement in its text."""

import ast
import re
from collections.abc import Iterator
from typing import NamedTuple

COMPARED = {
    "<": ("<=", ">"),
    "<=": ("<", ">="),
    ">": (">=", "<"),
    ">=": (">", "<="),
    "==": ("!=",),
    "!=": ("==",),
    "is": ("is not",),
    "is not": ("is",),
    "in": ("not in",),
    "not in": ("in",),
}
ARITHMETIC = {"+": "-", "-": "+", "*": "/", "/": "*", "//": "*", "%": "*", "**": "*", "&": "|", "|": "&", "^": "&"}
NAMES = {
    "min": "max",
    "minimum": "maximum",
    "fmin": "fmax",
    "argmin": "argmax",
    "nanmin": "nanmax",
    "any": "all",
    "floor": "ceil",
    "sin": "cos",
    "append": "pop",
    "nanargmin": "nanargmax",
    "keys": "values",
}
NAMES |= {there: here for here, there in NAMES.items() if here not in ("append", "keys")}
SYMBOLS = {
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Eq: "==",
    ast.NotEq: "!=",
    ast.Is: "is",
    ast.IsNot: "is not",
    ast.In: "in",
    ast.NotIn: "not in",
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.FloorDiv: "//",
    ast.Mod: "%",
    ast.Pow: "**",
    ast.BitAnd: "&",
    ast.BitOr: "|",
    ast.BitXor: "^",
    ast.And: "and",
    ast.Or: "or",
}
NUMBER_IN_TEXT = re.compile(rb"(?<![\w.{:#%])\d+(?:\.\d+)?(?![\w}])")
NAME_IN_TEXT = re.compile(rb"(?<=\{)[A-Za-z_][\w.]*(?=[}:!])")


class Mutant(NamedTuple):
    """A replacement in a file."""

    file: str
    line: int
    column: int
    kind: str
    new: str
    """Replacement text."""
    function: str
    """Qualified name of the function; empty outside of functions and classes."""
    lines: range
    """Lines of the statement, or of its head; empty where it runs when the module is imported."""
    span: tuple[int, int]
    """Start and end of the replaced text, in bytes."""

    @property
    def id(self) -> str:
        return f"{self.file}:{self.line}:{self.column}:{self.kind}:{self.new or 'none'}"

    def source(self, source: bytes) -> bytes:
        """Return the file with the fault."""
        return source[: self.span[0]] + self.new.encode() + source[self.span[1] :]

    def difference(self, source: bytes) -> tuple[str, str]:
        """Return the lines concerned before and after, without indentation, each joined to one line."""
        first, after = source.rfind(b"\n", 0, self.span[0]) + 1, source.find(b"\n", self.span[1])
        last = len(source) if after < 0 else after
        changed = source[first : self.span[0]] + self.new.encode() + source[self.span[1] : last]
        return " ".join(source[first:last].decode().split()), " ".join(changed.decode().split())


class Finder(ast.NodeVisitor):
    """Visitor that finds the possible replacements in a file."""

    def __init__(self, file: str, source: bytes) -> None:
        self.file, self.source = file, source
        self.starts = [0]
        for line in source.split(b"\n"):
            self.starts.append(self.starts[-1] + len(line) + 1)
        self.found: list[Mutant] = []
        self.names: list[str] = []
        self.lines, self.in_function, self.in_index = range(0), False, False
        self.visit(ast.parse(source))

    def offset(self, node: ast.expr | ast.stmt, end: bool = False) -> int:
        line, column = (node.end_lineno or 0, node.end_col_offset or 0) if end else (node.lineno, node.col_offset)
        return self.starts[line - 1] + column

    def add(self, kind: str, start: int, end: int, new: str) -> None:
        if self.source[start:end].decode() != new:
            line = self.source.count(b"\n", 0, start) + 1
            lines = self.lines if self.in_function else range(0)
            column = start - self.starts[line - 1] + 1
            self.found.append(Mutant(self.file, line, column, kind, new, ".".join(self.names), lines, (start, end)))

    def replace(self, kind: str, node: ast.expr | ast.stmt, *news: str) -> None:
        for new in news:
            self.add(kind, self.offset(node), self.offset(node, end=True), new)

    def replace_operator(self, kind: str, left: ast.expr, right: ast.expr, symbol: str, *news: str) -> None:
        """Replace the operator between two operands, which brackets and blanks may surround."""
        start, end = self.offset(left, end=True), self.offset(right)
        pattern = rf"(?<![\w<>=*/]){re.escape(symbol)}".replace("\\ ", r"\s+").encode()
        if match := re.search(pattern, self.source[start:end]):
            for new in news:
                self.add(kind, start + match.start(), start + match.end(), new)

    def visit(self, node: ast.AST) -> None:
        if isinstance(node, ast.stmt):
            body = getattr(node, "body", None)
            last = body[0].lineno - 1 if body and not isinstance(node, ast.Match) else node.end_lineno or 0
            self.lines = range(node.lineno, max(last, node.lineno) + 1)
            self.dropped(node)
        super().visit(node)

    def dropped(self, node: ast.stmt) -> None:
        """Return the statements that may be left out."""
        calls = isinstance(node, ast.Expr) and isinstance(node.value, ast.Call | ast.Yield | ast.YieldFrom)
        puts = isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Subscript)
        if calls or puts or isinstance(node, ast.AugAssign | ast.Raise | ast.Continue | ast.Break):
            self.replace("dropped", node, "pass")

    def visit_FunctionDef(self, node: ast.FunctionDef | ast.ClassDef) -> None:
        before = self.in_function, self.names
        self.names = [*self.names, node.name]
        if isinstance(node, ast.FunctionDef):
            self.in_function = False  # defaults are worked out with the module
            for default in [*node.args.defaults, *node.args.kw_defaults]:
                if default:
                    self.visit(default)
            self.in_function = True
        for item in node.body:
            self.visit(item)
        self.in_function, self.names = before

    visit_ClassDef = visit_FunctionDef  # noqa: N815

    def visit_AnnAssign(self, node: ast.AnnAssign) -> None:
        if node.value:
            self.visit(node.value)

    def visit_AugAssign(self, node: ast.AugAssign) -> None:
        symbol = SYMBOLS.get(type(node.op), "")
        if new := ARITHMETIC.get(symbol):
            self.replace_operator("arithmetic", node.target, node.value, f"{symbol}=", f"{new}=")
        self.generic_visit(node)

    def visit_Expr(self, node: ast.Expr) -> None:
        if not isinstance(node.value, ast.Constant):
            self.generic_visit(node)

    def visit_Return(self, node: ast.Return) -> None:
        if node.value and not (isinstance(node.value, ast.Constant) and node.value.value is None):
            self.replace("returned", node.value, "None")
        self.generic_visit(node)

    def visit_Compare(self, node: ast.Compare) -> None:
        for left, operator, right in zip([node.left, *node.comparators], node.ops, node.comparators, strict=False):
            symbol = SYMBOLS[type(operator)]
            self.replace_operator("compared", left, right, symbol, *COMPARED[symbol])
        self.generic_visit(node)

    def visit_BinOp(self, node: ast.BinOp) -> None:
        symbol = SYMBOLS.get(type(node.op), "")
        if symbol in ARITHMETIC:
            self.replace_operator("arithmetic", node.left, node.right, symbol, ARITHMETIC[symbol])
        self.generic_visit(node)

    def visit_BoolOp(self, node: ast.BoolOp) -> None:
        symbol = SYMBOLS[type(node.op)]
        for left, right in zip(node.values, node.values[1:], strict=False):
            self.replace_operator("boolean", left, right, symbol, "or" if symbol == "and" else "and")
        self.generic_visit(node)

    def visit_UnaryOp(self, node: ast.UnaryOp) -> None:
        start = self.offset(node)
        sign = re.compile(rb"not\s*|.").match(self.source, start)
        self.add("sign", start, sign.end() if sign else start, "")
        self.generic_visit(node)

    def visit_Call(self, node: ast.Call) -> None:
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        if name in NAMES:
            end = self.offset(node.func, end=True)
            self.add("name", end - len(name), end, NAMES[name])
        self.generic_visit(node)

    def visit_Subscript(self, node: ast.Subscript) -> None:
        self.visit(node.value)
        before, self.in_index = self.in_index, True
        self.visit(node.slice)
        self.in_index = before

    def visit_Slice(self, node: ast.Slice) -> None:
        for bound in (node.lower, node.upper):
            if bound and not isinstance(bound, ast.Constant):
                text = self.source[self.offset(bound) : self.offset(bound, end=True)].decode()
                self.replace("index", bound, f"{text} + 1", f"{text} - 1")
        self.generic_visit(node)

    def visit_Constant(self, node: ast.Constant) -> None:
        value = node.value
        if isinstance(value, bool):
            self.replace("truth", node, str(not value))
        elif isinstance(value, int | float):
            news = [repr(2 * value), repr(value + 1), repr(0 * value), *([repr(value - 1)] if self.in_index else [])]
            self.replace("number", node, *(new for new in dict.fromkeys(news) if eval(new) != value))
        elif isinstance(value, str):
            self.text(node)

    def visit_JoinedStr(self, node: ast.JoinedStr) -> None:
        self.text(node)

    def text(self, node: ast.expr) -> None:
        """Replace numbers in messages, and the names in their braces."""
        start = self.offset(node)
        source = self.source[start : self.offset(node, end=True)]
        if b" " not in source:
            return
        for match in NUMBER_IN_TEXT.finditer(source):
            number = ast.literal_eval(match[0].decode().lstrip("0") or "0")
            self.add("text", start + match.start(), start + match.end(), repr(2 * number or 1))
        names = list(NAME_IN_TEXT.finditer(source))
        for here, there in zip(names, names[1:] + names[:1], strict=True):
            self.add("text", start + here.start(), start + here.end(), there[0].decode())


def mutants(file: str, source: bytes) -> Iterator[Mutant]:
    """Yield all mutants of a file that are valid Python."""
    plain = ast.dump(ast.parse(source))
    for mutant in Finder(file, source).found:
        try:
            tree = ast.parse(mutant.source(source))
        except SyntaxError:
            continue
        if ast.dump(tree) != plain:
            yield mutant
