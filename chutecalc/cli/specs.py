"""Chutes of the specs that a command line names."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from chutecalc.errors import SHOWN, AllSpecsError, SpecError, UsageError
from chutecalc.printable import abbreviated
from chutecalc.spec.slips import value_fault

if TYPE_CHECKING:
    from chutecalc.api.chute import Chute


def read_chute(spec: str, settings: Sequence[str] = (), library: str | None = None) -> Chute:
    """Return the chute of a spec.

    Args:
        spec: path of its file, or ``-`` for standard input.
        settings: changes, as ``PATH=VALUE``.
        library: file of the materials and liners that it may use; None for the one beside it, if there is one.

    Raises:
        SpecError: the spec or a change has faults, those of changes laid on them.
        UsageError: the file is a baseline, or a setting is not ``PATH=VALUE``.
    """
    return read_with_content(spec, settings, library)[0]


def read_with_content(spec: str, settings: Sequence[str] = (), library: str | None = None) -> tuple[Chute, bytes]:
    """Return the chute of a spec, and the content of its file.

    Args:
        spec: path of its file, or ``-`` for standard input.
        settings: changes, as ``PATH=VALUE``.
        library: file of the materials and liners that it may use; None for the one beside it, if there is one.

    Raises:
        SpecError: as for :func:`read_chute`.
        UsageError: as for :func:`read_chute`.
    """
    from chutecalc.api.load import read

    changes = read_settings(settings)
    text, content, source = read_source(spec)
    try:
        return read(text, source, dict(changes.values()), library, file_of(spec)), content
    except SpecError as error:
        if not changes:
            raise
        from chutecalc.spec.faults import changed_faults

        arguments = {path: f"--set {setting}" for setting, (path, _) in changes.items()}
        raise SpecError(changed_faults(error.faults, arguments, text), error.source) from None


def file_of(spec: str) -> Path | None:
    """Return the path of a spec's file; None for standard input.

    Args:
        spec: path of its file, or ``-`` for standard input.
    """
    return None if spec == "-" else Path(spec)


def read_source(spec: str) -> tuple[str, bytes, str]:
    """Return the text of a spec, unchecked, the content of its file, and what messages call it.

    Args:
        spec: path of its file, or ``-`` for standard input.

    Raises:
        UsageError: the file is a baseline.
    """
    from chutecalc.spec.parse import decode
    from chutecalc.spec.reader import BASELINE_SUFFIX, STANDARD_INPUT, read_bytes, read_standard_input

    if spec.endswith(BASELINE_SUFFIX):
        chute = spec.removesuffix(BASELINE_SUFFIX) + ".toml"
        raise UsageError(f"{spec} is a baseline, not a chute. Run {chute}.")
    if spec == "-":
        content, source = read_standard_input(), STANDARD_INPUT
    else:
        content, source = read_bytes(Path(spec)), str(Path(spec))
    return decode(content, source), content, source


def read_chutes(specs: Sequence[str], settings: Sequence[str], library: str | None = None) -> list[Chute]:
    """Return the chutes of several specs.

    Args:
        specs: paths of their files. Baselines and libraries among them are left out, since a glob such as
            ``specs/*.toml`` matches them too.
        settings: changes in all of them, as ``PATH=VALUE``.
        library: file of the materials and liners that they may use; None for the one beside each.

    Raises:
        AllSpecsError: the faults of all specs.
        UsageError: a setting that is not ``PATH=VALUE``, or no spec but baselines.
    """
    from chutecalc.spec.library import LIBRARY_NAME
    from chutecalc.spec.reader import BASELINE_SUFFIX

    chutes: list[Chute] = []
    errors: list[SpecError] = []
    others = (BASELINE_SUFFIX, LIBRARY_NAME)
    for spec in [spec for spec in specs if not spec.endswith(others)] or specs:
        try:
            chutes.append(read_chute(spec, settings, library))
        except SpecError as error:
            errors.append(error)
    if errors:
        raise AllSpecsError(errors)
    return chutes


def read_settings(texts: Sequence[str]) -> dict[str, tuple[str, Any]]:
    """Return key path and value of each setting, by its text.

    Args:
        texts: ``PATH=VALUE`` each.

    Raises:
        UsageError: one is wrong, or two are of the same key.
    """
    first: dict[str, str] = {}
    changes = {}
    for text in texts:
        changes[text] = read_setting(text)
        path = changes[text][0]
        if path in first:
            raise UsageError(f"--set {first[path]} and --set {text} are of the same key. Keep one of them.")
        first[path] = text
    return changes


def read_setting(text: str) -> tuple[str, Any]:
    """Return key path and value of a setting.

    Args:
        text: ``PATH=VALUE``, with a value of TOML, or else text without quotes.

    Raises:
        UsageError: it has no path or no equals sign, or is neither a value nor text.

    >>> read_setting("segments.1.drop_m=2"), read_setting("title=Coal")
    (('segments.1.drop_m', 2), ('title', 'Coal'))
    """
    path, equals, value = text.partition("=")
    if not (path and equals):
        raise UsageError(f"--set takes PATH=VALUE, such as segments.1.drop_m=2, not {text!r}")
    from chutecalc.spec.parse import NotValue, parse_value

    path = path.strip()
    try:
        return path, parse_value(value)
    except NotValue:
        value = value.strip()
        if not re.match(r"[\[{\"'“„]|[-+−–]?[\d.,'’ ]++$", value) or not (fault := value_fault(path, value)):
            return path, value
    except SpecError as error:
        (fault,) = error.faults
    remedy = fault.remedy.replace(f"{path} = ", f"--set {path}=")
    raise UsageError(f"--set {abbreviated(text, SHOWN)} {fault.problem}. {remedy[0].upper()}{remedy[1:]}.")
