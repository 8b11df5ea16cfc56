"""Specs: units, faults with path, line, value, limits and remedy, and key paths."""

import tomllib

import numpy as np
import pytest

import chutecalc
from chutecalc.sections.registry import SHAPES
from chutecalc.segments.registry import KINDS
from chutecalc.spec.lines import key_lines
from tests.conftest import BASE, chute, spec

STARTER = chutecalc.STARTER


def faults(text_or_data):
    with pytest.raises(chutecalc.SpecError) as caught:
        chutecalc.parse(text_or_data)
    return list(caught.value.faults)


def starter(old, new):
    assert old in STARTER
    return STARTER.replace(old, new)


@pytest.mark.parametrize(
    ("key", "value", "twin", "same"),
    [
        ("segments.spoon.radius_m", 3.0, "segments.spoon.radius_mm", 3000),
        ("segments.spoon.radius_m", 0.3048 * 9.0, "segments.spoon.radius_ft", 9),
        ("sections.body.base_m", 0.508, "sections.body.base_in", 20),
        ("flow.rate_t_h", 3600.0, "flow.rate_kg_s", 1000),
        ("flow.rate_t_h", 907.18474, "flow.rate_stph", 1000),
        ("material.density_kg_m3", 800.0, "material.density_t_m3", 0.8),
        ("material.density_kg_m3", 50 * 0.45359237 / 0.3048**3, "material.density_lb_ft3", 50),
        ("inlet.velocity_m_s", 2.032, "inlet.velocity_fpm", 400),
        ("inlet.velocity_m_s", 3.048, "inlet.velocity_ft_s", 10),
        ("flow.gravity_m_s2", 9.8145600, "flow.gravity_ft_s2", 32.2),
        ("segments.spoon.to_slope_deg", 30.0, "segments.spoon.to_slope_rad", np.pi / 6),
    ],
)
def test_unit_twins_are_the_same_chute(key, value, twin, same):
    base = chutecalc.parse(STARTER).put({"inlet.slope_deg": 80})
    one = chutecalc.solve(base.put({key: value})).exit_velocity[0]
    assert chutecalc.solve(base.put({twin: same})).exit_velocity[0] == pytest.approx(one, rel=1e-13)


def test_a_metre_in_millimetres_is_exact():
    metric, fine = (
        chutecalc.parse(STARTER).put({f"segments.spoon.radius_{unit}": value})
        for unit, value in (("m", 3), ("mm", 3000))
    )
    assert chutecalc.solve(metric).exit_velocity[0] == chutecalc.solve(fine).exit_velocity[0]


@pytest.mark.parametrize(
    ("old", "new", "path", "given", "words", "remedy"),
    [
        ("rate_t_h = 1000", "rate = 1000", "flow.rate", "1000", "needs its unit", "rate_t_h or rate_kg_s or rate_stph"),
        ("rate_t_h = 1000", "rate_tph = 1000", "flow.rate_tph", "1000", "not end in a unit", "rate_t_h or rate_kg_s"),
        ("rate_t_h = 1000", "", "flow.rate_t_h", "", "is missing", "add rate_t_h"),
        ("rate_t_h = 1000", "rate_t_h = 0", "flow.rate_t_h", "0", "at least 0.001 t/h", "larger"),
        ("rate_t_h = 1000", "rate_t_h = true", "flow.rate_t_h", "true", "a number, at least 0.001 t/h", "a number"),
        ("rate_t_h = 1000", 'rate_t_h = "1000"', "flow.rate_t_h", '"1000"', "a number", "write 1000, the number alone"),
        ("rate_t_h = 1000", "rate_t_h = nan", "flow.rate_t_h", "nan", "finite", "finite number"),
        ("rate_t_h = 1000", "rate_t_h = 1979-05-27", "flow.rate_t_h", "1979-05-27", "a number", "write a number"),
        ("rate_t_h = 1000", "rate_t_h = inf", "flow.rate_t_h", "inf", "finite", "finite number"),
        ("rate_t_h = 1000", f"rate_t_h = 1{'0' * 400}", "", "", "a number of 401 digits, 1000", "shorten it"),
        ("base_m = 0.5", "base_m = 0.5\nbase_in = 20", "sections.body.base_in", "20", "is given twice", "keep one"),
        ("base_m = 0.5", "bse_m = 0.5", "sections.body.bse_m", "0.5", "is not a key", "did you mean base_m?"),
        ("radius_m = 3.0", "radius_mm = -3", "segments.2.radius_mm", "-3", "at least 1 mm", "larger"),
        ("chamfer_deg = 45", "chamfer_rad = 2", "sections.body.chamfer_rad", "2", "at most 1.5708 rad", "_deg = 2"),
        ('kind = "fall" ', 'kind = "drop" ', "segments.1.kind", '"drop"', "not a known kind", ", ".join(KINDS)),
        ('kind = "fall" ', 'kind = "spoon" ', "segments.1.kind", '"spoon"', "not a known kind", "crest is a curve"),
        ("[liners.ceramic]", "[liners]", "liners.friction_deg", "25", "must be a table", "[liners.NAME]"),
        ("rate_t_h = 1000", "rate_t_h = 1e10", "flow.rate_t_h", "10000000000.0", "1,000,000 t/h", "smaller"),
        ("rate_t_h = 1000", "rate_t_h = 1,5", "flow.rate_t_h", "1,5", "is not a number", "write rate_t_h = 1.5"),
        ('kind = "fall" ', "", "segments.1.kind", "", "is missing", ", ".join(KINDS)),
        ('shape = "chamfered"', 'shape = "o"', "sections.body.shape", '"o"', "not a known shape", ", ".join(SHAPES)),
        ('name = "spoon"', 'name = "a b"', "segments.2.name", '"a b"', "is not a valid name", "begin with a letter"),
        ('name = "spoon"', 'name = "1"', "segments.2.name", '"1"', "is not a valid name", "begin with a letter"),
        ('name = "spoon"', 'section = "nobody"', "segments.2.section", '"nobody"', "not defined", "use body, or add"),
        ('name = "spoon"', "liner = 3", "segments.2.liner", "3", "text in quotes", "put quotes around it"),
        ('title = "Fall and spoon, coal"', "title = 3", "title", "3", "text in quotes", "put quotes around it"),
        ("format = 1", "format = 2", "format", "2", "must be 1", "correct"),
        ("internal_friction_deg = 55", "", "material.internal_friction_deg", "", "or pressure_ratio", "add"),
        ("internal_friction_deg = 55", "pressure_ratio = 1.5", "material.pressure_ratio", "1.5", "at most 1", "small"),
        ("slope_deg = 90", "slope_deg = -90", "inlet.slope_deg", "-90", "greater than -90°", "larger"),
        ("velocity_m_s = 0.0", "velocity_m_s = -1.0", "inlet.velocity_m_s", "-1.0", "at least 0.001 m/s", "larger"),
    ],
)  # fmt: skip
def test_a_fault_names_path_value_limits_and_remedy(old, new, path, given, words, remedy):
    (fault,) = faults(starter(old, new))
    assert (fault.path, fault.given) == (path, given)
    assert words in fault.problem
    assert remedy in fault.remedy


def test_faults_name_their_lines_and_come_in_their_order():
    text = (
        starter("rate_t_h = 1000", "rate_t_h = -1")
        .replace("radius_m = 3.0", "radius_m = 0")
        .replace("drop_m = 2.0", "drop_m = 0")
    )
    found = faults(text)
    lines = text.splitlines()
    assert [lines[fault.line - 1].split(" ")[0] for fault in found] == ["rate_t_h", "drop_m", "radius_m"]


@pytest.mark.parametrize(
    ("changes", "path", "words"),
    [
        (
            {"segments": [{"kind": "hood", "radius_m": 1.0, "to_slope_deg": 10.0}]},
            "segments.1.to_slope_deg",
            "steeper than",
        ),
        (
            {"segments": [{"kind": "curve", "radius_m": 1.0, "to_slope_deg": 40.0}]},
            "segments.1.to_slope_deg",
            "no length",
        ),
        ({"segments": [{"kind": "straight", "slope_deg": 0.0, "drop_m": 1.0}]}, "segments.1.drop_m", "level"),
        ({"segments": [{"kind": "straight", "slope_deg": 90.0, "run_m": 1.0}]}, "segments.1.run_m", "vertical"),
        ({"inlet": {"velocity_m_s": 0.0}}, "inlet.velocity_m_s", "at rest"),
        ({"sections": {"body": {"shape": "vee", "chamfer_deg": 90.0}}}, "sections.body.chamfer_deg", "no width"),
        (
            {
                "sections": {"body": {"shape": "pipe", "radius_m": 0.3}},
                "segments": [{"kind": "curve", "radius_m": 0.6, "to_slope_deg": 10.0}],
            },
            "segments.1.radius_m",
            "inner wall",
        ),
        (
            {
                "sections": {
                    name: {"shape": "box", "width_m": 0.5, "height_m": height}
                    for name, height in (("a", 0.3), ("b", 0.6))
                },
                "segments": [
                    {
                        "kind": "hood",
                        "radius_m": 0.5,
                        "from_slope_deg": 0.0,
                        "to_slope_deg": 60.0,
                        "section": ["a", "b"],
                    }
                ],
            },
            "segments.1.radius_m",
            "inner wall",
        ),
        (
            {"sections": {"body": {"shape": "chamfered", "base_m": 0.0, "chamfer_deg": 90.0}}},
            "sections.body.chamfer_deg",
            "no width",
        ),
    ],
)
def test_faults_of_geometry(changes, path, words):
    (fault,) = faults(spec(**changes))
    assert fault.path == path
    assert words in fault.problem
    assert fault.remedy


@pytest.mark.parametrize("from_slope", [{}, {"from_slope_deg": 60.0}])
@pytest.mark.parametrize(("kind", "to_slope"), [("curve", 0.0), ("hood", 80.0)])
def test_a_closed_bend_below_a_fall_has_an_inner_wall(kind, to_slope, from_slope):
    """Also where the slope at its start, that of the falling stream, is not known before it is solved."""
    bend = {"kind": kind, "to_slope_deg": to_slope, **from_slope}
    tables = {"sections": {"body": {"shape": "pipe", "radius_m": 0.3}}, "inlet": {"slope_deg": 10.0}}
    fall = {"kind": "fall", "run_m": 0.5}
    (fault,) = faults(spec(**tables, segments=[fall, bend | {"radius_m": 0.6}]))
    assert (fault.path, "inner wall" in fault.problem) == ("segments.2.radius_m", True)
    assert ("from_slope_deg" in fault.remedy) == (kind == "curve" and not from_slope)
    assert chutecalc.solve(chutecalc.parse(spec(**tables, segments=[fall, bend | {"radius_m": 0.601}]))).ok


def test_a_closed_crest_below_a_fall_has_any_radius_once_it_says_that_it_is_one():
    tables = {"sections": {"body": {"shape": "pipe", "radius_m": 0.3}}, "inlet": {"slope_deg": 10.0}}
    crest = {"kind": "curve", "radius_m": 0.3, "to_slope_deg": 80.0}
    fall = {"kind": "fall", "run_m": 0.5}
    assert len(faults(spec(**tables, segments=[fall, crest]))) == 1
    chutecalc.parse(spec(**tables, segments=[fall, crest | {"from_slope_deg": 60.0}]))
    chutecalc.parse(spec(**tables, segments=[fall, crest | {"to_slope_deg": 90.0}]))  # no stream is steeper


def test_all_faults_of_geometry_at_once_and_only_after_all_others_are_mended():
    bent = spec(
        inlet={"velocity_m_s": 0.0, "slope_deg": 40.0},
        segments=[
            {"kind": "hood", "radius_m": 1.0, "to_slope_deg": 10.0},
            {"kind": "straight", "slope_deg": 0.0, "drop_m": 1.0},
        ],
    )
    assert {fault.path for fault in faults(bent)} == {
        "inlet.velocity_m_s",
        "segments.1.to_slope_deg",
        "segments.2.drop_m",
    }
    bent["flow"]["rate_t_h"] = -1
    assert {fault.path for fault in faults(bent)} == {"flow.rate_t_h"}


def test_a_hood_that_the_falling_stream_is_steeper_than_is_told_when_it_is_known():
    bad = chute(
        inlet={"velocity_m_s": 2.0, "slope_deg": 60.0},
        segments=[{"kind": "fall", "drop_m": 3.0}, {"kind": "hood", "radius_m": 1.0, "to_slope_deg": 70.0}],
    )
    with pytest.raises(chutecalc.SpecError, match=r"segments\.2\.to_slope_deg a roof must steepen") as caught:
        chutecalc.solve(bad)
    assert "from_slope_deg" in caught.value.faults[0].remedy


@pytest.mark.parametrize("measures", [{}, {"length_m": 1.0, "run_m": 1.0}])
def test_one_measure_of_a_straight_and_one_only(measures):
    (fault,) = faults(spec(segments=[{"kind": "straight", "slope_deg": 40.0} | measures]))
    assert "length_m, drop_m, run_m" in fault.problem


def test_the_three_measures_of_a_straight_agree():
    slope = np.radians(40.0)
    lengths = {"length_m": 2.0, "drop_m": 2.0 * np.sin(slope), "run_m": 2.0 * np.cos(slope)}
    exits = [
        chutecalc.solve(chute(segments=[{"kind": "straight", "slope_deg": 40.0, key: float(value)}])).exit_velocity[0]
        for key, value in lengths.items()
    ]
    assert exits == pytest.approx([exits[0]] * 3, rel=1e-14)


def test_several_sections_or_liners_have_to_be_named():
    two = spec(sections={"a": BASE["sections"]["body"], "b": {"shape": "rectangular", "width_m": 1.0}})
    (fault,) = faults(two)
    assert (fault.path, fault.problem) == ("segments.1.section", "is missing, and the spec has several sections")
    two["segments"][0]["section"] = "b"
    assert chutecalc.parse(two).design.segments[0].section.base[0] == 1.0


@pytest.mark.parametrize(
    ("data", "words"),
    [
        ({}, "flow"),
        (spec(segments=[]), "at least one table"),
        (spec(segments={"kind": "fall"}), "a list of tables"),
        (spec(segments=["fall"]), "a table"),
        (spec(flow=3), "a table"),
        (spec(liners={}), "at least one table"),
        (spec(liners={"a b": {"friction_deg": 20.0}}), "is not a valid name"),
        (spec(sections=[]), "a table"),
        (spec(material={"name": 3}), "text in quotes"),
    ],
)
def test_wrong_tables(data, words):
    assert any(words in f"{fault.path} {fault.problem} {fault.remedy}" for fault in faults(data))


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("[flow]\nrate_t_h = 1000".encode("utf-16"), "is UTF-16.*Save the file as UTF-8"),
        ("[flow]\ntitle = 'δ 30°'".encode("cp1253"), "bad.toml:2: has a character that is not UTF-8"),
        (b"", "is empty. Run chutecalc new"),
        (b"# nothing yet\n\n", "is empty. Run chutecalc new"),
    ],
)
def test_files_that_are_no_specs(tmp_path, content, words):
    path = tmp_path / "bad.toml"
    path.write_bytes(content)
    with pytest.raises(chutecalc.SpecError, match=words) as caught:
        chutecalc.load(path)
    assert caught.value.source == str(path)


def test_a_byte_order_mark_is_no_fault(tmp_path):
    path = tmp_path / "bom.toml"
    path.write_bytes(b"\xef\xbb\xbf" + STARTER.encode())
    assert chutecalc.load(path).spec.title == "Fall and spoon, coal"


def test_lines_of_keys_in_every_toml_form():
    text = 'a.b = 1\n[t]\nx = """\ny = 2\n"""\nz = [\n 1,\n]\n[[s]]\nk = 1\n[[s]]\nk = 2\n[s.sub]\n"q r" = 3\n'
    tomllib.loads(text)
    lines = key_lines(text)
    assert lines["a", "b"] == 1
    assert lines["t", "x"] == 3
    assert ("t", "y") not in lines
    assert lines["t", "z"] == 6
    assert (lines["s", 0, "k"], lines["s", 1, "k"]) == (10, 12)
    assert lines["s", 1, "sub", "q r"] == 14


def test_unnamed_segments_are_called_by_their_kind():
    fall = {"kind": "fall", "drop_m": 1.0}
    named = chute(segments=[fall, {**fall}, {"kind": "straight", "name": "fall_2", "slope_deg": 60.0, "length_m": 1.0}])
    assert [segment.name for segment in named.design.segments] == ["fall", "fall_3", "fall_2"]

    paths = ["segments.fall.drop_m", "segments.fall_3.drop_m", "segments.fall_2.length_m"]
    by_kind = named.vary(dict.fromkeys(paths, 2.0))
    by_number = named.vary({"segments.1.drop_m": 2.0, "segments.2.drop_m": 2.0, "segments.3.length_m": 2.0})
    assert chutecalc.solve(by_kind).exit_velocity == chutecalc.solve(by_number).exit_velocity
    assert named.function(paths, ["exit_velocity_m_s"])(2.0, 2.0, 2.0) == chutecalc.solve(by_kind).exit_velocity
    with pytest.raises(chutecalc.SpecError, match=r"no item 'hood'\. Use 1 \(fall\), 2 \(fall_3\) or fall_2\."):
        named.vary({"segments.hood.radius_m": 1.0})


def test_vary_by_name_number_and_twin():
    base = chutecalc.parse(STARTER)
    radii = np.array([2.0, 3.0, 4.0])
    by_name = chutecalc.solve(base.vary({"segments.spoon.radius_m": radii})).exit_velocity
    by_number = chutecalc.solve(base.vary({"segments.2.radius_mm": list(radii * 1000)})).exit_velocity
    assert np.array_equal(by_name, by_number)
    optional = base.vary({"sections.body.chamfer_m": [0.1, 0.2]})
    assert chutecalc.solve(optional).exit_velocity.shape == (2,)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"segments.spoon.radius_m": [1.0, -1.0]}, "-1 to 1"),
        ({"segments.spoon.radius_m": [1.0, np.nan]}, "finite"),
        ({"segments.spoon.radius": [1.0, 2.0]}, "needs its unit"),
        ({"segments.hood.radius_m": 1.0}, r"segments has no item 'hood'. Use 1 \(fall\) or spoon"),
        ({"segments.3.radius_m": 1.0}, r"segments has no item '3'. Use 1 \(fall\) or spoon"),
        ({"hoods.3.radius_m": 1.0}, "the spec has no table hoods. Use one of flow, material, liners,"),
        ({"segments..radius_m": 1.0}, "segments has no item ''"),
        ({"flow": 1.0}, "flow = 1 cannot be varied: it is not a quantity"),
        ({"flow.rate_t_h": [1.0, 2.0], "segments.1.drop_m": [1.0, 2.0, 3.0]}, "differ in length"),
        ({"flow.rate_t_h": [[1.0, 2.0]]}, "is an array of 2 dimensions; it must have one: a value for each design"),
        ({"flow.rate_t_h": []}, "takes numbers"),
        ({"flow.rate_t_h": "fast"}, 'flow.rate_t_h = "fast" must be a number'),
        ({"segments.spoon.length_m": 1.0}, "is not a key of this table"),
    ],
)
def test_vary_refuses_what_a_spec_would(changes, words):
    with pytest.raises(chutecalc.SpecError, match=words):
        chutecalc.parse(STARTER).vary(changes)


@pytest.mark.parametrize(
    "path",
    [
        "segments.1.kind",
        "segments.2.name",
        "segments.2.section",
        "segments.2.liner",
        "segments.1.onto_next",
        "sections.body.shape",
        "liners.ceramic.own_material",
        "model.friction_law",
        "title",
        "format",
        "segments",
    ],
)
@pytest.mark.parametrize(("values", "given"), [(1.0, "1"), ([1.0, 2.0], "1 to 2")])
def test_what_is_no_quantity_is_not_varied(path, values, given):
    with pytest.raises(chutecalc.SpecError) as caught:
        chutecalc.parse(STARTER).vary({path: values})
    (fault,) = caught.value.faults
    fault_text = "cannot be varied: it is not a quantity", "use the path of a quantity, such as flow.rate_t_h"
    assert fault[:4] == (path, *fault_text, given)


def test_faults_of_what_is_varied_are_told_together():
    changes = {"segments.1.name": [1.0, 2.0], "segments.1.kind": [1.0, 2.0], "segments.spoon.radius_m": [-1.0, 2.0]}
    with pytest.raises(chutecalc.SpecError) as caught:
        chutecalc.parse(STARTER).vary(changes)
    # of a segment without a kind nothing else is known
    assert [fault.path for fault in caught.value.faults] == ["segments.1.kind", "segments.2.radius_m"]


def test_a_curve_tangent_to_a_slanting_stream_keeps_the_base_designs_slope_in_a_sweep():
    base = chute(
        model={"steel": "follows_stream"},
        inlet={"velocity_m_s": 2.0, "slope_deg": 30.0},
        segments=[
            {"kind": "fall", "drop_m": 1.0},
            {"name": "spoon", "kind": "curve", "radius_m": 2.0, "to_slope_deg": 20.0},
        ],
    )
    alone = chutecalc.solve(base)
    (note,) = [finding for finding in alone.findings() if finding.code == "geometry_follows_flow"]
    assert note.severity == "note"
    swept = chutecalc.solve(base.vary({"inlet.velocity_m_s": [2.0, 1.0]}))
    surface = swept.trajectory.segment_solutions[1].contact.surface
    assert surface.slope[0] == alone.trajectory.segment_solutions[1].contact.surface.slope[0]
    assert swept.exit_velocity[0] == alone.exit_velocity[0]
    assert swept.segments[1].entry["velocity_m_s"][1] < swept.segments[0].exit["velocity_m_s"][1]  # an impact


def test_rtol_has_its_bounds():
    for wrong in (0.0, 1e-14, 0.1, float("nan")):
        with pytest.raises(chutecalc.UsageError, match="1e-13"):
            chutecalc.solve(chutecalc.parse(STARTER), rtol=wrong)


def with_tables(**tables):
    data = tomllib.loads(chutecalc.STARTER)
    return data | tables


def belt(**keys):
    return {"inlet": {"belt": {"velocity_m_s": 3.0, "pulley_radius_m": 0.4} | keys}}


@pytest.mark.parametrize(
    ("tables", "path", "words"),
    [
        ({"liners": {"a": {"yield_locus_kpa": [[1, 0.5]]}}}, "liners.a.yield_locus_kpa", "at least two rows"),
        ({"liners": {"a": {"yield_locus_kpa": [[1, 0.5], [1, 0.6]]}}}, "liners.a.yield_locus_kpa", "row 2"),
        ({"liners": {"a": {"yield_locus_kpa": [[1, 0.5], [2, 0.4]]}}}, "liners.a.yield_locus_kpa", "row 2"),
        ({"liners": {"a": {"yield_locus_kpa": [[0, 0.5], [2, 0.6]]}}}, "liners.a.yield_locus_kpa", "0 or less"),
        ({"liners": {"a": {"yield_locus_kpa": [1, 2]}}}, "liners.a.yield_locus_kpa", "rows of two numbers"),
        ({"liners": {"a": {"yield_locus_kpa": [[1, "x"], [2, 3]]}}}, "liners.a.yield_locus_kpa", "a number"),
        ({"liners": {"a": {"friction_deg": 20, "own_material": True}}}, "liners.a.own_material", "only one of"),
        ({"liners": {"a": {}}}, "liners.a.friction_deg", "is missing"),
        ({"liners": {"a": {"friction_deg": 20, "slip_ratio": 1.5}}}, "liners.a.slip_ratio", "at most 1"),
        ({"sections": {"s": {"shape": "circular"}}}, "sections.s.radius_m", "is missing"),
        ({"sections": {"s": {"shape": "facets", "facets": []}}}, "sections.s.facets", "at least one table"),
        (
            {"sections": {"s": {"shape": "facets", "facets": [{"length_m": 1, "slope_deg": 0}]}}},
            "sections.s.facets",
            "all level",
        ),
        (
            {"sections": {"s": {"shape": "facets", "facets": [{"length_m": 1, "slope_deg": a} for a in (40, 30)]}}},
            "sections.s.facets.2.slope_deg",
            "flatter than the facet before",
        ),
        (
            {"sections": {"s": {"shape": "facets", "facets": [{"length_m": 1, "slope_deg": 90}]}}},
            "sections.s.facets.1.slope_deg",
            "no width",
        ),
        ({"inlet": {"belt": {"velocity_m_s": 3, "pulley_radius_m": 0.4}, "slope_deg": 3}}, "inlet.slope_deg", "belt"),
        (belt(trough_deg=30), "inlet.belt.trough_deg", "only for a belt with width_m"),
        (belt(roll_mm=300), "inlet.belt.roll_mm", "only for a belt with width_m"),
        (belt(width_m=1, trough_deg=30), "inlet.belt.surcharge_deg", "is missing"),
        (belt(width_m=1, surcharge_deg=20), "inlet.belt.trough_deg", "needed with width_m"),
        (
            belt(width_m=1, trough_deg=30, surcharge_deg=20, material_depth_mm=100),
            "inlet.belt.material_depth_mm",
            "follows from width_m",
        ),
        (belt(width_m=1, trough_deg=0, surcharge_deg=0), "inlet.belt.surcharge_deg", "no load on a flat belt"),
        (belt(width_m=1, trough_deg=9, surcharge_deg=0, roll_m=0.9), "inlet.belt.surcharge_deg", "leaves no load"),
        (belt(width_m=1, trough_deg=9, surcharge_deg=9, roll_m=1), "inlet.belt.roll_m", "not shorter than"),
        (belt(width_m=0.09, trough_deg=9, surcharge_deg=9), "inlet.belt.width_m", "at least 0.1 m"),
        (belt(friction_deg=90), "inlet.belt.friction_deg", "at most 85°"),
        ({"inlet": {"velocity_m_s": 3}}, "inlet.slope_deg", "is missing"),
        ({"inlet": {"velocity_m_s": 3, "slope_deg": 9, "at_m": [1]}}, "inlet.at_m", "two numbers"),
        ({"model": {"friction_law": "mine"}}, "model.friction_law", "'paper' or 'equilibrium'"),
        ({"receiver": {"velocity_m_s": 0, "friction_deg": 30}}, "receiver.velocity_m_s", "at least 0.001"),
        ({"segments": [{"kind": "fall"}]}, "segments.1.drop_m", "is missing"),
        ({"segments": [{"kind": "fall", "onto_next": True}]}, "segments.1.onto_next", "needs a segment after it"),
        (
            {
                "segments": [
                    {"kind": "fall", "drop_m": 1},
                    {"kind": "straight", "slope_deg": 9, "length_m": 1, "start_m": [0, 0]},
                ]
            },
            "segments.2.start_m",
            "onto_next",
        ),
        (
            {"segments": [{"kind": "fall", "onto_next": True}, {"kind": "curve", "radius_m": 1, "to_slope_deg": 9}]},
            "segments.2.start_m",
            "is missing",
        ),
        ({"segments": [{"kind": "fall", "run_m": 1}]}, "segments.1.run_m", "straight down"),
        (
            {"material": {"density_kg_m3": 800, "pressure_ratio": 0.4}, "liners": {"a": {"own_material": True}}},
            "liners.a.own_material",
            "internal friction",
        ),
    ],
)
def test_faults_of_what_real_chutes_have(tables, path, words):
    with pytest.raises(chutecalc.SpecError) as caught:
        chutecalc.parse(with_tables(**tables))
    faults = [fault for fault in caught.value.faults if fault.path == path]
    assert faults, [fault.text("x") for fault in caught.value.faults]
    assert any(words in fault.problem for fault in faults), faults
    assert all(fault.remedy for fault in faults)


def test_sections_of_a_taper_have_to_be_alike():
    sections = {
        "one": {"shape": "chamfered", "base_m": 0.5, "chamfer_deg": 45},
        "two": {"shape": "chamfered", "base_m": 0.5, "chamfer_deg": 45, "chamfer_m": 0.1},
    }
    spoon = {"kind": "curve", "radius_m": 3, "to_slope_deg": 0, "section": ["one", "two"]}
    with pytest.raises(chutecalc.SpecError, match="differ in more than their numbers"):
        chutecalc.parse(with_tables(sections=sections, segments=[{"kind": "fall", "drop_m": 2}, spoon]))


@pytest.mark.parametrize(("end", "fits"), [(0.0061, True), (0.0059, False), (59.0, True), (61.0, False)])
def test_a_taper_of_more_than_a_hundred_to_one_is_refused(end, fits):
    sections = {"a": {"shape": "rectangular", "width_m": 0.6}, "b": {"shape": "rectangular", "width_m": 0.6}}
    tapered = {"kind": "straight", "slope_deg": 60, "length_m": 2, "section": ["a", "b"]}
    chute = chutecalc.parse(spec(sections=sections, segments=[tapered]))
    if fits:
        chute.vary({"sections.b.width_m": end})
    else:
        with pytest.raises(chutecalc.SpecError, match="tapers from a to b, of which one is more than 100 times"):
            chute.vary({"sections.b.width_m": end})


def test_lists_take_units_and_paths_lead_into_them():
    locus = [[0.5, 0.3], [1.0, 0.5]]
    pascal = [[500.0, 300.0], [1000.0, 500.0]]
    ends = [
        chutecalc.solve(chutecalc.parse(with_tables(liners={"a": {key: rows}}))).exit_velocity[0]
        for key, rows in (("yield_locus_kpa", locus), ("yield_locus_pa", pascal))
    ]
    assert ends[0] == pytest.approx(ends[1], rel=1e-13)
    base = chutecalc.parse(with_tables(liners={"a": {"yield_locus_kpa": locus}}))
    varied = chutecalc.solve(base.vary({"liners.a.yield_locus_kpa.2.2": [0.5, 0.6]})).exit_velocity
    assert varied[0] == ends[0]
    assert varied[1] != ends[0]


def test_a_setting_may_make_an_optional_table():
    chute = chutecalc.parse(chutecalc.STARTER).put({"model.friction_law": "equilibrium"})
    assert chute.design.equilibrium
    with pytest.raises(chutecalc.SpecError, match=r"inlet\.model"):
        chutecalc.parse(chutecalc.STARTER).put({"inlet.model.friction_law": "equilibrium"})


def test_designs_are_counted_over_the_whole_spec():
    base = chutecalc.parse(chutecalc.STARTER)
    unused = base.put({"sections.body.base_m": 0.5})
    many = unused.vary({"material.pressure_ratio": 0.4, "material.internal_friction_deg": [20, 30, 40]})
    solution = chutecalc.solve(many)
    assert solution.exit_velocity.shape == (3,)
    assert all(finding.mask.shape == (3,) for finding in solution.findings())
    with pytest.raises(chutecalc.SpecError, match="differ in length"):
        base.vary({"flow.rate_t_h": [1, 2]}).vary({"material.density_kg_m3": [1, 2, 3]})
    with pytest.raises(chutecalc.SpecError, match="given twice"):
        base.vary({"segments.2.radius_m": [1, 2], "segments.spoon.radius_mm": [3000, 3000]})


def test_a_table_that_stands_in_two_places_is_varied_in_one():
    body = {"shape": "chamfered", "base_m": 0.5, "chamfer_deg": 45}
    flat = {"kind": "straight", "slope_deg": 50.0, "length_m": 1.0, "section": ["a", "b"]}
    start = {"velocity_m_s": 4.0, "slope_deg": 50.0}
    base = chutecalc.parse(with_tables(sections={"a": body, "b": body}, inlet=start, segments=[flat, flat]))
    varied = base.vary({"sections.a.base_m": [0.6, 0.7], "segments.2.length_m": 2.0})
    assert varied.data["sections"]["b"] == body == base.data["sections"]["a"]
    assert [float(np.squeeze(segment["length_m"])) for segment in varied.data["segments"]] == [1.0, 2.0]
    both = base.vary({"sections.a.base_m": [0.6, 0.7], "sections.b.base_m": [0.4, 0.3]})
    assert both.data["sections"]["b"]["base_m"].tolist() == [0.4, 0.3]
    assert both.data["sections"]["a"]["base_m"].tolist() == [0.6, 0.7]


def test_a_batch_that_nobody_carries_on():
    sections = {"b": {"shape": "chamfered", "base_m": 0.5, "chamfer_deg": 45, "chamfer_m": 0.1}}
    flat = {"kind": "straight", "slope_deg": 5.0, "length_m": 9.0}
    base = chutecalc.parse(
        with_tables(sections=sections, inlet={"velocity_m_s": 1.0, "slope_deg": 5.0}, segments=[flat, dict(flat)])
    )
    solution = chutecalc.solve(base.vary({"sections.b.base_m": [0.4, 0.5]}))
    assert solution.status.tolist() == ["stall", "stall"]
    assert next(finding.code for finding in solution.findings()) == "stall"


def test_the_slope_of_the_inlet_belongs_to_the_drawing():
    """A curve below is drawn tangent to each stream; no case may change it."""
    tables = with_tables(
        inlet={"velocity_m_s": 2.0, "slope_deg": 90.0},
        segments=[{"kind": "fall", "drop_m": 1}, {"kind": "curve", "radius_m": 2, "to_slope_deg": 20}],
    )
    tangent = np.degrees(np.arctan(np.sqrt(3.0 + 2.0 * 9.80665)))  # after 1 m at 1 m/s forward, from 60°
    for steel in ("fixed", "follows_stream"):
        base = chutecalc.parse(tables | {"model": {"steel": steel}})
        slanting = chutecalc.solve(base.vary({"inlet.slope_deg": [90.0, 60.0]}))
        surface = slanting.trajectory.segment_solutions[1].contact.surface
        assert np.degrees(np.broadcast_to(surface.slope, 2)).tolist() == pytest.approx([90.0, tangent], rel=1e-12)
        assert slanting.status.tolist() == ["ok", "ok"]
    with pytest.raises(chutecalc.SpecError, match="belongs to the drawing"):
        chutecalc.parse(tables | {"cases": {"steep": {"inlet.slope_deg": 60.0}}})


@pytest.mark.parametrize(
    "text", ["title = " + "[" * 3000, "[flow]\nrate_t_h = " + "9" * 5000, "[flow]\nrate_kg_s = 1" + "0" * 400]
)
def test_texts_that_overwhelm_a_parser_are_faults(text):
    with pytest.raises(chutecalc.SpecError):
        chutecalc.parse(text)


@pytest.mark.parametrize("junk", [None, [1], b"", 3])
def test_what_is_no_spec_at_all(junk):
    with pytest.raises(chutecalc.SpecError, match="Give TOML text"):
        chutecalc.parse(junk)


@pytest.mark.parametrize(
    "body", [{"shape": "pipe", "radius_m": 0.3}, {"shape": "box", "width_m": 0.5, "height_m": 0.4}]
)
def test_a_closed_section_has_no_wall_height(body):
    (fault,) = faults(spec(sections={"body": body | {"wall_height_mm": 400.0}}))
    assert fault.path == "sections.body.wall_height_mm"
    assert "closed" in fault.problem
    assert "remove" in fault.remedy


def test_a_bend_of_a_pipe_may_be_as_tight_as_its_height_on_the_outside():
    """On a crest the roof is the longer wall; in a spoon it is the shorter one, and has to have a length."""
    pipe = {"body": {"shape": "pipe", "radius_m": 0.3}}
    for radius, slope in ((0.5, 60.0), (0.601, 10.0)):
        bend = [{"kind": "curve", "radius_m": radius, "to_slope_deg": slope}]
        (drawn,) = chutecalc.parse(spec(sections=pipe, segments=bend)).design.segments
        assert drawn.radius.tolist() == [radius]
    bend = [{"kind": "curve", "radius_m": 0.599, "to_slope_deg": 10.0}]
    assert [fault.path for fault in faults(spec(sections=pipe, segments=bend))] == ["segments.1.radius_m"]
