"""Chutes of the specs that a command line names."""

from __future__ import annotations

import re
import sys
import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from chutecalc.errors import AllSpecsError, SpecError, UsageError
from chutecalc.spec.slips import value_fault

if TYPE_CHECKING:
    from chutecalc.api.chute import Chute

STANDARD_INPUT = "standard input"


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

    changes = {setting: read_setting(setting) for setting in settings}
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
    from chutecalc.spec.parse import BASELINE_SUFFIX, decode, read_bytes

    if spec.endswith(BASELINE_SUFFIX):
        chute = spec.removesuffix(BASELINE_SUFFIX) + ".toml"
        raise UsageError(f"{spec} is a baseline, not a chute. Run {chute}.")
    if spec == "-":
        content, source = sys.stdin.buffer.read(), STANDARD_INPUT
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
    from chutecalc.spec.parse import BASELINE_SUFFIX

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
    try:
        return path.strip(), tomllib.loads(f"value = {value}")["value"]
    except tomllib.TOMLDecodeError:
        value = value.strip()
        if re.match(r"[\[{\"'“„]|[-+−–]?[\d.,'’ ]+$", value) and (fault := value_fault(path, value)):
            remedy = fault.remedy.replace(f"{path} = ", f"--set {path}=")
            raise UsageError(f"--set {text} {fault.problem}. {remedy[0].upper()}{remedy[1:]}.") from None
        return path.strip(), value
