"""What several tests need: specs as text and as tables."""

import copy
import signal
from collections.abc import Generator
from pathlib import Path
from typing import Any

import pytest

import chutecalc
from chutecalc.spec.reader import BASELINE_SUFFIX
from tests import seeds, skips

# A shell's background job ignores Ctrl-C, and so would the programs that tests start and interrupt.
signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_configure() -> None:
    seeds.settle()
    core = Path(chutecalc.__file__).parent / "core"
    sources = [path.stat().st_mtime for path in core.iterdir() if path.suffix in {".py", ".pxd"}]
    if any(module.stat().st_mtime < max(sources) for module in [*core.glob("*.so"), *core.glob("*.pyd")]):
        raise pytest.UsageError(f"{core} has changed since it was compiled: python setup.py build_ext --inplace")


def pytest_sessionstart(session: pytest.Session) -> None:
    """Show the seed at the top, with -q too, which omits pytest's own header."""
    terminal = session.config.pluginmanager.get_plugin("terminalreporter")
    if terminal is not None and seeds.replay():
        terminal.write_line(f"random cases: {seeds.replay()}")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    report = yield
    skips.judge(report)
    if report.failed and seeds.replay():
        report.sections.append(("random cases", f"the same again: {seeds.replay()} pytest '{item.nodeid}'"))
    return report


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(
    collector: pytest.Collector,
) -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    report = yield
    skips.judge(report)
    return report


ROOT = Path(__file__).parent.parent
REFERENCE = ROOT / "tests" / "reference"
LEVEL = chutecalc.STARTER.replace("to_slope_deg = 40", "to_slope_deg = 0 ")
"""The starting spec with a spoon that ends level, which draws a warning and a note."""
STANDARD_DESIGNS = sorted(path for path in (ROOT / "specs").rglob("*.toml") if not path.name.endswith(BASELINE_SUFFIX))

BASE: dict[str, Any] = {
    "flow": {"rate_t_h": 1000.0},
    "material": {"density_kg_m3": 800.0, "internal_friction_deg": 50.0},
    "liners": {"wall": {"friction_deg": 25.0}},
    "sections": {"body": {"shape": "chamfered", "base_m": 0.5, "chamfer_deg": 45.0}},
    "inlet": {"velocity_m_s": 4.0, "slope_deg": 40.0},
    "segments": [{"kind": "straight", "slope_deg": 40.0, "length_m": 3.0}],
}


def spec(**tables: Any) -> dict[str, Any]:
    """Return the base spec with tables replaced or, where they are tables in both, merged key by key."""
    data = copy.deepcopy(BASE)
    for name, table in tables.items():
        merge = isinstance(table, dict) and name in {"flow", "material", "inlet"}
        data[name] = data[name] | table if merge else table
    return data


def chute(**tables: Any) -> chutecalc.Chute:
    return chutecalc.parse(spec(**tables))


def vee(chamfer_deg: float = 45.0, **more: Any) -> dict[str, Any]:
    """Return sections of one vee, whose friction does not depend on depth."""
    return {"body": {"shape": "vee", "chamfer_deg": chamfer_deg, **more}}


def vee_friction(wall_deg: float, chamfer_deg: float, internal_deg: float) -> float:
    """Return the equivalent friction of a vee by the paper's Eq 4 and 11 at B = 0, written out as printed."""
    from math import cos, radians, sin, tan

    beta, delta = radians(chamfer_deg), radians(internal_deg)
    ratio = (1 + sin(delta) * cos(2 * beta)) / (1 + sin(delta))
    return tan(radians(wall_deg)) * (ratio + (1 - ratio) * cos(beta)) / cos(beta)


@pytest.fixture
def starter(tmp_path: Path) -> Path:
    """Write the starting spec, with a spoon that ends level and so draws findings, to a file and return its path."""
    path = tmp_path / "chute.toml"
    path.write_text(LEVEL, encoding="utf-8")
    return path
