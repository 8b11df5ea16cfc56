"""All checks of this project. `nox` runs what CI runs; `nox -l` lists the sessions, `nox -s style` runs one.

`tests` installs the project into `.venv` with the command that README.md gives, and `style`, `designs`, `docs` and
`benchmarks` use that environment. `package`, `plain` and `oldest` have environments of their own. Installing
takes a network; no test does, and pytest refuses connections to other machines.
"""

import os
import re
import secrets
import shutil
import subprocess
import sys
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
BENCHMARKS = (
    *("work_precision", "estimates", "batches", "chains", "stages"),
    *("startup", "check", "sweep", "commands", "scale"),
)
FIXED_CASES = {"CHUTECALC_SEED": None, "CHUTECALC_STRESS": None}
"""Random tests draw the same cases in every run; the session `nightly` draws new ones."""
EXAMPLES_SHIP = "from importlib.resources import files; assert (files('chutecalc') / 'examples' / 'vee.toml').is_file()"
PLAIN = (
    *("tests/unit/test_solution.py", "tests/unit/test_function.py", "tests/regression"),
    *("tests/cli/test_run.py", "tests/cli/test_other_commands.py"),
)
"""What is tested with the core in plain Python, whose digits tests/verification/test_compiled.py compares."""
OF_LIBRARIES = (
    *(f"tests/cli/test_{name}.py" for name in ("run", "outputs", "report", "pictures", "documents", "check", "slips")),
    *("tests/cli/test_other_commands.py", "tests/cli/test_optimise.py", "tests/cli/test_uncertain.py"),
    *("tests/cli/sweep/test_files.py", "tests/cli/test_dask.py", "tests/cli/test_hostile.py", "tests/regression"),
    *(f"tests/unit/test_{name}.py" for name in ("spec", "dxf", "plot", "dataframe", "edited", "chart", "function")),
)
"""What is tested with the oldest libraries: commands, formats, pictures, reading; `tests/unit tests/cli` is all."""


def others() -> list[str]:
    """Return the supported versions of Python on this machine, on the PATH or of pyenv, but the one that runs this."""
    found = []
    pyenv = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv"), "versions")
    for name in (each.rpartition(" ")[2] for each in PROJECT["classifiers"] if re.search(r":: 3\.\d+$", each)):
        places = [f"python{name}", *map(str, pyenv.glob(f"{name}.*/bin/python{name}"))]
        if name != f"3.{sys.version_info.minor}" and (here := next(filter(runs, places), None)):
            found.append(here)
    return found


def runs(python: str) -> bool:
    """Return whether an interpreter is there; pyenv has programs that only say that it is not."""
    return bool(shutil.which(python)) and subprocess.run([python, "-c", ""], capture_output=True).returncode == 0


OTHERS = others()
WHEELS_OF_OLDEST = 12
"""The last Python 3.n for which there are wheels of the oldest libraries."""
IN_PLACE = None if sys.version_info.minor <= WHEELS_OF_OLDEST else next(iter(OTHERS), None)
"""What tests the oldest libraries unless a variable names another; None for the one that runs this."""


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
    """Build the packages twice where no C compiler is to be found, install the wheel, and list what it comes with."""
    session.install("build", "twine", "cyclonedx-bom")
    folder = Path(session.create_tmp()).absolute()
    packages, again, installed = folder / "dist", folder / "again", folder / "installed"
    for old in (packages, again, installed):
        shutil.rmtree(old, ignore_errors=True)
    no_programs = {"PATH": str(folder)}
    session.run("python", "-m", "build", "--outdir", str(packages), ".", env=no_programs, silent=True)
    session.run("twine", "check", "--strict", *(str(path) for path in packages.iterdir()))
    (source,), (wheel,) = packages.glob("*.tar.gz"), packages.glob("*.whl")
    session.run("python", "-m", "tarfile", "-e", str(source), str(again))
    unpacked = again / source.name.removesuffix(".tar.gz")
    session.run("python", "-m", "build", "--wheel", "--outdir", str(again), str(unpacked), env=no_programs, silent=True)
    if (again / wheel.name).read_bytes() != wheel.read_bytes():
        session.error(f"{wheel} and {again / wheel.name} are of the same source, and differ")
    session.run("python", "-m", "venv", "--without-pip", str(installed))
    python = str(next(path for name in ("bin/python", "Scripts/python.exe") for path in installed.glob(name)))
    session.run("pip", "--python", python, "install", "--quiet", str(wheel))
    bill = str(wheel.with_suffix(".cdx.json"))
    session.run("cyclonedx-py", "environment", "--pyproject", "pyproject.toml", "--output-file", bill, python)
    with session.chdir(folder):
        session.run(python, "-c", "import chutecalc.core as core; assert core.compiled(), core", external=True)
        session.run(python, "-c", EXAMPLES_SHIP, external=True)


@nox.session(venv_backend="none")
def audit(session: nox.Session) -> None:
    """Look for known vulnerabilities of what is installed in `.venv`; without a database it says that it did not."""
    project_tool(session, "pip", "install", "--quiet", "pip-audit")
    session.run(str(BIN / "python"), ".ci/audit.py", external=True)


@nox.session(venv_backend="none")
def benchmarks(session: nox.Session) -> None:
    """Run every benchmark on small problems, to see that it runs."""
    project_tool(session, "pip", "install", "--quiet", *PROJECT["optional-dependencies"]["bench"])
    for name in BENCHMARKS:
        arguments = ("--quick", "--out", session.create_tmp())
        session.run(str(BIN / "python"), f"benchmarks/{name}.py", *arguments, external=True, silent=True)


@nox.session(python=OTHERS or None)
def plain(session: nox.Session) -> None:
    """Test the core in plain Python, as where it cannot be compiled, with each other version of Python there is."""
    if not OTHERS:
        session.warn("there is no other version of Python on this machine: it is this one again")
    with without_compiled_core():
        session.install("--editable", ".[test]", env={"CHUTECALC_COMPILE": "0"})
        session.run("python", "-c", "import chutecalc.core as core; assert not core.compiled(), core")
        session.run("python", "-m", "pytest", "-n", "auto", *PLAIN, env=FIXED_CASES)


@nox.session(python=os.environ.get("PYTHON_OLDEST") or IN_PLACE)
def oldest(session: nox.Session) -> None:
    """Test what touches a library with the oldest ones that pyproject.toml allows; arguments behind -- go to pytest.

    They need wheels for the interpreter: where this one is too new the oldest that is found is taken, or the one that
    PYTHON_OLDEST names. The core is the one that the session `tests` has compiled; another interpreter than that one's
    takes it in plain Python.
    """
    constraints = Path(session.create_tmp(), "constraints.txt").absolute()
    pins = session.run("python", ".ci/oldest.py", "pyproject.toml", silent=True)
    assert isinstance(pins, str)
    constraints.write_text(pins, encoding="utf-8")
    no_compiling = {"CHUTECALC_COMPILE": "0"}
    with without_compiled_core():  # which installing anew would remove
        session.install("--constraint", str(constraints), "--editable", ".[test]", env=no_compiling)
    session.run("python", "-m", "pytest", "-n", "auto", *(session.posargs or OF_LIBRARIES), env=FIXED_CASES)


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
    """Run the robustness and verification tests on random cases, and attack; arguments behind -- go to pytest."""
    session.install("--editable", ".[test]")
    chosen = os.environ.get("CHUTECALC_SEED", "random")
    seed = str(secrets.randbelow(10**9)) if chosen == "random" else chosen
    session.log(f"CHUTECALC_SEED={seed} repeats these cases")
    env = {"CHUTECALC_SEED": seed}
    rooms = ("tests/robustness", "tests/verification")
    session.run("python", "-m", "pytest", "-n", "auto", *rooms, *session.posargs, env=env)
    for attack in (("many", "--chutes", "100000"), ("attack", "10000", "1000"), ("kills", "10", "--seed", seed)):
        session.run("python", "-m", f"tests.robustness.{attack[0]}", *attack[1:], env=env)
