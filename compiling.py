"""The build backend: setuptools', which brings a C compiler along where the machine has none."""

import os
import shutil
import sys
import sysconfig
from pathlib import Path
from typing import Any

from setuptools import build_meta
from setuptools.build_meta import *  # noqa: F403 - a backend is all of its functions

ZIG = f"'{sys.executable}' -m ziglang cc -mcpu=baseline"  # not for this processor alone


def wanted() -> bool:
    """Whether the core is to be compiled at all."""
    return os.environ.get("CHUTECALC_COMPILE", "1") != "0"


def has_headers() -> bool:
    """Whether Python's own headers are there, which no compiler brings along."""
    return any(Path(sysconfig.get_path(name), "Python.h").exists() for name in ("include", "platinclude"))


def needs_zig() -> bool:
    """Whether a compiler has to be brought along."""
    if sys.platform == "win32" or "CC" in os.environ:
        return False
    usual = (sysconfig.get_config_var("CC") or "cc").split()[0]
    return not any(shutil.which(name) for name in (usual, "cc", "gcc", "clang"))


def _requirements() -> list[str]:
    compiler = ["ziglang>=0.13"] if needs_zig() else []
    return ["cython>=3.1", *compiler] if wanted() and has_headers() else []


def get_requires_for_build_wheel(config_settings: Any = None) -> list[str]:
    """What a wheel needs to be built."""
    return [*build_meta.get_requires_for_build_wheel(config_settings), *_requirements()]


def get_requires_for_build_editable(config_settings: Any = None) -> list[str]:
    """The same for an editable installation."""
    return [*build_meta.get_requires_for_build_editable(config_settings), *_requirements()]
