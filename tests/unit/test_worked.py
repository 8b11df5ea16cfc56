"""The formulas of a report: their numbers, put in by hand, give the results that stand beside them."""

import math
import re

import pytest

import chutecalc
from chutecalc.output.html_report.at_joints import joint_formulas
from chutecalc.output.html_report.at_worst import station_formulas, worst_place
from chutecalc.output.html_report.worked import SIGNIFICANT, names_in, symbols_in
from tests.conftest import ROOT, STANDARD_DESIGNS, chute

FUNCTIONS = {name: getattr(math, name) for name in ("sin", "cos", "tan", "sqrt", "radians")}
OPERAND = r"(?<![\w.])\d+(?:\.\d+)?(?:e-?\d+)?"
SLIDES_NOWHERE = {"hood_drops_off", "missed_spoon", "stall_at_impact"}


def evaluated(text: str) -> float:
    """Return what a pocket calculator gives for the numbers of a formula."""
    text = text.replace("−", "-").replace("·", "*").replace("²", "**2").replace("√", "sqrt")
    angle = r"(sin|cos|tan)(\*\*2)? (\(-[\d.e+-]+°\)|[\d.e+-]+°)"
    text = re.sub(
        angle, lambda found: f"({found[1]}(radians({found[3].strip('()').rstrip('°')})){found[2] or ''})", text
    )
    return float(eval(re.sub(r"\|(.*)\|", r"abs(\1)", text), FUNCTIONS))


def rounding(text: str) -> float:
    """Return by how much a formula may be off because its numbers are rounded: each moved by half of its last digit."""
    value, off = evaluated(text), 0.0
    for found in re.finditer(OPERAND, text):
        number = float(found[0])
        if number in (0.0, 1.0, 2.0, 3.6, 1000.0):  # constants of formulas, and what rounding leaves as it is
            continue
        half = 0.5 * 10.0 ** (math.floor(math.log10(number)) - SIGNIFICANT + 1)
        off += abs(evaluated(text[: found.start()] + repr(number + half) + text[found.end() :]) - value)
    return off


def formulas(solution):
    place = worst_place(solution)
    found = list(station_formulas(solution, place)) if place else []
    return found + [line for lines in joint_formulas(solution).values() for line in lines]


@pytest.mark.parametrize("file", STANDARD_DESIGNS, ids=lambda file: file.stem)
def test_numbers_put_in_by_hand_give_the_results_of_the_solver(file):
    solution = chutecalc.solve(chutecalc.load(file))
    assert (worst_place(solution) is None) == (file.stem in SLIDES_NOWHERE)
    lines = formulas(solution)
    assert sum(bool(line.numbers) for line in lines) >= (10 if worst_place(solution) else 0)
    listed = {name for symbol in symbols_in(lines) for name in symbol.split(", ")}
    assert {name for line in lines for name in names_in(f"{line.result.symbol} {line.formula}")} <= listed
    for line in lines:
        if line.numbers:
            off = abs(evaluated(line.numbers) - line.result.value)
            assert off <= 1.01 * rounding(line.numbers) + 1e-12 * abs(line.result.value), line


@pytest.mark.parametrize(
    "tables",
    [
        {"model": {"friction_law": "equilibrium"}},
        {"model": {"momentum_factor": 1.25}},
        {"liners": {"wall": {"friction_deg": 80.0, "slip_ratio": 0.8}}, "inlet": {"velocity_m_s": 9.0}},
        {"material": {"pressure_ratio": 0.4}},
        {"liners": {"wall": {"yield_locus_kpa": [[1.0, 0.6], [5.0, 2.5]]}}},
    ],
    ids=lambda tables: next(iter(tables)),
)
def test_variants_of_the_model_have_their_formulas(tables):
    solution = chutecalc.solve(chute(**tables))
    for line in formulas(solution):
        if line.numbers:
            off = abs(evaluated(line.numbers) - line.result.value)
            assert off <= 1.01 * rounding(line.numbers) + 1e-12 * abs(line.result.value), line


def test_pressure_along_the_stream_has_no_formula_for_a_pocket_calculator():
    symbols = [
        line.result.symbol for line in formulas(chutecalc.solve(chute(model={"longitudinal_pressure_ratio": 0.5})))
    ]
    assert "v dv/ds" not in symbols
    assert "μ_e" in symbols


def test_a_chute_that_stalls_is_worked_where_its_stream_enters_the_segment():
    place = worst_place(chutecalc.solve(chutecalc.load(ROOT / "specs/fails/stall.toml")))
    assert (place.part.name, place.share) == ("chute", 0.0)
