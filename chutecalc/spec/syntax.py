"""Words what is wrong with a text that is not TOML: which key, what is wrong with it, and what to write instead.

The parser tells the line. What is wrong there is looked for in the line itself, because the parser says little of it,
and each version of Python says it in other words.
"""

import re
import tomllib

from chutecalc.errors import Fault
from chutecalc.printable import abbreviated
from chutecalc.spec.lines import KEY, places
from chutecalc.spec.slips import LONGEST, invisible_fault, value_fault, without_comment

LISTS = ("segments",)
"""Tables of which there are several: their headers have double brackets."""
OTHER_FORMATS = {r"\{": "JSON", "---|- |\\w+:$": "YAML", "<": "XML", "```": "Markdown"}
"""How files in other formats begin."""
COMMENT = r"\s*(?://+|/\*+|;+|--+|%+|!+|REM\b)\s*(.*)"
"""Comments of other languages."""


def syntax_fault(text: str, message: str) -> Fault:
    r"""Return what is wrong with a text that is not TOML.

    Args:
        text: that could not be parsed.
        message: of the parser.

    >>> fault = syntax_fault("[flow]\nrate_t_h = 1'000", "Expected newline (at line 2, column 13)")
    >>> fault.text("spoon.toml")
    "spoon.toml:2: flow.rate_t_h = 1'000 is not a number as TOML writes it. Write rate_t_h = 1000."
    """
    lines = text.split("\n")
    found = re.search(r"\(at line (\d+), column (\d+)\)", message)
    number = int(found[1]) if found else len(lines)
    line = lines[number - 1]
    fault = _other_format(lines) or _given_twice(lines, number) or _not_closed(lines, number) or _slip(line)
    if fault is None:
        problem = f"is not valid TOML: {abbreviated(message.rpartition('(at ')[0].rstrip() or message, LONGEST)}"
        fault = Fault("", f"{problem}, column {found[2]}" if found else problem, "see https://toml.io")
    fault = fault if fault.line else fault._replace(line=number)
    place = next((place for place in places(text) if place.line == fault.line and not place.header), None)
    return fault._replace(path=place.path) if fault.path and place else fault  # with the tables that it is in


def _slip(line: str) -> Fault | None:
    """Return the fault of a line by itself."""
    if len(line) > LONGEST:
        return None
    return _header(line) or (_assignment(line) if re.search("[^=]=", line) else _statement(line))


def _other_format(lines: list[str]) -> Fault | None:
    """Return the fault of a file in another format, which shows where it begins."""
    number, first = next(((k, line.rstrip()) for k, line in enumerate(lines, 1) if line.strip()), (1, ""))
    name = next((name for mark, name in OTHER_FORMATS.items() if re.match(mark, first)), None)
    remedy = "run chutecalc new, which writes one to start from"
    return Fault("", f"this is {name}, and a spec is TOML", remedy, line=number) if name else None


def _given_twice(lines: list[str], number: int) -> Fault | None:
    """Return the fault of a table or a key that stands above already."""
    before = list(places("\n".join(lines[:number])))
    here = before.pop() if before else None
    if here is None or not here.location:
        return None
    if here.header and here.location[0] in LISTS and (own := _one_table(lines[:number], str(here.location[0]))):
        listed = here.location[0]
        return Fault("", f"[{listed}] is one table, and there are several", f"write [[{listed}]]", line=own)
    first = next((place.line for place in before if place.location == here.location), None)
    if first is None:
        return None
    if here.header:
        remedy = "put all its keys below one of the two headers"
        return Fault("", f"the table [{here.path}] is given twice, first in line {first}", remedy, line=here.line)
    return Fault(here.path, f"is given twice, first in line {first}", "keep one of the two", line=here.line)


def _one_table(lines: list[str], name: str) -> int | None:
    """Return the first line that has the name of a list in single brackets."""
    return next((k for k, line in enumerate(lines, 1) if re.match(rf"\s*\[\s*{name}\s*\]", line)), None)


def _not_closed(lines: list[str], number: int) -> Fault | None:
    """Return the fault of a list, a table or a text that goes on from lines above, and has no end."""
    above = [place for place in places("\n".join(lines[: number - 1])) if not place.header]
    if not above:
        return None
    begin = above[-1].line - 1
    key, _, value = lines[begin].partition("=")
    value, written = value.strip(), "\n".join(map(without_comment, lines[begin : number - 1]))
    closes = {"[": "]", "{": "}"}.get(value[:1], value[:3])
    count = written.count(closes)
    if value[:1] in ("[", "{") and written.count(value[0], len(key)) > count:
        if value[0] == "{":
            problem, remedy = (
                "is a table in braces, which must end in its line",
                f"write [{key.strip()}] above its keys",
            )
        else:
            problem, remedy = "is a list without an end", "close it with ]"
    elif closes in ('"""', "'''") and count == 1:
        problem, remedy = "is a text without an end", f"close it with {closes}"
    else:
        return None
    return Fault(key.strip(), problem, remedy, line=begin + 1)


def _header(line: str) -> Fault | None:
    """Return the fault of a header, whose brackets do not match or whose name is none."""
    bare = without_comment(line).strip()
    if "=" in bare or not (bare.startswith("[") or bare.endswith("]")):
        return None
    name = bare.strip("[] \t")
    if not re.fullmatch(KEY, name):
        return Fault("", "is not the header of a table", "use letters a to z, digits, - and _ in its name", bare)
    written = f"[[{name}]]" if name in LISTS else f"[{name}]"
    return Fault("", "is not the header of a table: its brackets do not match", f"write {written}", bare)


def _assignment(line: str) -> Fault | None:
    """Return the fault of a key or of its value."""
    key, _, value = (part.strip(" \t") for part in without_comment(line).partition("="))
    if fault := invisible_fault(key):
        return fault
    if comment := re.fullmatch(COMMENT, line):
        return Fault("", "a comment begins with #", f"write # {comment[1]}")
    plain = re.sub(r"\W+", "_", key, flags=re.ASCII).strip("_")
    if key.endswith(":"):
        return Fault(plain, "has := between key and value", f"write {plain} = {value}")
    if re.fullmatch(KEY, key):
        return value_fault(key, value)
    remedy = f"write {plain} = {value}" if plain else "use a key in letters a to z, such as radius_m"
    return Fault("", "is not a key: keys have letters a to z, digits, - and _", remedy, key or "nothing")


def _statement(line: str) -> Fault | None:
    """Return the fault of a line that is neither a header nor a key with a value."""
    if comment := re.fullmatch(COMMENT, line):
        return Fault("", "a comment begins with #", f"write # {comment[1]}")
    bare = without_comment(line).strip()
    if fault := invisible_fault(bare):
        return fault
    if re.match(r"<{7}|={7}|>{7}", bare):
        return Fault("", "is the mark of a merge that was not finished", "keep one of the two versions", bare)
    if re.match(r"- |```", bare):
        return Fault("", "is not TOML", "write key = value, or a header such as [flow]", bare)
    if pair := re.fullmatch(rf"({KEY})(?:\s*(:)\s*|(\s)\s*(?=[^\s\"']+$|[\"']))(\S.*)", bare):
        key, mark, _, value = pair.groups()
        problem = "has : between key and value" if mark == ":" else "has no = between key and value"
        return Fault(key, problem, f"write {key} = {_as_value(value)}")
    if name := re.fullmatch(rf"({KEY})\s*(:?)", bare):
        problem, remedy = "has no value", f"write {name[1]} = and its value, or [{name[1]}] for a table"
        return Fault(name[1], problem, remedy)
    return Fault("", "is not TOML", "write key = value, a header such as [flow], or # before a comment", bare)


def _as_value(text: str) -> str:
    """Return a text as a value: itself if it is one, else in quotes."""
    try:
        tomllib.loads(f"value = {text}")
    except tomllib.TOMLDecodeError:
        return '"' + text.strip("\"'") + '"'
    return text
