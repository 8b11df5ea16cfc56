"""Compile the solver's core during installation, where a C compiler is there or can be installed.

Without one, or with CHUTECALC_COMPILE=0, chutecalc is installed as plain Python and works the same, slower.
"""

import os
import shlex
import subprocess
import sys
import sysconfig
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.build_py import build_py

from compiling import ZIG, compile_requested, has_headers, needs_zig

CORE, SPECS = Path("chutecalc", "core"), Path("specs")
# The digits are those of plain Python: a sum of a product stays two roundings.
FLAGS = (
    []
    if sys.platform == "win32"
    else ["-O3", "-g0", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math", "-fno-wrapv", "-funroll-loops"]
)
# `matrix`: two rows in a register are faster than vectorised columns, which GCC prefers. `replay`: a recorded function
# is most often called for one design. Only GCC knows the flag.
OWN_FLAGS = {name: ["-fno-tree-loop-vectorize"] for name in ("matrix", "replay")}
SHARED = "chutecalc.core._views"  # code for array views, compiled once for all modules
DIRECTIVES = {
    "language_level": 3,
    "infer_types": True,  # from the C types in the .pxd beside each module
    "annotation_typing": False,
    "boundscheck": False,
    "wraparound": False,
    "initializedcheck": False,
    "nonecheck": False,
    "cdivision": True,
    "cpow": True,  # the power of C, not that of complex numbers
}


class Build(build_ext):
    """Build the extensions. If the compiler fails, warn and install plain Python."""

    def run(self) -> None:
        self.parallel = self.parallel or os.cpu_count()
        folders = [CORE] if self.inplace else [Path(self.build_lib, CORE)]
        for folder in folders:
            remove(folder)  # Python would import stale compiled modules before the sources
        try:
            translate(self.extensions)
            super().run()
        except (Exception, SystemExit) as error:  # a compiler may fail in any manner
            for folder in folders:
                remove(folder)  # all or none: they share C records
            self.warn(f"chutecalc is installed uncompiled: {error}")


class BuildPython(build_py):
    """Build the Python files, and put the standard designs beside them, where `chutecalc new --example` finds them."""

    def run(self) -> None:
        super().run()
        if self.editable_mode:
            return  # they are in the source
        for spec in SPECS.rglob("*.toml"):
            if not spec.name.endswith(".baseline.toml"):
                target = Path(self.build_lib, "chutecalc", "examples", spec.relative_to(SPECS))
                self.mkpath(str(target.parent))
                self.copy_file(str(spec), str(target))

    def copy_file(self, infile: str, outfile: str, *_: Any, **options: Any) -> Any:
        """Copy a file without its permissions, which differ from checkout to checkout."""
        return super().copy_file(infile, outfile, **options | {"preserve_mode": False})


def remove(folder: Path) -> None:
    """Remove the compiled modules of a folder."""
    for path in [*folder.glob("*.so"), *folder.glob("*.pyd")]:
        path.unlink()


def accepted(flags: list[str]) -> list[str]:
    """Return the flags that the compiler accepts."""
    compiler = shlex.split(os.environ.get("CC") or sysconfig.get_config_var("CC") or "cc")
    arguments = ["-Werror", "-x", "c", "-c", os.devnull, "-o", os.devnull]
    try:
        return [
            flag for flag in flags if subprocess.run([*compiler, flag, *arguments], capture_output=True).returncode == 0
        ]
    except OSError:  # no such compiler
        return []


def extensions() -> list[Extension]:
    """Return the core's modules as extensions, not yet translated to C; none where the core is not compiled."""
    if not compile_requested():
        remove(CORE)
        return []
    if not (has_headers() and find_spec("Cython")):  # not installed yet when pip asks for the requirements of a build
        return []
    if needs_zig():
        os.environ["CC"], os.environ["LDSHARED"] = ZIG, f"{ZIG} -shared"
    modules = [path for path in sorted(CORE.glob("*.py")) if path.stem not in {"__init__", "floats", "without_gil"}]
    found = [
        Extension(
            ".".join(path.with_suffix("").parts),
            [str(path)],
            extra_compile_args=FLAGS + accepted(OWN_FLAGS.get(path.stem, [])),
        )
        for path in modules
    ]
    return [*found, Extension(SHARED, [str(Path(*SHARED.split(".")).with_suffix(".c"))], extra_compile_args=FLAGS)]


def translate(modules: list[Extension]) -> None:
    """Translate modules to C, all at once, since they share code. Not where this file runs only to be asked."""
    if not modules:
        return
    from Cython.Build import cythonize

    translated = cythonize(
        modules,
        build_dir="build/c",
        compiler_directives=DIRECTIVES,
        shared_utility_qualified_name=SHARED,
        force=True,
        quiet=True,
    )
    sources = {extension.name: extension.sources for extension in translated}
    for extension in modules:
        extension.sources = sources[extension.name]


setup(ext_modules=extensions(), cmdclass={"build_ext": Build, "build_py": BuildPython})
