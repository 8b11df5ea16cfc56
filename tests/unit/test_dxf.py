"""Drawings for CAD, read back: steel as the design has it, the stream as it is solved, all of it on its layer."""

import io
import os
import subprocess
import sys
from math import cos, hypot, radians, sin

import ezdxf
import ezdxf.units
import numpy as np
import pytest

import chutecalc
from chutecalc.output.dxf.drawing import draw, save
from chutecalc.output.dxf.layers import LAYERS, case_layer
from tests.conftest import LEVEL, ROOT, STANDARD_DESIGNS, chute

ROUNDING = 1e-9
"""mm: a few times the rounding of a place of 10 m."""
FINEST = 0.02
"""mm on paper, a ninth of the thinnest line."""


def drawn(made):
    """Return a chute's drawing, read back."""
    if isinstance(made, str):
        made = chutecalc.load(ROOT / "specs" / f"{made}.toml")
    stream = io.BytesIO()
    save(draw(chutecalc.solve_cases(made)), stream)
    return ezdxf.read(io.StringIO(stream.getvalue().decode("utf-8")))


def on(document, layer, kind="*"):
    return list(document.modelspace().query(f'{kind}[layer=="{layer}"]'))


def arcs(document, layer):
    """Return centre, radius and angles of the arcs of a layer, in order."""
    found = (arc.dxf for arc in on(document, layer, "ARC"))
    return [(*arc.center.vec2, arc.radius, arc.start_angle, arc.end_angle) for arc in found]


def lines(document, layer):
    return [(*line.dxf.start.vec2, *line.dxf.end.vec2) for line in on(document, layer, "LINE")]


def polylines(document, layer):
    return [np.array(line.get_points("xy")).T for line in on(document, layer, "LWPOLYLINE")]


def close(numbers):
    return pytest.approx(numbers, abs=ROUNDING)


def texts_of(dimension):
    return [entity for entity in dimension.get_geometry_block() if entity.dxftype() == "MTEXT"]


@pytest.mark.parametrize("path", STANDARD_DESIGNS, ids=lambda path: path.stem)
def test_every_standard_design_is_drawn(path):
    made = chutecalc.load(path)
    document = drawn(made)
    audit = document.audit()
    assert not audit.errors
    assert not audit.fixes
    assert document.dxfversion >= "AC1024"
    assert document.header["$INSUNITS"] == ezdxf.units.MM
    assert {layer.name for layer in LAYERS} <= {layer.dxf.name for layer in document.layers}
    assert not on(document, "0")
    guides = [segment for segment in made.design.segments if hasattr(segment, "side")]
    steel = on(document, "STEEL")
    assert [each.dxftype() for each in steel] == ["LINE" if each.radius is None else "ARC" for each in guides]
    names = {text.dxf.text for text in on(document, "TEXT", "TEXT")}
    for each in guides:
        assert {each.name, f"{each.name}, inlet", f"{each.name}, outlet"} <= names
    assert made.spec.title in names


def test_the_docs_list_every_layer():
    page = (ROOT / "docs/running.md").read_text(encoding="utf-8").partition("| layer | what is on it |")[2]
    rows = [row.strip("| ").split(" | ") for row in page.strip().partition("\n\n")[0].splitlines()[1:]]
    assert rows[:-1] == [[f"`{layer.name}`", layer.holds] for layer in LAYERS]
    assert rows[-1] == ["`STREAM_NAME`", f"{case_layer('NAME').holds}; frozen"]


def test_a_spoon_is_a_true_arc():
    document = drawn(chutecalc.parse(LEVEL))  # 2 m down, then a quarter of R = 3 m
    assert arcs(document, "STEEL") == [close((3000.0, -2000.0, 3000.0, 180.0, 270.0))]


def test_hood_and_belts():
    document = drawn("transfer_90")
    hood = 220 - 1500 * sin(radians(20)), 690 - 1500 * cos(radians(20)), 1500, 90 - 88, 90 - 20
    spoon = 1150 + 4000 * sin(radians(81)), -1600 + 4000 * cos(radians(81)), 4000, 270 - 81, 270 - 30
    assert arcs(document, "STEEL") == [close(hood), close(spoon)]
    (pulley,) = on(document, "BELTS", "CIRCLE")
    assert (*pulley.dxf.center.vec2, pulley.dxf.radius) == close((0, 0, 500))
    assert arcs(document, "BELTS") == [close((0, 0, 520, 270, 90))]
    (received,) = polylines(document, "BELTS")
    assert received[1] == close([-4600, -4600])
    assert min(received[0]) < 3000 < max(received[0])


def test_dimensions_measure_the_design():
    document = drawn("transfer_90")
    found = {}
    for each in on(document, "DIMENSIONS", "DIMENSION"):
        found.setdefault(each.dimtype, []).append(each.get_measurement())
    aligned, angles, radii, ordinates = (found[kind] for kind in (0, 2, 4, 6))
    assert sorted(radii) == close([500, 1500, 4000])
    lesser = [min(angle, 360 - angle) for angle in angles]  # ezdxf measures on from one leg, whichever side the arc is
    assert sorted(lesser) == close([20, 30, 45, 45, 81, 88])
    shown = {mtext.plain_text() for each in on(document, "DIMENSIONS", "DIMENSION") for mtext in texts_of(each)}
    assert {"R4000", "R1500", "88°", "30°", "853.6", "0", "220", "690", "1150", "-1600", "3000", "-4600"} <= shown
    chamfered = 500 + 2 * 250 * cos(radians(45))
    assert sorted(aligned) == close([250, 250, 500, 500, chamfered, chamfered, 1000, 1000])
    assert len(ordinates) == 6 + 6


def test_straights_and_walls():
    section = {"body": {"shape": "rectangular", "width_m": 0.6, "wall_height_m": 0.4}}
    document = drawn(chute(sections=section))  # 3 m at 40° from the origin
    down = np.array([cos(radians(40)), -sin(radians(40))])
    up = np.array([sin(radians(40)), cos(radians(40))])
    assert lines(document, "STEEL") == [close((0, 0, *3000 * down))]
    top, first, last = lines(document, "WALLS")
    assert top == close((*400 * up, *(3000 * down + 400 * up)))
    assert first == close((0, 0, *400 * up))
    assert last == close((*3000 * down, *(3000 * down + 400 * up)))


def test_roofs_are_parallel():
    document = drawn("pipe_two_bends")
    for floor, roof in zip(arcs(document, "STEEL"), arcs(document, "ROOFS"), strict=True):
        assert roof[:2] == close(floor[:2])
        assert roof[3:] == close(floor[3:])
        assert abs(roof[2] - floor[2]) == close(240)
    circles = on(document, "SECTIONS", "CIRCLE")
    assert [circle.dxf.radius for circle in circles] == close([120] * 6)


def test_folds_and_tops_of_a_taper_are_linear_in_height():
    document = drawn("tapered_spoon")
    (x, z, radius, _, _) = arcs(document, "STEEL")[0]
    (top,) = polylines(document, "WALLS")
    heights = radius - np.hypot(top[0] - x, top[1] - z)
    assert heights == close(np.linspace(600, 450, heights.size))
    (fold,) = polylines(document, "FOLDS")
    heights = radius - np.hypot(fold[0] - x, fold[1] - z)
    assert heights[[0, -1]] == close([150 * sin(radians(35)), 200 * sin(radians(50))])


def test_a_plate_and_the_flights_between():
    made = chutecalc.load(ROOT / "specs/impact_plate.toml")
    document = drawn(made)
    ((x0, z0, x1, z1),) = lines(document, "STEEL")
    slope, length = made.design.segments[1].exit_slope[0], made.design.segments[1].length[0]
    assert (x1 - x0, z0 - z1) == close((1000 * length * cos(slope), 1000 * length * sin(slope)))
    stations = chutecalc.solve(made).stations(points=101)
    for name in ("throw", "drop"):
        rows = stations["segment"][0] == name
        path = 1000.0 * np.stack([stations["x_m"][0, rows], stations["z_m"][0, rows]])
        flown = [edge for edge in polylines(document, "FLIGHT") if edge.shape == path.shape]
        assert any(np.allclose(edge, path, atol=ROUNDING, rtol=0) for edge in flown)


@pytest.mark.parametrize("name", ["transfer_90", "tapered_spoon", "crest_held", "vee"])
def test_the_stream_is_where_it_is_solved_to_what_a_drawing_shows(name):
    made = chutecalc.load(ROOT / "specs" / f"{name}.toml")
    solution = chutecalc.solve(made)
    document = drawn(made)
    scale = document.header["$LTSCALE"]
    edges = polylines(document, "STREAM")
    for segment in made.design.segments:
        if not hasattr(segment, "side"):
            continue
        at = solution.stations(points=997, columns=["segment", "x_m", "z_m", "slope_deg", "depth_m"])
        rows = at["segment"][0] == segment.name
        x, z, slope, depth = (at[key][0, rows] for key in ("x_m", "z_m", "slope_deg", "depth_m"))
        above = segment.side * depth
        free = np.stack([x + above * np.sin(np.radians(slope)), z + above * np.cos(np.radians(slope))])
        for path in (np.stack([x, z]), free):
            assert min(farthest(1000.0 * path, edge) for edge in edges) < FINEST * scale


def farthest(points, line):
    """Return how far the farthest of some points is from a polyline."""
    start, step = line[:, None, :-1], np.diff(line)[:, None, :]
    share = ((points[:, :, None] - start) * step).sum(0) / np.maximum((step**2).sum(0), 1e-30)
    away = points[:, :, None] - start - np.clip(share, 0.0, 1.0) * step
    return np.hypot(*away).min(axis=1).max()


def test_sections_are_to_scale():
    faceted = {"shape": "facets", "wall_height_m": 0.5}
    faceted["facets"] = [{"length_m": 0.25, "slope_deg": 0}, {"length_m": 0.2, "slope_deg": 40}]
    document = drawn(chute(sections={"body": faceted}))
    for corners in polylines(document, "SECTIONS"):
        x, z = corners - corners[:, [2]]
        run, rise = 200 * cos(radians(40)), 200 * sin(radians(40))
        assert x == close([-run, -run, 0, 500, 500 + run, 500 + run])
        assert z == close([500, rise, 0, 0, rise, 500])
    half = drawn(chute(sections={"body": {"shape": "circular", "radius_m": 0.3, "wall_height_m": 0.2}}))
    for outline in on(half, "SECTIONS", "LWPOLYLINE"):
        (x0, _, bulge), (x1, _, _) = outline.get_points("xyb")
        chord = 2 * (300**2 - 100**2) ** 0.5  # 200 mm up a circle of 300 mm
        assert x1 - x0 == close(chord)
        assert bulge == pytest.approx(200 / (chord / 2))  # rise over half the chord


def test_sections_stand_clear_of_the_side_view():
    document = drawn("transfer_90")
    right = max(line[0].max() for layer in ("STREAM", "FLIGHT", "BELTS") for line in polylines(document, layer)[:3])
    assert min(line[0].min() for line in polylines(document, "SECTIONS")) > right


def test_each_case_has_its_own_frozen_layer():
    document = drawn("transfer_90")
    layers = {layer.dxf.name: layer for layer in document.layers}
    for case in ("dry", "wet", "surge", "slow_belt"):
        assert layers[f"STREAM_{case}"].is_frozen()
        assert polylines(document, f"STREAM_{case}")
    assert not layers["STREAM"].is_frozen()


def test_a_failing_chute_is_drawn_as_far_as_its_steel_is_known():
    words = {text.dxf.text for text in on(drawn("fails/stall_in_spoon"), "TEXT", "TEXT")}
    assert "The chute fails (status stall): the stream is drawn as far as it gets." in words
    upper = {"kind": "straight", "name": "upper", "slope_deg": 5.0, "length_m": 9.0}
    fall = {"kind": "fall", "drop_m": 1.0}
    lower = {"kind": "straight", "name": "lower", "slope_deg": 60.0, "length_m": 2.0}
    document = drawn(chute(segments=[upper, fall, lower]))  # the lower one is placed by a stream that stalls
    assert len(lines(document, "STEEL")) == 1
    words = {text.dxf.text for text in on(document, "TEXT", "TEXT")}
    assert "Not drawn, as the stream that places it does not get there: lower." in words


def test_titles_are_text_whatever_they_say():
    title = 'a^b %%d %%%c {\\fArial; "x"} 石 α'
    made = chute(title=title, project={"client": "C\nD", "number": "7^I", "notes": "one\ntwo"})
    texts = {text.plain_text() for text in on(drawn(made), "TEXT", "TEXT")}
    assert title in texts
    assert {"client: C D, number: 7^I", "one", "two"} <= texts


def test_a_drawing_is_the_same_bytes_each_time():
    made = chutecalc.parse(chutecalc.STARTER)
    written = []
    for _ in range(2):
        stream = io.BytesIO()
        save(draw(chutecalc.solve_cases(made)), stream)
        written.append(stream.getvalue())
    assert written[0] == written[1]


def test_notes_stand_clear_of_lines_and_of_each_other():
    document = drawn("power_station_us")
    scale = document.header["$LTSCALE"]
    texts = on(document, "TEXT", "TEXT")
    (name,) = (each for each in texts if each.dxf.text == "hood" and each.dxf.height == 3.5 * scale)
    middle = name.dxf.align_point
    for edge in polylines(document, "STREAM"):
        assert np.hypot(edge[0] - middle.x, edge[1] - middle.y).min() > 1.5 * scale
    belt = next(each for each in texts if each.dxf.text.startswith("feeding"))
    assert hypot(*(belt.dxf.align_point - middle).vec2) > 20.0 * scale


def test_cases_that_differ_by_capitals_have_layers_of_their_own():
    text = chutecalc.STARTER + '[cases.Wet]\n"flow.rate_t_h" = 900\n[cases.wet]\n"flow.rate_t_h" = 800\n'
    document = drawn(chutecalc.parse(text))
    assert {"STREAM_Wet", "STREAM_wet_2"} <= {layer.dxf.name for layer in document.layers}


def test_a_drawing_is_the_same_bytes_in_any_process(tmp_path):
    """Python orders sets by a seed of its own in each process; these two once gave different files."""
    found = []
    for seed in ("1", "4"):
        command = [sys.executable, "-m", "chutecalc", "run", "specs/fails/missed_spoon.toml", "--dxf"]
        file = tmp_path / f"{seed}.dxf"
        environment = os.environ | {"PYTHONHASHSEED": seed}
        subprocess.run([*command, str(file)], cwd=ROOT, env=environment, check=False, capture_output=True, timeout=120)
        found.append(file.read_bytes())
    assert found[0] == found[1]
