"""What pyproject.toml cannot say: the solver's core is compiled ahead of time, where a C compiler is or can be had.

Without one, or with CHUTECALC_COMPILE=0, chutecalc is installed as plain Python and works the same, slower.
"""

import os
import shlex
import subprocess
import sys
import sysconfig
from importlib.util import find_spec
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

from compiling import ZIG, has_headers, needs_zig, wanted

CORE = Path("chutecalc", "core")
# The digits are those of plain Python: a sum of a product stays two roundings.
FLAGS = (
    []
    if sys.platform == "win32"
    else ["-O3", "-g0", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math", "-fno-wrapv", "-funroll-loops"]
)
# Two rows in a register are faster than a row's columns, which GCC takes for better; other compilers do not know this.
# The steps of a recipe are most often done for one design.
OWN_FLAGS = {name: ["-fno-tree-loop-vectorize"] for name in ("matrix", "replay")}
SHARED = "chutecalc.core._views"  # what every module that looks at arrays takes: compiled once
DIRECTIVES = {
    "language_level": 3,
    "infer_types": True,  # what follows from the C types beside each module
    "annotation_typing": False,
    "boundscheck": False,
    "wraparound": False,
    "initializedcheck": False,
    "nonecheck": False,
    "cdivision": True,
    "cpow": True,  # C's own power; else that of complex numbers
}


class Build(build_ext):
    """Builds what it can: a compiler that fails leaves plain Python, and says so."""

    def run(self) -> None:
        self.parallel = self.parallel or os.cpu_count()
        folders = [CORE] if self.inplace else [Path(self.build_lib, CORE)]
        for folder in folders:
            remove(folder)  # what was compiled from other sources would be used before them
        try:
            super().run()
        except (Exception, SystemExit) as error:  # whatever a compiler may do
            for folder in folders:
                remove(folder)  # all of them or none: they know each other's records
            self.warn(f"chutecalc is installed uncompiled: {error}")


def remove(folder: Path) -> None:
    """Compiled modules."""
    for path in [*folder.glob("*.so"), *folder.glob("*.pyd")]:
        path.unlink()


def accepted(flags: list[str]) -> list[str]:
    """Those of some flags that the compiler knows."""
    compiler = shlex.split(os.environ.get("CC") or sysconfig.get_config_var("CC") or "cc")
    asked = ["-Werror", "-x", "c", "-c", os.devnull, "-o", os.devnull]
    try:
        return [
            flag for flag in flags if subprocess.run([*compiler, flag, *asked], capture_output=True).returncode == 0
        ]
    except OSError:  # there is none of that name
        return []


def extensions() -> list[Extension]:
    """The core's modules in C, or none."""
    if not wanted():
        remove(CORE)
        return []
    if not (has_headers() and find_spec("Cython")):  # not there yet when pip asks what a build needs
        return []
    from Cython.Build import cythonize

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
    found.append(Extension(SHARED, [str(Path(*SHARED.split(".")).with_suffix(".c"))], extra_compile_args=FLAGS))
    compiled: list[Extension] = cythonize(
        found,
        build_dir="build/c",
        compiler_directives=DIRECTIVES,
        shared_utility_qualified_name=SHARED,
        force=True,
        quiet=True,
    )
    return compiled


setup(ext_modules=extensions(), cmdclass={"build_ext": Build})
