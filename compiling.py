"""Build backend: that of setuptools, with a C compiler among the requirements where the machine has none."""

import os
import shutil
import sys
import sysconfig
from pathlib import Path
from typing import Any

from setuptools import build_meta
from setuptools.build_meta import *  # noqa: F403 - a backend has all of these functions

WHEEL_DATE = "315532800"
"""Of every file in a wheel, 1980-01-01, the first that a ZIP file can hold: the same source makes the same bytes."""
os.umask(0o022)  # of all that a build writes: permissions are in a wheel too
ZIG = f"'{sys.executable}' -m ziglang cc -mcpu=baseline"  # for any processor, not only this one


def compile_requested() -> bool:
    """Return whether the core shall be compiled."""
    return os.environ.get("CHUTECALC_COMPILE", "1") != "0"


def has_headers() -> bool:
    """Return whether Python's headers are installed, which no compiler has."""
    return any(Path(sysconfig.get_path(name), "Python.h").exists() for name in ("include", "platinclude"))


def needs_zig() -> bool:
    """Return whether the build has to install a compiler."""
    if sys.platform == "win32" or "CC" in os.environ:
        return False
    usual = (sysconfig.get_config_var("CC") or "cc").split()[0]
    return not any(shutil.which(name) for name in (usual, "cc", "gcc", "clang"))


def build_wheel(wheel_directory: str, config_settings: Any = None, metadata_directory: str | None = None) -> str:
    """Build a wheel. Its bytes depend on the source, the interpreter and the compiler, not on the day or the folder."""
    os.environ.setdefault("SOURCE_DATE_EPOCH", WHEEL_DATE)
    return str(build_meta.build_wheel(wheel_directory, config_settings, metadata_directory))


def _requirements() -> list[str]:
    """Return what compiling needs beyond setuptools."""
    compiler = ["ziglang>=0.13"] if needs_zig() else []
    return ["cython>=3.1", *compiler] if compile_requested() and has_headers() else []


def get_requires_for_build_wheel(config_settings: Any = None) -> list[str]:
    """Return the requirements for building a wheel."""
    return [*build_meta.get_requires_for_build_wheel(config_settings), *_requirements()]


def get_requires_for_build_editable(config_settings: Any = None) -> list[str]:
    """Return the requirements for an editable installation."""
    return [*build_meta.get_requires_for_build_editable(config_settings), *_requirements()]
