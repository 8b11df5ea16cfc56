"""Numbers whose unit is probably mistaken are told, with the unit that was probably meant."""

import json

import numpy as np
import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.fields.table import Table
from chutecalc.fields.units import UNITS, convert, first_unit, unit_keys
from chutecalc.sections.registry import SHAPES
from chutecalc.segments.registry import KINDS
from chutecalc.spec import chute_spec, limits
from tests.conftest import ROOT, STANDARD_DESIGNS, chute


def implausible(solved_chute):
    return [finding for finding in chutecalc.solve(solved_chute).findings() if finding.code == "implausible"]


def tables():
    """All tables of a spec."""
    every = [*vars(chute_spec).values(), limits.Limits, *SHAPES.values(), *KINDS.values()]
    found = {item for item in every if isinstance(item, type) and issubclass(item, Table) and item is not Table}
    return [
        *found,
        *(other for table in found for other in Table.__subclasses__() if other.__module__ == table.__module__),
    ]


def test_every_quantity_of_a_spec_has_a_plausible_range_within_its_bounds():
    quantities = {(table.__name__, key): one for table in tables() for key, one in table.quantities().items()}
    assert len(quantities) > 50
    for name, quantity in quantities.items():
        plausible = quantity.plausible
        assert plausible is not None, name
        assert 0.0 < plausible.low < plausible.high, name
        assert plausible.high <= max(quantity.bounds.values()), name
        assert plausible.below, name
        assert plausible.above, name


@pytest.mark.parametrize("path", STANDARD_DESIGNS, ids=lambda path: path.stem)
def test_standard_designs_are_plausible(path):
    assert implausible(chutecalc.load(path)) == []


def test_the_starter_is_plausible():
    assert implausible(chutecalc.parse(chutecalc.STARTER)) == []


@pytest.mark.parametrize(
    ("path", "value", "words"),
    [
        ("material.density_kg_m3", 53, "lighter than sawdust: write density_lb_ft3 = 53 if"),
        ("segments.spoon.radius_m", 1500, "longer than any chute: write radius_mm = 1500 if"),
        ("inlet.belt.velocity_m_s", 90, "faster than any belt: write velocity_fpm = 90 if"),
        ("inlet.belt.pulley_radius_m", 18, "wider than any chute: write pulley_radius_in = 18 if"),
        (
            "liners.ceramic.friction_deg",
            0.45,
            "write friction_rad = 0.45 if you meant radians, or friction_deg = 24.23 if",
        ),
        ("material.internal_friction_deg", 0.9, "write internal_friction_rad = 0.9 if"),
        ("material.lump_m", 15, "larger than any crusher takes: write lump_mm = 15 if"),
        ("flow.gravity_m_s2", 32.174, "write gravity_ft_s2 = 32.174 if"),
        ("limits.max_fill", 60, "write max_fill = 0.6 if you meant %"),
        ("receiver.velocity_fpm", 1.0, "1 fpm is slower than any belt: write velocity_m_s = 1 if you meant m/s"),
    ],
)
def test_the_likeliest_remedy(path, value, words):
    design = chutecalc.load(ROOT / "specs" / "belt_hood_spoon.toml").put({path: value})
    (finding,) = implausible(design)
    assert words in finding.message()
    assert finding.severity == "warning"
    assert (finding.segment, finding.key.split(".")[-1]) == ("", path.split(".")[-1])
    assert np.isnan(finding.s_m).all()


def test_all_are_told_at_once_before_the_other_warnings():
    design = chutecalc.load(ROOT / "specs" / "belt_hood_spoon.toml")
    wrong = {"material.density_kg_m3": 53.0, "segments.spoon.radius_m": 1500.0, "liners.ceramic.friction_deg": 0.45}
    codes = [finding.code for finding in chutecalc.solve(design.put(wrong)).findings() if finding.severity == "warning"]
    assert codes[:3] == ["implausible"] * 3
    assert "implausible" not in codes[3:]
    keys = {finding.key for finding in implausible(design.put(wrong))}
    assert keys == {"material.density_kg_m3", "segments.4.radius_m", "liners.ceramic.friction_deg"}


def test_a_batch_is_told_design_by_design():
    base = chute().vary({"material.density_kg_m3": [2.4, 800.0, 53.0, 20000.0], "inlet.velocity_m_s": 4.0})
    found = implausible(base)
    assert [finding.mask.tolist() for finding in found] == [
        [True, False, False, False],
        [False, False, True, False],
        [False, False, False, True],
    ]
    assert "density_t_m3 = 2.4" in found[0].message(0)
    assert "density_lb_ft3 = 53" in found[1].message(2)
    assert found[2].message(3) == "20000 kg/m³ is denser than any ore: check its value and its unit"


@pytest.mark.parametrize("rows", [[[500, 300], [1000, 520], [5000, 2300]]])
def test_a_locus_in_another_unit_is_told_once(rows):
    (finding,) = implausible(chute(liners={"wall": {"yield_locus_kpa": rows}}))
    assert "5000 kPa is more than any chute bears: write it as yield_locus_pa if you meant Pa" in finding.message()
    assert implausible(chute(liners={"wall": {"yield_locus_pa": rows}})) == []


def test_zero_is_no_mistaken_unit():
    segments = [{"kind": "fall", "drop_m": 1.0}, {"kind": "curve", "radius_m": 2.0, "to_slope_deg": 0.0}]
    inlet = {"velocity_m_s": 0.0, "slope_deg": 90.0}
    assert implausible(chute(liners={"wall": {"friction_deg": 0.0}}, inlet=inlet, segments=segments)) == []


def test_a_number_in_its_own_unit_is_plausible_in_any_of_them():
    """Every plausible value stays so when it is written in another unit."""
    for table in tables():
        for key, quantity in table.quantities().items():
            for unit in unit_keys(key, quantity.dimension).values():
                start = first_unit(quantity.dimension)
                written = convert(quantity.plausible.middle, quantity.dimension, start, unit)
                assert not quantity.plausible.mistaken(
                    np.array([convert(written, quantity.dimension, unit, start)])
                ).any()
    assert set(UNITS) >= {"length", "density"}


def test_it_is_printed_without_a_place_and_stands_in_files(tmp_path, capsys):
    target = tmp_path / "run.json"
    spec = str(ROOT / "specs" / "vee.toml")
    assert main(["run", spec, "--set", "flow.rate_t_h=0.02", "--json", str(target)]) == 0
    line = "warning implausible  flow.rate_t_h: 0.02 t/h is a trickle"
    assert line in capsys.readouterr().out
    (found,) = [one for one in json.loads(target.read_text())["chutes"][0]["findings"] if one["code"] == "implausible"]
    assert (found["segment"], found["key"], found["s_m"]) == (None, "flow.rate_t_h", None)
    assert main(["run", spec, "--set", "flow.rate_t_h=0.02", "--strict"]) == 1
