"""All checks of this project. `nox` runs what CI runs; `nox -l` lists the sessions, `nox -s style` runs one.

`tests` installs the project into `.venv` with the command that README.md gives, and `style`, `designs`, `docs` and
`benchmarks` use that environment. `package` and `oldest` have environments of their own.
"""

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import nox

nox.needs_version = ">=2024.4"
nox.options.default_venv_backend = "venv"
nox.options.stop_on_first_error = True
nox.options.error_on_missing_interpreters = True

PROJECT = nox.project.load_toml("pyproject.toml")["project"]
BIN = Path(".venv", "bin").absolute()
BENCHMARKS = ("work_precision", "estimates", "batches", "chains", "stages", "startup", "check", "sweep", "commands", "scale")
FIXED_CASES = {"CHUTECALC_SEED": None, "CHUTECALC_STRESS": None}
"""Random tests draw the same cases in every run; the session `nightly` draws new ones."""
EXAMPLES_SHIP = "from importlib.resources import files; assert (files('chutecalc') / 'examples' / 'vee.toml').is_file()"
UNCOMPILED = ("tests/unit/test_solution.py", "tests/unit/test_function.py", "tests/regression")
"""What is tested with the core in plain Python, whose digits tests/verification/test_compiled.py compares."""


def project_tool(session: nox.Session, name: str, *arguments: str) -> None:
    """Run a program of the project's own environment, `.venv`."""
    if not (BIN / name).exists():
        session.error(f".venv has no {name}: run nox -s tests, or the test command in README.md")
    session.run(str(BIN / name), *arguments, external=True)


@nox.session(venv_backend="none")
def tests(session: nox.Session) -> None:
    """Install and test the project with the command in README.md: newest dependencies, compiled core."""
    printed = session.run("python3", ".ci/test_command.py", "README.md", external=True, silent=True)
    assert isinstance(printed, str)
    session.run("bash", "-euo", "pipefail", "-c", printed.strip(), env=FIXED_CASES, external=True)


@nox.session(venv_backend="none")
def style(session: nox.Session) -> None:
    """Check style and types."""
    project_tool(session, "ruff", "check", ".")
    project_tool(session, "ruff", "format", "--check", ".")
    project_tool(session, "mypy")


@nox.session(venv_backend="none")
def designs(session: nox.Session) -> None:
    """Compare the standard designs with their baselines."""
    project_tool(session, "chutecalc", "check", "specs")


@nox.session(venv_backend="none")
def docs(session: nox.Session) -> None:
    """Build the documentation site into `site`; a warning, such as a link that leads nowhere, is an error."""
    project_tool(session, "pip", "install", "--quiet", *PROJECT["optional-dependencies"]["docs"])
    session.run(
        str(BIN / "python"), "-m", "mkdocs", "build", "--strict", external=True, env={"NO_MKDOCS_2_WARNING": "1"}
    )


@nox.session
def package(session: nox.Session) -> None:
    """Build the packages where no C compiler is to be found, and install the wheel."""
    session.install("build", "twine")
    folder = Path(session.create_tmp()).absolute()
    packages = folder / "dist"
    shutil.rmtree(packages, ignore_errors=True)
    no_programs = {"PATH": str(folder)}
    session.run("python", "-m", "build", "--outdir", str(packages), ".", env=no_programs, silent=True)
    built = [str(path) for path in packages.iterdir()]
    session.run("twine", "check", "--strict", *built)
    session.install("--no-deps", "--force-reinstall", *(path for path in built if path.endswith(".whl")))
    with session.chdir(folder):
        session.run("python", "-c", "import chutecalc.core as core; assert core.compiled(), core")
        session.run("python", "-c", EXAMPLES_SHIP)


@nox.session(venv_backend="none")
def benchmarks(session: nox.Session) -> None:
    """Run every benchmark on small problems, to see that it runs."""
    project_tool(session, "pip", "install", "--quiet", *PROJECT["optional-dependencies"]["bench"])
    for name in BENCHMARKS:
        arguments = ("--quick", "--out", session.create_tmp())
        session.run(str(BIN / "python"), f"benchmarks/{name}.py", *arguments, external=True, silent=True)


@nox.session(venv_backend="none")
def uncompiled(session: nox.Session) -> None:
    """Test the core in plain Python, as it is installed where it cannot be compiled."""
    with without_compiled_core():
        project_tool(session, "python", "-c", "import chutecalc.core as core; assert not core.compiled(), core")
        session.run(str(BIN / "python"), "-m", "pytest", "-n", "auto", *UNCOMPILED, env=FIXED_CASES, external=True)


@nox.session(python=os.environ.get("PYTHON_OLDEST"))
def oldest(session: nox.Session) -> None:
    """Test with the oldest dependencies that pyproject.toml allows. The solver itself, tests/verification, needs none.

    They need wheels for the interpreter: PYTHON_OLDEST names another one, such as 3.11. The core is the one that the
    session `tests` has compiled; another interpreter than that one's takes it in plain Python.
    """
    constraints = Path(session.create_tmp(), "constraints.txt").absolute()
    pins = session.run("python", ".ci/oldest.py", "pyproject.toml", silent=True)
    assert isinstance(pins, str)
    constraints.write_text(pins, encoding="utf-8")
    no_compiling = {"CHUTECALC_COMPILE": "0"}
    with without_compiled_core():  # which installing anew would remove
        session.install("--constraint", str(constraints), "--editable", ".[test]", env=no_compiling)
    rooms = [f"tests/{room}" for room in ("unit", "cli", "regression", "dem")]
    skipped = "--ignore=tests/dem/test_lammps.py"
    session.run("python", "-m", "pytest", "-n", "auto", skipped, *rooms, "chutecalc", env=FIXED_CASES)


@contextmanager
def without_compiled_core() -> Iterator[None]:
    """Put the compiled modules, which Python would take first, out of the way and back again."""
    core, aside = Path("chutecalc", "core"), Path(".nox", "compiled")
    aside.mkdir(parents=True, exist_ok=True)
    modules = [*core.glob("*.so"), *core.glob("*.pyd")]
    for module in modules:
        module.rename(aside / module.name)
    try:
        yield
    finally:
        for module in modules:
            (aside / module.name).rename(module)


@nox.session(default=False)
def nightly(session: nox.Session) -> None:
    """Run the robustness and verification tests on random cases; arguments behind -- go to pytest."""
    session.install("--editable", ".[test]")
    rooms = ("tests/robustness", "tests/verification")
    session.run("python", "-m", "pytest", "-n", "auto", *rooms, *session.posargs)
